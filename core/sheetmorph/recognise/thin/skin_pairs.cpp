// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/skin_pairs.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/recognise/thin/parity_sets.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace sheetmorph::recognise
{

namespace
{

// Thickness over size. Chosen: a plate a tenth as thick as its diagonal bends as a block. Measured:
// at 0.2, ThinSolid.BlocksBarsBallsAndRingsAreNone finds thin solids.
constexpr double thickest_of_size = 0.1;

// Minimum share of the evidence that must agree on a side. Chosen: one crease of ten may be at a
// rib, which is on both sides. Measured: at 0.45, the same test finds thin solids.
constexpr double agreement = 0.9;

// A smooth patch is weaker evidence than a crease. Chosen: so small that it decides only if there
// is no crease.
constexpr double weight_of_patch = 1e-3;

// Minimum area of further sheets of a component, in squares of the thickness. Chosen: five
// thicknesses square; smaller pairs of faces are bosses and ribs. Measured: at 12.5, the same test
// finds thin solids.
constexpr double least_further_sheet = 25.0;

// Evidence by group of cells: length in favour of side 0 and of side 1 of the sheet.
using Evidence = std::map<int, std::array<double, 2>>;

class Sheets
{
public:
    //! \param are_several  whether components may have more sheets than their largest
    Sheets(const FacetGraph& graph, const SkinCells& cells, bool are_several)
        : graph_(graph), cells_(cells), sets_(cells.count())
    {
        for (const OpposedCells& pair : cells.opposed)
            sets_.join(pair.one, pair.other, 1);
        seeds_.assign(at(graph.component_count()), -1);
        ledges_ = cells_at_ledges();
        while (choose_seeds())
        {
            // Ends because each round joins sets of cells.
            while (grow())
                continue;
            for (const int seed : seeds_)
                if (seed >= 0)
                    finished_.insert(sets_.root(seed));
            if (!are_several)
                break;
        }
    }

    //! +1 or -1 in a sheet of its component, else 0.
    int side(int cell) const
    {
        if (finished_.count(sets_.root(cell)) == 0)
            return 0;
        return sets_.side(cell) == 0 ? 1 : -1;
    }

private:
    // Starts a sheet at the largest pair of opposite skins of each component that is not in a sheet
    // yet. Returns whether there is one.
    bool choose_seeds()
    {
        Evidence areas;
        for (int cell = 0; cell < cells_.count(); ++cell)
            if (finished_.count(sets_.root(cell)) == 0)
                areas[sets_.root(cell)][at(sets_.side(cell))] += cells_.area[at(cell)];
        std::vector<double> largest(seeds_.size(), 0.0);
        const double least = finished_.empty() ? 0.0 : least_further_sheet;
        seeds_.assign(seeds_.size(), -1);
        for (const auto& [root, area] : areas)
        {
            const std::size_t component = at(cells_.component[at(root)]);
            const double both = std::min(area[0], area[1]);
            const double thickness = cells_.thickness[component];
            if (both > largest[component] && both > least * thickness * thickness)
            {
                largest[component] = both;
                seeds_[component] = root;
            }
        }
        return std::any_of(seeds_.begin(), seeds_.end(), [](int seed) { return seed >= 0; });
    }

    // +1 or -1 in the growing sheet, else 0.
    int side_in_growing(int cell) const
    {
        const int seed = seeds_[at(cells_.component[at(cell)])];
        if (seed < 0 || sets_.root(seed) != sets_.root(cell))
            return 0;
        return sets_.side(seed) == sets_.side(cell) ? 1 : -1;
    }

    void speak(Evidence& evidence, int in_sheet, int other, double length) const
    {
        const int sheet_side = side_in_growing(in_sheet);
        if (sheet_side != 0 && side_in_growing(other) == 0 && side(other) == 0)
            evidence[sets_.root(other)][at((sheet_side < 0 ? 1 : 0) ^ sets_.side(other))] += length;
    }

    Evidence at_creases() const
    {
        Evidence evidence;
        for (const FacetJoint& joint : graph_.joints())
        {
            const int a = cells_.cell[at(joint.one)], b = cells_.cell[at(joint.other)];
            if (a < 0 || b < 0 || a == b)
                continue;
            speak(evidence, a, b, joint.length);
            speak(evidence, b, a, joint.length);
        }
        return evidence;
    }

    // For each ledge in a skin, the cells along it and the length of contact.
    std::vector<std::map<int, double>> cells_at_ledges() const
    {
        std::map<int, std::map<int, double>> around;
        std::set<int> high;
        const auto note = [&](int facet, int beside, double length)
        {
            const int cell = cells_.cell[at(beside)], patch = cells_.patch[at(facet)];
            if (cells_.cell[at(facet)] >= 0 || cell < 0)
                return;
            around[patch][cell] += length;
            const double thickness = cells_.thickness[at(cells_.component[at(cell)])];
            if (2.0 * graph_.area(facet) > highest_ledge * thickness * length)
                high.insert(patch);
        };
        for (const FacetJoint& joint : graph_.joints())
        {
            note(joint.one, joint.other, joint.length);
            note(joint.other, joint.one, joint.length);
        }
        std::vector<std::map<int, double>> found;
        for (auto& [patch, cells] : around)
            if (high.count(patch) == 0 && cells.size() > 1)
                found.push_back(std::move(cells));
        return found;
    }

    // Cells that meet in a ledge much lower than the thickness belong to one skin.
    void add_ledges(Evidence& evidence) const
    {
        for (const std::map<int, double>& cells : ledges_)
            for (const auto& [one, length] : cells)
                for (const auto& [other, other_length] : cells)
                    if (one != other)
                        speak(evidence, one, other, std::min(length, other_length));
    }

    // A patch whose sheet cells all lie on one side is evidence for that side.
    void add_patches(Evidence& evidence) const
    {
        // by patch: one of its cells, whether it has both sides
        std::map<int, std::pair<int, int>> sheet_cell;
        for (std::size_t t = 0; t < cells_.cell.size(); ++t)
            if (const int cell = cells_.cell[t]; cell >= 0 && side_in_growing(cell) != 0)
            {
                auto& found = sheet_cell.emplace(cells_.patch[t], std::pair(cell, 0)).first->second;
                found.second |= side_in_growing(found.first) != side_in_growing(cell);
            }
        for (std::size_t t = 0; t < cells_.cell.size(); ++t)
        {
            const auto found = sheet_cell.find(cells_.patch[t]);
            if (cells_.cell[t] >= 0 && found != sheet_cell.end() && found->second.second == 0)
                speak(evidence, found->second.first, cells_.cell[t],
                      weight_of_patch * std::sqrt(graph_.area(static_cast<int>(t))));
        }
    }

    bool grow()
    {
        Evidence evidence = at_creases();
        add_ledges(evidence);
        add_patches(evidence);
        bool has_grown = false;
        for (const auto& [root, lengths] : evidence)
        {
            const int flip = lengths[1] > lengths[0] ? 1 : 0;
            if (side_in_growing(root) != 0
                || lengths[at(flip)] < agreement * (lengths[0] + lengths[1]))
                continue;
            const int seed = seeds_[at(cells_.component[at(root)])];
            sets_.join(seed, root, flip);
            has_grown = true;
        }
        return has_grown;
    }

    const FacetGraph& graph_;
    const SkinCells& cells_;
    ParitySets sets_;
    std::vector<int> seeds_;  // by component: a cell of the growing sheet, or -1
    std::vector<std::map<int, double>> ledges_;
    std::set<int> finished_;  // roots of the sheets that are complete
};

// Diagonals of the components' bounding boxes, mm.
std::vector<double> sizes(const mesh::TriangleMesh& mesh, const FacetGraph& graph)
{
    std::vector<Eigen::RowVector3d> low(at(graph.component_count()),
                                        Eigen::RowVector3d::Constant(1e300));
    std::vector<Eigen::RowVector3d> high(at(graph.component_count()),
                                         Eigen::RowVector3d::Constant(-1e300));
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const std::size_t component = at(graph.component(t));
            const auto point = mesh.points().row(mesh.triangles()(t, k));
            low[component] = low[component].cwiseMin(point);
            high[component] = high[component].cwiseMax(point);
        }
    std::vector<double> found;
    for (std::size_t k = 0; k < low.size(); ++k)
        found.push_back((high[k] - low[k]).norm());
    return found;
}

}  // namespace

