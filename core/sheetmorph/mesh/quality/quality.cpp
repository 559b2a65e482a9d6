// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/quality.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/geometry/thinness.h"
#include "sheetmorph/mesh/topology/edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

namespace sheetmorph::mesh
{

namespace
{

// Radians. Chosen: two triangles closer than 30 degrees lie on each other; no sheet is formed so
// sharply without a hem. least_growth keeps the hems that the part has at rest.
constexpr double folded_over = 150.0 * degree;
constexpr double least_growth = 30.0 * degree;

double corner_angle(const TriangleMesh& mesh, int triangle, int k)
{
    const auto at = [&](int corner) -> Vector3
    { return mesh.points().row(mesh.triangles()(triangle, corner % 3)).transpose(); };
    const Vector3 a = at(k + 1) - at(k);
    const Vector3 b = at(k + 2) - at(k);
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double aspect(const TriangleMesh& mesh, int triangle)
{
    const Eigen::RowVector3i corners = mesh.triangles().row(triangle);
    const Vector3 a = mesh.points().row(corners(1)) - mesh.points().row(corners(0));
    const Vector3 b = mesh.points().row(corners(2)) - mesh.points().row(corners(0));
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    return std::sqrt(0.75) * longest / a.cross(b).norm();
}

// Tangent of the smallest corner angle, which is opposite the shortest edge and at most 60 degrees.
double smallest_tangent(const TriangleMesh& mesh, int triangle)
{
    const Eigen::RowVector3i corners = mesh.triangles().row(triangle);
    Vector3 edges[3];
    for (int k = 0; k < 3; ++k)  // edge k is opposite corner k
        edges[k] =
            mesh.points().row(corners((k + 2) % 3)) - mesh.points().row(corners((k + 1) % 3));
    const double lengths[3] = {edges[0].squaredNorm(), edges[1].squaredNorm(),
                               edges[2].squaredNorm()};
    const auto k = std::min_element(lengths, lengths + 3) - lengths;
    const Vector3& a = edges[(k + 1) % 3];
    const Vector3& b = edges[(k + 2) % 3];
    const double along = -a.dot(b);
    return along > 0.0 ? a.cross(b).norm() / along : 0.0;
}

// Whether two neighbours lie on each other, but did not at rest.
bool is_fold(const TriangleMesh& rest, const TriangleMesh& deformed, const EdgeUse uses[2])
{
    for (int k = 0; k < 2; ++k)
        if (is_thin(rest.points(), rest.triangles(), uses[k].triangle)
            || is_thin(deformed.points(), rest.triangles(), uses[k].triangle))
            return false;
    const double now = bend_angle(deformed.points(), uses[0], uses[1]);
    return now > folded_over && now - bend_angle(rest.points(), uses[0], uses[1]) >= least_growth;
}

std::vector<int> flipped_triangles(const TriangleMesh& rest, const TriangleMesh& deformed,
                                   const EdgeTable& table)
{
    std::vector<int> flipped;
    for (int edge = 0; edge < table.count(); ++edge)
        for (const EdgeUse& one : table.uses(edge))
            for (const EdgeUse* other = &one + 1; other != table.uses(edge).end(); ++other)
            {
                const EdgeUse pair[2] = {one, *other};
                if (is_fold(rest, deformed, pair))
                    flipped.insert(flipped.end(), {one.triangle, other->triangle});
            }
    make_set(flipped);
    return flipped;
}

}  // namespace

MeshQuality quality(const TriangleMesh& mesh)
{
    MeshQuality found;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        if (is_thin(mesh.points(), mesh.triangles(), t))
        {
            ++found.degenerate;
            continue;
        }
        found.worst_aspect = std::max(found.worst_aspect, aspect(mesh, t));
        for (int k = 0; k < 3; ++k)
            found.worst_angle_degrees =
                std::min(found.worst_angle_degrees, corner_angle(mesh, t, k) / degree);
    }
    return found;
}

Eigen::VectorXd vertex_quality(const TriangleMesh& mesh)
{
    Eigen::VectorXd found = Eigen::VectorXd::Constant(mesh.vertex_count(), std::sqrt(3.0));
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const double tangent = smallest_tangent(mesh, t);
        for (int k = 0; k < 3; ++k)
        {
            double& worst = found(mesh.triangles()(t, k));
            worst = std::min(worst, tangent);
        }
    }
    return found.array().atan() / degree;
}

QualityChange compare_quality(const TriangleMesh& rest, const Points& points)
{
    if (points.rows() != rest.points().rows())
        throw InvalidInput("the deformed shape has " + std::to_string(points.rows())
                           + " points, the mesh at rest has "
                           + std::to_string(rest.vertex_count()));
    const TriangleMesh deformed(points, rest.triangles());
    const EdgeTable table(rest);
    QualityChange change;
    change.deformed = quality(deformed);
    change.flipped = flipped_triangles(rest, deformed, table);
    const double shortest = exactness(rest.points(), rest.size());
    bool is_first = true;
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const EdgeUse& use = *table.uses(edge).begin();
        const double length = (rest.points().row(use.to) - rest.points().row(use.from)).norm();
        if (length <= shortest)
            continue;
        const double stretch = (points.row(use.to) - points.row(use.from)).norm() / length;
        change.largest_stretch = is_first ? stretch : std::max(change.largest_stretch, stretch);
        change.smallest_stretch = is_first ? stretch : std::min(change.smallest_stretch, stretch);
        is_first = false;
    }
    return change;
}

}  // namespace sheetmorph::mesh
