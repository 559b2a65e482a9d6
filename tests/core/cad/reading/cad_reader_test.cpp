// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/reading/cad_reader.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/quality/quality.h"
#include "cad/cad_files.h"

#include <Eigen/LU>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace sheetmorph::cad::test
{

namespace
{

double volume(const mesh::TriangleMesh& mesh)
{
    double sum = 0.0;
    for (Eigen::Index t = 0; t < mesh.triangles().rows(); ++t)
    {
        Matrix3 corners;
        for (int k = 0; k < 3; ++k)
            corners.col(k) = mesh.points().row(mesh.triangles()(t, k)).transpose();
        sum += corners.determinant() / 6.0;
    }
    return sum;
}

double longest_edge(const mesh::TriangleMesh& mesh)
{
    double longest = 0.0;
    for (Eigen::Index t = 0; t < mesh.triangles().rows(); ++t)
        for (int k = 0; k < 3; ++k)
            longest = std::max(longest, (mesh.points().row(mesh.triangles()(t, k))
                                         - mesh.points().row(mesh.triangles()(t, (k + 1) % 3)))
                                            .norm());
    return longest;
}

// Largest distance of the vertices of a cylinder's faces from it.
double worst_cylinder_error(const CadPart& part)
{
    double worst = 0.0;
    for (std::size_t t = 0; t < part.face_of_triangle.size(); ++t)
    {
        const CadSurface& surface =
            part.surfaces[static_cast<std::size_t>(part.face_of_triangle[t])];
        if (surface.kind != SurfaceKind::cylinder)
            continue;
        for (int k = 0; k < 3; ++k)
        {
            const int v = part.mesh.triangles()(static_cast<Eigen::Index>(t), k);
            const Vector3 from = part.mesh.points().row(v).transpose() - surface.point;
            const double away = (from - from.dot(surface.axis) * surface.axis).norm();
            worst = std::max(worst, std::abs(away - surface.radius));
        }
    }
    return worst;
}

std::multiset<double> cylinder_radii(const CadPart& part)
{
    std::multiset<double> radii;
    for (const CadSurface& surface : part.surfaces)
        if (surface.kind == SurfaceKind::cylinder)
            radii.insert(surface.radius);
    return radii;
}

CadModel read(const std::string& path, const CadMeshing& meshing = {})
{
    return read_cad(path, meshing, Progress());
}

std::string complaint(const std::string& path, const CadMeshing& meshing = {})
{
    try
    {
        read(path, meshing);
    }
    catch (const InvalidInput& error)
    {
        return error.what();
    }
    return "";
}

class PlateFile : public testing::TestWithParam<const char*>
{
public:
    std::string write(const TemporaryFolder& folder) const
    {
        const std::string ending = GetParam();
        const std::string path = folder.file("plate." + ending);
        if (ending == "step")
            write_plate_step(path);
        else if (ending == "igs")
            write_plate_iges(path);
        else
            write_plate_brep(path);
        return path;
    }
};

}  // namespace

TEST_P(PlateFile, is_one_closed_part_with_its_holes_exact)
{
    const TemporaryFolder folder;
    const CadModel model = read(write(folder), {4.0, 0.05, 0.35});
    ASSERT_EQ(model.parts.size(), 1u);
    const CadPart& part = model.parts[0];
    EXPECT_THAT(part.name, testing::AnyOf("plate", "part"));
    EXPECT_TRUE(part.is_closed);
    EXPECT_TRUE(part.skipped_faces.empty());
    EXPECT_EQ(part.surfaces.size(), 8u);
    const double exact = 2.0 * (60.0 * 40.0 - M_PI * (9.0 + 25.0));
    EXPECT_NEAR(volume(part.mesh), exact, 0.002 * exact);
    EXPECT_LE(longest_edge(part.mesh), 4.4);
    // An IGES file has its edges as splines.
    const bool is_iges = std::string(GetParam()) == "igs";
    EXPECT_LT(worst_cylinder_error(part), is_iges ? 1e-4 : 1e-9);
    const std::multiset<double> radii = cylinder_radii(part);
    ASSERT_EQ(radii.size(), 2u);
    EXPECT_NEAR(*radii.begin(), 3.0, 1e-9);
    EXPECT_NEAR(*radii.rbegin(), 5.0, 1e-9);
    EXPECT_LE(part.deviation, 0.05);
    EXPECT_GT(mesh::quality(part.mesh).worst_angle_degrees, 15.0);
}

INSTANTIATE_TEST_SUITE_P(Formats, PlateFile, testing::Values("step", "igs", "brep"));

TEST(CadReader, places_and_names_the_parts_of_an_assembly)
{
    const TemporaryFolder folder;
    write_assembly_step(folder.file("fixture.stp"));
    const CadModel model = read(folder.file("fixture.stp"), {5.0, 0.1, 0.35});
    ASSERT_EQ(model.parts.size(), 3u);
    EXPECT_EQ(model.parts[0].name, "plate");
    EXPECT_EQ(model.parts[1].name, "pin");
    EXPECT_EQ(model.parts[2].name, "pin 2");
    EXPECT_EQ(model.parts[1].mesh.triangle_count(), model.parts[2].mesh.triangle_count());
    const auto lying = model.parts[2].mesh.points();
    EXPECT_NEAR(lying.col(1).minCoeff(), 12.0, 1e-12);
    EXPECT_NEAR(lying.col(1).maxCoeff(), 20.0, 1e-12);
    EXPECT_NEAR(lying.col(0).minCoeff(), 37.0, 0.1);
    EXPECT_LT(worst_cylinder_error(model.parts[2]), 1e-12);
    EXPECT_GT(volume(model.parts[2].mesh), 0.0);
}

TEST(CadReader, takes_free_shells_and_solids_of_one_file)
{
    const TemporaryFolder folder;
    write_sheet_and_ball_brep(folder.file("both.brep"));
    const CadModel model = read(folder.file("both.brep"), {5.0, 0.1, 0.35});
    ASSERT_EQ(model.parts.size(), 2u);
    const CadPart &ball = model.parts[0], &sheet = model.parts[1];
    EXPECT_TRUE(ball.is_closed);
    EXPECT_FALSE(sheet.is_closed);
    const double exact = 4.0 / 3.0 * M_PI * 64.0;
    EXPECT_NEAR(volume(ball.mesh), exact, 0.05 * exact);
    for (Eigen::Index v = 0; v < ball.mesh.points().rows(); ++v)
        EXPECT_NEAR((ball.mesh.points().row(v) - Eigen::RowVector3d(100, 0, 0)).norm(), 4.0, 1e-9);
    EXPECT_NEAR(sheet.mesh.points().col(2).minCoeff(), 2.0, 1e-12);
    EXPECT_EQ(sheet.circles.size(), 2u);
    EXPECT_GT(mesh::quality(sheet.mesh).worst_angle_degrees, 20.0);
}

TEST(CadReader, follows_bends_and_keeps_flats_coarse)
{
    const TemporaryFolder folder;
    write_bend_brep(folder.file("bend.brep"));
    const CadMeshing meshing{6.0, 0.05, 0.35};
    const CadPart part = read(folder.file("bend.brep"), meshing).parts.at(0);
    EXPECT_TRUE(part.is_closed);
    EXPECT_LE(part.deviation, meshing.deflection);
    EXPECT_LE(longest_edge(part.mesh), 6.6);
    EXPECT_LT(worst_cylinder_error(part), 1e-9);
    EXPECT_LT(part.mesh.triangle_count(), 2500);
}

TEST(CadReader, recognises_cones_tori_and_what_a_spline_really_is)
{
    const TemporaryFolder folder;
    write_solids_brep(folder.file("solids.brep"));
    const CadModel model = read(folder.file("solids.brep"), {3.0, 0.1, 0.35});
    ASSERT_EQ(model.parts.size(), 3u);
    EXPECT_THAT(model.parts[0].surfaces,
                testing::Contains(testing::Field(&CadSurface::kind, SurfaceKind::cone)));
    EXPECT_NEAR(model.parts[0].surfaces[0].half_angle, std::atan(0.5), 1e-12);
    EXPECT_EQ(model.parts[1].surfaces[0].kind, SurfaceKind::torus);
    EXPECT_NEAR(model.parts[1].surfaces[0].minor_radius, 2.0, 1e-12);
    const std::multiset<double> radii = cylinder_radii(model.parts[2]);
    ASSERT_EQ(radii.size(), 1u);
    EXPECT_NEAR(*radii.begin(), 5.0, 1e-5);
    for (const CadPart& part : model.parts)
        EXPECT_TRUE(part.is_closed) << part.name;
}

TEST(CadReader, gives_the_same_mesh_again)
{
    const TemporaryFolder folder;
    write_bend_brep(folder.file("bend.brep"));
    const CadPart one = read(folder.file("bend.brep"), {4.0, 0.1, 0.35}).parts.at(0);
    const CadPart other = read(folder.file("bend.brep"), {4.0, 0.1, 0.35}).parts.at(0);
    EXPECT_EQ(one.mesh.points(), other.mesh.points());
    EXPECT_EQ(one.mesh.triangles(), other.mesh.triangles());
}

TEST(CadReader, reads_the_text_of_a_shape)
{
    const TemporaryFolder folder;
    write_plate_brep(folder.file("plate.brep"));
    std::ostringstream text;
    text << std::ifstream(folder.file("plate.brep")).rdbuf();
    const CadModel model = read_brep(text.str(), "cover", {5.0, 0.1, 0.35});
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].name, "cover");
    EXPECT_THROW(read_brep("no shape", "cover", {}), InvalidInput);
}

