// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/constraints/constraint_checks.h"

#include "sheetmorph/base/errors.h"
#include "surface/strip.h"

#include <functional>
#include <gmock/gmock.h>
#include <limits>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A strip with something of every kind, which is taken.
Case with_everything()
{
    Case one = cases::strip();
    one.constraints.features = {cases::patch("patch", one.mesh, Vector3(50.0, 12.0, 0.0), 8.0)};
    one.constraints.points = {{"probe", 20, {0.2, 0.3, 0.5}, true}};
    one.constraints.propagated = {{"weld", {44, 45}, "contact"}};
    one.constraints.stitches = {{"stitch", {60, 61}, "contact"}};
    one.targets.feature_logs = {Vector3::Zero()};
    one.targets.points = {{Vector3(1.0, 2.0, 3.0), Vector3::Zero()}};
    one.targets.propagated = {{Points::Zero(2, 3), Points::Zero(2, 3), {}}};
    return one;
}

void check(const Case& one)
{
    check_constraints(one.mesh, one.constraints);
    check_targets(one.constraints, one.targets);
}

using Spoil = std::function<void(Case&)>;

void expect_refused(const std::vector<std::pair<const char*, Spoil>>& cases)
{
    ASSERT_NO_THROW(check(with_everything()));
    for (const auto& [told, spoil] : cases)
    {
        Case wrong = with_everything();
        spoil(wrong);
        EXPECT_THAT([&] { check(wrong); }, ThrowsMessage<InvalidInput>(HasSubstr(told))) << told;
    }
}

TEST(ConstraintChecks, EveryWrongConstraintIsNamed)
{
    expect_refused({
        {"no triangles", [](Case& c) { c.mesh = mesh::TriangleMesh(); }},
        {"'root' names", [](Case& c) { c.constraints.fixed[0].vertices[1] = -1; }},
        {"'tip' names", [](Case& c) { c.constraints.handles[0].vertices[1] = 126; }},
        {"'patch' names", [](Case& c) { c.constraints.features[0].vertices[1] = 99999; }},
        {"'weld' has no vertices", [](Case& c) { c.constraints.propagated[0].vertices.clear(); }},
        {"'stitch' names", [](Case& c) { c.constraints.stitches[0].vertices[0] = -8; }},
        {"'probe' lies on", [](Case& c) { c.constraints.points[0].triangle = -1; }},
        {"'probe' lies on",
         [](Case& c) { c.constraints.points[0].triangle = c.mesh.triangle_count(); }},
        {"sum 1",
         [](Case& c) {
             c.constraints.points[0].barycentric = {0.2, 0.3, 0.6};
         }},
        {"sum 1",
         [](Case& c) {
             c.constraints.points[0].barycentric = {0.2, 0.3, 0.4};
         }},
        {"sum 1",
         [](Case& c) {
             c.constraints.points[0].barycentric = {-0.5, 0.5, 1.0};
         }},
        {"sum 1",
         [](Case& c) {
             c.constraints.points[0].barycentric = {nan, 0.5, 0.5};
         }},
    });
}

TEST(ConstraintChecks, EveryWrongNumberOfAPoseIsNamed)
{
    expect_refused({
        {"0 handle motions", [](Case& c) { c.targets.handles.clear(); }},
        {"2 feature rotations", [](Case& c) { c.targets.feature_logs.resize(2); }},
        {"0 point targets", [](Case& c) { c.targets.points.clear(); }},
        {"0 propagated regions", [](Case& c) { c.targets.propagated.clear(); }},
        {"'tip': its motion", [](Case& c) { c.targets.handles[0].translation.x() = nan; }},
        {"'tip': its motion", [](Case& c) { c.targets.handles[0].rotation_log.y() = nan; }},
        {"'tip': its motion", [](Case& c) { c.targets.handles[0].pivot.z() = nan; }},
        {"'patch': its rotation", [](Case& c) { c.targets.feature_logs[0].x() = nan; }},
        {"'probe': its target", [](Case& c) { c.targets.points[0].position.x() = nan; }},
        {"'probe': its target", [](Case& c) { c.targets.points[0].rotation_log.x() = nan; }},
        {"'weld' needs 2", [](Case& c) { c.targets.propagated[0].positions = Points::Zero(3, 3); }},
        {"'weld' needs 2",
         [](Case& c) { c.targets.propagated[0].rotation_logs = Points::Zero(1, 3); }},
        {"'weld' needs 2", [](Case& c) { c.targets.propagated[0].rotations.resize(1); }},
        {"not finite", [](Case& c) { c.targets.propagated[0].positions(1, 1) = nan; }},
        {"not finite", [](Case& c) { c.targets.propagated[0].rotation_logs(0, 2) = nan; }},
    });
    Case turned = with_everything();
    turned.targets.propagated[0].rotations.assign(2, Matrix3::Identity());
    EXPECT_NO_THROW(check(turned));
}

}  // namespace
}  // namespace sheetmorph::surface
