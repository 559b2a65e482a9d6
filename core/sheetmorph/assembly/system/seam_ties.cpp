// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/system/seam_ties.h"

#include "sheetmorph/base/index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>

namespace sheetmorph::assembly
{

namespace
{

// Relative to the size, and to a length: differences that are rounding. Chosen: far above 1e-16,
// and below or at the last digit of files with seven digits.
constexpr double as_near = 1e-9;
constexpr double as_fine = 1e-6;

// The mean edge length, rounded to steps of a ratio.
double coarseness(const mesh::TriangleMesh& mesh)
{
    double sum = 0.0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            sum += (mesh.points().row(mesh.triangles()(t, k))
                    - mesh.points().row(mesh.triangles()(t, (k + 1) % 3)))
                       .norm();
    return sum > 0.0 ? std::round(std::log(sum / (3.0 * mesh.triangle_count())) / as_fine) : 0.0;
}

std::vector<char> rigid_vertices(const Sheet& sheet)
{
    std::vector<char> is_rigid(at(sheet.mesh.vertex_count()), 0);
    const auto mark = [&](const auto& items)
    {
        for (const auto& item : items)
            for (const int vertex : item.vertices)
                is_rigid[at(vertex)] = 1;
    };
    mark(sheet.surface.features);
    mark(sheet.surface.handles);
    mark(sheet.surface.fixed);
    mark(sheet.surface.stitches);
    for (const surface::PointConstraint& point : sheet.surface.points)
        for (const int corner : sheet.mesh.triangles().row(point.triangle))
            is_rigid[at(corner)] = 1;
    return is_rigid;
}

//! Ties vertices to others, so that none depends on itself.
class Tying
{
public:
    explicit Tying(const Sheet& sheet)
        : sheet_(sheet),
          step_(std::max(as_near * sheet.mesh.size(), std::numeric_limits<double>::min())),
          is_rigid_(rigid_vertices(sheet)),
          place_of_(at(sheet.mesh.vertex_count()), nullptr)
    {
    }

    // Ties the targets of all seams, nearest first.
    void tie_targets(const std::vector<Seam>& seams)
    {
        using Key = std::tuple<double, int, int>;  // distance, rank of the source, vertex
        std::vector<std::pair<Key, const mesh::Anchor*>> wishes;
        for (const Seam& seam : seams)
            for (std::size_t k = 0; k < seam.target.size(); ++k)
                if (const int vertex = seam.target[k]; !is_rigid_[at(vertex)])
                    wishes.emplace_back(
                        Key(steps_to(vertex, seam.of_target[k]), seam.source_rank, vertex),
                        &seam.of_target[k]);
        std::stable_sort(wishes.begin(), wishes.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [key, place] : wishes)
            if (const mesh::Anchor*& known = place_of_[at(std::get<2>(key))]; known == nullptr)
                known = place;
    }

    // Ties the source where a whole triangle of the target is already tied elsewhere.
    void tie_source(const Seam& seam)
    {
        for (std::size_t k = 0; k < seam.source.size(); ++k)
        {
            const int vertex = seam.source[k];
            const mesh::Anchor& place = seam.of_source[k];
            const auto is_elsewhere = [&](int corner)
            {
                return place_of_[at(corner)] != nullptr
                       && !leads_to(*place_of_[at(corner)], sheet_.part_of(vertex));
            };
            if (!is_rigid_[at(vertex)] && place_of_[at(vertex)] == nullptr
                && std::all_of(place.corners.begin(), place.corners.end(), is_elsewhere))
                place_of_[at(vertex)] = &place;
        }
    }

    std::vector<surface::Tie> in_order() const
    {
        std::vector<surface::Tie> ties;
        std::vector<char> is_done(place_of_.size(), 0);
        for (int vertex = 0; vertex < sheet_.mesh.vertex_count(); ++vertex)
            add_after_corners(vertex, is_done, ties);
        return ties;
    }

private:
    double steps_to(int vertex, const mesh::Anchor& place) const
    {
        const Vector3 own = sheet_.mesh.points().row(vertex).transpose();
        return std::round((own - place.on(sheet_.mesh.points())).norm() / step_);
    }

    //! Whether a place lies on a part, directly or through ties.
    bool leads_to(const mesh::Anchor& place, int part) const
    {
        std::set<int> seen;
        std::vector<int> open(place.corners.begin(), place.corners.end());
        while (!open.empty())
        {
            const int vertex = open.back();
            open.pop_back();
            if (sheet_.part_of(vertex) == part)
                return true;
            const mesh::Anchor* below = place_of_[at(vertex)];
            if (below != nullptr && seen.insert(vertex).second)
                open.insert(open.end(), below->corners.begin(), below->corners.end());
        }
        return false;
    }

    void add_after_corners(int vertex, std::vector<char>& is_done,
                           std::vector<surface::Tie>& ties) const
    {
        const mesh::Anchor* place = place_of_[at(vertex)];
        if (place == nullptr || is_done[at(vertex)])
            return;
        is_done[at(vertex)] = 1;
        for (const int corner : place->corners)
            add_after_corners(corner, is_done, ties);
        ties.push_back({vertex, *place});
    }

    const Sheet& sheet_;
    double step_;
    std::vector<char> is_rigid_;
    std::vector<const mesh::Anchor*> place_of_;  // by vertex, if tied
};

}  // namespace

std::vector<int> ranks_by_fineness(const Assembly& assembly)
{
    std::vector<double> coarse;
    for (const Part& part : assembly.parts)
        coarse.push_back(coarseness(part.mesh));
    std::vector<int> order(assembly.parts.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int a, int b)
              {
                  return std::tie(coarse[at(b)], assembly.parts[at(a)].name)
                         < std::tie(coarse[at(a)], assembly.parts[at(b)].name);
              });
    std::vector<int> ranks(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        ranks[at(order[k])] = static_cast<int>(k);
    return ranks;
}

void lead_by_coarser(const Assembly& assembly, const std::vector<int>& ranks, PropagationPlan& plan)
{
    for (DirectedContact& directed : plan.measured)
    {
        const Contact& contact = assembly.contacts[at(directed.contact)];
        directed.is_reversed = ranks[at(contact.b.part)] < ranks[at(contact.a.part)];
    }
}

std::vector<surface::Tie> tied(const Sheet& sheet, const std::vector<Seam>& seams)
{
    Tying tying(sheet);
    tying.tie_targets(seams);
    std::vector<const Seam*> by_rank;
    for (const Seam& seam : seams)
        by_rank.push_back(&seam);
    std::stable_sort(
        by_rank.begin(), by_rank.end(),
        [](const Seam* a, const Seam* b)
        { return std::tie(a->source_rank, a->rank) < std::tie(b->source_rank, b->rank); });
    for (const Seam* seam : by_rank)
        tying.tie_source(*seam);
    return tying.in_order();
}

}  // namespace sheetmorph::assembly
