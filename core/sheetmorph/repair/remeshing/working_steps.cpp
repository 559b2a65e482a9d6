// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps of adaptive isotropic remeshing (Botsch, Kobbelt 2004; Dunyach et al. 2013).
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/repair/remeshing/sizes.h"
#include "sheetmorph/repair/remeshing/working_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace sheetmorph::repair
{

namespace
{

// From Botsch and Kobbelt, A Remeshing Approach to Multiresolution Modeling, 2004: after a split or
// a collapse at these lengths, edges are nearer to the target than before.
constexpr double too_long = 4.0 / 3.0;
constexpr double too_short = 4.0 / 5.0;

// Of a new triangle, relative to its longest edge. Chosen: an angle of one degree; sliver_aspect of
// the diagnosis is 0.04.
constexpr double least_height = 0.02;
constexpr auto edges_of_work = "the edges of the new mesh";
// Cosine between a triangle's normals before and after a step. Chosen: 37 degrees, the bend of a
// coarse round wall.
constexpr double least_alignment = 0.8;

// Whether a triangle keeps its orientation, approximately, and has an area.
bool is_sound(const Vector3& before, const Vector3& after)
{
    const double product = before.norm() * after.norm();
    return product > 0.0 && before.dot(after) > least_alignment * product;
}

double height_ratio(const Vector3& a, const Vector3& b, const Vector3& c)
{
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return longest > 0.0 ? WorkingMesh::area_vector(a, b, c).norm() / longest : 0.0;
}

double cotangent_at(const Vector3& apex, const Vector3& a, const Vector3& b)
{
    const Vector3 to_a = a - apex, to_b = b - apex;
    return to_a.dot(to_b) / std::max(to_a.cross(to_b).norm(), 1e-300);
}

bool flip_if_better(WorkingMesh& work, int t, int k)
{
    const int right = work.opposite(t, k), left = work.corner(t, k + 2);
    const Vector3 &a = work.at(t, k), &b = work.at(t, k + 1);
    const Vector3 &c = work.point[left], &d = work.point[right];
    // Two angles add up to more than pi if their cotangents add up to less than 0.
    if (!(cotangent_at(c, a, b) + cotangent_at(d, a, b) < -1e-7) || !work.may_flip(t, k))
        return false;
    // Compares with the area vector of the pair, because a thin triangle alone has no reliable
    // normal.
    const Vector3 pair = WorkingMesh::area_vector(a, b, c) + WorkingMesh::area_vector(b, a, d);
    if (!is_sound(pair, WorkingMesh::area_vector(a, d, c))
        || !is_sound(pair, WorkingMesh::area_vector(d, b, c)))
        return false;
    work.flip(t, k);
    return true;
}

// Whether the triangles around a vertex keep their orientation if it moves to `place`. Triangles
// that also contain the vertex `gone` disappear.
bool may_move(const WorkingMesh& work, int v, int gone, const Vector3& place)
{
    for (const int t : work.around(v))
    {
        const int k = work.corner_of(t, v);
        if (work.corner(t, k + 1) == gone || work.corner(t, k + 2) == gone)
            continue;
        const Vector3 &p = work.at(t, k + 1), &q = work.at(t, k + 2), &now = work.point[v];
        // A degenerate triangle may become any triangle.
        const double height = height_ratio(now, p, q);
        if (height > 1e-4
            && (height_ratio(place, p, q) < std::min(least_height, height)
                || !is_sound(WorkingMesh::area_vector(now, p, q),
                             WorkingMesh::area_vector(place, p, q))))
            return false;
    }
    return true;
}

bool grows_too_long(const WorkingMesh& work, int v, const std::vector<int>& ring,
                    const Vector3& place)
{
    return std::any_of(ring.begin(), ring.end(),
                       [&](int other)
                       {
                           return (work.point[other] - place).norm()
                                  > too_long * 0.5 * (work.size[other] + work.size[v]);
                       });
}

// Collapses a side to one end or to its middle if the result is sound.
void collapse_if_sound(WorkingMesh& work, int t, int k)
{
    int a = work.corner(t, k), b = work.corner(t, k + 1);
    if (work.is_frozen[a] && work.is_frozen[b])
        return;
    if (work.is_frozen[b])
        std::swap(a, b);
    if (!work.may_collapse(t, k))
        return;
    const std::vector<int> beside_a = work.neighbours(t, a), beside_b = work.neighbours(t, b);
    const auto is_sound_at = [&](const Vector3& place)
    {
        return may_move(work, b, a, place) && (work.is_frozen[a] || may_move(work, a, b, place))
               && !grows_too_long(work, b, beside_b, place)
               && !grows_too_long(work, a, beside_a, place);
    };
    std::vector<Vector3> places{work.point[a]};
    if (!work.is_frozen[a])
        places = {0.5 * (work.point[a] + work.point[b]), work.point[a], work.point[b]};
    const auto place = std::find_if(places.begin(), places.end(), is_sound_at);
    if (place == places.end())
        return;
    work.collapse(b, a);
    work.point[a] = *place;
    if (!work.is_frozen[a])
        work.size[a] = 0.5 * (work.size[a] + work.size[b]);
}

// The centroid of the surrounding triangles, weighted by area over squared target size, projected
// onto the tangent plane of the vertex.
Vector3 smoothed_place(const WorkingMesh& work, int v)
{
    Vector3 sum = Vector3::Zero(), normal = Vector3::Zero();
    double weight = 0.0;
    for (const int t : work.around(v))
    {
        const Vector3 area = work.area_vector(t);
        double size = 0.0;
        Vector3 middle = Vector3::Zero();
        for (const int other : work.triangle(t).corner)
        {
            size += work.size[other] / 3.0;
            middle += work.point[other] / 3.0;
        }
        const double share = area.norm() / (size * size);
        sum += share * middle;
        weight += share;
        normal += area;
    }
    if (weight <= 0.0)
        return work.point[v];
    const Vector3 step = sum / weight - work.point[v];
    normal.normalize();
    return work.point[v] + step - normal * normal.dot(step);
}

// A free side in a work list. Earlier operations on the list may have changed or removed it.
struct Side
{
    double excess;
    int t, k, from, to;

    bool is_there(const WorkingMesh& work) const
    {
        return work.triangle(t).is_alive() && work.corner(t, k) == from
               && work.corner(t, k + 1) == to;
    }
};

// The free sides whose excess (a function of actual over target length) is above 1, largest first.
template <typename Choice>
std::vector<Side> sides_where(const WorkingMesh& work, Choice excess_of)
{
    std::vector<Side> sides;
    work.for_each_side(
        [&](int t, int k)
        {
            const double excess = excess_of(work.length(t, k) / work.wanted_length(t, k));
            if (excess > 1.0 && work.is_free_side(t, k))
                sides.push_back({excess, t, k, work.corner(t, k), work.corner(t, k + 1)});
        });
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& one, const Side& other) { return one.excess > other.excess; });
    return sides;
}

}  // namespace

