// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/inward_probes.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/topology/submesh.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::recognise
{

namespace
{

constexpr int most_looks = 64;            // of a facet; chosen: more show no new neighbour
constexpr Eigen::Index least_looks = 50;  // fewest for a thread; chosen, not measured

// Target number of rays. From statistics: shares of the surface are exact to 1 / sqrt(2000) = 2 %.
constexpr double looks_a_component = 2000.0;

// Cosine of 135 degrees. Chosen: the two skins of a sheet with a draft or an end taper face each
// other to 45 degrees.
constexpr double facing = -0.70710678118654752;

// Depth of the ray origin below the surface, relative to the square root of the component's area.
// Chosen as in across_sheet.cpp.
constexpr double first_step = 1e-7;

// Low-discrepancy barycentric coordinates (R2 sequence, Roberts 2018).
Vector3 spread(int k)
{
    double u = std::fmod(0.5 + 0.7548776662466927 * (k + 1), 1.0);
    double v = std::fmod(0.5 + 0.5698402909980532 * (k + 1), 1.0);
    if (u + v > 1.0)
    {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    return {1.0 - u - v, u, v};
}

// One closed component, isolated so that its rays end inside it whatever touches it.
class ComponentProbe
{
public:
    ComponentProbe(const mesh::TriangleMesh& mesh, const FacetGraph& graph, std::vector<int> facets)
        : mesh_(mesh),
          graph_(graph),
          facets_(std::move(facets)),
          tree_(mesh::submesh(mesh, facets_).mesh)
    {
        for (const int facet : facets_)
            area_ += graph.area(facet);
    }

    void look(std::vector<InwardProbe>& probes) const
    {
        struct Look
        {
            int facet, index, of;
        };
        std::vector<Look> looks;
        for (const int facet : facets_)
        {
            if (graph_.is_thin(facet))
                continue;
            const double share = graph_.area(facet) / area_ * looks_a_component;
            const int count = std::clamp(static_cast<int>(std::ceil(share)), 1, most_looks);
            for (int k = 0; k < count; ++k)
                looks.push_back({facet, k, count});
        }
        const std::size_t first = probes.size();
        probes.resize(first + looks.size());
        parallel_ranges(static_cast<Eigen::Index>(looks.size()), least_looks,
                        [&](Eigen::Index begin, Eigen::Index end)
                        {
                            for (auto k = static_cast<std::size_t>(begin);
                                 k < static_cast<std::size_t>(end); ++k)
                            {
                                const auto& [facet, index, of] = looks[k];
                                const Vector3 middle = Vector3::Constant(1.0 / 3.0);
                                probes[first + k] =
                                    probe(facet, of == 1 ? middle : spread(index), of);
                            }
                        });
    }

private:
    InwardProbe probe(int facet, const Vector3& place, int looks) const
    {
        const Vector3 normal = graph_.normal(facet);
        Vector3 start = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            start += place(k) * mesh_.points().row(mesh_.triangles()(facet, k)).transpose();
        const double step = first_step * std::sqrt(area_);
        const std::optional<mesh::Hit> hit = tree_.nearest_hit(start - step * normal, -normal);
        InwardProbe found{facet, -1, 0.0, graph_.area(facet) / looks, false};
        if (!hit)
            return found;
        found.opposite = facets_[static_cast<std::size_t>(hit->triangle)];
        found.distance = hit->distance + step;
        found.is_facing = graph_.normal(found.opposite).dot(normal) < facing;
        return found;
    }

    const mesh::TriangleMesh& mesh_;
    const FacetGraph& graph_;
    std::vector<int> facets_;
    mesh::PickingTree tree_;
    double area_ = 0.0;
};

}  // namespace

std::vector<InwardProbe> inward_probes(const mesh::TriangleMesh& mesh, const FacetGraph& graph)
{
    std::vector<std::vector<int>> facets(at(graph.component_count()));
    for (int t = 0; t < graph.triangle_count(); ++t)
        facets[static_cast<std::size_t>(graph.component(t))].push_back(t);
    std::vector<InwardProbe> probes;
    for (std::size_t k = 0; k < facets.size(); ++k)
        if (graph.is_closed(static_cast<int>(k)))
            ComponentProbe(mesh, graph, std::move(facets[k])).look(probes);
    return probes;
}

}  // namespace sheetmorph::recognise
