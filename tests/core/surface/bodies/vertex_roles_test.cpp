// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/vertex_roles.h"

#include "sheetmorph/base/errors.h"
#include "surface/strip.h"

#include <gmock/gmock.h>
#include <limits>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;
using cases::solve;
using cases::strip;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

auto refuses(const Case& one)
{
    return [one] { solve(one); };
}

TEST(VertexRoles, RefusesAFeatureBetweenAFixedRegionAndAHandle)
{
    Case one = cases::flat_plate();
    one.constraints.features[1].vertices.push_back(one.constraints.fixed[0].vertices[0]);
    one.constraints.features[1].vertices.push_back(one.constraints.handles[0].vertices[0]);
    EXPECT_THAT(refuses(one), ThrowsMessage<InvalidInput>(
                                  AllOf(HasSubstr("'hole1'"), HasSubstr("a fixed region"),
                                        HasSubstr("handle 'tip'"), HasSubstr("only one"))));
}

TEST(VertexRoles, FixedWinsWhereAHandleOverlapsIt)
{
    Case one = strip();
    const int corner = one.constraints.fixed[0].vertices[0];
    one.constraints.handles[0].vertices.push_back(corner);
    EXPECT_EQ(solve(one).positions.row(corner), one.mesh.points().row(corner));
}

TEST(VertexRoles, RefusesHandlesThatOverlap)
{
    Case one = strip();
    one.constraints.handles.push_back(
        {"other", {one.constraints.handles[0].vertices[1]}, "handle"});
    one.targets.handles.emplace_back();
    EXPECT_THAT(refuses(one),
                ThrowsMessage<InvalidInput>(
                    AllOf(HasSubstr("'tip' and handle 'other'"), HasSubstr("remove these"))));
}

TEST(VertexRoles, NamesTheComponentThatNothingHolds)
{
    Case one = strip();
    Points points(one.mesh.vertex_count() + 3, 3);
    points << one.mesh.points(), Points::Random(3, 3);
    Triangles triangles(one.mesh.triangle_count() + 1, 3);
    const int first = one.mesh.vertex_count();
    triangles << one.mesh.triangles(), Eigen::RowVector3i(first, first + 1, first + 2);
    one.mesh = mesh::TriangleMesh(points, triangles);
    EXPECT_THAT(refuses(one),
                ThrowsMessage<InvalidInput>(
                    AllOf(HasSubstr(std::to_string(first) + ", " + std::to_string(first + 1)),
                          HasSubstr("mark a fixed region or a handle"))));
}

TEST(VertexRoles, RefusesIdsOutOfRangeEmptyRegionsAndNumbersThatAreNone)
{
    Case outside = strip();
    outside.constraints.fixed[0].vertices.push_back(100000);
    EXPECT_THAT(refuses(outside),
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("'root'"), HasSubstr("100000"))));
    Case empty = strip();
    empty.constraints.features = {{"hole", {}, FeatureRotation::free, "feature"}};
    EXPECT_THAT(refuses(empty), ThrowsMessage<InvalidInput>(HasSubstr("no vertices")));
    Case nan = strip();
    nan.targets.handles[0].translation.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refuses(nan),
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("'tip'"), HasSubstr("not finite"))));
    Case weights = strip();
    weights.constraints.points = {{"p", 3, {0.5, 0.5, 0.5}, false}};
    EXPECT_THAT(refuses(weights), ThrowsMessage<InvalidInput>(HasSubstr("sum 1")));
    Case pose = strip();
    pose.targets.handles.clear();
    EXPECT_THAT(refuses(pose), ThrowsMessage<InvalidInput>(HasSubstr("0 handle motions")));
}

}  // namespace
}  // namespace sheetmorph::surface
