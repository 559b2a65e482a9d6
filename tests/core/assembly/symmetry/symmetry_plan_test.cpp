// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/symmetry/symmetry_plan.h"

#include "sheetmorph/assembly/session/live_drag.h"

#include "assembly/frames.h"
#include "assembly/refusals.h"

#include <functional>
#include <gmock/gmock.h>

namespace sheetmorph::assembly
{

using namespace mesh;
using namespace surface;

namespace
{

using frames::Frame;
using testing::HasSubstr;
using testing::SizeIs;

// A wavy sheet from x = -90 to 90 mm that is its own mirror, triangles too.
TriangleMesh mirrored_sheet(int columns, int rows)
{
    const TriangleMesh half =
        shapes::sheet({columns, rows}, [](double u, double v)
                      { return Vector3(90.0 * u, 60.0 * v, 5.0 * std::sin(3 * u + 2 * v)); });
    Points points = half.points();
    points.col(0) *= -1.0;
    Triangles triangles = half.triangles();
    triangles.col(1).swap(triangles.col(2));
    return shapes::welded({half, TriangleMesh(points, triangles)});
}

VertexIds near(const TriangleMesh& mesh, const Vector3& place, double reach)
{
    return shapes::vertices_where(
        mesh, [&](const Vector3& p) { return (p - place).head<2>().norm() < reach; });
}

// Held along y = 0; a handle, a point and a turned patch on the right.
Frame one_sided()
{
    Frame frame{"one sided", {}, {}};
    Assembly& assembly = frame.assembly;
    assembly.parts.push_back({"hood", mirrored_sheet(12, 8), {}, Mode::automatic});
    const TriangleMesh& mesh = assembly.parts[0].mesh;
    assembly.fixed = {
        {"root", 0, shapes::vertices_where(mesh, [](const Vector3& p) { return p.y() < 1e-6; })}};
    assembly.handles = {{"corner", 0, near(mesh, {90, 60, 0}, 12.0), false}};
    assembly.features = {
        {"patch", 0, near(mesh, {45, 30, 0}, 10.0), FeatureRotation::prescribed, {}, {}, false}};
    PartPoint point;
    point.name = "peg";
    point.constraint = {"peg", 40, Vector3(0.2, 0.5, 0.3), true, false};
    assembly.points = {point};
    assembly.symmetry = SymmetryPlane{};
    frame.pose.handles["corner"] = frames::motion({3, 2, 15}, {0.2, 1, 0.3}, 20.0, {90, 60, 2});
    frame.pose.feature_logs["patch"] = rotation_log({0.1, 0.2, 1.0}, 0.3);
    frame.pose.points["peg"] = {Vector3(20, 25, 8), rotation_log({1.0, 0.0, 0.2}, 0.2)};
    return frame;
}

// Largest distance of a vertex from the mirror of its mirrored vertex.
double asymmetry(const TriangleMesh& rest, const Points& deformed)
{
    double worst = 0.0;
    for (int i = 0; i < rest.vertex_count(); ++i)
    {
        const Vector3 flip(-1.0, 1.0, 1.0);
        const int other =
            shapes::vertex_at(rest, rest.points().row(i).transpose().cwiseProduct(flip));
        const Vector3 mirrored = deformed.row(other).transpose().cwiseProduct(flip);
        worst = std::max(worst, (mirrored - deformed.row(i).transpose()).norm());
    }
    return worst;
}

}  // namespace

TEST(SymmetryPlan, ASymmetricMeshAnswersSymmetrically)
{
    const Frame frame = one_sided();
    const DeformationSession session(frame.assembly);
    EXPECT_THAT(session.assembly().handles, SizeIs(2));
    EXPECT_THAT(session.assembly().features, SizeIs(2));
    EXPECT_THAT(session.assembly().points, SizeIs(2));
    const Deformed shape = session.deform(frame.pose);
    const TriangleMesh& rest = frame.assembly.parts[0].mesh;
    EXPECT_LT(asymmetry(rest, shape.parts[0].positions), 1e-9 * rest.size());
    EXPECT_GT((shape.parts[0].positions - rest.points()).cwiseAbs().maxCoeff(), 10.0);
}

TEST(SymmetryPlan, ADragOnOneSideActsOnBothFromTheFirstFrame)
{
    const Frame frame = one_sided();
    const DeformationSession session(frame.assembly);
    const std::unique_ptr<LiveDrag> drag = session.begin_drag({"corner"}, frame.pose);
    const TriangleMesh& rest = frame.assembly.parts[0].mesh;
    EXPECT_LT(asymmetry(rest, drag->frame(frame.pose)->parts[0].positions), 1e-6 * rest.size());
    drag->wait();
    EXPECT_LT(asymmetry(rest, drag->frame(frame.pose)->parts[0].positions), 1e-6 * rest.size());
    Pose wrong = frame.pose;
    wrong.sizes["patch"] = 3.0;
    EXPECT_THROW(drag->frame(wrong), InvalidInput);
}

TEST(SymmetryPlan, AMeshSymmetricTo1e9AnswersSymmetricTo1e9)
{
    Frame frame = one_sided();
    std::srand(4);
    TriangleMesh& mesh = frame.assembly.parts[0].mesh;
    const TriangleMesh exact = mesh;
    mesh = TriangleMesh(mesh.points() + 1e-9 * Points::Random(mesh.vertex_count(), 3),
                        mesh.triangles());
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    EXPECT_LT(asymmetry(exact, shape.parts[0].positions), 2e-8);
}

TEST(SymmetryPlan, BothSidesDeclaredIsTheSameAsOne)
{
    Frame one = one_sided();
    Frame both = one_sided();
    const Mirror mirror(*both.assembly.symmetry);
    const TriangleMesh& mesh = both.assembly.parts[0].mesh;
    both.assembly.handles.push_back({"left corner", 0, near(mesh, {-90, 60, 0}, 12.0), false});
    const Points shape = DeformationSession(one.assembly).deform(one.pose).parts[0].positions;
    const auto distance = [&]
    {
        const Deformed other = DeformationSession(both.assembly).deform(both.pose);
        return (other.parts[0].positions - shape).cwiseAbs().maxCoeff();
    };
    EXPECT_LT(distance(), 1e-9);
    both.pose.handles["left corner"] = mirror.motion(both.pose.handles["corner"]);
    EXPECT_LT(distance(), 1e-9);
    both.pose.handles.erase("corner");
    EXPECT_LT(distance(), 1e-9);
    both.pose.handles["corner"] = frames::motion({1, 0, 0}, {0, 0, 1}, 0.0, {90, 60, 2});
    EXPECT_THAT(refusal(both), HasSubstr("the handles 'corner' and 'left corner', which mirror"));
}

TEST(SymmetryPlan, AHandleOnThePlaneKeepsTheSymmetricPartOfItsMotion)
{
    Frame frame = one_sided();
    const TriangleMesh& mesh = frame.assembly.parts[0].mesh;
    frame.assembly.handles = {{"nose", 0, near(mesh, {0, 60, 0}, 12.0), false}};
    frame.pose.handles = {{"nose", frames::motion({7, 2, 15}, {1, 2, 3}, 40.0, {0, 60, 0})}};
    const DeformationSession session(frame.assembly);
    EXPECT_THAT(session.assembly().handles, SizeIs(1));
    const Deformed shape = session.deform(frame.pose);
    EXPECT_LT(asymmetry(mesh, shape.parts[0].positions), 1e-9 * mesh.size());
    const int middle =
        shapes::vertex_at(mesh, {0, 60, mesh.points()(near(mesh, {0, 60, 0}, 1)[0], 2)});
    EXPECT_NEAR(shape.parts[0].positions(middle, 0), 0.0, 1e-12);
}

TEST(SymmetryPlan, MirrorsBetweenTwoPartsToo)
{
    Frame frame{"pair", {}, {}};
    const TriangleMesh right = shapes::sheet(
        {6, 6}, [](double u, double v) { return Vector3(10 + 60 * u, 60 * v, 4 * u * v); });
    Points points = right.points();
    points.col(0) *= -1.0;
    frame.assembly.parts = {{"right", right, {}, Mode::automatic},
                            {"left", TriangleMesh(points, right.triangles()), {}, Mode::automatic}};
    const auto at_root = [](const Vector3& p) { return p.y() < 1e-6; };
    frame.assembly.fixed = {frames::side("root", frame.assembly, 0, at_root)};
    frame.assembly.handles = {{"tip", 0, near(right, {70, 60, 0}, 12), false}};
    frame.assembly.symmetry = SymmetryPlane{};
    frame.pose.handles["tip"] = frames::motion({1, 2, 9}, {1, 1, 0}, 15.0, {70, 60, 0});
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    Points mirrored = shape.parts[1].positions;
    mirrored.col(0) *= -1.0;
    EXPECT_LT((mirrored - shape.parts[0].positions).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(SymmetryPlan, WhatHasNoMirrorIsNamed)
{
    Frame frame = one_sided();
    frame.assembly.symmetry->point = {7.0, 0.0, 0.0};
    EXPECT_THAT(refusal(frame), HasSubstr("part 'hood': handle 'corner' has no mirror on the other "
                                          "side of the symmetry plane"));
}

TEST(SymmetryPlan, AHandleWhoseMirrorIsFixedIsRefused)
{
    Frame frame = one_sided();
    const TriangleMesh& mesh = frame.assembly.parts[0].mesh;
    frame.assembly.fixed.push_back({"clamp", 0, near(mesh, {-90, 60, 0}, 8.0)});
    EXPECT_THAT(refusal(frame), HasSubstr("the mirror of handle 'corner' covers a part of fixed "
                                          "region 'clamp'"));
}

using Edit = std::function<void(PartFeature&)>;

std::string refusal_of(Assembly assembly)
{
    try
    {
        complete_by_symmetry(assembly);
    }
    catch (const InvalidInput& fault)
    {
        return fault.what();
    }
    return "";
}

// A patch on either side that moves along a line.
Assembly both_patches()
{
    Assembly both = one_sided().assembly;
    const TriangleMesh& mesh = both.parts[0].mesh;
    PartFeature& own = both.features[0];
    own.motion = {FeatureMotion::Type::line, Vector3::Zero(), Vector3(0.6, 0.8, 0.0)};
    both.features.push_back({"left patch",
                             0,
                             near(mesh, {-45, 30, 0}, 10.0),
                             FeatureRotation::prescribed,
                             {FeatureMotion::Type::line, Vector3::Zero(), {-0.6, 0.8, 0.0}},
                             {},
                             false});
    return both;
}

TEST(SymmetryPlan, FeaturesThatMirrorEachOtherAreDeclaredAlike)
{
    Assembly both = both_patches();
    EXPECT_EQ(refusal_of(both), "");
    const std::vector<std::pair<const char*, Edit>> edits = {
        {"differ in their rotation", [](auto& f) { f.rotation = FeatureRotation::interpolated; }},
        {"differ in their motion", [](auto& f) { f.motion.type = FeatureMotion::Type::plane; }},
        {"differ in their motion",
         [](auto& f) {
             f.motion.direction = {0.6, 0.8, 0.0};
         }},
    };
    for (const auto& [told, edit] : edits)
    {
        Assembly wrong = both;
        edit(wrong.features[1]);
        EXPECT_THAT(refusal_of(wrong), HasSubstr(told));
    }
    // The direction of a motion that has none is not read.
    for (PartFeature& feature : both.features)
        feature.motion.type = FeatureMotion::Type::translation;
    both.features[1].motion.direction = Vector3::UnitY();
    EXPECT_EQ(refusal_of(both), "");
    both.features[0].size = 5.0;
    Assembly sized = both;
    complete_by_symmetry(sized);
    EXPECT_EQ(sized.features[1].size, 5.0);
    EXPECT_TRUE(sized.features[1].is_resizable);
    both.features[1].size = 6.0;
    EXPECT_THAT(refusal_of(both), HasSubstr("differ in their size"));
}

// A sheet on one side only: what the description moves must have a mirror, the rest need not.
TEST(SymmetryPlan, AFeatureWithoutAMirrorIsRefusedWhereItIsMoved)
{
    Assembly assembly;
    assembly.parts.push_back({"half",
                              shapes::mapped(shapes::grid(8, 8, 80.0, 80.0), [](const Vector3& p)
                                             { return Vector3(p + Vector3(5.0, 0.0, 0.0)); }),
                              {},
                              Mode::automatic});
    assembly.symmetry = SymmetryPlane{};
    assembly.features = {{"patch",
                          0,
                          near(assembly.parts[0].mesh, {45, 40, 0}, 12.0),
                          FeatureRotation::free,
                          {},
                          {},
                          false}};
    EXPECT_EQ(refusal_of(assembly), "");
    for (const Edit& edit :
         std::vector<Edit>{[](auto& f) { f.rotation = FeatureRotation::prescribed; },
                           [](auto& f) { f.size = 3.0; }, [](auto& f) { f.is_resizable = true; },
                           [](auto& f) { f.motion.type = FeatureMotion::Type::fixed; }})
    {
        Assembly moved = assembly;
        edit(moved.features[0]);
        EXPECT_THAT(refusal_of(moved), HasSubstr("feature 'patch' has no mirror"));
    }
}

}  // namespace sheetmorph::assembly
