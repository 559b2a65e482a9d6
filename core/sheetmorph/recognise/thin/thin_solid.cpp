// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/thin_solid.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/recognise/thin/skin_walls.h"
#include "sheetmorph/recognise/thin/solid_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace sheetmorph::recognise
{

namespace
{

// Criteria for the main skin of a component, in order; the first that differs decides.
struct Candidate
{
    double steps = 0.0, area = 0.0;
    int first = std::numeric_limits<int>::max();

    bool is_better_than(const Candidate& other) const
    {
        // Chosen: areas that differ by less are those of symmetric skins.
        const double rounding = 1e-9 * (area + other.area);
        if (std::abs(steps - other.steps) > rounding)
            return steps < other.steps;
        if (std::abs(area - other.area) > rounding)
            return area > other.area;
        return first < other.first;
    }
};

// By component: +1 or -1, the side of the main skin.
std::vector<int> main_sides(const FacetGraph& graph, const FacetSides& sides)
{
    std::vector<std::array<Candidate, 2>> skins(at(graph.component_count()));
    for (int t = 0; t < graph.triangle_count(); ++t)
    {
        if (sides.side[at(t)] == 0)
            continue;
        Candidate& skin = skins[at(graph.component(t))][sides.side[at(t)] > 0 ? 0 : 1];
        skin.area += graph.area(t);
        skin.steps += sides.is_step[at(t)] ? graph.area(t) : 0.0;
        skin.first = std::min(skin.first, t);
    }
    std::vector<int> found;
    for (const auto& [plus, minus] : skins)
        found.push_back(minus.is_better_than(plus) ? -1 : 1);
    return found;
}

std::vector<SolidSide> facet_sides(const FacetGraph& graph, const SkinPairs& pairs,
                                   const FacetSides& sides)
{
    const std::vector<int> main = main_sides(graph, sides);
    std::vector<SolidSide> found;
    for (int t = 0; t < graph.triangle_count(); ++t)
    {
        const std::size_t component = at(graph.component(t));
        if (!pairs.is_thin[component] || sides.side[at(t)] == main[component])
            found.push_back(SolidSide::main);
        else if (sides.side[at(t)] != 0)
            found.push_back(SolidSide::opposite);
        else
            found.push_back(sides.is_lump[at(t)] ? SolidSide::lump : SolidSide::wall);
    }
    return found;
}

std::vector<SolidSide> vertex_sides(const mesh::TriangleMesh& mesh,
                                    const std::vector<SolidSide>& facets)
{
    std::vector<SolidSide> found(at(mesh.vertex_count()), SolidSide::lump);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            SolidSide& side = found[at(mesh.triangles()(t, k))];
            side = std::min(side, facets[at(t)]);
        }
    return found;
}

// Averages the lengths of the rays from the facets of a vertex's own skin. Rays from lumps do not
// count.
Eigen::VectorXd thickness_map(const mesh::TriangleMesh& mesh, const ThinSolid& solid,
                              const std::vector<InwardProbe>& probes,
                              const std::vector<double>& typical)
{
    const Eigen::Index count = mesh.vertex_count();
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(count), share = Eigen::VectorXd::Zero(count);
    for (const InwardProbe& probe : probes)
    {
        const SolidSide side = solid.facets[at(probe.facet)];
        const double reach = farthest_skin * typical[at(solid.component[at(probe.facet)])];
        if (!probe.is_facing || probe.distance > reach
            || (side != SolidSide::main && side != SolidSide::opposite))
            continue;
        for (int k = 0; k < 3; ++k)
        {
            const int vertex = mesh.triangles()(probe.facet, k);
            if (solid.vertices[at(vertex)] != side)
                continue;
            sum(vertex) += probe.area * probe.distance;
            share(vertex) += probe.area;
        }
    }
    return (share.array() > 0.0)
        .select(sum.array() / share.array(), std::numeric_limits<double>::quiet_NaN());
}

// By component: its typical thickness, mm; 0 if it is not thin.
std::vector<double> thickness_of_components(const SkinCells& cells, const SkinPairs& pairs)
{
    std::vector<double> found = cells.thickness;
    for (std::size_t k = 0; k < found.size(); ++k)
        found[k] = pairs.is_thin[k] ? found[k] : 0.0;
    return found;
}

// The typical thickness of the thin component with the largest surface, mm.
double main_thickness(const FacetGraph& graph, const SkinCells& cells, const SkinPairs& pairs)
{
    std::vector<double> areas(at(graph.component_count()), 0.0);
    for (int t = 0; t < graph.triangle_count(); ++t)
        if (pairs.is_thin[at(graph.component(t))])
            areas[at(graph.component(t))] += graph.area(t);
    const auto largest = std::max_element(areas.begin(), areas.end());
    return cells.thickness[static_cast<std::size_t>(largest - areas.begin())];
}

// Adds components that are thin if they may have several sheets joined by thick bodies.
void add_joined_sheets(const SkinPairs& several, const FacetGraph& graph, SkinPairs& pairs)
{
    for (int t = 0; t < graph.triangle_count(); ++t)
        if (!pairs.is_thin[at(graph.component(t))])
            pairs.side[at(t)] = several.side[at(t)];
    for (std::size_t k = 0; k < pairs.is_thin.size(); ++k)
        pairs.is_thin[k] = pairs.is_thin[k] || several.is_thin[k];
}

std::string why_not(const FacetGraph& graph, const SkinPairs& pairs)
{
    bool is_any_closed = false;
    for (int component = 0; component < graph.component_count(); ++component)
        is_any_closed = is_any_closed || graph.is_closed(component);
    if (!is_any_closed)
        return "its surface is not closed, or its facets are not consistently oriented; merge its "
               "vertices and orient it if it should be a solid";
    const double share = *std::max_element(pairs.share.begin(), pairs.share.end());
    if (share >= least_share_of_skins)
        return "its thickness is more than a tenth of its size; leave it as it is";
    return "only " + std::to_string(std::lround(100.0 * share))
           + " % of its surface are two skins one thickness apart; leave it as it is";
}

// Intermediate results about the facets of a mesh.
struct Findings
{
    const mesh::TriangleMesh& mesh;
    const FacetGraph& graph;
    const std::vector<InwardProbe>& probes;
    const SkinCells& cells;
};

ThinSolid solid_of(const Findings& found, const SkinPairs& pairs)
{
    const FacetSides sides = skin_walls(found.mesh, found.graph, found.cells, pairs);
    look_for_stop();
    ThinSolid solid;
    solid.thickness = main_thickness(found.graph, found.cells, pairs);
    solid.facets = facet_sides(found.graph, pairs, sides);
    solid.component = found.graph.components();
    solid.of_component = thickness_of_components(found.cells, pairs);
    solid.vertices = vertex_sides(found.mesh, solid.facets);
    solid.thicknesses = thickness_map(found.mesh, solid, found.probes, found.cells.thickness);
    look_for_stop();
    solid.walls = wall_pieces(found.mesh, found.graph, solid.facets);
    solid.holes = through_holes(found.mesh, found.graph, solid);
    solid.lumps = lump_pieces(found.mesh, found.probes, sides.is_lump);
    return solid;
}

// By component: whether its main skin is in several pieces that no lump connects.
std::vector<char> broken_components(const mesh::TriangleMesh& mesh, const ThinSolid& solid)
{
    DisjointSets sets(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 1; k < 3 && solid.facets[at(t)] == SolidSide::main; ++k)
            sets.join(mesh.triangles()(t, 0), mesh.triangles()(t, k));
    for (const VertexIds& lump : solid.lumps)
        for (const int vertex : lump)
            sets.join(lump.front(), vertex);
    std::vector<int> root;
    std::vector<char> is_broken;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const std::size_t component = at(solid.component[at(t)]);
        if (component >= root.size())
        {
            root.resize(component + 1, -1);
            is_broken.resize(component + 1, 0);
        }
        if (solid.facets[at(t)] != SolidSide::main)
            continue;
        const int own = sets.root(mesh.triangles()(t, 0));
        is_broken[component] =
            is_broken[component] || (root[component] >= 0 && root[component] != own);
        root[component] = own;
    }
    return is_broken;
}

}  // namespace

