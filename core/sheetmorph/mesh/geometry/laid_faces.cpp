// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/laid_faces.h"

#include "sheetmorph/mesh/geometry/operators.h"
#include "sheetmorph/mesh/geometry/thinness.h"
#include "sheetmorph/mesh/topology/edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sheetmorph::mesh
{

namespace
{

// Height over longest edge, below which rounding determines the side of the apex. From rounding: a
// height is exact to 1e-16 of the coordinates, 1e-10 of an edge of 0.01 mm in a part of 10 m.
// Chosen a hundred times higher.
constexpr double straight = 1e-8;

constexpr int not_laid = -1;

Vector3 point_of(const TriangleMesh& mesh, int vertex)
{
    return mesh.points().row(vertex).transpose();
}

// The perpendicular from the line through `start` along the unit vector `along` to `point`.
Vector3 height_over(const Vector3& start, const Vector3& along, const Vector3& point)
{
    const Vector3 arm = point - start;
    return arm - along * along.dot(arm);
}

// The side of its longest edge `base` on which a collinear triangle lies in its unfolded
// neighbourhood. The neighbour of largest height decides: the apex points away from a neighbour
// across `base`, and towards a neighbour across another edge.
Vector3 side_of_straight(const TriangleMesh& mesh, const EdgeTable& edges, int t, int base)
{
    const Vector3 start = point_of(mesh, mesh.triangles()(t, base));
    const Vector3 along =
        (point_of(mesh, mesh.triangles()(t, (base + 1) % 3)) - start).normalized();
    Vector3 highest = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
        for (const EdgeUse& use : edges.uses(edges.edge_of(t, k)))
        {
            const Vector3 height = height_over(start, along, point_of(mesh, use.opposite));
            if (use.triangle != t && height.squaredNorm() > highest.squaredNorm())
                highest = k == base ? Vector3(-height) : height;
        }
    return highest.isZero(0.0) ? Vector3(along.unitOrthogonal()) : Vector3(highest.normalized());
}

LaidFaces::Corners laid_corners(const TriangleMesh& mesh, const EdgeTable& edges, int t)
{
    LaidFaces::Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = point_of(mesh, mesh.triangles()(t, static_cast<int>(k)));
    std::size_t base = 0;
    const auto length = [&](std::size_t k) { return (corners[(k + 1) % 3] - corners[k]).norm(); };
    for (std::size_t k = 1; k < 3; ++k)
        if (length(k) > length(base))
            base = k;
    const double longest = length(base);
    const Vector3 along = (corners[(base + 1) % 3] - corners[base]) / longest;
    Vector3& apex = corners[(base + 2) % 3];
    const Vector3 height = height_over(corners[base], along, apex);
    if (height.norm() >= thinnest_for_operators * longest)
        return corners;
    const Vector3 up = height.norm() > straight * longest
                           ? Vector3(height.normalized())
                           : side_of_straight(mesh, edges, t, static_cast<int>(base));
    apex += thinnest_for_operators * longest * up - height;
    return corners;
}

//! The faces of a mesh and the face of each triangle.
struct Laid
{
    LaidFaces faces;
    std::vector<int> face_of;  // by triangle: its face, or not_laid
};

Laid unglued_faces(const TriangleMesh& mesh, const EdgeTable& edges)
{
    const Points weights = half_cotangents(mesh);
    Laid laid;
    laid.face_of.assign(static_cast<std::size_t>(mesh.triangle_count()), not_laid);
    laid.faces.triangles.resize(mesh.triangle_count(), 3);
    int count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (edges.edge_of(t, 0) >= 0 && !weights.row(t).isZero(0.0))
        {
            laid.face_of[static_cast<std::size_t>(t)] = count;
            laid.faces.corners.push_back(laid_corners(mesh, edges, t));
            laid.faces.triangles.row(count++) = mesh.triangles().row(t);
        }
    laid.faces.triangles.conservativeResize(count, 3);
    laid.faces.glued.assign(3 * static_cast<std::size_t>(count), LaidFaces::open);
    laid.faces.rim = laid.faces.glued;
    return laid;
}

// Visits every edge of the mesh with the sides of its laid faces.
template <typename Visit>
void for_each_edge(const TriangleMesh& mesh, const EdgeTable& edges, const Laid& laid, Visit visit)
{
    std::vector<std::vector<int>> sides(static_cast<std::size_t>(edges.count()));
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            if (laid.face_of[static_cast<std::size_t>(t)] != not_laid)
                sides[static_cast<std::size_t>(edges.edge_of(t, k))].push_back(
                    3 * laid.face_of[static_cast<std::size_t>(t)] + k);
    for (std::size_t edge = 0; edge < sides.size(); ++edge)
        visit(static_cast<int>(edge), sides[edge]);
}

void glue(LaidFaces& faces, int one, int other)
{
    faces.glued[static_cast<std::size_t>(one)] = other;
    faces.glued[static_cast<std::size_t>(other)] = one;
}

// Angle of a side's face about its edge, directed from the smaller vertex to the larger.
double angle_about_edge(const LaidFaces& faces, int side, const Vector3& first)
{
    const LaidFaces::Corners& corners = faces.corners[static_cast<std::size_t>(side / 3)];
    const auto k = static_cast<std::size_t>(side % 3);
    const double sense = faces.from(side) < faces.to(side) ? 1.0 : -1.0;
    const Vector3 along = sense * (corners[(k + 1) % 3] - corners[k]).normalized();
    const Vector3 height = height_over(corners[k], along, corners[(k + 2) % 3]);
    const Vector3 start = height_over(Vector3::Zero(), along, first);
    return std::atan2(along.dot(start.cross(height)), start.dot(height));
}

// Sorts the sides of an edge by angle, so that each face faces the next.
void sort_about_edge(const LaidFaces& faces, std::vector<int>& sides)
{
    const LaidFaces::Corners& corners = faces.corners[static_cast<std::size_t>(sides[0] / 3)];
    const auto k = static_cast<std::size_t>(sides[0] % 3);
    const Vector3 first = corners[(k + 2) % 3] - corners[k];
    std::vector<std::pair<double, int>> sorted;
    for (const int side : sides)
        sorted.emplace_back(side == sides[0] ? -4.0 : angle_about_edge(faces, side, first), side);
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sides.size(); ++i)
        sides[i] = sorted[i].second;
}

}  // namespace

