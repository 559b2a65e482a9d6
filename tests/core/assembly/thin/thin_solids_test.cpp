// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/deformation_session.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/recognise/thin/thickness_gauge.h"
#include "sheetmorph/repair/self_intersections.h"
#include "assembly/frames.h"
#include "assembly/gap_change.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::assembly
{

using namespace mesh;
using namespace recognise;
namespace
{

constexpr double length = 180.0;
constexpr double thickness = 2.0;

// A plate of 180 x 60 mm with three holes, one part; the end x = 0 is held, x = 180 the handle.
Assembly plate_assembly(const TriangleMesh& mesh, Thin thin)
{
    Assembly assembly;
    Part part;
    part.name = "plate";
    part.mesh = mesh;
    part.thin = thin;
    assembly.parts = {part};
    assembly.fixed = {
        frames::side("root", assembly, 0, [](const Vector3& p) { return p.x() < 1e-6; })};
    const PartRegion tip =
        frames::side("tip", assembly, 0, [](const Vector3& p) { return p.x() > length - 1e-6; });
    assembly.handles = {{tip.name, 0, tip.vertices}};
    return assembly;
}

void add_rims(Assembly& assembly, const std::vector<VertexIds>& rims)
{
    for (std::size_t k = 0; k < rims.size(); ++k)
    {
        PartFeature hole;
        hole.name = "hole" + std::to_string(k);
        hole.vertices = rims[k];
        assembly.features.push_back(hole);
    }
}

Pose pose_of(const RigidMotion& motion)
{
    Pose pose;
    pose.handles["tip"] = motion;
    return pose;
}

RigidMotion bent(double degrees)
{
    const double angle = degrees * shapes::pi / 180.0, radius = length / angle;
    const Vector3 end(radius * std::sin(angle), 0.0, radius * (1.0 - std::cos(angle)));
    return frames::motion(end - Vector3(length, 0, 0), {0, 1, 0}, -degrees, {length, 30, 0});
}

RigidMotion twisted(double degrees)
{
    return frames::motion({0, 0, 0}, {1, 0, 0}, degrees, {length, 30, 0});
}

class ThinSolids : public testing::TestWithParam<std::pair<const char*, RigidMotion>>
{
};

TEST_P(ThinSolids, KeepTheirThicknessAndNeverMeetThemselves)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes({3, 40, 7, 60.0, 12.0});
    const TriangleMesh mesh = shapes::two_skinned(plate.mesh, thickness);
    Assembly assembly = plate_assembly(mesh, Thin::yes);
    add_rims(assembly, plate.rims);
    const DeformationSession session(assembly);
    const Deformed shape = session.deform(pose_of(GetParam().second));
    const Points& positions = shape.parts[0].positions;
    const ThicknessChange change = thickness_change(mesh, *session.thin_solid(0), positions);
    EXPECT_NEAR(change.rest_least, thickness, 1e-9);
    EXPECT_NEAR(change.rest_most, thickness, 1e-9);
    EXPECT_LT(change.worst, 0.005);
    EXPECT_LT(change.worst_at_walls, 0.02);
    EXPECT_TRUE(repair::self_intersections(TriangleMesh(positions, mesh.triangles())).empty());
}

TEST_P(ThinSolids, BendAsTheOpenSheetInTheirMiddle)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const TriangleMesh solid = shapes::two_skinned(plate.mesh, thickness);
    const auto sink = [](const Vector3& p) { return Vector3(p - Vector3(0, 0, 0.5 * thickness)); };
    const TriangleMesh middle = shapes::mapped(plate.mesh, sink);
    Assembly thin = plate_assembly(solid, Thin::yes), open = plate_assembly(middle, Thin::no);
    add_rims(thin, plate.rims);
    add_rims(open, plate.rims);
    const Pose pose = pose_of(GetParam().second);
    const Points expected = DeformationSession(open).deform(pose).parts[0].positions;
    const Points found = DeformationSession(thin).deform(pose).parts[0].positions;
    const int count = plate.mesh.vertex_count();
    const Points halfway = 0.5 * (found.topRows(count) + found.middleRows(count, count));
    const double farthest = (expected - middle.points()).rowwise().norm().maxCoeff();
    EXPECT_LT((halfway - expected).rowwise().norm().maxCoeff(), 0.001 * farthest);
}

