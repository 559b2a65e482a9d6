// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/steel/steel_answer.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/surface/steel/shell_minimum.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace sheetmorph::surface
{

namespace
{

// Relative to the size, if the thickness is unknown. Chosen: 1 mm for a part of 100 mm; usual sheet
// metal parts lie between 1/30 and 1/1000. The report names the value.
constexpr double default_thickness = 0.01;

// Relative to the size, for `refine`. Chosen so thick that stretching costs little against bending:
// the bending stiffness is 25 times that of the default, and only rotations change the shape.
constexpr double refined_thickness = 0.05;

// The diagonal of the rectangle with the same covariance of its area as the sheet; exact for a flat
// rectangle. Unlike the diagonal of a bounding box, it does not depend on the axes. It depends
// neither on the facets nor on unused vertices.
double size_of_triangles(const mesh::TriangleMesh& mesh)
{
    double area = 0.0, second = 0.0;
    Vector3 first = Vector3::Zero();
    const Vector3 origin = mesh.triangle_count() > 0
                               ? Vector3(mesh.points().row(mesh.triangles()(0, 0)).transpose())
                               : Vector3(Vector3::Zero());
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        std::array<Vector3, 3> corners;
        for (int c = 0; c < 3; ++c)
            corners[at(c)] = mesh.points().row(mesh.triangles()(t, c)).transpose() - origin;
        const Vector3 sum = corners[0] + corners[1] + corners[2];
        const double own = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
        area += own;
        first += own / 3.0 * sum;
        // Mean of a squared length over a triangle, from its corners and their sum.
        second += own / 12.0
                  * (sum.squaredNorm() + corners[0].squaredNorm() + corners[1].squaredNorm()
                     + corners[2].squaredNorm());
    }
    if (!(area > 0.0))
        return 0.0;
    return std::sqrt(12.0 * std::max(0.0, second / area - (first / area).squaredNorm()));
}

// A refined linear result uses a shell so thick that only large rotations change the shape.
double thickness_of(const mesh::TriangleMesh& rest, const SurfaceConstraints& constraints)
{
    return constraints.energy == Energy::steel ? sheet_thickness(constraints.thickness, rest)
                                               : refined_thickness * size_of_triangles(rest);
}

// Columns: two sides of a triangle and its unit normal times its size.
Matrix3 frame(const Points& points, const std::array<int, 3>& corners)
{
    const Vector3 first = points.row(corners[0]).transpose();
    Matrix3 found;
    found.col(0) = points.row(corners[1]).transpose() - first;
    found.col(1) = points.row(corners[2]).transpose() - first;
    found.col(2) = found.col(0).cross(found.col(1));
    found.col(2) /= std::max(std::sqrt(found.col(2).norm()), 1e-300);
    return found;
}

}  // namespace

double sheet_thickness(double given, const mesh::TriangleMesh& mesh)
{
    return given > 0.0 ? given : default_thickness * size_of_triangles(mesh);
}

SteelAnswer::SteelAnswer(const mesh::TriangleMesh& rest, const SurfaceConstraints& constraints)
    : mesh_(rest),
      size_(size_of_triangles(rest)),
      thickness_(thickness_of(rest, constraints)),
      poisson_(constraints.poisson)
{
}

SteelAnswer::Shape SteelAnswer::solve(const ShellPose& pose, const Progress& progress) const
{
    const std::vector<Turner> turners = shell_turners(pose.part);
    Joints joints(pose.part, pose.targets, turners, pose.bodies);
    joints.start_as_known();  // matches the initial positions of the sheet
    ShellMovers movers(mesh_, pose, joints, turners);
    ShellSystem shell({mesh_, pose.part, poisson_}, std::move(movers), joints);
    Shape found{pose.positions, {}, pose.bodies};
    if (shell.unknowns() > 0 && pose.positions != pose.part.rest.points())
    {
        found.convergence = minimise_shell(shell, {pose.targets, size_, thickness_, progress});
        found.positions = shell.shape().positions;
        found.energy = shell.energy(thickness_ * thickness_ / 12.0);
    }
    for (std::size_t k = 0; k < turners.size(); ++k)
    {
        RigidMotion& motion = found.bodies.motions[at(turners[k].body)];
        motion = motion_of(pose.part.roles.bodies[at(turners[k].body)], joints.states()[k],
                           motion.rotation_log);
    }
    found.logs = measured_logs(pose, found.positions, found.bodies);
    return found;
}

// Free vertices take the mean rotation of the triangles around them; the others keep their
// prescribed rotation.
Points SteelAnswer::measured_logs(const ShellPose& pose, const Points& positions,
                                  const BodyMotions& bodies) const
{
    const PlacementInput& part = pose.part;
    std::vector<Matrix3> sums(at(part.rest.vertex_count()), Matrix3::Zero());
    for (const ShellMesh::Triangle& triangle : mesh_.triangles)
    {
        const Matrix3 before = frame(part.rest.points(), triangle.corners);
        const double area = before.col(2).squaredNorm();
        const Matrix3 turn = polar_rotation(frame(positions, triangle.corners) * before.inverse());
        for (const int corner : triangle.corners)
            sums[at(corner)] += area * turn;
    }
    Points logs = pose.logs;
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
        const auto row = static_cast<Eigen::Index>(i);
        if (part.roles.role[i] == Role::body)
            logs.row(row) = bodies.motions[at(part.roles.owner[i])].rotation_log.transpose();
        else if (part.roles.role[i] == Role::free && !sums[i].isZero(0.0))
            logs.row(row) = log_near(nearest_rotation(sums[i]), pose.logs.row(row)).transpose();
    }
    return logs;
}

}  // namespace sheetmorph::surface
