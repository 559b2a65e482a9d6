// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/contacts/contact_patches.h"

#include "sheetmorph/base/disjoint_sets.h"

#include <algorithm>
#include <map>
#include <set>

namespace sheetmorph::recognise
{

namespace
{

// From geometry: fewer vertices do not span an area, and their triangles are added.
constexpr std::size_t fewest = 3;

// A vertex within this many reaches of the other part can connect two touching vertices. Chosen:
// between two touching vertices of a bent flange, the gap may be a few times as wide.
constexpr double nearly = 3.0;

class Clusterer
{
public:
    Clusterer(const PartShape& a, const PartShape& b,
              const std::array<std::vector<Touch>, 2>& touches, double reach)
        : shapes_{&a, &b},
          touches_(touches),
          reach_(reach),
          sets_(static_cast<int>(touches[0].size() + touches[1].size()))
    {
        for (int side = 0; side < 2; ++side)
            for (std::size_t i = 0; i < touches[side].size(); ++i)
                place_[side][touches[side][i].vertex] = number(side, i);
    }

    std::vector<Patch> patches()
    {
        for (int side = 0; side < 2; ++side)
        {
            join_neighbours(side);
            for (std::size_t i = 0; i < touches_[side].size(); ++i)
                join_across(side, i);
        }
        std::map<int, std::array<std::vector<const Touch*>, 2>> clusters;
        for (int side = 0; side < 2; ++side)
            for (std::size_t i = 0; i < touches_[side].size(); ++i)
                clusters[sets_.root(number(side, i))][side].push_back(&touches_[side][i]);
        std::vector<Patch> found;
        for (const auto& [root, members] : clusters)
            found.push_back(patch_of(members));
        return found;
    }

private:
    int number(int side, std::size_t i) const
    {
        return static_cast<int>(i + (side == 0 ? 0 : touches_[0].size()));
    }

    // Joins the touching neighbours of each vertex, also across one vertex that nearly touches.
    void join_neighbours(int side)
    {
        for (std::size_t i = 0; i < touches_[side].size(); ++i)
            for (const int near : corners_around(side, touches_[side][i].vertex))
                if (!joins(side, i, near) && is_close(side, near))
                    for (const int next : corners_around(side, near))
                        joins(side, i, next);
    }

    bool joins(int side, std::size_t i, int vertex)
    {
        const auto found = place_[side].find(vertex);
        if (found == place_[side].end())
            return false;
        sets_.join(number(side, i), found->second);
        return true;
    }

    bool is_close(int side, int vertex) const
    {
        const Vector3 point = shapes_[side]->graph().point(vertex);
        return shapes_[1 - side]->tree().nearest_point(point, nearly * reach_).has_value();
    }

    VertexIds corners_around(int side, int vertex) const
    {
        VertexIds corners;
        for (const int t : shapes_[side]->triangles_at(vertex))
            for (int k = 0; k < 3; ++k)
                corners.push_back(shapes_[side]->graph().mesh().triangles()(t, k));
        return corners;
    }

    void join_across(int side, std::size_t i)
    {
        const Triangles& other = shapes_[1 - side]->graph().mesh().triangles();
        for (int k = 0; k < 3; ++k)
        {
            const auto found = place_[1 - side].find(other(touches_[side][i].triangle, k));
            if (found != place_[1 - side].end())
                sets_.join(number(side, i), found->second);
        }
    }

    Patch patch_of(const std::array<std::vector<const Touch*>, 2>& members) const
    {
        Patch patch;
        std::vector<double> distances;
        double edges = 0.0;
        for (int side = 0; side < 2; ++side)
        {
            std::set<int> vertices;
            for (const Touch* touch : members[side])
            {
                vertices.insert(touch->vertex);
                distances.push_back(touch->distance);
                edges += touch->is_edge;
            }
            const Triangles& triangles = shapes_[side]->graph().mesh().triangles();
            if (vertices.size() < fewest)
                for (const Touch* touch : members[1 - side])
                    for (int k = 0; k < 3; ++k)
                        vertices.insert(triangles(touch->triangle, k));
            patch.sides[side].assign(vertices.begin(), vertices.end());
        }
        const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
        std::nth_element(distances.begin(), middle, distances.end());
        patch.distance = *middle;
        patch.edge_share = edges / static_cast<double>(distances.size());
        return patch;
    }

    std::array<const PartShape*, 2> shapes_;
    const std::array<std::vector<Touch>, 2>& touches_;
    double reach_;
    DisjointSets sets_;
    std::array<std::map<int, int>, 2> place_;  // index of a touching vertex in sets_
};

}  // namespace

std::vector<Patch> patches_of(const PartShape& a, const PartShape& b,
                              const std::array<std::vector<Touch>, 2>& touches, double reach)
{
    return Clusterer(a, b, touches, reach).patches();
}

}  // namespace sheetmorph::recognise