INSTANTIATE_TEST_SUITE_P(Motions, ThinSolids,
                         testing::Values(std::pair("bend30", bent(30.0)),
                                         std::pair("bend120", bent(120.0)),
                                         std::pair("twist20", twisted(20.0)),
                                         std::pair("twist90", twisted(90.0))),
                         [](const auto& each) { return std::string(each.param.first); });

// The solid of a sheet with a vertex more in the middle of every triangle of its lower skin.
TriangleMesh finer_below(const TriangleMesh& sheet)
{
    const TriangleMesh solid = shapes::two_skinned(sheet, thickness);
    const int count = solid.vertex_count(), more = sheet.triangle_count();
    Points points(count + more, 3);
    points.topRows(count) = solid.points();
    Triangles triangles(solid.triangle_count() + 2 * more, 3);
    triangles.topRows(solid.triangle_count()) = solid.triangles();
    for (int t = 0; t < more; ++t)
    {
        const Eigen::RowVector3i own = solid.triangles().row(2 * t + 1);
        const int middle = count + t, added = solid.triangle_count() + 2 * t;
        points.row(middle) = (points.row(own(0)) + points.row(own(1)) + points.row(own(2))) / 3.0;
        triangles.row(2 * t + 1) << own(0), own(1), middle;
        triangles.row(added) << own(1), own(2), middle;
        triangles.row(added + 1) << own(2), own(0), middle;
    }
    return TriangleMesh(points, triangles);
}

// A plate bent to an arc: the vertices inside facets of the other skin lie on the arc, not in the
// plane of its corners, which is a third of the sagitta nearer to the axis.
TEST(ThinSolid, AVertexInsideAFacetLiesOnTheArcOfItsCorners)
{
    const TriangleMesh sheet = shapes::grid(20, 6, length, 60.0);
    const TriangleMesh mesh = finer_below(sheet);
    const Assembly assembly = plate_assembly(mesh, Thin::yes);
    const Points shape =
        DeformationSession(assembly).deform(pose_of(bent(60.0))).parts[0].positions;
    const double radius = length / (shapes::pi / 3.0), edge = length / 20.0;
    const double sagitta = edge * edge / (9.0 * radius);
    const auto away = [&](int vertex)
    { return std::hypot(shape(vertex, 0), shape(vertex, 2) - radius); };
    for (int t = 0; t < sheet.triangle_count(); ++t)
    {
        const int middle = mesh.vertex_count() - sheet.triangle_count() + t;
        const Eigen::RowVector3d place = mesh.points().row(middle);
        if (place.x() < 40.0 || place.x() > 140.0 || place.y() < 15.0 || place.y() > 45.0)
            continue;
        double of_corners = 0.0;
        for (int k = 0; k < 3; ++k)
            of_corners += away(sheet.triangles()(t, k) + sheet.vertex_count()) / 3.0;
        EXPECT_NEAR(away(middle), of_corners, 0.4 * sagitta) << t;
    }
}

TEST(ThinSolid, FixedAndHandleVerticesAreMetBitwiseOnEverySide)
{
    const TriangleMesh mesh = shapes::two_skinned(shapes::plate_with_holes().mesh, thickness);
    const Assembly assembly = plate_assembly(mesh, Thin::yes);
    const RigidMotion motion = bent(40.0);
    const Points positions =
        DeformationSession(assembly).deform(pose_of(motion)).parts[0].positions;
    for (const int vertex : assembly.fixed.front().vertices)
        EXPECT_EQ(positions.row(vertex), mesh.points().row(vertex));
    for (const int vertex : assembly.handles.front().vertices)
        EXPECT_EQ(Vector3(positions.row(vertex)), motion.apply(Vector3(mesh.points().row(vertex))));
}

// A feature on one skin and another on the other one touch in a vertex of the wall alone.
TEST(ThinSolid, FeaturesThatShareAVertexAreOneBodyOnEverySkin)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const TriangleMesh mesh = shapes::two_skinned(plate.mesh, thickness);
    const int opposite = plate.mesh.vertex_count();
    Assembly assembly = plate_assembly(mesh, Thin::yes);
    add_rims(assembly, plate.rims);
    PartFeature tab;
    tab.name = "tab";
    const Vector3 centre =
        plate.mesh.points()(plate.rims[1], Eigen::indexing::all).colwise().mean();
    const int shared = plate.rims[1].front() + opposite;
    tab.vertices = {shared};
    const Vector3 way = Vector3(mesh.points().row(shared)) - centre;
    for (int v = opposite; v < 2 * opposite; ++v)
    {
        const Vector3 off = Vector3(mesh.points().row(v)) - centre;
        if (off.dot(way) > 1.3 * way.squaredNorm() && off.norm() < 2.0 * way.norm())
            tab.vertices.push_back(v);
    }
    ASSERT_GT(tab.vertices.size(), 2U);
    assembly.features.push_back(tab);
    const DeformationSession session(assembly);
    const Deformed shape = session.deform(pose_of(bent(60.0)));
    for (const FeatureResult& feature : shape.features)
        EXPECT_LT(feature.edge_error, 1e-9) << feature.name;
    EXPECT_FALSE(session.joined_bodies().empty());
}

