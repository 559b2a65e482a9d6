// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/bodies/body_motions.h"

namespace sheetmorph::surface
{

//! A rotating body: its rotation or position is an unknown of the energy together with the sheet.
//! It is a body with a free rotation, a motion or a link, or a point with a free rotation.
struct Turner
{
    int body = -1;
    int point = -1;
    bool turns = true;      //!< the energy determines its rotation; else the pose or the field
    bool is_bound = false;  //!< a motion or link restricts its translation
    VertexIds vertices;     //!< vertices at which the sheet rotates fully with it
    bool shifts = false;    //!< its translation is unknown too, if no sheet is solved for

    //! Whether its rotation is part of the reduced problem. A motion or link leaves part of the
    //! rotation unknown, even if the field determines it.
    bool is_turned() const { return turns || is_bound; }
};

//! Lists bodies first, leaders before their followers, then points.
std::vector<Turner> turners_of(const mesh::TriangleMesh& mesh,
                               const SurfaceConstraints& constraints, const VertexRoles& roles);

//! Sets the rotation of every rotating body to zero.
BodyMotions unmoved_turners(const std::vector<Turner>& turners, BodyMotions bodies);

}  // namespace sheetmorph::surface
