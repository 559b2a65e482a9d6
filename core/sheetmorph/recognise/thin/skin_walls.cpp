// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/skin_walls.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/topology/submesh.h"
#include "sheetmorph/recognise/thin/thin_solid.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace sheetmorph::recognise
{

namespace
{

// In thicknesses; from skin_cells.cpp: a wall at the edge of a fold reaches sqrt(2) of them.
// Measured: at half of it walls are lost (six tests of ThinSolid and ThicknessGauge).
constexpr double reach_of_walls = 1.6;

// A facet whose inward normal deviates by more than 60 degrees from the direction to the other skin
// runs along that direction. Chosen: a chamfer by 45 degrees belongs to its skin. Measured: at
// twice the cosine a wall takes in facets of the skins (the two tests of farthest_skin).
constexpr double across = 0.5;

constexpr int on_both = 2;  // chosen: no side, which is +1 or -1
constexpr int none = -1;

constexpr Eigen::Index least_facets = 50;  // fewest for a thread; chosen, not measured

class Walls
{
public:
    Walls(const mesh::TriangleMesh& mesh, const FacetGraph& graph, const SkinCells& cells,
          const SkinPairs& pairs)
        : mesh_(mesh), graph_(graph), cells_(cells), pairs_(pairs)
    {
        std::map<std::pair<int, int>, std::vector<int>> skins;
        for (int t = 0; t < graph_.triangle_count(); ++t)
            if (pairs.side[at(t)] != 0)
                skins[{graph.component(t), pairs.side[at(t)]}].push_back(t);
        for (const auto& [skin, facets] : skins)
            trees_.emplace(skin, mesh::PickingTree(mesh::submesh(mesh, facets).mesh));
        result_.side = pairs.side;
        result_.is_lump.assign(pairs.side.size(), 0);
        result_.is_step.assign(pairs.side.size(), 0);
        is_wall_.assign(pairs.side.size(), 0);
        is_ledge_.assign(pairs.side.size(), 0);
    }

    FacetSides run()
    {
        find_sides_of_patches();
        measure_corners();
        parallel_ranges(graph_.triangle_count(), least_facets,
                        [this](Eigen::Index begin, Eigen::Index end)
                        {
                            for (auto t = static_cast<int>(begin); t < end; ++t)
                                if (is_open(t))
                                    place(t);
                        });
        give_steps_to_their_skin();
        place_thin_facets();
        return result_;
    }

private:
    // 0 on components that are not thin.
    double thickness(int facet) const
    {
        const std::size_t component = at(graph_.component(facet));
        return pairs_.is_thin[component] ? cells_.thickness[component] : 0.0;
    }

    // Whether a facet is not on a skin yet.
    bool is_open(int facet) const
    {
        return pairs_.side[at(facet)] == 0 && !graph_.is_thin(facet) && thickness(facet) > 0.0;
    }

    // The skin of the facet's patch, or on_both if the patch has no skin or both.
    int side_of(int facet) const
    {
        const auto patch = side_of_patch_.find(cells_.patch[at(facet)]);
        return patch != side_of_patch_.end() ? patch->second : on_both;
    }

    // Measures the distances from corners of possible walls to the skins once, because facets share
    // corners.
    void measure_corners()
    {
        facet_at_.assign(at(mesh_.vertex_count()), none);
        for (int t = 0; t < graph_.triangle_count(); ++t)
            for (int k = 0; k < 3 && is_open(t) && side_of(t) == on_both; ++k)
                if (int& facet = facet_at_[at(mesh_.triangles()(t, k))];
                    facet == none || graph_.component(facet) == graph_.component(t))
                    facet = t;
        distances_.resize(facet_at_.size());
        parallel_ranges(mesh_.vertex_count(), least_facets,
                        [this](Eigen::Index begin, Eigen::Index end)
                        {
                            for (auto v = static_cast<int>(begin); v < end; ++v)
                                for (const int sign : {-1, 1})
                                    if (facet_at_[at(v)] != none)
                                        distances_[at(v)][sign > 0] =
                                            nearest(facet_at_[at(v)], sign, corner(v)).distance;
                        });
    }

    Vector3 corner(int vertex) const { return mesh_.points().row(vertex).transpose(); }

    // Searches the skins of the facet's own component only; parts that touch it from outside have
    // no effect.
    mesh::Hit nearest(int facet, int sign, const Vector3& point) const
    {
        return *trees_.at({graph_.component(facet), sign}).nearest_point(point);
    }

    void find_sides_of_patches()
    {
        for (int t = 0; t < graph_.triangle_count(); ++t)
            if (const int side = pairs_.side[at(t)]; side != 0)
            {
                int& found = side_of_patch_.emplace(cells_.patch[at(t)], side).first->second;
                found = found == side ? side : on_both;
            }
    }

    // The largest distance of a corner of the facet from a skin, mm.
    double farthest(int facet, int sign) const
    {
        double longest = 0.0;
        for (int k = 0; k < 3; ++k)
        {
            const int vertex = mesh_.triangles()(facet, k);
            const bool is_measured =
                graph_.component(facet_at_[at(vertex)]) == graph_.component(facet);
            longest =
                std::max(longest, is_measured ? distances_[at(vertex)][sign > 0]
                                              : nearest(facet, sign, corner(vertex)).distance);
        }
        return longest;
    }

    bool runs_along(int facet, const mesh::Hit& other) const
    {
        const Vector3 way = other.point - graph_.centroid(facet);
        return -way.dot(graph_.normal(facet)) < across * way.norm();
    }

    void place(int facet)
    {
        const int side = side_of(facet);
        const double reach = reach_of_walls * thickness(facet);
        if (side != on_both)
        {
            const mesh::Hit other = nearest(facet, -side, graph_.centroid(facet));
            is_wall_[at(facet)] = other.distance <= reach && runs_along(facet, other);
            if (!is_wall_[at(facet)])
                add_to_skin(facet, side);
            return;
        }
        const double near = farthest(facet, 1), far = farthest(facet, -1);
        is_wall_[at(facet)] = near <= reach && far <= reach;
        is_ledge_[at(facet)] = std::min(near, far) <= highest_ledge * thickness(facet);
        result_.is_lump[at(facet)] = !is_wall_[at(facet)];
    }

    void add_to_skin(int facet, int sign)
    {
        result_.side[at(facet)] = sign;
        const mesh::Hit other = nearest(facet, -sign, graph_.centroid(facet));
        result_.is_lump[at(facet)] = other.distance > farthest_skin * thickness(facet);
    }

    // Keeps only the ledges whose facets are all low, because every wall has low facets along its
    // rims.
    void keep_whole_ledges()
    {
        std::set<int> high;
        for (int t = 0; t < graph_.triangle_count(); ++t)
            if (is_wall_[at(t)] && !is_ledge_[at(t)])
                high.insert(cells_.patch[at(t)]);
        for (int t = 0; t < graph_.triangle_count(); ++t)
            if (high.count(cells_.patch[at(t)]) != 0)
                is_ledge_[at(t)] = 0;
    }

    void give_steps_to_their_skin()
    {
        keep_whole_ledges();
        DisjointSets walls(graph_.triangle_count());
        for (const FacetJoint& joint : graph_.joints())
            if (is_wall_[at(joint.one)] && is_wall_[at(joint.other)]
                && is_ledge_[at(joint.one)] == is_ledge_[at(joint.other)])
                walls.join(joint.one, joint.other);
        std::map<int, int> side_around;
        const auto note = [&](int wall, int other)
        {
            const int side = result_.side[at(other)];
            if (!is_wall_[at(wall)] || is_wall_[at(other)] || side == 0)
                return;
            int& found = side_around.emplace(walls.root(wall), side).first->second;
            found = found == side ? side : on_both;
        };
        for (const FacetJoint& joint : graph_.joints())
        {
            note(joint.one, joint.other);
            note(joint.other, joint.one);
        }
        for (int t = 0; t < graph_.triangle_count(); ++t)
            if (is_wall_[at(t)])
                if (const auto found = side_around.find(walls.root(t));
                    found != side_around.end() && found->second != on_both)
                {
                    add_to_skin(t, found->second);
                    result_.is_step[at(t)] = 1;
                }
    }

    // Adds degenerate facets to a skin that contains all their corners, because the skin would
    // otherwise have a slit.
    void place_thin_facets()
    {
        std::vector<std::array<char, 2>> touches(at(mesh_.vertex_count()), {0, 0});
        for (int t = 0; t < graph_.triangle_count(); ++t)
            for (int k = 0; k < 3 && result_.side[at(t)] != 0; ++k)
                touches[at(mesh_.triangles()(t, k))][result_.side[at(t)] > 0 ? 0 : 1] = 1;
        for (int t = 0; t < graph_.triangle_count(); ++t)
            for (const int sign : {1, -1})
                if (graph_.is_thin(t) && thickness(t) > 0.0 && result_.side[at(t)] == 0)
                {
                    bool all = true;
                    for (int k = 0; k < 3; ++k)
                        all = all && touches[at(mesh_.triangles()(t, k))][sign > 0 ? 0 : 1] != 0;
                    result_.side[at(t)] = all ? sign : 0;
                }
    }

    const mesh::TriangleMesh& mesh_;
    const FacetGraph& graph_;
    const SkinCells& cells_;
    const SkinPairs& pairs_;
    std::map<std::pair<int, int>, mesh::PickingTree> trees_;  // by component and side
    std::map<int, int> side_of_patch_;
    // by vertex: a facet whose component its distances refer to, or none
    std::vector<int> facet_at_;
    std::vector<std::array<double, 2>> distances_;  // mm, from the skins -1 and 1
    std::vector<char> is_wall_, is_ledge_;          // all corners of a ledge lie on one skin
    FacetSides result_;
};

}  // namespace

FacetSides skin_walls(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                      const SkinCells& cells, const SkinPairs& pairs)
{
    if (std::find(pairs.is_thin.begin(), pairs.is_thin.end(), 1) == pairs.is_thin.end())
        return {pairs.side, std::vector<char>(pairs.side.size(), 0),
                std::vector<char>(pairs.side.size(), 0)};
    return Walls(mesh, graph, cells, pairs).run();
}

}  // namespace sheetmorph::recognise