Convergence flip_to_delaunay(WorkingMesh& work, int most_rounds)
{
    Convergence found{edges_of_work, false, 0, 0.0, "edges"};
    // Only triangles next to an edge flipped in one round need to be checked in the next.
    std::vector<int> waiting(static_cast<std::size_t>(work.count()));
    std::iota(waiting.begin(), waiting.end(), 0);
    for (; found.rounds < most_rounds && !found.is_converged; ++found.rounds)
    {
        std::vector<int> turned;
        for (const int t : waiting)
            for (int k = 0; k < 3 && work.triangle(t).is_alive(); ++k)
                if (const int other = work.across(t, k);
                    other >= 0 && (found.rounds > 0 || other < t) && flip_if_better(work, t, k))
                    turned.insert(turned.end(), {t, other});
        found.miss = static_cast<double>(turned.size()) / 2.0;
        found.is_converged = turned.empty();
        make_set(turned);
        waiting = std::move(turned);
    }
    return found;
}

void even_sizes(WorkingMesh& work)
{
    constexpr int rounds = 3;  // chosen: new vertices are few edges away from old sizes
    for (int round = 0; round < rounds; ++round)
        work.for_each_side(
            [&](int t, int k)
            {
                double &a = work.size[work.corner(t, k)], &b = work.size[work.corner(t, k + 1)];
                const double growth = size_growth * work.length(t, k);
                a = std::min(a, b + growth);
                b = std::min(b, a + growth);
            });
}

namespace
{

std::vector<Side> long_sides(const WorkingMesh& work)
{
    return sides_where(work, [](double length) { return length / too_long; });
}

// Raises the shortest target lengths if they would create more triangles than allowed.
std::vector<Side> affordable_sides(WorkingMesh& work)
{
    constexpr double growth = 1.25;  // chosen: a step reduces the triangles by a third (1 / 1.25^2)
    std::vector<Side> sides = long_sides(work);
    const auto is_too_much = [&]
    { return static_cast<std::size_t>(work.count()) + 2 * sides.size() > work.most_triangles; };
    while (is_too_much() && work.raise_least_size(growth))
        sides = long_sides(work);
    if (is_too_much())
        sides.resize(std::min(
            sides.size(), (work.most_triangles
                           - std::min(work.most_triangles, static_cast<std::size_t>(work.count())))
                              / 2));
    return sides;
}

}  // namespace

Convergence split_long_edges(WorkingMesh& work, int most_rounds)
{
    Convergence found{edges_of_work, false, 0, 0.0, "edges"};
    for (; found.rounds < most_rounds && !found.is_converged; ++found.rounds)
    {
        even_sizes(work);
        const std::vector<Side> sides = affordable_sides(work);
        for (const Side& side : sides)
            if (side.is_there(work))
                work.split(side.t, side.k);
        flip_to_delaunay(work, 40);
        found.miss = static_cast<double>(sides.size());
        found.is_converged = sides.empty();
    }
    return found;
}

// A collapse may rename adjacent sides; the next round finds them again.
Convergence collapse_short_edges(WorkingMesh& work, int most_rounds)
{
    Convergence found{edges_of_work, false, 0, 0.0, "edges"};
    for (; found.rounds < most_rounds && !found.is_converged; ++found.rounds)
    {
        int renamed = 0;
        for (const Side& side : sides_where(work, [](double length) { return too_short / length; }))
        {
            if (!side.is_there(work))
                ++renamed;
            else if (work.length(side.t, side.k) < too_short * work.wanted_length(side.t, side.k))
                collapse_if_sound(work, side.t, side.k);
        }
        found.miss = renamed;
        found.is_converged = renamed == 0;
    }
    return found;
}

void smooth(WorkingMesh& work)
{
    for (int v = 0; v < work.vertex_count(); ++v)
    {
        if (!work.is_movable(v))
            continue;
        const Vector3 place = smoothed_place(work, v);
        if (may_move(work, v, -1, place))
            work.point[v] = place;
    }
}

}  // namespace sheetmorph::repair
