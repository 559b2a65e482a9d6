// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/thin/thin_solid.h"

namespace sheetmorph::recognise
{

//! The vertex whose thickness changes most.
struct ThicknessPlace
{
    int vertex = -1;                    //!< -1 if nothing was measured
    double rest = 0.0, deformed = 0.0;  //!< mm
};

//! The thickness of a thin solid at rest and in one pose, mm, from the vertices of each skin to the
//! other. Lumps are excluded.
struct ThicknessChange
{
    double rest_least = 0.0, rest_most = 0.0;
    double least = 0.0, most = 0.0;
    double worst = 0.0;           //!< largest |t / t_rest - 1| away from walls
    double worst_at_walls = 0.0;  //!< the same at vertices on a wall
    ThicknessPlace place;         //!< of the larger of the two
};

//! \param mesh       at rest
//! \param positions  (n, 3) mm, of the whole part in one pose
ThicknessChange thickness_change(const mesh::TriangleMesh& mesh, const ThinSolid& solid,
                                 const Points& positions);

}  // namespace sheetmorph::recognise
