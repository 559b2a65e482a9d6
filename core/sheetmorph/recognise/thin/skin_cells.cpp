// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/skin_cells.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/index.h"

#include <algorithm>
#include <map>

namespace sheetmorph::recognise
{

namespace
{

// Range of a skin, in typical thicknesses. From geometry: at the edge of a fold by 90 degrees the
// skins are sqrt(2) = 1.41 apart. Chosen: forming may halve the thickness.
constexpr double thinnest_skin = 0.5;
constexpr double thickest_skin = 1.6;

using WeightedDistances = std::vector<std::pair<double, double>>;

// The weighted median of the distances first..last - 1.
double median(const WeightedDistances& distances, std::size_t first, std::size_t last)
{
    double half = 0.0;
    for (std::size_t k = first; k < last; ++k)
        half += 0.5 * distances[k].second;
    while (first + 1 < last && half > distances[first].second)
        half -= distances[first++].second;
    return distances[first].first;
}

// The most frequent distance: the median of the densest window of relative width 25 %; 0 if there
// are no distances.
double typical(WeightedDistances distances)
{
    std::sort(distances.begin(), distances.end());
    double most = 0.0, inside = 0.0;
    std::size_t first = 0;
    std::pair<std::size_t, std::size_t> best{0, 0};
    for (std::size_t last = 0; last < distances.size(); ++last)
    {
        inside += distances[last].second;
        for (; distances[last].first > 1.25 * distances[first].first; ++first)
            inside -= distances[first].second;
        // A margin above rounding, so that among equal shares the smaller distance wins.
        if (inside > most * (1.0 + 1e-9))
        {
            most = inside;
            best = {first, last + 1};
        }
    }
    return best.second == 0 ? 0.0 : median(distances, best.first, best.second);
}

std::vector<double> thicknesses(const FacetGraph& graph, const std::vector<InwardProbe>& probes,
                                double given)
{
    std::vector<WeightedDistances> facing(at(graph.component_count()));
    for (const InwardProbe& probe : probes)
        if (probe.is_facing)
            facing[at(graph.component(probe.facet))].emplace_back(probe.distance, probe.area);
    std::vector<double> found;
    for (WeightedDistances& distances : facing)
        found.push_back(given > 0.0 && !distances.empty() ? given : typical(std::move(distances)));
    return found;
}

std::vector<int> smooth_patches(const FacetGraph& graph)
{
    DisjointSets smooth(graph.triangle_count());
    for (const FacetJoint& joint : graph.joints())
        if (joint.bend < crease && !graph.is_thin(joint.one) && !graph.is_thin(joint.other))
            smooth.join(joint.one, joint.other);
    std::vector<int> patch;
    for (int t = 0; t < graph.triangle_count(); ++t)
        patch.push_back(smooth.root(t));
    return patch;
}

// Whether each ray hits the other skin at a plausible distance.
std::vector<char> thin_looks(const FacetGraph& graph, const std::vector<InwardProbe>& probes,
                             const std::vector<double>& thickness)
{
    std::vector<char> found;
    for (const InwardProbe& probe : probes)
    {
        const double typical_one = thickness[at(graph.component(probe.facet))];
        found.push_back(probe.is_facing && probe.distance > thinnest_skin * typical_one
                        && probe.distance < thickest_skin * typical_one);
    }
    return found;
}

// A few facets of a wall may face each other across a narrow strut; their cells are too small for a
// skin.
void drop_crumbs(const SkinCells& cells, std::vector<char>& is_skin)
{
    for (std::size_t t = 0; t < is_skin.size(); ++t)
        if (const int cell = cells.cell[t]; cell >= 0)
        {
            const double thickness = cells.thickness[at(cells.component[at(cell)])];
            is_skin[t] = cells.area[at(cell)] > thickness * thickness;
        }
}

void number_cells(const FacetGraph& graph, const std::vector<char>& is_skin, SkinCells& cells)
{
    DisjointSets sets(graph.triangle_count());
    for (const FacetJoint& joint : graph.joints())
        if (joint.bend < crease && is_skin[at(joint.one)] && is_skin[at(joint.other)])
            sets.join(joint.one, joint.other);
    cells.cell.assign(is_skin.size(), -1);
    cells.area.clear();
    cells.component.clear();
    for (int t = 0; t < graph.triangle_count(); ++t)
    {
        if (!is_skin[at(t)])
            continue;
        int& of_root = cells.cell[at(sets.root(t))];
        if (of_root < 0)
        {
            of_root = cells.count();
            cells.area.push_back(0.0);
            cells.component.push_back(graph.component(t));
        }
        cells.cell[at(t)] = of_root;
        cells.area[at(of_root)] += graph.area(t);
    }
}

std::vector<OpposedCells> opposed_cells(const std::vector<InwardProbe>& probes,
                                        const std::vector<char>& is_thin_look,
                                        const std::vector<int>& cell)
{
    std::map<std::pair<int, int>, double> seen;
    for (std::size_t k = 0; k < probes.size(); ++k)
    {
        if (!is_thin_look[k])
            continue;
        const int a = cell[at(probes[k].facet)], b = cell[at(probes[k].opposite)];
        if (a >= 0 && b >= 0)
            seen[{std::min(a, b), std::max(a, b)}] += probes[k].area;
    }
    std::vector<OpposedCells> found;
    for (const auto& [pair, area] : seen)
        found.push_back({pair.first, pair.second, area});
    std::stable_sort(found.begin(), found.end(),
                     [](const OpposedCells& a, const OpposedCells& b) { return a.area > b.area; });
    return found;
}

}  // namespace

SkinCells skin_cells(const FacetGraph& graph, const std::vector<InwardProbe>& probes,
                     double thickness)
{
    SkinCells cells;
    cells.thickness = thicknesses(graph, probes, thickness);
    cells.patch = smooth_patches(graph);
    const std::vector<char> is_thin_look = thin_looks(graph, probes, cells.thickness);
    std::vector<double> balance(at(graph.triangle_count()), 0.0);
    for (std::size_t k = 0; k < probes.size(); ++k)
        balance[at(probes[k].facet)] += is_thin_look[k] ? probes[k].area : -probes[k].area;
    std::vector<char> is_skin;
    for (const double area : balance)
        is_skin.push_back(area > 0.0);
    number_cells(graph, is_skin, cells);
    drop_crumbs(cells, is_skin);
    number_cells(graph, is_skin, cells);
    cells.opposed = opposed_cells(probes, is_thin_look, cells.cell);
    return cells;
}

}  // namespace sheetmorph::recognise
