// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/whole/seam_ties.h"

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

std::vector<char> rigid_vertices(const Assembly& joined)
{
    const Part& part = joined.parts.front();
    std::vector<char> is_rigid(at(part.mesh.vertex_count()), 0);
    const auto mark = [&](const auto& items)
    {
        for (const auto& item : items)
            for (const int vertex : item.vertices)
                is_rigid[at(vertex)] = 1;
    };
    mark(joined.features);
    mark(joined.handles);
    mark(joined.fixed);
    mark(part.stitches);
    for (const PartPoint& point : joined.points)
        for (const int corner : part.mesh.triangles().row(point.constraint.triangle))
            is_rigid[at(corner)] = 1;
    return is_rigid;
}

//! Ties vertices to others, so that none depends on itself.
class Tying
{
public:
    explicit Tying(const Assembly& joined)
        : part_(joined.parts.front()),
          step_(std::max(as_near * part_.mesh.size(), std::numeric_limits<double>::min())),
          is_rigid_(rigid_vertices(joined)),
          place_of_(at(part_.mesh.vertex_count()), nullptr)
    {
    }

    // Ties the targets of all seams, nearest first.
    void tie_targets(const std::vector<TiedSeam>& seams)
    {
        using Key = std::tuple<double, int, int>;  // distance, rank of the source, vertex
        std::vector<std::pair<Key, const mesh::Anchor*>> wishes;
        for (const TiedSeam& seam : seams)
            for (std::size_t k = 0; k < seam.target.size(); ++k)
                if (const int vertex = seam.target[k]; !is_rigid_[at(vertex)])
                    wishes.emplace_back(
                        Key(steps_to(vertex, seam.places.of_target[k]), seam.source_rank, vertex),
                        &seam.places.of_target[k]);
        std::stable_sort(wishes.begin(), wishes.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [key, place] : wishes)
            if (const mesh::Anchor*& known = place_of_[at(std::get<2>(key))]; known == nullptr)
                known = place;
    }

    // Ties the source where a whole triangle of the target is already tied elsewhere.
    void tie_source(const TiedSeam& seam)
    {
        for (std::size_t k = 0; k < seam.source.size(); ++k)
        {
            const int vertex = seam.source[k];
            const mesh::Anchor& place = seam.places.of_source[k];
            const auto is_elsewhere = [&](int corner) {
                return place_of_[at(corner)] != nullptr
                       && !leads_to(*place_of_[at(corner)], part_of(vertex));
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
        for (int vertex = 0; vertex < part_.mesh.vertex_count(); ++vertex)
            add_after_corners(vertex, is_done, ties);
        return ties;
    }

private:
    double steps_to(int vertex, const mesh::Anchor& place) const
    {
        const Vector3 own = part_.mesh.points().row(vertex).transpose();
        return std::round((own - place.on(part_.mesh.points())).norm() / step_);
    }

    int part_of(int vertex) const
    {
        const auto after = std::upper_bound(part_.joined.begin(), part_.joined.end(), vertex);
        return static_cast<int>(after - part_.joined.begin()) - 1;
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
            if (part_of(vertex) == part)
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

    const Part& part_;
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

void lead_by_coarser(const Assembly& assembly, PropagationPlan& plan)
{
    const std::vector<int> ranks = ranks_by_fineness(assembly);
    for (DirectedContact& directed : plan.measured)
    {
        const Contact& contact = assembly.contacts[at(directed.contact)];
        directed.is_reversed = ranks[at(contact.b.part)] < ranks[at(contact.a.part)];
    }
}

std::vector<surface::Tie> tied(const Assembly& joined, const std::vector<TiedSeam>& seams)
{
    Tying tying(joined);
    tying.tie_targets(seams);
    std::vector<const TiedSeam*> by_rank;
    for (const TiedSeam& seam : seams)
        by_rank.push_back(&seam);
    std::stable_sort(
        by_rank.begin(), by_rank.end(),
        [](const TiedSeam* a, const TiedSeam* b)
        { return std::tie(a->source_rank, a->rank) < std::tie(b->source_rank, b->rank); });
    for (const TiedSeam* seam : by_rank)
        tying.tie_source(*seam);
    return tying.in_order();
}

}  // namespace sheetmorph::assembly
