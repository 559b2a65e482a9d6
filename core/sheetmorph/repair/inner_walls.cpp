// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/inner_walls.h"

#include "sheetmorph/base/disjoint_sets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace sheetmorph::repair
{

namespace
{

// Relative to a wall's area: largest deviation from flatness, and from facing the other wall. From
// files with seven digits: an area is exact to 1e-6. Chosen ten times larger.
constexpr double rounding = 1e-5;

struct Side
{
    int low, high;  // vertices
    int triangle, k;

    bool is_at(const Side& other) const { return low == other.low && high == other.high; }
};

// The sides of triangles that share an edge. Unlike EdgeTable, it counts each side of duplicate
// triangles.
using Edge = std::vector<Side>;

std::vector<Edge> edges_of(const mesh::TriangleMesh& mesh)
{
    std::vector<Side> sides;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const auto [low, high] =
                std::minmax({mesh.triangles()(t, k), mesh.triangles()(t, (k + 1) % 3)});
            sides.push_back({low, high, t, k});
        }
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) {
                  return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
              });
    std::vector<Edge> edges;
    for (const Side& side : sides)
    {
        if (edges.empty() || !edges.back().front().is_at(side))
            edges.emplace_back();
        edges.back().push_back(side);
    }
    return edges;
}

// By triangle: its piece, named by the piece's first triangle. Triangles connect across edges of
// exactly two triangles.
std::vector<int> pieces_of(const mesh::TriangleMesh& mesh, const std::vector<Edge>& edges)
{
    DisjointSets sets(mesh.triangle_count());
    for (const Edge& edge : edges)
        if (edge.size() == 2)
            sets.join(edge.front().triangle, edge.back().triangle);
    std::vector<int> piece;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        piece.push_back(sets.root(t));
    return piece;
}

// Pairs of pieces that share vertices, and the pieces at each vertex.
struct Touching
{
    std::vector<std::set<int>> at;  // by vertex
    std::set<std::pair<int, int>> pairs;

    Touching(const mesh::TriangleMesh& mesh, const std::vector<int>& piece)
        : at(static_cast<std::size_t>(mesh.vertex_count()))
    {
        for (int t = 0; t < mesh.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k)
                at[mesh.triangles()(t, k)].insert(piece[t]);
        for (const std::set<int>& here : at)
            for (const int one : here)
                for (const int other : here)
                    if (one != other)
                        pairs.emplace(one, other);
    }

    bool touches_any(int piece) const
    {
        const auto next = pairs.lower_bound({piece, -1});
        return next != pairs.end() && next->first == piece;
    }

    // Whether all pieces at a vertex touch the given piece, and none is that piece.
    bool is_across(int vertex, int piece) const
    {
        return std::all_of(at[vertex].begin(), at[vertex].end(),
                           [&](int other) {
                               return pairs.count({piece, other}) > 0;
                           });
    }
};

struct Wall
{
    std::vector<int> outline;  // edges, ascending
    Vector3 area = Vector3::Zero();
    double size = 0.0;  // mm^2
};

std::map<int, Wall> walls_of(const mesh::TriangleMesh& mesh, const std::vector<Edge>& edges,
                             const std::vector<int>& piece)
{
    std::map<int, Wall> walls;
    for (std::size_t edge = 0; edge < edges.size(); ++edge)
        for (const Side& side : edges[edge])
            if (edges[edge].size() > 3)
                walls[piece[side.triangle]].outline.push_back(static_cast<int>(edge));
    for (const Edge& edge : edges)
        for (const Side& side : edge)
            if (edge.size() == 1 || edge.size() == 3)
                walls.erase(piece[side.triangle]);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (const auto wall = walls.find(piece[t]); wall != walls.end())
        {
            const Eigen::RowVector3i corners = mesh.triangles().row(t);
            const Vector3 a = mesh.points().row(corners(1)) - mesh.points().row(corners(0));
            const Vector3 b = mesh.points().row(corners(2)) - mesh.points().row(corners(0));
            wall->second.area += 0.5 * a.cross(b);
            wall->second.size += 0.5 * a.cross(b).norm();
        }
    return walls;
}

bool are_face_to_face(const Wall& one, const Wall& other)
{
    const double allowed = rounding * one.size;
    return std::abs(one.area.norm() - one.size) < allowed
           && std::abs(other.area.norm() - other.size) < allowed
           && (one.area + other.area).norm() < allowed;
}

}  // namespace

std::vector<mesh::TJunction> seam_junctions(const mesh::TriangleMesh& mesh, double tolerance)
{
    const std::vector<Edge> edges = edges_of(mesh);
    const std::vector<int> piece = pieces_of(mesh, edges);
    const Touching touching(mesh, piece);
    std::vector<mesh::TJunction> found;
    if (touching.pairs.empty())
        return found;
    std::vector<mesh::BoundaryEdge> seams;
    for (const Edge& edge : edges)
        for (const Side& side : edge)
            if (edge.size() == 2 && touching.touches_any(piece[side.triangle]))
                seams.push_back({mesh.triangles()(side.triangle, side.k),
                                 mesh.triangles()(side.triangle, (side.k + 1) % 3), side.triangle});
    std::map<std::pair<int, int>, int> triangle_at;
    for (const mesh::BoundaryEdge& edge : seams)
        triangle_at[{edge.from, edge.to}] = edge.triangle;
    for (const mesh::TJunction& junction : mesh::junctions_on(mesh, seams, tolerance))
        if (touching.is_across(junction.vertex,
                               piece[triangle_at.at({junction.from, junction.to})]))
            found.push_back(junction);
    return found;
}

std::vector<char> inner_walls(const mesh::TriangleMesh& mesh)
{
    const std::vector<Edge> edges = edges_of(mesh);
    const std::vector<int> piece = pieces_of(mesh, edges);
    const std::map<int, Wall> walls = walls_of(mesh, edges, piece);
    std::map<std::vector<int>, int> by_outline;
    std::set<int> inner;
    for (const auto& [own, wall] : walls)
    {
        const auto [other, is_new] = by_outline.emplace(wall.outline, own);
        if (!is_new && inner.count(other->second) == 0
            && are_face_to_face(wall, walls.at(other->second)))
            inner.insert({own, other->second});
    }
    std::vector<char> flags;
    for (const int own : piece)
        flags.push_back(inner.count(own) > 0);
    return flags;
}

}  // namespace sheetmorph::repair
