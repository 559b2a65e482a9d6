// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/system/loose_pieces.h"

#include "assembly/frames.h"
#include "assembly/refusals.h"

#include <gtest/gtest.h>

namespace sheetmorph::assembly
{
namespace
{

// One part of two sheets, one above the other; only the lower one is held and moved.
frames::Frame two_sheets(Unheld unheld)
{
    frames::Frame frame{"sheets", {}, {}};
    Assembly& assembly = frame.assembly;
    frames::add_plate(assembly, "first", {0.0, 0.0, 0.0}, false);
    frames::add_plate(assembly, "second", {0.0, 0.0, 5.0}, false);
    const mesh::TriangleMesh &low = assembly.parts[0].mesh, &high = assembly.parts[1].mesh;
    const int count = low.vertex_count();
    Points points(2 * count, 3);
    points << low.points(), high.points();
    Triangles triangles(2 * low.triangle_count(), 3);
    triangles << low.triangles(), (high.triangles().array() + count).matrix();
    assembly.parts = {assembly.parts[0]};
    assembly.parts[0].mesh = mesh::TriangleMesh(points, triangles);
    assembly.features.clear();
    assembly.fixed = {frames::side("root", assembly, 0,
                                   [](const Vector3& p) { return p.z() < 1.0 && p.x() < 1e-6; })};
    const PartRegion tip = frames::side(
        "tip", assembly, 0, [](const Vector3& p) { return p.z() < 1.0 && p.x() > 100.0; });
    assembly.handles = {{tip.name, 0, tip.vertices}};
    assembly.unheld = unheld;
    frame.pose.handles["tip"] = frames::motion({0, 0, 20}, {0, 1, 0}, 10.0, {100, 0, 0});
    return frame;
}

TEST(LoosePieces, StayAtRestUnlessToldOtherwise)
{
    const frames::Frame frame = two_sheets(Unheld::rest);
    const DeformationSession session(frame.assembly);
    const Points& rest = frame.assembly.parts[0].mesh.points();
    const Eigen::Index half = rest.rows() / 2;
    const Points moved = session.deform(frame.pose).parts[0].positions;
    EXPECT_EQ(moved.bottomRows(half), rest.bottomRows(half));
    EXPECT_GT((moved - rest).topRows(half).rowwise().norm().maxCoeff(), 10.0);
    ASSERT_EQ(session.loose_pieces().size(), 1U);
    EXPECT_EQ(session.loose_pieces().front().pieces, 1);
    EXPECT_EQ(session.loose_pieces().front().vertices, half);
}

TEST(LoosePieces, GoRigidlyAlongWithTheNearestPlace)
{
    const frames::Frame frame = two_sheets(Unheld::along);
    const Points& rest = frame.assembly.parts[0].mesh.points();
    const Eigen::Index half = rest.rows() / 2;
    const Points moved = DeformationSession(frame.assembly).deform(frame.pose).parts[0].positions;
    const auto edge = [&](const Points& points, Eigen::Index k)
    { return (points.row(half + k) - points.row(half)).norm(); };
    for (Eigen::Index k = 1; k < half; ++k)
        EXPECT_NEAR(edge(moved, k), edge(rest, k), 1e-9);
}

TEST(LoosePieces, AreRefusedWhereTheAssemblyWantsIt)
{
    EXPECT_NE(refusal(two_sheets(Unheld::refuse)).find("nothing constrains the component"),
              std::string::npos);
}

}  // namespace
}  // namespace sheetmorph::assembly
