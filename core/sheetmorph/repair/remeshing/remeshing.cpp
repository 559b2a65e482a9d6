// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/remeshing.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/mesh/geometry/areas.h"
#include "sheetmorph/repair/remeshing/remesh_result.h"
#include "sheetmorph/repair/remeshing/round_rims.h"
#include "sheetmorph/repair/remeshing/twin_flats.h"
#include "sheetmorph/repair/remeshing/working_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

namespace sheetmorph::repair
{

using mesh::TriangleMesh;

namespace
{

using Pairs = std::vector<std::pair<int, int>>;

// Measured: a set-up takes 3.2 GiB for a million vertices, that is two million triangles, so this
// limit needs about 5 GiB.
constexpr double most_triangles = 3e6;

// The number of triangles is limited in proportion to the input: a multiple of the input facets,
// plus a multiple of the triangles that the edge length alone needs, and at least always_allowed.
// Chosen: sizes that grow from rims and bends need up to twice the triangles of the edge length
// alone; the limits stop inputs whose smallest facets would need millions.
constexpr double per_facet = 50.0, per_needed = 4.0, always_allowed = 50e3;

void require_three_corners(const Triangles& triangles)
{
    std::vector<int> bad;
    for (int t = 0; t < triangles.rows(); ++t)
        if (triangles(t, 0) == triangles(t, 1) || triangles(t, 1) == triangles(t, 2)
            || triangles(t, 2) == triangles(t, 0))
            bad.push_back(t);
    if (!bad.empty())
        throw InvalidInput("triangles with one vertex at two corners: " + list_ids(bad),
                           "repair the mesh first, which removes them");
}

double total_area(const TriangleMesh& mesh)
{
    double area = 0.0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        area += 0.5 * mesh::doubled_area(mesh, t).norm();
    return area;
}

// The number of equilateral triangles of this edge length that cover an area (sqrt(3) / 4 edge^2
// each).
double needed(double area, double edge)
{
    // Divides twice, because the square of a tiny edge underflows to 0.
    return area / 0.433 / edge / edge;
}

void check(const TriangleMesh& mesh, const RemeshOptions& options)
{
    require_three_corners(mesh.triangles());
    if (!(options.edge > 0.0) || !std::isfinite(options.edge))
        throw InvalidInput(
            "the edge length for remeshing is " + std::to_string(options.edge) + " mm",
            "give a positive length");
    const double area = total_area(mesh);
    if (needed(area, options.edge) > most_triangles)
        throw InvalidInput(
            "edges of " + std::to_string(options.edge) + " mm would need "
                + std::to_string(std::lround(std::min(needed(area, options.edge), 1e24) / 1e6))
                + " million triangles",
            "give a longer edge, about " + std::to_string(std::sqrt(area / 0.433 / 3e5)) + " mm");
}

// Small facets on bends and near rims can require edges far shorter than the target edge length.
std::size_t allowed_triangles(const TriangleMesh& mesh, double edge)
{
    const double wanted =
        per_facet * mesh.triangle_count() + per_needed * needed(total_area(mesh), edge);
    return static_cast<std::size_t>(std::clamp(wanted, always_allowed, 2.0 * most_triangles));
}

// The edges of a table that meet a condition, as sorted pairs of vertices.
template <typename Condition>
Pairs pairs_where(const mesh::EdgeTable& table, Condition condition)
{
    Pairs pairs;
    for (int edge = 0; edge < table.count(); ++edge)
        if (condition(edge))
        {
            const mesh::EdgeUse& use = *table.uses(edge).begin();
            pairs.emplace_back(std::min(use.from, use.to), std::max(use.from, use.to));
        }
    return pairs;
}

// The same flats with Delaunay triangles between the same vertices, so that later cuts along ridges
// make short diagonals.
TriangleMesh flipped_on_planes(const TriangleMesh& mesh, const mesh::EdgeTable& table,
                               const Patches& patches)
{
    const Pairs folds =
        pairs_where(table,
                    [&](int edge)
                    {
                        const mesh::EdgeUses uses = table.uses(edge);
                        return uses.count() != 2
                               || patches.plane[uses.begin()->triangle]
                                      != patches.plane[(uses.begin() + 1)->triangle];
                    });
    const std::vector<double> sizes(static_cast<std::size_t>(mesh.vertex_count()), 0.0);
    WorkingMesh work({mesh, folds, patches.patch, sizes, patches.is_flat});
    flip_to_delaunay(work);
    Triangles triangles(mesh.triangle_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            triangles(t, k) = work.corner(t, k);
    return TriangleMesh(mesh.points(), std::move(triangles));
}

// The ridges of a mesh in the edge table of another mesh with the same ridges.
Patches on_table(const Patches& patches, const mesh::EdgeTable& before,
                 const mesh::EdgeTable& after)
{
    const Pairs ridges = pairs_where(before, [&](int edge) { return patches.is_ridge[edge] != 0; });
    Patches found = patches;
    found.is_ridge.assign(static_cast<std::size_t>(after.count()), 0);
    for (int edge = 0; edge < after.count(); ++edge)
    {
        const mesh::EdgeUse& use = *after.uses(edge).begin();
        found.is_ridge[edge] =
            std::binary_search(ridges.begin(), ridges.end(),
                               std::pair(std::min(use.from, use.to), std::max(use.from, use.to)));
    }
    return found;
}

struct PatchTriangles
{
    TriangleMesh mesh;
    std::vector<int> patch;
};

// The mesh without the second flat of every pair.
PatchTriangles without_twins(const PatchTriangles& given, const std::vector<TwinFlats>& twins)
{
    std::vector<int> kept;
    for (int t = 0; t < given.mesh.triangle_count(); ++t)
        if (std::none_of(twins.begin(), twins.end(),
                         [&](const TwinFlats& pair)
                         { return pair.twin == given.patch[static_cast<std::size_t>(t)]; }))
            kept.push_back(t);
    std::vector<int> patch;
    for (const int t : kept)
        patch.push_back(given.patch[static_cast<std::size_t>(t)]);
    return {TriangleMesh(given.mesh.points(), given.mesh.triangles()(kept, Eigen::indexing::all)),
            patch};
}

void project(WorkingMesh& work, const PatchTrees& trees)
{
    std::vector<int> moving;
    for (int v = 0; v < work.vertex_count(); ++v)
        if (work.is_movable(v))
            moving.push_back(v);
    const auto project_some = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index k = begin; k < end; ++k)
        {
            const int vertex = moving[at(k)];
            Vector3& place = work.point[vertex];
            place = trees.nearest(work.patch[work.triangle_at(vertex)], place).point;
        }
    };
    parallel_ranges(static_cast<Eigen::Index>(moving.size()), microsecond_items, project_some);
}

// A fixed number of rounds, as in the method: every round makes the triangles more even, and no
// round depends on convergence. Only the splits and collapses of the last round and the final flips
// must converge.
Convergence improve(WorkingMesh& work, const PatchTrees& trees, const Progress& progress)
{
    // From Botsch and Kobbelt, A Remeshing Approach to Multiresolution Modeling, 2004, who take 5
    // to 10. Chosen: three more only even out what the last splits have left.
    constexpr int rounds = 8, finishing = 3;
    Convergence found, cut;
    flip_to_delaunay(work);
    for (int round = 0; round < rounds + finishing; ++round)
    {
        progress.report(double(round) / (rounds + finishing), "remeshing");
        if (round < rounds)
            cut = split_long_edges(work);
        const Convergence collapsed = collapse_short_edges(work);
        if (round + 1 == rounds + finishing)
            found.join(collapsed);
        flip_to_delaunay(work, 4);
        smooth(work);
        project(work, trees);
    }
    found.join(cut);
    found.join(flip_to_delaunay(work));
    return found;
}

}  // namespace

