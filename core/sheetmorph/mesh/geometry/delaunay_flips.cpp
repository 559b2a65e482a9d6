// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/delaunay_flips.h"

#include "sheetmorph/base/index.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <limits>

namespace sheetmorph::mesh
{

namespace
{

// Sum of cotangents below which an edge flips if it is negative. Four points on a circle have the
// sum 0, and rounding must not flip them endlessly. From rounding: the error of a cotangent c is
// about c^2 eps, 1e-12 for a corner of half a degree.
constexpr double rounding = 1e-9;

//! A side in the frame of its face: unit vectors along it and into the face, and the position of
//! the apex.
struct SideFrame
{
    Vector3 along, inward;
    double length, foot, height;

    SideFrame(const LaidFaces& faces, int side, bool is_reversed)
    {
        const LaidFaces::Corners& corners = faces.corners[at(side / 3)];
        const std::size_t start = at((side + (is_reversed ? 1 : 0)) % 3);
        const std::size_t end = at((side + (is_reversed ? 0 : 1)) % 3);
        const Vector3 edge = corners[end] - corners[start];
        const Vector3 arm = corners[at((side + 2) % 3)] - corners[start];
        length = edge.norm();
        along = edge / length;
        foot = along.dot(arm);
        const Vector3 up = arm - foot * along;
        height = up.norm();
        inward = up / height;
    }

    double area() const { return 0.5 * length * height; }
};

double cotangent_sum(const LaidFaces& faces, int side)
{
    const int other = faces.glued[at(side)];
    return corner_cotangent(faces.corners[at(side / 3)], (side + 2) % 3)
           + corner_cotangent(faces.corners[at(other / 3)], (other + 2) % 3);
}

// Whether the two faces run along the side in opposite directions, as consistently oriented faces
// do. A side from a vertex to itself counts as opposed.
bool is_opposed(const LaidFaces& faces, int side, int other)
{
    return faces.from(side) == faces.to(other);
}

//! The neighbour of a side, saved to attach it to another side.
struct Seam
{
    int glued;
    int rim;
};

Seam seam_of(const LaidFaces& faces, int side)
{
    return {faces.glued[at(side)], faces.rim[at(side)]};
}

void attach(LaidFaces& faces, int side, const Seam& seam)
{
    faces.glued[at(side)] = seam.glued;
    faces.rim[at(side)] = seam.rim;
    if (seam.glued != LaidFaces::open)
    {
        faces.glued[at(seam.glued)] = side;
        faces.rim[at(seam.glued)] = LaidFaces::open;
    }
}

// A seam between two of the four outer sides must be updated at both ends.
void move_seams(LaidFaces& faces, const std::array<int, 4>& old_sides,
                const std::array<int, 4>& new_sides)
{
    std::array<Seam, 4> seams{};
    for (std::size_t i = 0; i < 4; ++i)
        seams[i] = seam_of(faces, old_sides[i]);
    for (Seam& seam : seams)
        for (std::size_t i = 0; i < 4; ++i)
            if (seam.glued == old_sides[i])
            {
                seam.glued = new_sides[i];
                break;
            }
    for (std::size_t i = 0; i < 4; ++i)
        attach(faces, new_sides[i], seams[i]);
}

// Side s of face f runs from a to b with apex c; d is the apex beyond it. The new faces are (c, d,
// b) in place of f and (d, c, a) in place of its neighbour. Their first sides are the flipped side.
bool flip(LaidFaces& faces, int side)
{
    const int other = faces.glued[at(side)];
    if (other / 3 == side / 3)
        return false;
    const bool opposed = is_opposed(faces, side, other);
    const SideFrame near(faces, side, false);
    const SideFrame far(faces, other, opposed);
    const Vector3 along = (near.area() * near.along + far.area() * far.along).normalized();
    Vector3 up = near.area() * near.inward - far.area() * far.inward;
    up -= along * along.dot(up);
    // The faces have no common height: both are folded onto each other. Chosen far above rounding.
    if (!(up.norm() > 1e-6 * (near.area() + far.area())))
        return false;
    up.normalize();
    const Vector3 b = near.length * along;
    const Vector3 c = near.foot * along + near.height * up;
    const Vector3 d = far.foot * along - far.height * up;
    const int f = side / 3;
    const int g = other / 3;
    const int vertex_a = faces.from(side), vertex_b = faces.to(side);
    const int vertex_c = faces.apex(side), vertex_d = faces.apex(other);
    const auto next = [](int s, int steps) { return s / 3 * 3 + (s + steps) % 3; };
    const int bc = next(side, 1), ca = next(side, 2);
    const int ad = opposed ? next(other, 1) : next(other, 2);
    const int db = opposed ? next(other, 2) : next(other, 1);
    faces.triangles.row(f) << vertex_c, vertex_d, vertex_b;
    faces.triangles.row(g) << vertex_d, vertex_c, vertex_a;
    faces.corners[at(f)] = {c, d, b};
    faces.corners[at(g)] = {d, c, Vector3::Zero()};
    move_seams(faces, {bc, ca, ad, db}, {3 * f + 2, 3 * g + 1, 3 * g + 2, 3 * f + 1});
    attach(faces, 3 * f, {3 * g, LaidFaces::open});
    return true;
}

}  // namespace

double worst_cotangent_sum(const LaidFaces& faces)
{
    double worst = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 3 * faces.count(); ++side)
        if (faces.glued[at(side)] > side)
            worst = std::min(worst, cotangent_sum(faces, side));
    return worst;
}

Convergence flip_to_delaunay(LaidFaces& faces, int most_a_side)
{
    std::vector<int> waiting;
    for (int side = 3 * faces.count() - 1; side >= 0; --side)
        waiting.push_back(side);
    const std::int64_t most = std::min<std::int64_t>(
        static_cast<std::int64_t>(most_a_side) * static_cast<std::int64_t>(waiting.size()),
        std::numeric_limits<int>::max());
    Convergence found{"the intrinsic triangles of the sheet", false, 0, 0.0, "of a cotangent"};
    while (!waiting.empty() && found.rounds < most)
    {
        const int side = waiting.back();
        waiting.pop_back();
        const int other = faces.glued[at(side)];
        if (other == LaidFaces::open || cotangent_sum(faces, side) >= -rounding)
            continue;
        if (!flip(faces, side))
            continue;
        ++found.rounds;
        for (const int face : {side / 3, other / 3})
            for (int k = 1; k < 3; ++k)
                waiting.push_back(3 * face + k);
    }
    found.is_converged = waiting.empty();
    if (!found.is_converged)
        found.miss = std::max(0.0, -worst_cotangent_sum(faces));
    return found;
}

}  // namespace sheetmorph::mesh
