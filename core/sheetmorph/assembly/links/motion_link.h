// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/part_geometry.h"
#include "sheetmorph/surface/solve/deformation.h"
#include "sheetmorph/volume/oriented_box.h"
#include "sheetmorph/volume/volume_link.h"

#include <memory>
#include <optional>

namespace sheetmorph::assembly
{

//! A control mesh for display.
struct ShownControlMesh
{
    Points vertices;      //!< (m, 3) mm
    Triangles triangles;  //!< (t, 3)
};

//! Transfers the motion of a source region to target points on other parts.
class MotionLink
{
public:
    virtual ~MotionLink() = default;

    //! \param source  the source part in one pose
    //! \returns       positions and rotations of the targets, rows in their given order
    virtual volume::LinkedTargets transfer(const surface::Deformation& source,
                                           Exactness exactness) const = 0;

    //! The vertices of the source part whose positions and logs transfer() reads, ascending.
    virtual VertexIds reads() const = 0;

    //! The control mesh in that pose; nothing if the link has none.
    virtual std::optional<ShownControlMesh> control_mesh(
        const surface::Deformation& source) const = 0;
};

//! Input of every link; read only during construction.
struct MotionLinkInput
{
    const mesh::PartGeometry& source_part;
    const VertexIds& source;
    const Points& targets;  //!< (k, 3) mm at rest
};

//! Options of a link's control mesh.
struct ControlMeshOptions
{
    volume::OrientedBox box;
    int levels = 3;
    double smoothness = 0.05;
};

//! The method of the paper: source -> control mesh (3.3) -> targets (2.11). Sources of more than
//! 2,000 vertices are sampled.
std::unique_ptr<MotionLink> control_mesh_link(const MotionLinkInput& input,
                                              const ControlMeshOptions& options);

//! Every target keeps its position relative to the nearest triangle of the source region and its
//! frame, as *TIE of FE codes does: p = q + R (p_hat - q_hat). So the gap keeps its length.
std::unique_ptr<MotionLink> tied_link(const MotionLinkInput& input);

}  // namespace sheetmorph::assembly