TEST(CadReader, says_what_is_wrong_with_a_file)
{
    const TemporaryFolder folder;
    for (const std::string ending : {"step", "igs", "brep"})
    {
        const std::string path = folder.file("broken." + ending);
        std::ofstream(path) << "solid of nothing\n";
        EXPECT_THAT(complaint(path), testing::HasSubstr("; ")) << ending;
    }
    EXPECT_THAT(complaint(folder.file("part.xyz")), testing::HasSubstr("not a CAD file"));
}

TEST(CadReader, refuses_sizes_out_of_range)
{
    const TemporaryFolder folder;
    write_plate_brep(folder.file("plate.brep"));
    const std::string path = folder.file("plate.brep");
    EXPECT_THAT(complaint(path, {-1.0, 0.0, 0.35}), testing::HasSubstr("length"));
    EXPECT_THAT(complaint(path, {1.0, 0.1, 3.0}), testing::HasSubstr("angle"));
    EXPECT_THAT(complaint(path, {1e-9, 0.1, 0.35}),
                testing::HasSubstr("triangles, the limit is 3 million; give a longer edge"));
}

TEST(CadReader, can_be_cancelled)
{
    const TemporaryFolder folder;
    write_plate_brep(folder.file("plate.brep"));
    const Progress stop([](double, const std::string&) { return false; });
    EXPECT_THROW(read_cad(folder.file("plate.brep"), {}, stop), Cancelled);
    // Also while OpenCASCADE triangulates, and while a face is refined: both report from outside.
    for (const int reports : {4, 8, 12})
    {
        int left = reports;
        const Progress later([&](double, const std::string&) { return --left > 0; });
        EXPECT_THROW(read_cad(folder.file("plate.brep"), {0.08, 0.0, 0.35}, later), Cancelled);
    }
}

TEST(CadReader, refuses_an_iges_file_that_is_cut_off)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("plate.igs");
    write_plate_iges(path);
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    for (const std::size_t lost : {2, 90, 500, 3000, 10000})
    {
        std::ofstream(path) << text.str().substr(0, text.str().size() - lost);
        if (lost > 2)
        {
            EXPECT_THAT(complaint(path), testing::HasSubstr("; ")) << lost;
        }
    }
}

}  // namespace sheetmorph::cad::test