SkinPairs skin_pairs(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                     const SkinCells& cells, bool are_several)
{
    const Sheets sheets(graph, cells, are_several);
    SkinPairs pairs;
    const std::size_t count = at(graph.component_count());
    std::vector<double> whole(count, 0.0), skins(count, 0.0);
    for (int t = 0; t < graph.triangle_count(); ++t)
    {
        pairs.side.push_back(cells.cell[at(t)] < 0 ? 0 : sheets.side(cells.cell[at(t)]));
        const std::size_t component = at(graph.component(t));
        whole[component] += graph.area(t);
        skins[component] += pairs.side.back() != 0 ? graph.area(t) : 0.0;
    }
    const std::vector<double> size = sizes(mesh, graph);
    for (std::size_t k = 0; k < count; ++k)
    {
        pairs.share.push_back(whole[k] > 0.0 ? skins[k] / whole[k] : 0.0);
        pairs.is_thin.push_back(pairs.share[k] >= least_share_of_skins
                                && cells.thickness[k] <= thickest_of_size * size[k]);
    }
    for (int t = 0; t < graph.triangle_count(); ++t)
        if (!pairs.is_thin[at(graph.component(t))])
            pairs.side[at(t)] = 0;
    return pairs;
}

}  // namespace sheetmorph::recognise
