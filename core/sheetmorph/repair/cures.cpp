// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/cures.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/geometry/thinness.h"
#include "sheetmorph/mesh/search/near_vertices.h"
#include "sheetmorph/mesh/topology/orientation.h"
#include "sheetmorph/repair/inner_walls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace sheetmorph::repair
{

namespace
{

// Relative to the tolerance for merging vertices. Lower triangles are removed. Merely thin
// triangles stay, because they connect their neighbours. Chosen: a triangle a thousandth as high as
// the tolerance is a line within what the user allows to merge.
constexpr double least_height = 1e-3;

// Height over longest edge, from mesh::thinnest_triangle: rounding dominates the area of a lower
// facet.
constexpr double flat = mesh::thinnest_triangle;

// Limit on rounds. A round removes every flat facet that is not next to another removed one.
// Chosen: a fan of 100 flat facets is removed; CAD systems write none so large.
constexpr int flat_rounds = 100;

struct Facet
{
    std::array<int, 3> corners;
    int origin;
};

using Facets = std::vector<Facet>;
using Edge = std::pair<int, int>;

mesh::TriangleMesh mesh_of(const Points& points, const Facets& facets)
{
    Triangles triangles(facets.size(), 3);
    for (std::size_t t = 0; t < facets.size(); ++t)
        for (int k = 0; k < 3; ++k)
            triangles(t, k) = facets[t].corners[k];
    return mesh::TriangleMesh(points, std::move(triangles));
}

// Height of a facet on its longest edge, mm; 0 if a corner is repeated.
double height(const Points& points, const Facet& facet)
{
    const auto corner = [&](int k) -> Vector3 { return points.row(facet.corners[k]).transpose(); };
    const Vector3 a = corner(1) - corner(0), b = corner(2) - corner(0);
    const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
    return longest > 0.0 ? a.cross(b).norm() / longest : 0.0;
}

// Removes facets with the same corners as an earlier one.
Facets without_doubles(const Facets& facets)
{
    Facets found;
    std::set<std::array<int, 3>> seen;
    for (const Facet& facet : facets)
    {
        std::array<int, 3> key = facet.corners;
        std::sort(key.begin(), key.end());
        if (seen.insert(key).second)
            found.push_back(facet);
    }
    return found;
}

// Removes degenerate and duplicate facets.
Facets sound_facets(const mesh::TriangleMesh& mesh, const std::vector<int>& first, double tolerance)
{
    Facets facets;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        Facet facet{{}, t};
        for (int k = 0; k < 3; ++k)
            facet.corners[k] = first[mesh.triangles()(t, k)];
        if (height(mesh.points(), facet) > least_height * tolerance)
            facets.push_back(facet);
    }
    return without_doubles(facets);
}

// Index of the longest or the shortest side of a facet.
int side_of(const Points& points, const Facet& facet, bool is_longest)
{
    std::array<double, 3> lengths{};
    for (int k = 0; k < 3; ++k)
        lengths[k] =
            (points.row(facet.corners[k]) - points.row(facet.corners[(k + 1) % 3])).squaredNorm();
    const auto found = is_longest ? std::max_element(lengths.begin(), lengths.end())
                                  : std::min_element(lengths.begin(), lengths.end());
    return static_cast<int>(found - lengths.begin());
}

bool is_flat(const Points& points, const Facet& facet)
{
    const int side = side_of(points, facet, true);
    const double longest =
        (points.row(facet.corners[side]) - points.row(facet.corners[(side + 1) % 3])).norm();
    return height(points, facet) <= flat * longest;
}

// The facets at every edge, regardless of direction.
std::map<Edge, std::vector<std::size_t>> facets_on_edges(const Facets& facets)
{
    std::map<Edge, std::vector<std::size_t>> found;
    for (std::size_t t = 0; t < facets.size(); ++t)
        for (int k = 0; k < 3; ++k)
            found[std::minmax(facets[t].corners[k], facets[t].corners[(k + 1) % 3])].push_back(t);
    return found;
}

// The two parts of a facet cut at a vertex on one of its edges.
Facets halves(const Facet& facet, Edge edge, int vertex)
{
    Facets found(2, facet);
    for (int k = 0; k < 3; ++k)
    {
        found[0].corners[k] = facet.corners[k] == edge.first ? vertex : facet.corners[k];
        found[1].corners[k] = facet.corners[k] == edge.second ? vertex : facet.corners[k];
    }
    return found;
}

//! Removes flat facets from a mesh, round by round.
class FlatFacets
{
public:
    //! \param first  by vertex: the vertex that represents it
    FlatFacets(const Points& points, Facets& facets, std::vector<int>& first)
        : points_(points), facets_(facets), first_(first)
    {
    }

    //! Removes needles by merging two of their corners. Removes caps by cutting the other facets at
    //! their longest side at the apex, so that the mesh stays closed. Returns the number of removed
    //! facets.
    int take_out()
    {
        for (int round = 0; round < flat_rounds; ++round)
        {
            std::vector<std::size_t> found;
            for (std::size_t t = 0; t < facets_.size(); ++t)
                if (is_flat(points_, facets_[t]))
                    found.push_back(t);
            if (found.empty())
                break;
            take_out(found);
        }
        return count_;
    }

private:
    void take_out(const std::vector<std::size_t>& found)
    {
        const auto on_edges = facets_on_edges(facets_);
        is_gone_.assign(facets_.size(), 0);
        merged_.clear();
        pieces_.clear();
        for (const std::size_t t : found)
            if (const Edge tiny = edge_of(t, false);
                length(tiny) <= 2 * flat * length(edge_of(t, true)))
                merged_.emplace(tiny.second, tiny.first);
            else
                cut_beside(t, on_edges.at(edge_of(t, true)));
        for (std::size_t t = 0; t < facets_.size(); ++t)
            if (!is_gone_[t])
                pieces_.push_back(facets_[t]);
        merge();
    }

    // Cuts the facets at the longest side of a flat facet at its apex, unless one of them was
    // already cut in this round.
    void cut_beside(std::size_t t, const std::vector<std::size_t>& beside)
    {
        if (std::any_of(beside.begin(), beside.end(), [&](auto k) { return is_gone_[k] != 0; }))
            return;
        const Edge edge = edge_of(t, true);
        const int apex = facets_[t].corners[(side_of(points_, facets_[t], true) + 2) % 3];
        for (const std::size_t k : beside)
        {
            is_gone_[k] = 1;
            const std::array<int, 3>& own = facets_[k].corners;
            if (std::find(own.begin(), own.end(), apex) == own.end())
                for (const Facet& half : halves(facets_[k], edge, apex))
                    pieces_.push_back(half);
        }
        ++count_;
    }

    // Replaces the second vertex of every tiny edge by the first.
    void merge()
    {
        facets_.clear();
        for (Facet& facet : pieces_)
        {
            auto& [a, b, c] = facet.corners;
            for (int* corner : {&a, &b, &c})
                *corner = place(*corner);
            if (a != b && b != c && c != a)
                facets_.push_back(facet);
            else
                ++count_;
        }
        for (int& vertex : first_)
            vertex = place(vertex);
        facets_ = without_doubles(facets_);
    }

    Edge edge_of(std::size_t t, bool is_longest) const
    {
        const int side = side_of(points_, facets_[t], is_longest);
        return std::minmax(facets_[t].corners[side], facets_[t].corners[(side + 1) % 3]);
    }

    double length(const Edge& edge) const
    {
        return (points_.row(edge.first) - points_.row(edge.second)).norm();
    }

    int place(int vertex) const
    {
        for (auto to = merged_.find(vertex); to != merged_.end(); to = merged_.find(vertex))
            vertex = to->second;
        return vertex;
    }

    const Points& points_;
    Facets& facets_;
    std::vector<int>& first_;
    std::vector<char> is_gone_;
    std::map<int, int> merged_;
    Facets pieces_;
    int count_ = 0;
};

using Cuts = std::map<std::pair<int, int>, std::set<int>>;

// The vertices at which a side of a facet is cut, in order along it. The facet's own apex is
// excluded; in a flat facet it may be as near.
VertexIds cuts_of(const Points& points, const Facet& facet, int side, const Cuts& known)
{
    const int from = facet.corners[side], to = facet.corners[(side + 1) % 3];
    const auto found = known.find({from, to});
    if (found == known.end())
        return {};
    VertexIds cuts(found->second.begin(), found->second.end());
    cuts.erase(std::remove(cuts.begin(), cuts.end(), facet.corners[(side + 2) % 3]), cuts.end());
    const Vector3 way = points.row(to) - points.row(from);
    std::sort(cuts.begin(), cuts.end(),
              [&](int a, int b) { return points.row(a).dot(way) < points.row(b).dot(way); });
    return cuts;
}

// A fan of triangles from the apex opposite `side`, which is cut at the given vertices.
Facets fan(const Facet& facet, int side, VertexIds cuts)
{
    const int from = facet.corners[side], to = facet.corners[(side + 1) % 3];
    const int apex = facet.corners[(side + 2) % 3];
    cuts.push_back(to);
    Facets pieces;
    int before = from;
    for (const int cut : cuts)
    {
        pieces.push_back({{before, cut, apex}, facet.origin});
        before = cut;
    }
    return pieces;
}

// Cuts each facet at the vertices inside one of its edges. Returns the number of cut facets.
int cut_junctions(const Points& points, Facets& facets, double tolerance)
{
    const mesh::TriangleMesh mesh = mesh_of(points, facets);
    Cuts cuts;
    for (const auto junctions : {mesh::t_junctions, seam_junctions})
        for (const mesh::TJunction& junction : junctions(mesh, tolerance))
            cuts[{junction.from, junction.to}].insert(junction.vertex);
    int count = 0;
    Facets whole;
    for (const Facet& facet : facets)
    {
        VertexIds inside;
        int side = 0;
        for (; side < 3 && inside.empty(); ++side)
            inside = cuts_of(points, facet, side, cuts);
        const Facets pieces = inside.empty() ? Facets{facet} : fan(facet, side - 1, inside);
        whole.insert(whole.end(), pieces.begin(), pieces.end());
        count += !inside.empty();
    }
    facets = std::move(whole);
    return count;
}

// Keeps only the vertices that facets use, in their original order.
void number_vertices(const Points& points, const Facets& facets, const std::vector<int>& first,
                     CuredMesh& found)
{
    std::vector<int> number(first.size(), -1);
    for (const Facet& facet : facets)
        for (const int corner : facet.corners)
            number[corner] = 0;
    int count = 0;
    for (int& place : number)
        place = place < 0 ? -1 : count++;
    Points kept(count, 3);
    for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] >= 0)
            kept.row(number[i]) = points.row(static_cast<Eigen::Index>(i));
    Triangles triangles(facets.size(), 3);
    for (std::size_t t = 0; t < facets.size(); ++t)
    {
        found.triangle_of.push_back(facets[t].origin);
        for (int k = 0; k < 3; ++k)
            triangles(t, k) = number[facets[t].corners[k]];
    }
    for (const int place : first)
        found.vertex_of.push_back(number[place]);
    found.mesh = mesh::TriangleMesh(std::move(kept), std::move(triangles));
}

