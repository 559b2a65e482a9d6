// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/bodies/body_motions.h"

namespace sheetmorph::surface
{

//! Something whose rotation or place the energy decides together with the sheet: a body that turns
//! freely or keeps a motion or a link, or a point whose rotation is free.
struct Turner
{
    int body = -1;
    int point = -1;
    bool turns = true;      //!< its rotation is the energy's, else the pose or the field knows it
    bool is_bound = false;  //!< its translation is not the sheet's own either
    VertexIds vertices;     //!< where the sheet turns wholly with it
    bool shifts = false;    //!< its translation is sought besides, where no sheet is solved for

    //! Its rotation is one of the reduced problem: what a motion or a link leaves of a rotation,
    //! the field's too, only that knows.
    bool is_turned() const { return turns || is_bound; }
};

//! Bodies first, leaders of links before their followers; then points.
std::vector<Turner> turners_of(const mesh::TriangleMesh& mesh,
                               const SurfaceConstraints& constraints, const VertexRoles& roles);

//! Bodies with every turner where it was at rest.
BodyMotions unmoved_turners(const std::vector<Turner>& turners, BodyMotions bodies);

}  // namespace sheetmorph::surface