TEST(ThinSolid, RegionsOnTheOppositeSkinAloneHoldAndMoveThePart)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const TriangleMesh mesh = shapes::two_skinned(plate.mesh, thickness);
    for (const int skin : {0, plate.mesh.vertex_count()})
    {
        Assembly assembly = plate_assembly(mesh, Thin::yes);
        assembly.fixed.front().vertices = plate.left;
        assembly.handles.front().vertices = plate.right;
        for (int& vertex : assembly.fixed.front().vertices)
            vertex += skin;
        for (int& vertex : assembly.handles.front().vertices)
            vertex += skin;
        const RigidMotion motion = bent(30.0);
        const Points positions =
            DeformationSession(assembly).deform(pose_of(motion)).parts[0].positions;
        for (const int vertex : assembly.handles.front().vertices)
            EXPECT_EQ(Vector3(positions.row(vertex)),
                      motion.apply(Vector3(mesh.points().row(vertex))));
        EXPECT_LT(thickness_change(mesh, *find_thin_solid(mesh).solid, positions).worst, 0.005);
    }
}

// A strip on edge stands along the wall of the plate that bends, and at a corner of its skin.
TEST(ThinSolid, WhatIsTiedToAWallStaysThere)
{
    Assembly assembly =
        plate_assembly(shapes::two_skinned(shapes::plate_with_holes().mesh, thickness), Thin::yes);
    const auto on_edge = [](const Vector3& p) { return Vector3(p.x(), -0.1, p.y() - 10.0); };
    Part strip;
    strip.name = "strip";
    strip.mesh = shapes::mapped(shapes::grid(60, 10, length, 20.0), on_edge);
    assembly.parts.push_back(strip);
    Contact contact;
    contact.name = "edge";
    contact.type = ContactType::tied;
    contact.a = frames::side("a", assembly, 0,
                             [](const Vector3& p)
                             { return p.y() < 1e-6 || (p.x() > 150 && p.y() < 15.0); });
    contact.b =
        frames::side("b", assembly, 1, [](const Vector3& p) { return std::abs(p.z()) < 3; });
    assembly.contacts = {contact};
    const Deformed shape = DeformationSession(assembly).deform(pose_of(bent(30.0)));
    EXPECT_LT(frames::gap_change(assembly, shape.contacts.front(), shape), 0.05);
}

TEST(ThinSolid, AHoleIsOneFeatureThroughBothSkins)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const int count = plate.mesh.vertex_count();
    const TriangleMesh mesh = shapes::two_skinned(plate.mesh, thickness);
    const ThinSolid solid = *find_thin_solid(mesh).solid;
    for (const int skin : {0, count})
    {
        Assembly assembly = plate_assembly(mesh, Thin::yes);
        VertexIds rim = plate.rims[1];
        for (int& vertex : rim)
            vertex += skin;
        add_rims(assembly, {rim});
        const Deformed shape = DeformationSession(assembly).deform(pose_of(bent(60.0)));
        EXPECT_LT(shape.features.front().edge_error, exactness(mesh.points(), mesh.size()));
        const RigidMotion& motion = shape.features.front().motion;
        for (const int vertex : solid.holes[1].vertices)
            EXPECT_LT((Vector3(shape.parts[0].positions.row(vertex))
                       - motion.apply(Vector3(mesh.points().row(vertex))))
                          .norm(),
                      exactness(mesh.points(), mesh.size()));
    }
}

