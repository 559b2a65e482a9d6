// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/face_refinement.h"
#include "sheetmorph/base/errors.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <map>

namespace sheetmorph::cad::test
{

namespace
{

class Plane : public FaceSurface
{
public:
    Vector3 point(const Vector2& uv) const override { return {uv.x(), uv.y(), 0.0}; }
    Eigen::Matrix<double, 3, 2> tangents(const Vector2&) const override
    {
        return Eigen::Matrix<double, 3, 2>::Identity();
    }
    bool is_plane() const override { return true; }
};

// A cylinder about the y axis.
class Cylinder : public FaceSurface
{
public:
    Vector3 point(const Vector2& uv) const override
    {
        return {radius * std::cos(uv.x()), -uv.y(), radius * std::sin(uv.x())};
    }
    Eigen::Matrix<double, 3, 2> tangents(const Vector2& uv) const override
    {
        Eigen::Matrix<double, 3, 2> both;
        both << -radius * std::sin(uv.x()), 0, 0, -1, radius * std::cos(uv.x()), 0;
        return both;
    }
    bool is_plane() const override { return false; }

    static constexpr double radius = 10.0;
};

// The corners of a rectangle, more of them along its first side, in two triangles a piece.
FaceMesh rectangle(const FaceSurface& surface, const Vector2& size, int pieces, double longest)
{
    std::vector<FaceVertex> vertices;
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i <= pieces; ++i)
        for (const double v : {0.0, size.y()})
        {
            FaceVertex vertex;
            vertex.uv = Vector2(size.x() * i / pieces, v);
            vertex.point = surface.point(vertex.uv);
            vertex.normal = surface_normal(surface, vertex.uv);
            vertex.size = longest;
            vertex.is_fixed = true;
            vertices.push_back(vertex);
        }
    for (int i = 0; i < pieces; ++i)
    {
        triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
        triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
    }
    return FaceMesh(vertices, triangles, {});
}

double area(const FaceMesh& mesh)
{
    double sum = 0.0;
    for (const FaceMesh::Triangle& t : mesh.triangles())
        if (t.is_alive())
        {
            const Vector2 ab = mesh.vertex(t.corner[1]).uv - mesh.vertex(t.corner[0]).uv;
            const Vector2 ac = mesh.vertex(t.corner[2]).uv - mesh.vertex(t.corner[0]).uv;
            const double one = 0.5 * (ab.x() * ac.y() - ab.y() * ac.x());
            EXPECT_GT(one, 0.0);
            sum += one;
        }
    return sum;
}

double smallest_angle(const FaceMesh& mesh)
{
    double smallest = M_PI;
    for (const FaceMesh::Triangle& t : mesh.triangles())
        for (std::size_t k = 0; k < 3 && t.is_alive(); ++k)
        {
            const Vector3 p = mesh.vertex(t.corner[k]).point;
            const Vector3 a = mesh.vertex(t.corner[(k + 1) % 3]).point - p;
            const Vector3 b = mesh.vertex(t.corner[(k + 2) % 3]).point - p;
            smallest = std::min(smallest, std::acos(a.dot(b) / (a.norm() * b.norm())));
        }
    return smallest * 180.0 / M_PI;
}

FaceSizes sizes_of(double edge, double deflection, double angle)
{
    FaceSizes sizes;
    sizes.edge = edge;
    sizes.deflection = deflection;
    sizes.angle = angle;
    return sizes;
}

}  // namespace

TEST(FaceRefinement, tells_when_it_has_no_more_vertices)
{
    const Plane plane;
    FaceMesh mesh = rectangle(plane, {40.0, 30.0}, 40, 1.0);
    FaceSizes sizes = sizes_of(4.0, 0.1, 0.35);
    sizes.most_vertices = 90;
    const Convergence found = refine_face(mesh, plane, sizes);
    EXPECT_FALSE(found.is_converged);
    EXPECT_GT(found.miss, 0.0);
    EXPECT_EQ(found.sentence().find("the edges of CAD faces did not converge"), 0U);
}

TEST(FaceRefinement, fills_a_flat_face_with_well_shaped_triangles)
{
    const Plane plane;
    FaceMesh mesh = rectangle(plane, {40.0, 30.0}, 40, 1.0);
    EXPECT_TRUE(refine_face(mesh, plane, sizes_of(4.0, 0.1, 0.35)).is_converged);
    EXPECT_NEAR(area(mesh), 1200.0, 1e-9);
    EXPECT_GT(smallest_angle(mesh), 5.0);  // at the ends: sides of 30 mm that must stay
    int fixed = 0;
    for (const FaceVertex& vertex : mesh.vertices())
        fixed += vertex.is_fixed;
    EXPECT_EQ(fixed, 82);
    EXPECT_EQ(deviation(mesh, plane), 0.0);
}

TEST(FaceRefinement, follows_a_curved_face_and_leaves_it_long_along_its_rulings)
{
    const Cylinder cylinder;
    FaceMesh mesh = rectangle(cylinder, {1.5, 60.0}, 8, 60.0);
    refine_face(mesh, cylinder, sizes_of(60.0, 0.05, 0.5));
    EXPECT_NEAR(area(mesh), 90.0, 1e-9);
    EXPECT_LT(mesh.triangles().size(), 100u);
    EXPECT_LT(deviation(mesh, cylinder), 0.06);
    for (const FaceVertex& vertex : mesh.vertices())
        EXPECT_NEAR(std::hypot(vertex.point.x(), vertex.point.z()), Cylinder::radius, 1e-12);
}

TEST(FaceMesh, splits_flips_and_collapses_back_to_what_it_was)
{
    const Plane plane;
    FaceMesh mesh = rectangle(plane, {1.0, 1.0}, 1, 1.0);
    const int side = mesh.is_free_side(0, 0) ? 0 : mesh.is_free_side(0, 1) ? 1 : 2;
    FaceVertex middle;
    middle.uv = Vector2(0.5, 0.5);
    middle.point = plane.point(middle.uv);
    const int added = mesh.split(0, side, middle);
    EXPECT_EQ(mesh.around(added).size(), 4u);
    EXPECT_NEAR(area(mesh), 1.0, 1e-15);
    mesh.collapse(added, 0);
    EXPECT_NEAR(area(mesh), 1.0, 1e-15);
    int alive = 0;
    for (const FaceMesh::Triangle& triangle : mesh.triangles())
        alive += triangle.is_alive();
    EXPECT_EQ(alive, 2);
}

TEST(FaceMesh, refuses_triangles_that_are_no_surface)
{
    const std::vector<FaceVertex> vertices(4);
    EXPECT_THROW(FaceMesh(vertices, {{0, 1, 2}, {0, 1, 3}}, {}), InvalidInput);
}

}  // namespace sheetmorph::cad::test