RemeshedMesh remeshed(const TriangleMesh& mesh, const RemeshOptions& options,
                      const Progress& progress)
{
    check(mesh, options);
    progress.report(0.0, "finding flats and creases");
    const mesh::EdgeTable table(mesh);
    const Patches patches = find_patches(mesh, table, {options.crease_angle, 0.5 * options.edge});
    const TriangleMesh flipped = flipped_on_planes(mesh, table, patches);
    const mesh::EdgeTable flipped_table(flipped);
    const Patches on_flipped = on_table(patches, table, flipped_table);
    RoundRims rims;
    if (options.are_rims_on_circles)
        rims = RoundRims(mesh, table);
    const Pairs ridges = pairs_where(table, [&](int edge) { return patches.is_ridge[edge] != 0; });
    const double least_area = options.edge * options.edge;
    const FoundTwins found =
        find_twin_flats({flipped, patches.patch, ridges}, patches.is_flat, least_area);
    const std::vector<double> sizes = wanted_sizes(flipped, flipped_table, on_flipped,
                                                   {options.edge, rims.sizes(mesh.vertex_count())});
    CutMesh cut = cut_ridges(flipped, flipped_table, on_flipped,
                             {{options.edge, evened(sizes, found.twins)}, found.stops});
    cut.mesh = rims.rounded(mesh.vertex_count(), cut);
    std::vector<int> patch;
    for (const int origin : cut.triangle_of)
        patch.push_back(patches.patch[origin]);
    const std::vector<TwinFlats> twins =
        twins_after_cuts(found.twins, {cut.mesh, patch, cut.ridges});
    const PatchTriangles worked = without_twins({cut.mesh, patch}, twins);
    WorkingMesh work({worked.mesh, cut.ridges, worked.patch, cut.sizes, patches.is_flat,
                      options.edge, allowed_triangles(mesh, options.edge)});
    const PatchTrees trees(mesh, patches.patch);
    const Convergence convergence = improve(work, trees, progress.part(0.1, 0.8));
    progress.report(0.8, "measuring the deviation");
    RemeshedMesh made = result_of(work, {mesh, table, patches, cut, trees, twins, rims.count()});
    made.convergence = convergence;
    made.least_edge = work.least_size;
    return made;
}

}  // namespace sheetmorph::repair
