// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/face_refiner.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sheetmorph::cad
{

namespace
{

double cross(const Vector2& a, const Vector2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

double worth(const FaceVertex& a, const FaceVertex& b, const FaceVertex& c)
{
    const Vector2 ab = b.uv - a.uv, ac = c.uv - a.uv;
    const double area = cross(ab, ac);
    if (!(area > 1e-12 * (ab.squaredNorm() + ac.squaredNorm())))
        return -1.0;
    const Vector3 p = b.point - a.point, q = c.point - b.point, r = a.point - c.point;
    const Vector3 normal = p.cross(r);
    const Vector3 outward = a.normal + b.normal + c.normal;
    // Chosen: a triangle that leans by more than 78 degrees to the surface is folded.
    if (outward.squaredNorm() > 0 && -normal.dot(outward) < 0.2 * normal.norm() * outward.norm())
        return -1.0;
    double sides[] = {p.squaredNorm(), q.squaredNorm(), r.squaredNorm()};
    std::sort(std::begin(sides), std::end(sides));
    return sides[2] > 0 ? normal.squaredNorm() / (sides[1] * sides[2]) : -1.0;
}

double gap_at(const FaceSurface& surface, const Vector2& uv, const Vector3& on_mesh)
{
    const Vector3 gap = surface.point(uv) - on_mesh;
    const Vector3 normal = surface_normal(surface, uv);
    return normal.isZero() ? gap.norm() : std::abs(gap.dot(normal));
}

Vector3 surface_normal(const FaceSurface& surface, const Vector2& uv)
{
    const auto tangents = surface.tangents(uv);
    const Vector3 normal = tangents.col(0).cross(tangents.col(1));
    const double length = normal.norm();
    const double scale = tangents.col(0).norm() * tangents.col(1).norm();
    return length > 1e-9 * scale && length > 0 ? Vector3(normal / length) : Vector3::Zero();
}

double deviation(const FaceMesh& mesh, const FaceSurface& surface)
{
    double largest = 0.0;
    for (const FaceMesh::Triangle& triangle : mesh.triangles())
    {
        if (!triangle.is_alive())
            continue;
        const FaceVertex& a = mesh.vertex(triangle.corner[0]);
        const FaceVertex& b = mesh.vertex(triangle.corner[1]);
        const FaceVertex& c = mesh.vertex(triangle.corner[2]);
        const auto at = [&](double wa, double wb, double wc)
        {
            const Vector3 on_mesh = wa * a.point + wb * b.point + wc * c.point;
            largest =
                std::max(largest, gap_at(surface, wa * a.uv + wb * b.uv + wc * c.uv, on_mesh));
        };
        at(0.5, 0.5, 0.0);
        at(0.0, 0.5, 0.5);
        at(0.5, 0.0, 0.5);
        at(1.0 / 3, 1.0 / 3, 1.0 / 3);
    }
    return largest;
}

}  // namespace sheetmorph::cad
