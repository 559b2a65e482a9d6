// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/region_loops.h"

#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/mesh/topology/boundary.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace sheetmorph::recognise
{

namespace
{

constexpr int none = -1;

// Area over squared perimeter; a loop with less is a slit. From geometry: a circle has 1 / (4 pi),
// a rectangle w / (4 l): 1/600 as wide as long. Chosen below the narrowest laser cut, 0.2 mm over
// 100 mm.
constexpr double slimmest = 4e-4;

// The mesh cut along the borders of its regions: every region has its own vertices.
struct CutMesh
{
    mesh::TriangleMesh mesh;
    VertexIds welded;         // by vertex: the vertex of the merged mesh
    std::vector<int> region;  // by vertex
};

CutMesh cut_apart(const FacetGraph& graph, const std::vector<int>& labels)
{
    const Triangles& triangles = graph.mesh().triangles();
    std::vector<std::pair<int, int>> corners;  // vertex, region
    corners.reserve(static_cast<std::size_t>(triangles.size()));
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            corners.emplace_back(triangles(t, k), labels[t]);
    std::vector<std::pair<int, int>> distinct = corners;
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    CutMesh cut;
    Points points(distinct.size(), 3);
    for (std::size_t i = 0; i < distinct.size(); ++i)
    {
        points.row(static_cast<Eigen::Index>(i)) = graph.point(distinct[i].first).transpose();
        cut.welded.push_back(distinct[i].first);
        cut.region.push_back(distinct[i].second);
    }
    Triangles ids(triangles.rows(), 3);
    for (Eigen::Index k = 0; k < ids.size(); ++k)
        ids.data()[k] = static_cast<int>(
            std::lower_bound(distinct.begin(), distinct.end(), corners[k]) - distinct.begin());
    cut.mesh = mesh::TriangleMesh(std::move(points), std::move(ids));
    return cut;
}

int side_between(const FacetGraph& graph, int triangle, int a, int b)
{
    for (int k = 0; k < 3; ++k)
    {
        const int from = graph.mesh().triangles()(triangle, k);
        const int to = graph.mesh().triangles()(triangle, (k + 1) % 3);
        if ((from == a && to == b) || (from == b && to == a))
            return k;
    }
    return none;
}

class LoopMeasure
{
public:
    LoopMeasure(const FacetGraph& graph, const CutMesh& cut)
        : graph_(graph), cut_(cut), edges_(mesh::boundary_edges(cut.mesh))
    {
    }

    RegionLoop measured(const VertexIds& cut_loop) const
    {
        RegionLoop loop;
        loop.region = cut_.region[cut_loop.front()];
        for (const int vertex : cut_loop)
            loop.vertices.push_back(cut_.welded[vertex]);
        const Points points = graph_.mesh().points()(loop.vertices, Eigen::indexing::all);
        const Vector3 doubled = fitting::doubled_area(points);
        loop.area = 0.5 * doubled.norm();
        loop.normal = doubled.normalized();
        loop.center = points.colwise().mean().transpose();
        add_edges(cut_loop, loop);
        return loop;
    }

private:
    int triangle_at(int a, int b) const
    {
        const auto key = std::minmax(a, b);
        const auto is_before = [](const mesh::BoundaryEdge& edge, const std::pair<int, int>& wanted)
        { return std::pair(std::min(edge.from, edge.to), std::max(edge.from, edge.to)) < wanted; };
        return std::lower_bound(edges_.begin(), edges_.end(), std::pair(key.first, key.second),
                                is_before)
            ->triangle;
    }

    void add_edges(const VertexIds& cut_loop, RegionLoop& loop) const
    {
        double perimeter = 0.0;
        const std::size_t count = cut_loop.size();
        for (std::size_t i = 0; i < count; ++i)
        {
            const int triangle = triangle_at(cut_loop[i], cut_loop[(i + 1) % count]);
            const int a = loop.vertices[i];
            const int b = loop.vertices[(i + 1) % count];
            const int side = side_between(graph_, triangle, a, b);
            loop.triangles.push_back(triangle);
            loop.across.push_back(graph_.across(triangle, side));
            const int edge = graph_.edges().edge_of(triangle, side);
            loop.free_edges += edge >= 0 && graph_.edges().uses(edge).count() == 1;
            const Vector3 span = graph_.point(b) - graph_.point(a);
            const int tip = graph_.mesh().triangles()(triangle, (side + 2) % 3);
            Vector3 inwards = graph_.point(tip) - graph_.point(a);
            inwards -= inwards.dot(span) / std::max(span.squaredNorm(), 1e-300) * span;
            perimeter += span.norm();
            loop.inwards += inwards.normalized().dot(loop.normal.cross(span));
        }
        loop.inwards /= std::max(perimeter, 1e-300);
        if (loop.area < slimmest * perimeter * perimeter)
            loop.area = 0.0;
    }

    const FacetGraph& graph_;
    const CutMesh& cut_;
    std::vector<mesh::BoundaryEdge> edges_;
};

}  // namespace

std::vector<RegionLoop> region_loops(const FacetGraph& graph, const std::vector<int>& labels)
{
    const CutMesh cut = cut_apart(graph, labels);
    const LoopMeasure measure(graph, cut);
    std::vector<RegionLoop> loops;
    for (const VertexIds& cut_loop : mesh::boundary_loops(cut.mesh))
    {
        if (cut_loop.size() < 3)
            continue;
        RegionLoop loop = measure.measured(cut_loop);
        if (loop.area > 0.0)
            loops.push_back(std::move(loop));
    }
    std::stable_sort(loops.begin(), loops.end(),
                     [](const RegionLoop& a, const RegionLoop& b) { return a.region < b.region; });
    return loops;
}

}  // namespace sheetmorph::recognise
