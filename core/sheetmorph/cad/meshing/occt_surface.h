// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_model.h"
#include "sheetmorph/cad/meshing/face_refinement.h"

#include <BRepAdaptor_Surface.hxx>

namespace sheetmorph::cad
{

//! A face's surface of OpenCASCADE, placed as the face is.
class OcctSurface : public FaceSurface
{
public:
    explicit OcctSurface(const TopoDS_Face& face) : surface_(face, false) {}

    Vector3 point(const Vector2& uv) const override;
    Eigen::Matrix<double, 3, 2> tangents(const Vector2& uv) const override;
    bool is_plane() const override { return surface_.GetType() == GeomAbs_Plane; }

private:
    BRepAdaptor_Surface surface_;
};

//! What kind of surface a face lies on. A spline surface that is a plane, cylinder, cone, sphere
//! or torus within `tolerance` (mm) is called so.
CadSurface describe_surface(const TopoDS_Face& face, double tolerance);

//! One vector type in the other.
inline Vector3 to_vector(const gp_XYZ& xyz)
{
    return {xyz.X(), xyz.Y(), xyz.Z()};
}

}  // namespace sheetmorph::cad