// Builds the mesh with consistently oriented pieces, closed ones outwards.
void put_together(const Points& points, const Facets& facets, const std::vector<int>& first,
                  CuredMesh& found)
{
    found.triangle_of.clear();
    found.vertex_of.clear();
    number_vertices(points, facets, first, found);
    const mesh::Orientation orientation =
        mesh::outward_orientation(found.mesh, mesh::EdgeTable(found.mesh));
    found.turned = static_cast<int>(orientation.flipped.size());
    found.mesh = mesh::oriented(found.mesh, orientation);
}

// Removes the walls that two pieces share. Returns the number of removed facets.
int open_inner_walls(const mesh::TriangleMesh& mesh, Facets& facets)
{
    const std::vector<char> is_inner = inner_walls(mesh);
    Facets outer;
    for (std::size_t t = 0; t < facets.size(); ++t)
        if (!is_inner[t])
            outer.push_back(facets[t]);
    const std::size_t count = facets.size() - outer.size();
    facets = std::move(outer);
    return static_cast<int>(count);
}

}  // namespace

CuredMesh cured(const mesh::TriangleMesh& mesh, double tolerance, int most_rounds)
{
    CuredMesh found;
    mesh::Weld places = mesh::weld(mesh, tolerance);
    for (std::size_t i = 0; i < places.first.size(); ++i)
        found.welded += places.first[i] != static_cast<int>(i);
    Facets facets = sound_facets(mesh, places.first, tolerance);
    if (facets.empty())
        throw InvalidInput("every triangle is lower than the merge tolerance, "
                               + std::to_string(tolerance) + " mm",
                           "give a smaller tolerance");
    found.removed = mesh.triangle_count() - static_cast<int>(facets.size());
    Convergence& cuts = found.convergence = {"the cuts at T-junctions", false, 0, 0.0, "triangles"};
    for (; cuts.rounds < most_rounds && !cuts.is_converged; ++cuts.rounds)
    {
        const int cut = cut_junctions(mesh.points(), facets, tolerance);
        found.split += cut;
        cuts.miss = cut;
        cuts.is_converged = cut == 0;
    }
    found.removed += FlatFacets(mesh.points(), facets, places.first).take_out();
    put_together(mesh.points(), facets, places.first, found);
    if (const int inner = open_inner_walls(found.mesh, facets); inner > 0)
    {
        found.removed += inner;
        put_together(mesh.points(), facets, places.first, found);
    }
    // A cut may have created a triangle that already existed.
    if (Facets once = without_doubles(facets); once.size() < facets.size())
    {
        found.removed += static_cast<int>(facets.size() - once.size());
        facets = std::move(once);
        put_together(mesh.points(), facets, places.first, found);
    }
    return found;
}

}  // namespace sheetmorph::repair
