// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/links/motion_link.h"
#include "sheetmorph/mesh/geometry/normals.h"
#include "sheetmorph/mesh/geometry/operators.h"
#include "sheetmorph/mesh/quality/median.h"
#include "sheetmorph/mesh/topology/components.h"
#include "sheetmorph/volume/local_rotations.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// A fit to more points than this gains nothing: a control mesh has a few hundred vertices.
constexpr std::size_t most_samples = 2000;

// Vertices of triangles: only these have an area and a normal of their own. All, if there is none.
VertexIds on_the_sheet(const TriangleMesh& mesh, const VertexIds& source)
{
    const std::vector<int> label = connected_components(mesh).label;
    VertexIds found;
    for (const int vertex : source)
        if (label[static_cast<std::size_t>(vertex)] != Components::unused)
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
double median_edge(const TriangleMesh& mesh, const VertexIds& source)
{
    std::vector<char> inside(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (const int vertex : source)
        inside[static_cast<std::size_t>(vertex)] = 1;
    std::vector<double> lengths;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = mesh.triangles()(t, k);
            const int b = mesh.triangles()(t, (k + 1) % 3);
            if (inside[static_cast<std::size_t>(a)] || inside[static_cast<std::size_t>(b)])
                lengths.push_back((mesh.points().row(a) - mesh.points().row(b)).norm());
        }
    return median(std::move(lengths));
}

LinkSource link_source(const TriangleMesh& mesh, const VertexIds& samples)
{
    LinkSource source;
    source.points = rows_of(mesh.points(), samples);
    source.normals = rows_of(vertex_normals(mesh.points(), mesh.triangles()), samples);
    const Eigen::VectorXd areas = voronoi_areas(mesh);
    source.areas.resize(static_cast<Eigen::Index>(samples.size()));
    for (std::size_t k = 0; k < samples.size(); ++k)
        source.areas(static_cast<Eigen::Index>(k)) = areas(samples[k]);
    return source;
}

LinkOptions link_options(const MotionLinkInput& input, const ControlMeshOptions& options)
{
    LinkOptions chosen;
    chosen.smoothness = options.smoothness;
    chosen.offset = median_edge(input.source_mesh, input.source);
    return chosen;
}

class ControlMeshLink : public MotionLink
{
public:
    ControlMeshLink(const MotionLinkInput& input, const ControlMeshOptions& options)
        : samples_(sampled(on_the_sheet(input.source_mesh, input.source))),
          source_(link_source(input.source_mesh, samples_)),
          meter_(input.source_mesh, samples_),
          control_(ControlShape(options.levels), options.box),
          link_(control_, source_, input.targets, link_options(input, options))
    {
    }

    LinkedTargets transfer(const Deformation& source) const override
    {
        return link_.transfer(state_of(source));
    }

    VertexIds reads() const override { return meter_.reads(); }

    std::optional<ShownControlMesh> control_mesh(const Deformation& source) const override
    {
        return ShownControlMesh{link_.control_vertices(state_of(source)),
                                control_.shape.triangles()};
    }

private:
    SourceState state_of(const Deformation& source) const
    {
        LocalRotations turned =
            meter_.measure(source.positions, rows_of(source.rotation_logs, samples_));
        SourceState state;
        state.positions = rows_of(source.positions, samples_);
        state.mean = mean_motion(source_.points, state.positions, turned, source_.areas);
        state.rotations = std::move(turned.matrices);
        state.logs = std::move(turned.logs);
        return state;
    }

    VertexIds samples_;
    LinkSource source_;
    LocalRotationMeter meter_;
    ControlMesh control_;
    VolumeLink link_;
};

}  // namespace

std::unique_ptr<MotionLink> control_mesh_link(const MotionLinkInput& input,
                                              const ControlMeshOptions& options)
{
    return std::make_unique<ControlMeshLink>(input, options);
}

}  // namespace sheetmorph
