// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sstream>
#include <string>

namespace sheetmorph
{

//! How exact a solution is. `live`: one back-substitution, and weights of control meshes in 24 bits
//! (1e-6 of the size or better). `exact`: refined on the residual in factored form, for results
//! that are kept or written.
enum class Exactness
{
    live,
    exact
};

//! How an iteration ended. Every iteration reports it, because its result enters a larger answer.
struct Convergence
{
    const char* what = "";     //!< it settles, for messages: "the turns of form features"
    bool is_converged = true;  //!< false if the limit on rounds ended it
    int rounds = 0;
    double miss = 0.0;        //!< size of the last change
    const char* unit = "mm";  //!< of that: "mm", "radians"

    //! Keeps the worse of two reports.
    void join(const Convergence& other)
    {
        if (is_converged && (!other.is_converged || other.rounds > rounds))
            *this = other;
    }

    //! "the rotations of form features did not converge in 100 iterations (the last one still
    //! changed 0.02 radians)"; empty if the iteration has converged.
    std::string sentence() const
    {
        std::ostringstream text;
        text.precision(2);
        if (!is_converged)
            text << what << " did not converge in " << rounds
                 << (rounds == 1 ? " iteration" : " iterations") << " (the last one still changed "
                 << miss << " " << unit << ")";
        return text.str();
    }
};

}  // namespace sheetmorph
