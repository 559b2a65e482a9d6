// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/sizes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace sheetmorph::repair
{

namespace
{

// Relative to the target edge length. Chosen: a smaller size would need 900 times the triangles.
constexpr double finest = 1.0 / 30.0;

// Edges next to a ridge, relative to its shortest segment. Chosen just below too_long (4/3), so
// that no segment of a ridge is longer than its neighbours allow.
constexpr double per_segment = 1.3;

// Edges on a bend, relative to its radius. From geometry: 20 degrees each (the crease_angle of the
// options), 1.5 % of the radius from the arc.
constexpr double per_radius = 0.35;

// Radians; a smaller bend counts as flat. From files with seven digits: normals of facets a
// thousandth of the part wide are exact to 1e-4. Chosen 30 times larger.
constexpr double least_bend = 0.003;

double length(const mesh::TriangleMesh& mesh, const mesh::EdgeUse& use)
{
    return (mesh.points().row(use.to) - mesh.points().row(use.from)).norm();
}

// Height of a triangle on one of its edges, mm.
double height(const mesh::TriangleMesh& mesh, const mesh::EdgeUse& use)
{
    const Vector3 way = mesh.points().row(use.to) - mesh.points().row(use.from);
    const Vector3 across = mesh.points().row(use.opposite) - mesh.points().row(use.from);
    return way.cross(across).norm() / std::max(way.norm(), 1e-300);
}

// Radius of curvature at an edge: mean height of its two facets divided by the bend, mm.
double radius(const mesh::TriangleMesh& mesh, const mesh::EdgeUses& uses, double bend)
{
    return 0.5 * (height(mesh, *uses.begin()) + height(mesh, *(uses.begin() + 1))) / bend;
}

// Limits the growth of sizes along edges with Dijkstra's algorithm, from small to large.
void grow_slowly(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                 std::vector<double>& size)
{
    std::vector<std::vector<std::pair<int, double>>> neighbours(size.size());
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const mesh::EdgeUse& use = *table.uses(edge).begin();
        neighbours[use.from].emplace_back(use.to, length(mesh, use));
        neighbours[use.to].emplace_back(use.from, length(mesh, use));
    }
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    for (std::size_t i = 0; i < size.size(); ++i)
        waiting.emplace(size[i], static_cast<int>(i));
    while (!waiting.empty())
    {
        const auto [here, vertex] = waiting.top();
        waiting.pop();
        if (here > size[vertex])
            continue;
        for (const auto& [other, distance] : neighbours[vertex])
            if (here + size_growth * distance < size[other])
            {
                size[other] = here + size_growth * distance;
                waiting.emplace(size[other], other);
            }
    }
}

}  // namespace

std::vector<double> wanted_sizes(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                                 const Patches& patches, const SizeLimits& limits)
{
    const double edge_length = limits.edge;
    std::vector<double> size(static_cast<std::size_t>(mesh.vertex_count()), edge_length);
    const auto limit = [&](const mesh::EdgeUse& use, double wanted)
    {
        const double most = std::max(wanted, finest * edge_length);
        size[use.from] = std::min(size[use.from], most);
        size[use.to] = std::min(size[use.to], most);
    };
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const mesh::EdgeUses uses = table.uses(edge);
        const mesh::EdgeUse& use = *uses.begin();
        if (patches.is_ridge[edge])
            limit(use, per_segment * length(mesh, use));
        const double bend =
            uses.count() == 2 ? mesh::bend_angle(mesh.points(), use, *(uses.begin() + 1)) : 0.0;
        const bool is_curved =
            uses.count() == 2
            && (!patches.is_flat[patches.patch[use.triangle]]
                || !patches.is_flat[patches.patch[(uses.begin() + 1)->triangle]]);
        if (is_curved && !patches.is_ridge[edge] && bend > least_bend)
            limit(use, std::max(per_radius * radius(mesh, uses, bend), 0.125 * edge_length));
    }
    for (std::size_t i = 0; i < size.size(); ++i)
        size[i] = std::min(size[i], std::max(limits.at_vertices[i], finest * edge_length));
    grow_slowly(mesh, table, size);
    return size;
}

}  // namespace sheetmorph::repair