LaidFaces laid_faces(const TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    Laid laid = unglued_faces(mesh, edges);
    for_each_edge(mesh, edges, laid,
                  [&](int edge, const std::vector<int>& sides)
                  {
                      if (sides.size() == 2)
                          return glue(laid.faces, sides[0], sides[1]);
                      for (const int side : sides)
                          laid.faces.rim[static_cast<std::size_t>(side)] = edge;
                  });
    return std::move(laid.faces);
}

LaidFaces covered_faces(const TriangleMesh& mesh)
{
    LaidFaces single = laid_faces(mesh);
    std::vector<int> rim = single.rim;
    std::sort(rim.begin(), rim.end());
    if (std::adjacent_find(rim.begin(), rim.end(),
                           [](int a, int b) { return a == b && a != LaidFaces::open; })
        == rim.end())
        return single;
    const EdgeTable edges(mesh);
    Laid laid = unglued_faces(mesh, edges);
    LaidFaces& faces = laid.faces;
    const int count = faces.count();
    faces.triangles.conservativeResize(2 * count, 3);
    faces.triangles.bottomRows(count) = Triangles(faces.triangles.topRows(count));
    faces.corners.reserve(2 * static_cast<std::size_t>(count));
    for (int f = 0; f < count; ++f)
        faces.corners.push_back(faces.corners[static_cast<std::size_t>(f)]);
    faces.glued.assign(6 * static_cast<std::size_t>(count), LaidFaces::open);
    faces.rim = faces.glued;
    faces.share = 0.5;
    const auto looking = [&](int side, bool forward)
    { return side + ((faces.from(side) < faces.to(side)) == forward ? 0 : 3 * count); };
    for_each_edge(mesh, edges, laid,
                  [&](int edge, std::vector<int> sides)
                  {
                      if (sides.size() == 1)
                          for (const bool forward : {true, false})
                              faces.rim[static_cast<std::size_t>(looking(sides[0], forward))] =
                                  2 * edge + (forward ? 1 : 0);
                      if (sides.size() < 2)
                          return;
                      sort_about_edge(faces, sides);
                      for (std::size_t i = 0; i < sides.size(); ++i)
                          glue(faces, looking(sides[i], true),
                               looking(sides[(i + 1) % sides.size()], false));
                  });
    return std::move(laid.faces);
}

double corner_cotangent(const LaidFaces::Corners& corners, int corner)
{
    const auto k = static_cast<std::size_t>(corner);
    const Vector3 one = corners[(k + 1) % 3] - corners[k];
    const Vector3 other = corners[(k + 2) % 3] - corners[k];
    return one.dot(other) / one.cross(other).norm();
}

double face_area(const LaidFaces::Corners& corners)
{
    return 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
}

}  // namespace sheetmorph::mesh
