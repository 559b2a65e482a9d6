// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/links/patch_anchors.h"
#include "sheetmorph/assembly/session/deformation_session.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::assembly::frames
{

//! The worst change of the distance of a driven vertex to the place below it at rest, mm. That
//! place goes along with its triangle, so sliding counts.
inline double gap_change(const Assembly& assembly, const ContactFidelity& fidelity,
                         const Deformed& shape)
{
    const auto at = [](int part) { return static_cast<std::size_t>(part); };
    const Contact& contact = assembly.contacts[at(fidelity.contact)];
    const bool is_reversed = contact.a.part != fidelity.source_part;
    const PartRegion& source = is_reversed ? contact.b : contact.a;
    const PartRegion& target = is_reversed ? contact.a : contact.b;
    const mesh::PartGeometry below(assembly.parts[at(source.part)].mesh);
    const Points rest = rows_of(assembly.parts[at(target.part)].mesh.points(), target.vertices);
    const Points now = rows_of(shape.parts[at(target.part)].positions, target.vertices);
    // A wall, or a row of vertices, has no triangles of its own.
    const bool is_wide =
        assembly.parts[at(source.part)].thin != Thin::no || !has_triangles(below, source.vertices);
    const std::vector<mesh::Anchor> anchors = nearest_anchors(
        below, is_wide ? with_triangles_below(below, source.vertices, rest) : source.vertices,
        rest);
    double worst = 0.0;
    for (Eigen::Index k = 0; k < rest.rows(); ++k)
    {
        const mesh::Anchor& anchor = anchors[static_cast<std::size_t>(k)];
        const double before = (rest.row(k).transpose() - anchor.on(below.mesh().points())).norm();
        const Vector3 place = anchor.on(shape.parts[at(source.part)].positions);
        worst = std::max(worst, std::abs((now.row(k).transpose() - place).norm() - before));
    }
    return worst;
}

}  // namespace sheetmorph::assembly::frames
