// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/diagnosis.h"

#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/mesh/geometry/thinness.h"
#include "sheetmorph/mesh/quality/median.h"
#include "sheetmorph/mesh/quality/pieces.h"
#include "sheetmorph/mesh/quality/t_junctions.h"
#include "sheetmorph/mesh/regions/crease_loops.h"
#include "sheetmorph/mesh/search/near_vertices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace sheetmorph::mesh
{

namespace
{

// Radians (40 degrees). From geometry: a rim bends by 90 degrees. The facets of a round wall bend
// by 40 degrees if there are nine of them.
constexpr double rim_angle = 0.7;

// Relative to the radius. From geometry: a vertex on the chord of a 16-gon deviates by
// 1 - cos(pi / 16) = 0.019.
constexpr double rim_roundness = 0.02;

// The bounding box excludes unused vertices, which may be anywhere.
double size_of_triangles(const TriangleMesh& mesh)
{
    if (mesh.triangle_count() == 0)
        return mesh.size();
    Eigen::RowVector3d low = mesh.points().row(mesh.triangles()(0, 0)), high = low;
    for (Eigen::Index k = 0; k < mesh.triangles().size(); ++k)
    {
        const auto corner = mesh.points().row(mesh.triangles().data()[k]);
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    return (high - low).norm();
}

void count_vertices(const TriangleMesh& mesh, const Weld& places, Diagnosis& found)
{
    std::vector<char> is_used(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            is_used[mesh.triangles()(t, k)] = 1;
    found.unused_vertices = static_cast<int>(std::count(is_used.begin(), is_used.end(), 0));
    found.duplicate_vertices = places.equal;
    found.near_duplicate_vertices = places.near;
}

double aspect(const TriangleMesh& mesh, int triangle)
{
    const auto corner = [&](int k) -> Vector3
    { return mesh.points().row(mesh.triangles()(triangle, k)).transpose(); };
    const Vector3 a = corner(1) - corner(0), b = corner(2) - corner(0);
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    return longest / a.cross(b).norm();
}

int duplicate_triangles(const Triangles& triangles)
{
    std::vector<std::array<int, 3>> sorted(static_cast<std::size_t>(triangles.rows()));
    for (int t = 0; t < triangles.rows(); ++t)
    {
        sorted[t] = {triangles(t, 0), triangles(t, 1), triangles(t, 2)};
        std::sort(sorted[t].begin(), sorted[t].end());
    }
    std::sort(sorted.begin(), sorted.end());
    const auto last = std::unique(sorted.begin(), sorted.end());
    return static_cast<int>(sorted.end() - last);
}

void count_triangles(const TriangleMesh& mesh, Diagnosis& found)
{
    found.duplicate_triangles = duplicate_triangles(mesh.triangles());
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        if (is_thin(mesh.points(), mesh.triangles(), t))
            ++found.degenerate_triangles;
        else if (aspect(mesh, t) > sliver_aspect)
            ++found.slivers;
    }
}

void measure_edges(const TriangleMesh& mesh, const EdgeTable& table, Diagnosis& found)
{
    std::vector<double> lengths(static_cast<std::size_t>(table.count()));
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const EdgeUse& use = *table.uses(edge).begin();
        lengths[edge] = (mesh.points().row(use.to) - mesh.points().row(use.from)).norm();
    }
    if (lengths.empty())
        return;
    found.edges.median = median(lengths);
    const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
    found.edges.shortest = *least;
    found.edges.longest = *most;
}

std::array<int, 2> open_and_non_manifold(const EdgeTable& table)
{
    std::array<int, 2> counts{0, 0};
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const int uses = table.uses(edge).count();
        counts[0] += uses == 1;
        counts[1] += uses > 2;
    }
    return counts;
}

void find_rims(const TriangleMesh& mesh, const EdgeTable& table, Diagnosis& found)
{
    RimDiagnosis& rims = found.rims;
    for (const VertexIds& loop : crease_loops(mesh, table, rim_angle))
    {
        const auto circle =
            fitting::round_rim(mesh.points()(loop, Eigen::indexing::all), rim_roundness);
        if (!circle)
            continue;
        const int vertices = static_cast<int>(loop.size());
        const bool is_first = rims.count++ == 0;
        rims.fewest_vertices = is_first ? vertices : std::min(rims.fewest_vertices, vertices);
        rims.smallest_radius =
            is_first ? circle->radius : std::min(rims.smallest_radius, circle->radius);
        rims.largest_radius = std::max(rims.largest_radius, circle->radius);
    }
}

TriangleMesh with_one_vertex_a_place(const TriangleMesh& mesh, const std::vector<int>& first)
{
    Triangles triangles = mesh.triangles();
    for (Eigen::Index k = 0; k < triangles.size(); ++k)
        triangles.data()[k] = first[triangles.data()[k]];
    return TriangleMesh(mesh.points(), std::move(triangles));
}

}  // namespace

TriangleMesh without_cuts(const TriangleMesh& mesh, double tolerance)
{
    // A closed surface with a ledge lower than the tolerance has no cut; merging would create one.
    const bool is_closed = open_and_non_manifold(EdgeTable(mesh))[0] == 0;
    return is_closed ? mesh : with_one_vertex_a_place(mesh, weld(mesh, tolerance).first);
}

Diagnosis diagnose(const TriangleMesh& mesh, double tolerance)
{
    Diagnosis found;
    found.size = size_of_triangles(mesh);
    found.tolerance = tolerance;
    const Weld places = weld(mesh, tolerance);
    look_for_stop();
    count_vertices(mesh, places, found);
    count_triangles(mesh, found);
    const EdgeTable table(mesh);
    measure_edges(mesh, table, found);
    const Orientation orientation = consistent_orientation(mesh, table);
    found.flipped_triangles = static_cast<int>(orientation.flipped.size());
    found.is_one_sided = !orientation.is_possible;
    std::tie(found.open_edges, found.non_manifold_edges) =
        std::tuple_cat(open_and_non_manifold(table));
    look_for_stop();
    const TriangleMesh exact = with_one_vertex_a_place(mesh, weld(mesh, 0.0).first);
    found.t_junctions = static_cast<int>(t_junctions(exact, tolerance).size());
    look_for_stop();
    const TriangleMesh whole = without_cuts(mesh, tolerance);
    const EdgeTable seams(whole);
    std::tie(found.open_edges_welded, found.non_manifold_edges_welded) =
        std::tuple_cat(open_and_non_manifold(seams));
    look_for_stop();
    find_rims(whole, seams, found);
    look_for_stop();
    found.pieces = diagnose_pieces(whole, seams);
    return found;
}

}  // namespace sheetmorph::mesh
