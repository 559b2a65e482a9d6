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
    Eigen::VectorXd change;   //!< change of the shape, possibly shortened by a bound
    double length = 0.0;      //!< before any bound, in the unit of the limits
    double slope = 0.0;       //!< gradient . change; negative downhill
    bool is_bounded = false;  //!< whether a bound has shortened the change

    //! Whether the model is the second-order one at the current shape. Only such a step converges.
    bool is_exact = true;
};

//! A value that depends on a shape, and quadratic models of it.
class NewtonProblem
{
public:
    virtual ~NewtonProblem() = default;

    //! The value at the current shape; not finite if the shape is impossible.
    virtual double value() = 0;

    //! The step of one model at the current shape. Model 0 comes first. Later models are more
    //! convex and serve if the earlier ones fail.
    //! \returns nothing if the model is not positive definite
    virtual std::optional<NewtonStep> step(int model) = 0;

    //! Saves the current shape, from which move() and restore() start.
    virtual void remember() = 0;

    //! Sets the saved shape, moved by share * step.change.
    virtual void move(const NewtonStep& step, double share) = 0;

    virtual void restore() = 0;
};

//! Criteria of convergence, and limits.
struct NewtonLimits
{
    const char* what = "";    //!< as Convergence::what
    const char* unit = "mm";  //!< of lengths
    int most_rounds = 100;    //!< most steps
    double settled = 1e-9;    //!< a whole step this short has converged; from the accuracy of 1e-9
    double finest = 1e-15;    //!< no step follows one this short; from doubles
    double squares_below =
        0.0;            //!< below it, steps that shrink tenfold converge quadratically; 0: never
    double left = 0.0;  //!< largest error after such a step
    int models = 1;
    int remembered = 1;    //!< a whole step of model 0 may rise to the largest of these values
    double noise = 1e-14;  //!< rounding of the value, relative; from doubles, 50 units
    double unseen_gain = 1e-13;  //!< relative; rounding hides a smaller decrement
    const char* task = nullptr;  //!< for progress: "laying flat"; nullptr: no reports
};

//! Moves a shape to a minimum of its value by Newton's method with a line search.
//! It has converged if the whole step of an exact, positive definite model is short, or if that
//! step cannot lower the value because its decrement is below rounding. A step that a bound or the
//! line search has shortened does not show convergence, and neither does a missing step.
//! \throws Cancelled if the progress callback requests it
[[nodiscard]] Convergence newton_minimum(NewtonProblem& problem, const NewtonLimits& limits,
                                         const Progress& progress = {});

}  // namespace sheetmorph::numerics
