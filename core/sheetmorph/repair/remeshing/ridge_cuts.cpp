// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/ridge_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sheetmorph::repair
{

namespace
{

using Corners = std::array<int, 3>;

// Target sizes along an edge: given at its ends, growing inwards up to the largest.
struct EdgeSizes
{
    double length, from, to, largest;

    double at(double share) const
    {
        return std::min({largest, from + size_growth * share * length,
                         to + size_growth * (1.0 - share) * length});
    }
};

// Positions (0 to 1) of the cuts of an edge: equal steps of the integral of 1 / size.
std::vector<double> even_cuts(const EdgeSizes& sizes)
{
    // Chosen: the midpoint rule integrates sizes that grow by 0.3 to better than 0.1 %.
    constexpr int steps = 256;
    std::array<double, steps + 1> passed{};
    for (int k = 0; k < steps; ++k)
        passed[k + 1] = passed[k] + sizes.length / (steps * sizes.at((k + 0.5) / steps));
    const int pieces = std::max(1, static_cast<int>(std::lround(passed[steps])));
    std::vector<double> cuts;
    for (int piece = 1, k = 0; piece < pieces; ++piece)
    {
        const double wanted = passed[steps] * piece / pieces;
        while (passed[k + 1] < wanted)
            ++k;
        cuts.push_back((k + (wanted - passed[k]) / (passed[k + 1] - passed[k])) / steps);
    }
    return cuts;
}

// Cuts the ridges first, then their triangles.
class RidgeCutter
{
public:
    RidgeCutter(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table)
        : mesh_(mesh), table_(table), first_(table.count()), count_(table.count(), 0)
    {
    }

    void cut(const Patches& patches, const CutWish& wanted)
    {
        found_.sizes = wanted.sizes.at_vertices;
        for (const TwinStop& stop : wanted.stops)
            stops_[{stop.from, stop.to}].emplace_back(stop.share, found_.sizes[stop.vertex]);
        for (int edge = 0; edge < table_.count(); ++edge)
        {
            first_[edge] = mesh_.vertex_count() + static_cast<int>(found_.places.size());
            if (patches.is_ridge[edge])
                cut_edge(edge, wanted.sizes.edge);
        }
        for (int t = 0; t < mesh_.triangle_count(); ++t)
            cut_triangle(t);
    }

    CutMesh result()
    {
        const int old_count = mesh_.vertex_count();
        Points points(old_count + static_cast<int>(found_.places.size()), 3);
        points.topRows(old_count) = mesh_.points();
        for (std::size_t k = 0; k < found_.places.size(); ++k)
        {
            const EdgePlace& place = found_.places[k];
            points.row(old_count + static_cast<int>(k)) =
                (1.0 - place.share) * mesh_.points().row(place.from)
                + place.share * mesh_.points().row(place.to);
        }
        Triangles triangles(pieces_.size(), 3);
        for (std::size_t t = 0; t < pieces_.size(); ++t)
            triangles.row(t) << pieces_[t][0], pieces_[t][1], pieces_[t][2];
        found_.mesh = mesh::TriangleMesh(std::move(points), std::move(triangles));
        std::sort(found_.ridges.begin(), found_.ridges.end());
        return std::move(found_);
    }

private:
    // The vertices of an edge from its smaller to its larger end.
    VertexIds chain(int edge) const
    {
        const mesh::EdgeUse& use = *table_.uses(edge).begin();
        VertexIds ids{std::min(use.from, use.to)};
        for (int k = 0; k < count_[edge]; ++k)
            ids.push_back(first_[edge] + k);
        ids.push_back(std::max(use.from, use.to));
        return ids;
    }

    void cut_edge(int edge, double largest)
    {
        const mesh::EdgeUse& use = *table_.uses(edge).begin();
        const int from = std::min(use.from, use.to), to = std::max(use.from, use.to);
        const double length = (mesh_.points().row(to) - mesh_.points().row(from)).norm();
        const auto put = [&](double share, double size)
        {
            found_.places.push_back({from, to, share});
            found_.sizes.push_back(size);
            ++count_[edge];
        };
        Stops stops{{0.0, found_.sizes[from]}};
        if (const auto own = stops_.find({from, to}); own != stops_.end())
            stops.insert(stops.end(), own->second.begin(), own->second.end());
        stops.emplace_back(1.0, found_.sizes[to]);
        std::sort(stops.begin(), stops.end());
        for (std::size_t k = 1; k < stops.size(); ++k)
        {
            const auto [start, size] = stops[k - 1];
            const double step = stops[k].first - start;
            const EdgeSizes sizes{step * length, size, stops[k].second, largest};
            for (const double share : even_cuts(sizes))
                put(start + share * step, sizes.at(share));
            if (k + 1 < stops.size())
                put(stops[k].first, stops[k].second);
        }
        const VertexIds ids = chain(edge);
        for (std::size_t k = 1; k < ids.size(); ++k)
            found_.ridges.emplace_back(std::min(ids[k - 1], ids[k]), std::max(ids[k - 1], ids[k]));
    }

    // The vertices inserted into side k of a triangle, in the direction of the side.
    VertexIds inside_side(int triangle, int k) const
    {
        const int edge = table_.edge_of(triangle, k);
        if (edge < 0 || count_[edge] == 0)
            return {};
        VertexIds ids = chain(edge);
        if (ids.front() != mesh_.triangles()(triangle, k))
            std::reverse(ids.begin(), ids.end());
        return VertexIds(ids.begin() + 1, ids.end() - 1);
    }

    void cut_triangle(int triangle)
    {
        const auto corners = mesh_.triangles().row(triangle);
        cut_sides({corners(0), corners(1), corners(2)},
                  {inside_side(triangle, 0), inside_side(triangle, 1), inside_side(triangle, 2)},
                  triangle);
    }

    // Makes a fan over the first side with inserted vertices and cuts the remaining sides
    // recursively.
    void cut_sides(Corners corners, std::array<VertexIds, 3> sides, int origin)
    {
        if (sides[0].empty() && (!sides[1].empty() || !sides[2].empty()))
            return cut_sides({corners[1], corners[2], corners[0]}, {sides[1], sides[2], sides[0]},
                             origin);
        if (sides[0].empty())
        {
            pieces_.push_back(corners);
            found_.triangle_of.push_back(origin);
            return;
        }
        VertexIds chain = sides[0];
        chain.insert(chain.begin(), corners[0]);
        chain.push_back(corners[1]);
        for (std::size_t k = 1; k < chain.size(); ++k)
        {
            const bool is_first = k == 1, is_last = k + 1 == chain.size();
            cut_sides(
                {chain[k - 1], chain[k], corners[2]},
                {VertexIds(), is_last ? sides[1] : VertexIds(), is_first ? sides[2] : VertexIds()},
                origin);
        }
    }

    const mesh::TriangleMesh& mesh_;
    const mesh::EdgeTable& table_;
    std::vector<int> first_;  // by edge: its first new vertex
    std::vector<int> count_;
    std::vector<Corners> pieces_;
    using Stops = std::vector<std::pair<double, double>>;  // position on an edge and the size there
    std::map<std::pair<int, int>, Stops> stops_;
    CutMesh found_;
};

}  // namespace

CutMesh cut_ridges(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                   const Patches& patches, const CutWish& wanted)
{
    RidgeCutter cutter(mesh, table);
    cutter.cut(patches, wanted);
    return cutter.result();
}

}  // namespace sheetmorph::repair
