// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sstream>
#include <string>

namespace sheetmorph
{

//! How far an answer goes: `live` one substitution, and weights of control meshes in 24 bits (1e-6
//! of the size or better), `exact` refined on the factored residual, for what is kept or written.
enum class Exactness
{
    live,
    exact
};

//! How a computation in rounds ended. None gives up in silence: what it returns goes on to the
//! answer it is part of.
struct Convergence
{
    const char* what = "";     //!< it settles, for messages: "the turns of form features"
    bool is_converged = true;  //!< or its rounds ended before
    int rounds = 0;
    double miss = 0.0;        //!< what its last round still had to change
    const char* unit = "mm";  //!< of that: "mm", "radians"

    //! The one that is to be told of two that an answer rests on.
    void join(const Convergence& other)
    {
        if (is_converged && (!other.is_converged || other.rounds > rounds))
            *this = other;
    }

    //! "the rotations of form features did not converge in 100 iterations (the last one still
    //! changed 0.02 radians)";
    //! empty if they have.
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
