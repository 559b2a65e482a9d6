// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/facets/coarse_facets.h"

#include "sheetmorph/mesh/topology/editable_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace sheetmorph::recognise
{

namespace
{

constexpr int none = -1;

// Cosine between normals inside a facet, and at a vertex on a straight edge. From files with seven
// digits: normals of a facet a thousandth of the part wide are exact to 1e-4 radians; chosen ten
// times larger, a thousandth of a radian (1 - 1e-3^2 / 2).
constexpr double in_plane = 1.0 - 5e-7;
constexpr double straight = -1.0 + 5e-7;

// Target edge length relative to the facet's width and to the part's size. From geometry: a patch
// of 14 triangles is about three edges wide, so it spans several facets and shows their curvature,
// and a tenth of the part. Measured: with of_size 0.06, Surfaces.AConeIsExactHoweverSlenderAndFine
// finds no exact cone.
constexpr double of_width = 2.0;
constexpr double of_size = 0.03;

// Relative to the target length: shorter edges collapse, unless the collapse creates an edge longer
// than too_long. Chosen: a collapse merges two edges into one of up to twice the length; 1.7 keeps
// the angles of the new triangles.
constexpr double too_short = 1.0;
constexpr double too_long = 1.7;

// Minimum height over longest side of a triangle after a collapse. Chosen: three degrees; normals
// are still exact to 1e-5 (from files with seven digits).
constexpr double slimmest = 0.05;

// Coarsening is worthwhile if at most this share of the triangles would remain. Chosen: removing
// less than a tenth does not change how far a patch reaches.
constexpr double far_fewer = 0.9;

// The facet of every triangle. A degenerate triangle forms its own facet.
std::vector<int> facets_of(const FacetGraph& graph)
{
    std::vector<int> facet(static_cast<std::size_t>(graph.triangle_count()), none);
    std::vector<int> front;
    int count = 0;
    for (int seed = 0; seed < graph.triangle_count(); ++seed)
    {
        if (facet[seed] != none)
            continue;
        facet[seed] = count;
        front.assign(1, seed);
        while (!front.empty() && !graph.is_thin(seed))
        {
            const int here = front.back();
            front.pop_back();
            for (int k = 0; k < 3; ++k)
            {
                const int other = graph.across(here, k);
                if (other == none || facet[other] != none
                    || std::abs(graph.normal(seed).dot(graph.normal(other))) < in_plane)
                    continue;
                facet[other] = count;
                front.push_back(other);
            }
        }
        ++count;
    }
    return facet;
}

// Removes vertices from facets.
class FacetThinner
{
public:
    FacetThinner(const FacetGraph& graph, const std::vector<int>& facet)
        : graph_(graph),
          facet_(facet),
          triangles_(graph.mesh(), {}),
          uses_(static_cast<std::size_t>(graph.mesh().vertex_count()), 0)
    {
        for (int t = 0; t < graph.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k)
                ++uses_[graph.mesh().triangles()(t, k)];
        measure_wanted();
    }

    // Whether coarsening would remove enough triangles.
    bool is_worth_while() const
    {
        double few = 0.0;
        for (int t = 0; t < graph_.triangle_count(); ++t)
        {
            // Area of a triangle with the target length: two of them fill a square.
            const double sides = std::pow(wanted_[facet_[t]], 2) / 2.0;
            few += sides > 0.0 ? std::min(1.0, graph_.area(t) / sides) : 1.0;
        }
        return few < far_fewer * graph_.triangle_count();
    }

    // Ends because every pass but the last removes a vertex.
    const mesh::EditableTriangles& thinned()
    {
        for (bool has_changed = true; has_changed;)
        {
            has_changed = false;
            for (int v = 0; v < triangles_.vertex_count(); ++v)
                has_changed = try_vertex(v) || has_changed;
        }
        return triangles_;
    }

private:
    void measure_wanted();
    bool try_vertex(int v);
    bool may_move(int v, int to, const std::vector<int>& fan, double wanted) const;
    std::vector<int> ways(int v, const std::vector<int>& fan) const;
    double length(int a, int b) const { return (graph_.point(a) - graph_.point(b)).norm(); }

    const FacetGraph& graph_;
    const std::vector<int>& facet_;
    mesh::EditableTriangles triangles_;
    std::vector<int> uses_;       // by vertex: number of its triangles
    std::vector<double> wanted_;  // by facet: target edge length, mm; 0: no collapse
};

void FacetThinner::measure_wanted()
{
    const int count = 1 + *std::max_element(facet_.begin(), facet_.end());
    std::vector<double> area(static_cast<std::size_t>(count), 0.0), border = area;
    for (int t = 0; t < graph_.triangle_count(); ++t)
    {
        area[facet_[t]] += graph_.area(t);
        for (int k = 0; k < 3; ++k)
        {
            const int other = graph_.across(t, k);
            const Triangles& corners = graph_.mesh().triangles();
            if (other == none || facet_[other] != facet_[t])
                border[facet_[t]] += length(corners(t, k), corners(t, (k + 1) % 3));
        }
    }
    const double longest = of_size * graph_.mesh().size();
    wanted_.resize(area.size());
    for (std::size_t f = 0; f < area.size(); ++f)
        wanted_[f] =
            border[f] > 0.0 ? std::min(of_width * 2.0 * area[f] / border[f], longest) : longest;
}

// Vertices that v may collapse onto: any neighbour if v is inside a facet; the neighbours along the
// edge if v is on a straight edge between two facets or on a straight border of one.
std::vector<int> FacetThinner::ways(int v, const std::vector<int>& fan) const
{
    std::vector<int> all, edge;
    bool is_border = false;
    for (const int t : fan)
    {
        const int k = triangles_.corner_of(t, v);
        const int after = triangles_.across(t, k), before = triangles_.across(t, k + 2);
        if (graph_.is_thin(t))
            return {};
        all.push_back(triangles_.corner(t, k + 1));
        if (after == none || facet_[after] != facet_[t])
            edge.push_back(all.back());
        if (before == none)
            edge.push_back(triangles_.corner(t, k + 2));
        is_border = is_border || after == none || before == none;
    }
    if (edge.empty())
        return all;
    const bool is_one_facet = std::all_of(fan.begin(), fan.end(),
                                          [&](int t) { return facet_[t] == facet_[fan.front()]; });
    if (edge.size() != 2 || (is_border && !is_one_facet))
        return {};
    const Vector3 one = (graph_.point(edge[0]) - graph_.point(v)).normalized();
    const Vector3 two = (graph_.point(edge[1]) - graph_.point(v)).normalized();
    return one.dot(two) < straight ? edge : std::vector<int>();
}

bool FacetThinner::try_vertex(int v)
{
    if (triangles_.triangle_at(v) == none)
        return false;
    const std::vector<int> fan = triangles_.around(v);
    if (static_cast<int>(fan.size()) != uses_[v] || fan.size() < 3)
        return false;
    double wanted = std::numeric_limits<double>::max();
    for (const int t : fan)
        wanted = std::min(wanted, wanted_[facet_[t]]);
    int best = none;
    double shortest = too_short * wanted;
    for (const int to : ways(v, fan))
        if (const double far = length(v, to); far < shortest && may_move(v, to, fan, wanted))
        {
            shortest = far;
            best = to;
        }
    if (best == none)
        return false;
    for (const int t : fan)
        if (triangles_.corner_of(t, best) < 0)
            ++uses_[best];
        else
            for (int k = 0; k < 3; ++k)
                --uses_[triangles_.corner(t, k)];
    uses_[v] = 0;
    triangles_.collapse(v, best);
    return true;
}

// Rejects a collapse that flips a triangle or creates a sliver or an edge that is too long.
bool FacetThinner::may_move(int v, int to, const std::vector<int>& fan, double wanted) const
{
    const std::vector<int> beyond = triangles_.around(to);
    if (static_cast<int>(beyond.size()) != uses_[to])
        return false;
    std::vector<int> ring;
    for (const int t : beyond)
        for (int k = 0; k < 3; ++k)
            if (triangles_.corner(t, k) != to)
                ring.push_back(triangles_.corner(t, k));
    std::vector<int> common;
    int going = 0;
    for (const int t : fan)
    {
        const int k = triangles_.corner_of(t, v);
        const int b = triangles_.corner(t, k + 1), c = triangles_.corner(t, k + 2);
        for (const int near : {b, c})
            if (near != to && std::find(ring.begin(), ring.end(), near) != ring.end()
                && std::find(common.begin(), common.end(), near) == common.end())
                common.push_back(near);
        if (b == to || c == to)
        {
            // Collapsing a triangle without neighbours on both remaining sides would isolate its
            // third vertex.
            if (triangles_.across(t, k + 1) == none
                && triangles_.across(t, b == to ? k + 2 : k) == none)
                return false;
            ++going;
            continue;
        }
        const Vector3 ab = graph_.point(b) - graph_.point(to);
        const Vector3 ac = graph_.point(c) - graph_.point(to);
        const double longest = std::max({ab.norm(), ac.norm(), length(b, c)});
        if (!(ab.cross(ac).dot(graph_.normal(t)) > slimmest * longest * longest)
            || std::max(ab.norm(), ac.norm()) > too_long * wanted)
            return false;
    }
    // Link condition: the two vertices share only the apexes of the triangles at their common edge.
    return static_cast<int>(common.size()) == going;
}

mesh::TriangleMesh rest_of(const mesh::TriangleMesh& mesh, const mesh::EditableTriangles& thinned,
                           const std::vector<int>& facet, std::vector<int>& facet_of_rest)
{
    std::vector<int> number(static_cast<std::size_t>(mesh.vertex_count()), none);
    std::vector<int> kept;
    Triangles rest(thinned.count(), 3);
    Eigen::Index rows = 0;
    for (int t = 0; t < thinned.count(); ++t)
    {
        if (!thinned.triangle(t).is_alive())
            continue;
        for (int k = 0; k < 3; ++k)
        {
            const int v = thinned.corner(t, k);
            if (number[v] == none)
            {
                number[v] = static_cast<int>(kept.size());
                kept.push_back(v);
            }
            rest(rows, k) = number[v];
        }
        facet_of_rest.push_back(facet[t]);
        ++rows;
    }
    return {mesh.points()(kept, Eigen::indexing::all), rest.topRows(rows)};
}

}  // namespace

std::optional<CoarseFacets> CoarseFacets::of(const FacetGraph& fine)
{
    if (fine.scatter() > 0.0 || fine.triangle_count() == 0)
        return std::nullopt;
    std::vector<int> facet = facets_of(fine);
    FacetThinner thinner(fine, facet);
    if (!thinner.is_worth_while())
        return std::nullopt;
    std::vector<int> facet_of_rest;
    const mesh::TriangleMesh rest = rest_of(fine.mesh(), thinner.thinned(), facet, facet_of_rest);
    return CoarseFacets(rest, std::move(facet_of_rest), std::move(facet));
}

CoarseFacets::CoarseFacets(const mesh::TriangleMesh& mesh, std::vector<int> facet_of_coarse,
                           std::vector<int> facet_of_fine)
    : graph_(mesh, 0.0, 0.0), facet_of_coarse_(std::move(facet_of_coarse))
{
    const int count = 1 + *std::max_element(facet_of_fine.begin(), facet_of_fine.end());
    area_.assign(static_cast<std::size_t>(count), 0.0);
    for (int t = 0; t < graph_.triangle_count(); ++t)
        area_[facet_of_coarse_[t]] += graph_.area(t);
    starts_.assign(static_cast<std::size_t>(count) + 1, 0);
    for (const int facet : facet_of_fine)
        ++starts_[facet + 1];
    for (std::size_t f = 1; f < starts_.size(); ++f)
        starts_[f] += starts_[f - 1];
    std::vector<int> next = starts_;
    fine_.resize(facet_of_fine.size());
    for (std::size_t t = 0; t < facet_of_fine.size(); ++t)
        fine_[next[facet_of_fine[t]]++] = static_cast<int>(t);
}

std::vector<int> CoarseFacets::fine_triangles(const std::vector<int>& coarse) const
{
    std::vector<int> facets;
    std::vector<double> inside(area_.size(), 0.0);
    for (const int t : coarse)
    {
        inside[facet_of_coarse_[t]] += graph_.area(t);
        facets.push_back(facet_of_coarse_[t]);
    }
    std::sort(facets.begin(), facets.end());
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    std::vector<int> found;
    for (const int f : facets)
        if (2.0 * inside[f] >= area_[f])
            found.insert(found.end(), fine_.begin() + starts_[f], fine_.begin() + starts_[f + 1]);
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace sheetmorph::recognise