TEST(ThinSolid, PointsOnEveryFacetAreMet)
{
    const TriangleMesh mesh = shapes::two_skinned(shapes::plate_with_holes().mesh, thickness);
    const ThinSolid solid = *find_thin_solid(mesh).solid;
    for (const SolidSide side : {SolidSide::main, SolidSide::opposite, SolidSide::wall})
    {
        Assembly assembly = plate_assembly(mesh, Thin::yes);
        assembly.handles.clear();
        int triangle = mesh.triangle_count() - 1;
        const auto is_elsewhere = [&](int t)
        {
            return solid.facets[static_cast<std::size_t>(t)] != side
                   || mesh.points()(mesh.triangles()(t, 0), 0) < 100.0;
        };
        while (is_elsewhere(triangle))
            --triangle;
        PartPoint point{"pin", 0, {"pin", triangle, {0.2, 0.3, 0.5}, false, false}};
        assembly.points = {point};
        const auto place = [&](const Points& points) -> Vector3
        {
            return (point.constraint.barycentric.transpose()
                    * points(mesh.triangles().row(triangle).transpose().eval(),
                             Eigen::indexing::all))
                .transpose();
        };
        Pose pose;
        pose.points["pin"].position = place(mesh.points()) + Vector3(-2.0, 1.0, 25.0);
        const Points positions = DeformationSession(assembly).deform(pose).parts[0].positions;
        EXPECT_LT((place(positions) - pose.points["pin"].position).norm(),
                  exactness(mesh.points(), mesh.size()));
    }
}

TEST(ThinSolid, ManyPlatesWithBendsAndHolesKeepTheirThickness)
{
    std::mt19937 random(3);
    const auto between = [&](double low, double high)
    { return low + (high - low) * (random() / 4294967296.0); };
    for (int round = 0; round < 12; ++round)
    {
        const double wall = between(0.5, 3.0), angle = between(-1.5, 1.5);
        const TriangleMesh sheet =
            shapes::with_bend(shapes::plate_with_holes({3, 32, 6, 60.0, between(6.0, 18.0)}).mesh,
                              between(50, 70), std::abs(angle) * between(10.0, 30.0), angle);
        const TriangleMesh mesh = shapes::two_skinned(sheet, wall);
        Assembly assembly = plate_assembly(mesh, Thin::yes);
        const double end = mesh.points().rowwise().squaredNorm().maxCoeff();
        assembly.handles = {{"tip", 0,
                             shapes::vertices_where(mesh, [&](const Vector3& p)
                                                    { return p.squaredNorm() > 0.97 * end; })}};
        const RigidMotion motion =
            frames::motion({between(-5, 5), between(-5, 5), between(-15, 15)},
                           {between(-1, 1), between(-1, 1), between(-1, 1)}, between(-15, 15),
                           Vector3(mesh.points().row(assembly.handles[0].vertices[0])));
        const DeformationSession session(assembly);
        const Points positions = session.deform(pose_of(motion)).parts[0].positions;
        const ThicknessChange change = thickness_change(mesh, *session.thin_solid(0), positions);
        EXPECT_LT(change.worst, 0.02) << "round " << round;
        EXPECT_LT(change.worst_at_walls, 0.02) << "round " << round;
        EXPECT_TRUE(repair::self_intersections(TriangleMesh(positions, mesh.triangles())).empty())
            << "round " << round;
    }
}

TEST(ThinSolid, WhatIsNoThinSolidIsRefusedOrSolvedAsItIs)
{
    Assembly assembly = plate_assembly(shapes::box(6, {length, 100, 90}), Thin::yes);
    try
    {
        DeformationSession session(assembly);
        FAIL() << "a block is no thin solid";
    }
    catch (const InvalidInput& fault)
    {
        EXPECT_NE(std::string(fault.what()).find("part 'plate': it is not a thin solid"),
                  std::string::npos);
    }
    assembly.parts[0].thin = Thin::automatic;
    const DeformationSession session(assembly);
    EXPECT_EQ(session.thin_solid(0), nullptr);
    Assembly plain = assembly;
    plain.parts[0].thin = Thin::no;
    EXPECT_EQ(session.deform(pose_of(bent(10.0))).parts[0].positions,
              DeformationSession(plain).deform(pose_of(bent(10.0))).parts[0].positions);
}

TEST(ThinSolid, ASessionOfTheSamePartTakesOverWhatItFound)
{
    const TriangleMesh mesh = shapes::two_skinned(shapes::plate_with_holes().mesh, thickness);
    const Assembly assembly = plate_assembly(mesh, Thin::automatic);
    const DeformationSession first(assembly);
    const DeformationSession second(assembly, {}, &first);
    EXPECT_EQ(first.thin_solid(0), second.thin_solid(0));
    EXPECT_TRUE(second.timings().empty());
    EXPECT_EQ(first.deform(pose_of(bent(30.0))).parts[0].positions,
              second.deform(pose_of(bent(30.0))).parts[0].positions);
}

}  // namespace
}  // namespace sheetmorph::assembly
