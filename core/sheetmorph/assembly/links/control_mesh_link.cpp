// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/links/motion_link.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/geometry/components.h"
#include "sheetmorph/mesh/geometry/normals.h"
#include "sheetmorph/mesh/geometry/operators.h"
#include "sheetmorph/mesh/quality/median.h"
#include "sheetmorph/mesh/topology/orientation.h"
#include "sheetmorph/volume/local_rotations.h"

#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

// Points of a fit. Chosen: five for each of the 386 vertices of a control mesh; more gain nothing.
constexpr std::size_t most_samples = 2000;

// Largest distance of offset samples from the middle of the box, in half extents. From the mean
// value coordinates: they lose digits with the cube of the distance and are exact to 1e-12 within
// 10. Farther away the fit has no minimum.
constexpr double farthest_offset = 10.0;

// Widens the box of a region that is small compared with the edges around it, so that offsets fit.
volume::OrientedBox around_offsets(volume::OrientedBox box, double offset)
{
    const Vector3 before = box.half_extents;
    box.half_extents = before.cwiseMax(offset / farthest_offset);
    box.widened_by += box.half_extents - before;
    return box;
}

// The vertices of a region that belong to triangles of some extent, because only these have an area
// and a normal. All vertices if there are none.
VertexIds on_the_sheet(const mesh::Submesh& patch, const VertexIds& source)
{
    const std::vector<int> label = mesh::connected_components(patch.mesh).label;
    VertexIds found;
    for (const int vertex : source)
        if (const int row = patch.index_of[at(vertex)];
            row >= 0 && label[at(row)] != mesh::Components::unused)
            found.push_back(vertex);
    return found.empty() ? source : found;
}

VertexIds sampled(const VertexIds& source)
{
    const std::size_t stride = (source.size() + most_samples - 1) / most_samples;
    VertexIds samples;
    for (std::size_t k = 0; k < source.size(); k += std::max<std::size_t>(stride, 1))
        samples.push_back(source[k]);
    return samples;
}

// h of the offset samples: the median length of the edges at the source.
double median_edge(const mesh::Submesh& patch, const VertexIds& source)
{
    std::vector<char> inside(patch.index_of.size(), 0);
    for (const int vertex : source)
        inside[at(vertex)] = 1;
    std::vector<double> lengths;
    const mesh::TriangleMesh& mesh = patch.mesh;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = mesh.triangles()(t, k);
            const int b = mesh.triangles()(t, (k + 1) % 3);
            if (inside[at(patch.vertices[at(a)])] || inside[at(patch.vertices[at(b)])])
                lengths.push_back((mesh.points().row(a) - mesh.points().row(b)).norm());
        }
    return mesh::median(std::move(lengths));
}

volume::LinkSource link_source(const mesh::TriangleMesh& mesh, const mesh::Submesh& patch,
                               const VertexIds& samples)
{
    volume::LinkSource source;
    source.points = rows_of(mesh.points(), samples);
    source.normals = Eigen::RowVector3d::UnitZ().replicate(source.points.rows(), 1);
    source.areas = Eigen::VectorXd::Zero(source.points.rows());
    // Triangles of a deck may have mixed orientations, and normals of neighbours must not cancel.
    const mesh::TriangleMesh facing = mesh::oriented(
        patch.mesh, mesh::consistent_orientation(patch.mesh, mesh::EdgeTable(patch.mesh)));
    const Points normals = mesh::vertex_normals(facing.points(), facing.triangles());
    const Eigen::VectorXd areas = mesh::voronoi_areas(patch.mesh);
    for (Eigen::Index k = 0; k < source.areas.size(); ++k)
        if (const int row = patch.index_of[at(samples[at(k)])]; row >= 0)
        {
            source.normals.row(k) = normals.row(row);
            source.areas(k) = areas(row);
        }
    return source;
}

//! The source of a link, with the triangles around it.
struct Source
{
    Source(const mesh::PartGeometry& part, const VertexIds& region)
        : Source(part, region, part.patch(region))
    {
    }

    Source(const mesh::PartGeometry& part, const VertexIds& region, const mesh::Submesh& patch)
        : vertices(sampled(on_the_sheet(patch, region))),
          samples(link_source(part.mesh(), patch, vertices)),
          edge(median_edge(patch, region))
    {
    }

    VertexIds vertices;
    volume::LinkSource samples;
    double edge;  // mm
};

class ControlMeshLink : public MotionLink
{
public:
    ControlMeshLink(const MotionLinkInput& input, const ControlMeshOptions& options)
        : source_(input.source_part, input.source),
          meter_(input.source_part, source_.vertices),
          control_(volume::ControlShape::shared(options.levels),
                   around_offsets(options.box, source_.edge)),
          link_(control_, source_.samples, input.targets, {options.smoothness, source_.edge})
    {
    }

    volume::LinkedTargets transfer(const surface::Deformation& source,
                                   Exactness exactness) const override
    {
        return link_.transfer(state_of(source), exactness);
    }

    VertexIds reads() const override { return meter_.reads(); }

    std::optional<ShownControlMesh> control_mesh(const surface::Deformation& source) const override
    {
        return ShownControlMesh{link_.control_vertices(state_of(source)),
                                control_.shape.triangles()};
    }

private:
    volume::SourceState state_of(const surface::Deformation& source) const
    {
        volume::LocalRotations turned =
            meter_.measure(source.positions, rows_of(source.rotation_logs, source_.vertices));
        volume::SourceState state;
        state.positions = rows_of(source.positions, source_.vertices);
        state.mean = volume::mean_motion(source_.samples.points, state.positions, turned,
                                         source_.samples.areas);
        state.rotations = std::move(turned.matrices);
        state.logs = std::move(turned.logs);
        return state;
    }

    Source source_;
    volume::LocalRotationMeter meter_;
    volume::ControlMesh control_;
    volume::VolumeLink link_;
};

}  // namespace

std::unique_ptr<MotionLink> control_mesh_link(const MotionLinkInput& input,
                                              const ControlMeshOptions& options)
{
    return std::make_unique<ControlMeshLink>(input, options);
}

}  // namespace sheetmorph::assembly
