// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace sheetmorph
{

//! How far an answer goes: `live` one substitution, and weights of control meshes in 24 bits (1e-6
//! of the size or better), `exact` refined on the factored residual, for what is kept or written.
enum class Exactness
{
    live,
    exact
};

}  // namespace sheetmorph
