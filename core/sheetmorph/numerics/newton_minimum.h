// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"

#include <Eigen/Core>
#include <optional>

namespace sheetmorph::numerics
{

//! The step to the minimum of a quadratic model.
struct NewtonStep
{
    Eigen::VectorXd change;   //!< to take; a bound on the step may have shortened it
    double length = 0.0;      //!< of the step before any bound, in the unit of the limits
    double slope = 0.0;       //!< gradient . change; below 0 where the change goes downhill
    bool is_bounded = false;  //!< a bound has shortened the change

    //! Whether the model is the second-order one of the value here. Only such a step converges.
    bool is_exact = true;
};

//! A value that depends on a shape, and quadratic models of it. Steps move the shape.
class NewtonProblem
{
public:
    virtual ~NewtonProblem() = default;

    //! The value at the present shape; not finite where the shape is impossible.
    virtual double value() = 0;

    //! The step of one model at the present shape. Model 0 comes first; the later ones are more
    //! convex and serve where those before fail.
    //! \returns nothing where the model is not positive definite
    virtual std::optional<NewtonStep> step(int model) = 0;

    //! Makes the present shape the one that move() and restore() begin from.
    virtual void remember() = 0;

    //! Moves the remembered shape by share * step.change.
    virtual void move(const NewtonStep& step, double share) = 0;

    virtual void restore() = 0;
};

//! When a minimum is found, and when to give up.
struct NewtonLimits
{
    const char* what = "";    //!< as Convergence::what
    const char* unit = "mm";  //!< of lengths
    int most_rounds = 100;    //!< most steps
    double settled = 1e-9;    //!< a whole step at most this long has converged
    double finest = 1e-15;    //!< after such a step none follows
    double squares_below =
        0.0;            //!< steps below it that shrink tenfold square what is left; 0: none
    double left = 0.0;  //!< what those may leave
    int models = 1;
    int remembered = 1;    //!< values; a whole step of model 0 may rise to the largest of them
    double noise = 1e-14;  //!< of the value: its rounding
    double unseen_gain = 1e-13;  //!< of the value: a decrement that rounding hides
    const char* task = nullptr;  //!< for progress: "laying flat"; nullptr: none is reported
};

//! Moves a shape to a minimum of its value by Newton's method with a line search.
//!
//! It has converged when the whole step of an exact, positive definite model is short, or when that
//! step cannot lower the value because its decrement is below rounding. The length that a bound or
//! the line search leaves of a step says nothing, and neither does a step that was not found.
//! \throws Cancelled if the progress callback asks for it
[[nodiscard]] Convergence newton_minimum(NewtonProblem& problem, const NewtonLimits& limits,
                                         const Progress& progress = {});

}  // namespace sheetmorph::numerics
