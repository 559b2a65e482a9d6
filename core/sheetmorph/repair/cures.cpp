// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/cures.h"

#include "sheetmorph/base/errors.h"
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

namespace sheetmorph
{

namespace
{

// Lower triangles have no height. What is merely thin holds its neighbours together.
constexpr double least_height = 1e-3;  // of the tolerance

struct Facet
{
    std::array<int, 3> corners;
    int origin;
};

using Facets = std::vector<Facet>;

TriangleMesh mesh_of(const Points& points, const Facets& facets)
{
    Triangles triangles(facets.size(), 3);
    for (std::size_t t = 0; t < facets.size(); ++t)
        for (int k = 0; k < 3; ++k)
            triangles(t, k) = facets[t].corners[k];
    return TriangleMesh(points, std::move(triangles));
}

// Its height over the longest edge, 0 if a corner stands twice.
double height(const Points& points, const Facet& facet)
{
    const auto corner = [&](int k) -> Vector3 { return points.row(facet.corners[k]).transpose(); };
    const Vector3 a = corner(1) - corner(0), b = corner(2) - corner(0);
    const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
    return longest > 0.0 ? a.cross(b).norm() / longest : 0.0;
}

// Leaves out the facets over the corners of an earlier one.
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

// Leaves out facets without height and doubled ones.
Facets sound_facets(const TriangleMesh& mesh, const std::vector<int>& first, double tolerance)
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

using Cuts = std::map<std::pair<int, int>, std::set<int>>;

// The vertices a side of a facet is cut at, along it. The facet's own apex is none, though in a
// flat facet it may be as near.
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

// A fan of the facet over its side `side`, which is cut at some vertices.
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

// Cuts each facet at the vertices inside one of its edges; returns how many were cut.
int cut_junctions(const Points& points, Facets& facets, double tolerance)
{
    const TriangleMesh mesh = mesh_of(points, facets);
    Cuts cuts;
    for (const auto junctions : {t_junctions, seam_junctions})
        for (const TJunction& junction : junctions(mesh, tolerance))
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

// Only vertices that a facet has, in their old order.
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
    found.mesh = TriangleMesh(std::move(kept), std::move(triangles));
}

// The mesh of the facets, each piece facing one way, closed ones outwards.
void put_together(const Points& points, const Facets& facets, const std::vector<int>& first,
                  CuredMesh& found)
{
    found.triangle_of.clear();
    found.vertex_of.clear();
    number_vertices(points, facets, first, found);
    const Orientation orientation = outward_orientation(found.mesh, EdgeTable(found.mesh));
    found.turned = static_cast<int>(orientation.flipped.size());
    found.mesh = oriented(found.mesh, orientation);
}

// Leaves out the walls that two pieces have in common; returns how many facets.
int open_inner_walls(const TriangleMesh& mesh, Facets& facets)
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

CuredMesh cured(const TriangleMesh& mesh, double tolerance, int most_rounds)
{
    CuredMesh found;
    const Weld places = weld(mesh, tolerance);
    for (std::size_t i = 0; i < places.first.size(); ++i)
        found.welded += places.first[i] != static_cast<int>(i);
    Facets facets = sound_facets(mesh, places.first, tolerance);
    if (facets.empty())
        throw InvalidInput("no triangle is higher than the tolerance of the weld, "
                               + std::to_string(tolerance) + " mm",
                           "give a smaller one");
    found.removed = mesh.triangle_count() - static_cast<int>(facets.size());
    Convergence& cuts = found.convergence = {"the cuts at T-junctions", false, 0, 0.0, "triangles"};
    for (; cuts.rounds < most_rounds && !cuts.is_converged; ++cuts.rounds)
    {
        const int cut = cut_junctions(mesh.points(), facets, tolerance);
        found.split += cut;
        cuts.miss = cut;
        cuts.is_converged = cut == 0;
    }
    put_together(mesh.points(), facets, places.first, found);
    if (const int inner = open_inner_walls(found.mesh, facets); inner > 0)
    {
        found.removed += inner;
        put_together(mesh.points(), facets, places.first, found);
    }
    // Cuts may have made a triangle that was there already.
    if (Facets once = without_doubles(facets); once.size() < facets.size())
    {
        found.removed += static_cast<int>(facets.size() - once.size());
        facets = std::move(once);
        put_together(mesh.points(), facets, places.first, found);
    }
    return found;
}

}  // namespace sheetmorph