ThinFinding find_thin_solid(const mesh::TriangleMesh& mesh, double thickness)
{
    if (!(thickness >= 0.0) || std::isinf(thickness))
        throw InvalidInput("the thickness of a thin solid must be a number of mm, 0 or more");
    if (mesh.triangle_count() == 0)
        return {std::nullopt, "it has no triangles; give it some"};
    const FacetGraph graph = FacetGraph::of_solids(mesh);
    look_for_stop();
    const std::vector<InwardProbe> probes = inward_probes(mesh, graph);
    look_for_stop();
    const SkinCells cells = skin_cells(graph, probes, thickness);
    look_for_stop();
    SkinPairs pairs = skin_pairs(mesh, graph, cells);
    look_for_stop();
    if (std::find(pairs.is_thin.begin(), pairs.is_thin.end(), 0) != pairs.is_thin.end())
        add_joined_sheets(skin_pairs(mesh, graph, cells, true), graph, pairs);
    const auto is_none = [&]
    { return std::find(pairs.is_thin.begin(), pairs.is_thin.end(), 1) == pairs.is_thin.end(); };
    if (is_none())
        return {std::nullopt, why_not(graph, pairs)};
    const Findings found{mesh, graph, probes, cells};
    ThinSolid solid = solid_of(found, pairs);
    const std::vector<char> is_broken = broken_components(mesh, solid);
    if (std::find(is_broken.begin(), is_broken.end(), 1) == is_broken.end())
        return {std::move(solid), ""};
    for (std::size_t component = 0; component < is_broken.size(); ++component)
        if (is_broken[component])
            pairs.is_thin[component] = 0;
    if (is_none())
        return {std::nullopt, "its skin is in pieces that only walls connect; leave it as it is"};
    return {solid_of(found, pairs), ""};
}

}  // namespace sheetmorph::recognise
