// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/occt_surface.h"

#include <Adaptor3d_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <ShapeCustom_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

namespace sheetmorph::cad
{

namespace
{

CadSurface placed(SurfaceKind kind, const gp_Pnt& point, const gp_Dir& axis)
{
    CadSurface found;
    found.kind = kind;
    found.point = to_vector(point.XYZ());
    found.axis = to_vector(axis.XYZ()).normalized();
    return found;
}

CadSurface cylinder(const gp_Cylinder& shape)
{
    CadSurface found = placed(SurfaceKind::cylinder, shape.Location(), shape.Axis().Direction());
    found.radius = shape.Radius();
    return found;
}

CadSurface cone(const gp_Cone& shape)
{
    CadSurface found = placed(SurfaceKind::cone, shape.Apex(), shape.Axis().Direction());
    found.half_angle = std::abs(shape.SemiAngle());
    return found;
}

CadSurface torus(const gp_Torus& shape)
{
    CadSurface found = placed(SurfaceKind::torus, shape.Location(), shape.Axis().Direction());
    found.radius = shape.MajorRadius();
    found.minor_radius = shape.MinorRadius();
    return found;
}

CadSurface sphere(const gp_Sphere& shape)
{
    CadSurface found = placed(SurfaceKind::sphere, shape.Location(), shape.Position().Direction());
    found.radius = shape.Radius();
    return found;
}

CadSurface cylinder_about(const gp_Ax1& axis, double radius)
{
    CadSurface found = placed(SurfaceKind::cylinder, axis.Location(), axis.Direction());
    found.radius = radius;
    return found;
}

// A line turned about an axis.
CadSurface revolved(const gp_Ax1& axis, const gp_Lin& line)
{
    const Vector3 along = to_vector(axis.Direction().XYZ());
    const Vector3 foot = to_vector(axis.Location().XYZ());
    const Vector3 direction = to_vector(line.Direction().XYZ());
    const Vector3 from = to_vector(line.Location().XYZ()) - foot;
    const Vector3 away = from - from.dot(along) * along;
    if (direction.cross(along).norm() < 1e-12)
        return cylinder_about(axis, away.norm());
    if (std::abs(direction.dot(along)) < 1e-12)
        return placed(SurfaceKind::plane, line.Location(), axis.Direction());
    const Vector3 outward = direction - direction.dot(along) * along;
    if (away.cross(outward).norm() > 1e-12 * (1.0 + away.norm()))
        return {};  // the lines do not meet: a hyperboloid
    const double reach = away.dot(outward) / outward.squaredNorm();
    CadSurface found = placed(SurfaceKind::cone, axis.Location(), axis.Direction());
    found.point = foot + (from - reach * direction).dot(along) * along;
    found.half_angle = std::atan2(outward.norm(), std::abs(direction.dot(along)));
    return found;
}

CadSurface swept(const Adaptor3d_Surface& surface)
{
    const Handle(Adaptor3d_Curve) curve = surface.BasisCurve();
    if (surface.GetType() == GeomAbs_SurfaceOfRevolution && curve->GetType() == GeomAbs_Line)
        return revolved(surface.AxeOfRevolution(), curve->Line());
    if (surface.GetType() != GeomAbs_SurfaceOfExtrusion)
        return {};
    const gp_Dir direction = surface.Direction();
    if (curve->GetType() == GeomAbs_Line)
        return placed(SurfaceKind::plane, curve->Line().Location(),
                      direction.Crossed(curve->Line().Direction()));
    if (curve->GetType() == GeomAbs_Circle
        && curve->Circle().Axis().Direction().IsParallel(direction, 1e-12))
        return cylinder_about(gp_Ax1(curve->Circle().Location(), direction),
                              curve->Circle().Radius());
    return {};
}

CadSurface described(const Adaptor3d_Surface& surface)
{
    switch (surface.GetType())
    {
        case GeomAbs_Plane:
            return placed(SurfaceKind::plane, surface.Plane().Location(),
                          surface.Plane().Axis().Direction());
        case GeomAbs_Cylinder:
            return cylinder(surface.Cylinder());
        case GeomAbs_Cone:
            return cone(surface.Cone());
        case GeomAbs_Sphere:
            return sphere(surface.Sphere());
        case GeomAbs_Torus:
            return torus(surface.Torus());
        case GeomAbs_SurfaceOfRevolution:
        case GeomAbs_SurfaceOfExtrusion:
            return swept(surface);
        default:
            return {};
    }
}

}  // namespace

Vector3 OcctSurface::point(const Vector2& uv) const
{
    return to_vector(surface_.Value(uv.x(), uv.y()).XYZ());
}

Eigen::Matrix<double, 3, 2> OcctSurface::tangents(const Vector2& uv) const
{
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface_.D1(uv.x(), uv.y(), point, along_u, along_v);
    Eigen::Matrix<double, 3, 2> both;
    both << to_vector(along_u.XYZ()), to_vector(along_v.XYZ());
    return both;
}

CadSurface describe_surface(const TopoDS_Face& face, double tolerance)
{
    const BRepAdaptor_Surface surface(face);
    const CadSurface found = described(surface);
    if (found.kind != SurfaceKind::other)
        return found;
    ShapeCustom_Surface converter(BRep_Tool::Surface(face));
    const Handle(Geom_Surface) simple = converter.ConvertToAnalytical(tolerance, false);
    if (simple.IsNull())
        return found;
    CadSurface recognised = described(GeomAdaptor_Surface(simple));
    recognised.fit_error = converter.Gap();
    return recognised;
}

}  // namespace sheetmorph::cad
