// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/kept_motion.h"
#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/cad/meshing/occt_surface.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <cmath>
#include <gp_Lin.hxx>
#include <gp_Quaternion.hxx>

namespace sheetmorph::cad
{

namespace
{

// Radians, and mm: axes that agree are one axis. From the accuracy of rigid motions, 1e-9, and from
// OpenCASCADE's Precision::Confusion, 1e-7 mm.
constexpr double same_angle = 1e-9, same_place = 1e-7;

bool is_plane_spanned(const Points& points)
{
    const Points about = points.rowwise() - points.colwise().mean();
    const Matrix3 moments = about.transpose() * about;
    const Vector3 values = Eigen::SelfAdjointEigenSolver<Matrix3>(moments).eigenvalues();
    // Squares of lengths: a line may be 1e-4 of its length wide. Chosen: its width then turns the
    // motion about it by errors of rounding over 1e-4, 1e-12.
    constexpr double straight = 1e-8;
    return values(1) > straight * values(2);
}

// The point, with its distance from an axis multiplied by `scale`.
Vector3 resized(const Vector3& point, const gp_Ax1& axis, double scale)
{
    const Vector3 foot = to_vector(axis.Location().XYZ());
    const Vector3 along = to_vector(axis.Direction().XYZ());
    const Vector3 on_axis = foot + along * along.dot(point - foot);
    return on_axis + scale * (point - on_axis);
}

Handle(Geom_CylindricalSurface) cylinder_of(const Handle(Geom_Surface) & surface)
{
    const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
    return Handle(Geom_CylindricalSurface)::DownCast(trimmed.IsNull() ? surface
                                                                      : trimmed->BasisSurface());
}

bool is_about(const gp_Ax1& one, const gp_Ax1& axis)
{
    return one.IsParallel(axis, same_angle) && gp_Lin(axis).Distance(one.Location()) < same_place;
}

}  // namespace

Vector3 KeptMotion::point(const Vector3& before) const
{
    const Vector3 there = scale == 1.0 ? before : resized(before, axis, scale);
    return to_vector(gp_Pnt(there(0), there(1), there(2)).Transformed(motion).XYZ());
}

Handle(Geom_Surface) KeptMotion::surface(const Handle(Geom_Surface) & before) const
{
    Handle(Geom_Surface) sized = before;
    if (scale != 1.0)
    {
        const Handle(Geom_CylindricalSurface) cylinder = cylinder_of(before);
        sized = new Geom_CylindricalSurface(cylinder->Position(), scale * cylinder->Radius());
    }
    return Handle(Geom_Surface)::DownCast(sized->Transformed(motion));
}

Handle(Geom_Curve) KeptMotion::curve(const Handle(Geom_Curve) & before) const
{
    Handle(Geom_Curve) sized = before;
    if (scale != 1.0)
    {
        const auto circle = Handle(Geom_Circle)::DownCast(before);
        const auto line = Handle(Geom_Line)::DownCast(before);
        if (!circle.IsNull() && is_about(circle->Circ().Axis(), axis))
            sized = new Geom_Circle(circle->Circ().Position(), scale * circle->Radius());
        else if (!line.IsNull() && line->Position().IsParallel(axis, same_angle))
        {
            const Vector3 foot = resized(to_vector(line->Position().Location().XYZ()), axis, scale);
            sized = new Geom_Line(gp_Pnt(foot(0), foot(1), foot(2)), line->Position().Direction());
        }
        else
            return {};
    }
    return Handle(Geom_Curve)::DownCast(sized->Transformed(motion));
}

std::optional<KeptMotion> rigid_fit(const Points& from, const Points& to, double tolerance,
                                    bool is_straight)
{
    if (from.rows() < (is_straight ? 2 : 3) || (!is_straight && !is_plane_spanned(from)))
        return {};
    const Vector3 centre = from.colwise().mean(), there = to.colwise().mean();
    // Far from the origin, rotation and translation would cancel.
    const Points one = from.rowwise() - centre.transpose(),
                 other = to.rowwise() - there.transpose();
    const RigidMotion best = best_rigid_motion(one, other);
    if ((best.apply(one) - other).rowwise().norm().maxCoeff() > tolerance)
        return {};
    const Eigen::Quaterniond turn(best.rotation());
    const Vector3 zero = best.apply(Vector3(-centre)) + there;
    KeptMotion found;
    found.motion.SetRotation(gp_Quaternion(turn.x(), turn.y(), turn.z(), turn.w()));
    found.motion.SetTranslationPart(gp_Vec(zero(0), zero(1), zero(2)));
    return found;
}

std::optional<KeptMotion> resized_fit(const Points& from, const Points& to, double tolerance,
                                      const Handle(Geom_Surface) & surface)
{
    const Handle(Geom_CylindricalSurface) cylinder = cylinder_of(surface);
    if (cylinder.IsNull() || from.rows() < 4)
        return {};
    const Points one = from.rowwise() - from.colwise().mean(),
                 other = to.rowwise() - to.colwise().mean();
    const Eigen::FullPivLU<Matrix3> moments(one.transpose() * one);
    if (!moments.isInvertible())
        return {};
    // The affine map is a scaling across the axis, followed by a rotation.
    const Matrix3 map = (moments.inverse() * (one.transpose() * other)).transpose();
    const gp_Ax3& place = cylinder->Position();
    const double scale = 0.5
                         * ((map * to_vector(place.XDirection().XYZ())).norm()
                            + (map * to_vector(place.YDirection().XYZ())).norm());
    if (!(scale > 1e-6) || !std::isfinite(scale))
        return {};
    Points sized = from;
    for (Eigen::Index i = 0; i < from.rows(); ++i)
        sized.row(i) = resized(from.row(i).transpose(), place.Axis(), scale).transpose();
    std::optional<KeptMotion> found = rigid_fit(sized, to, tolerance, false);
    if (found)
    {
        found->axis = place.Axis();
        found->scale = scale;
    }
    return found;
}

}  // namespace sheetmorph::cad
