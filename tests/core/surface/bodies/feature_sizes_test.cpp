// SPDX-License-Identifier: LGPL-2.1-or-later
// Sizes that a pose sets.
#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/topology/edges.h"
#include "surface/free_strip.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace sheetmorph::surface
{
namespace
{

using namespace cases;

using testing::AllOf;
using testing::HasSubstr;

TEST(FeatureSizes, SizesAreReachedWithExactCirclesAndNoTriangleTurnedOver)
{
    Case one = strip_with_holes(true);
    for (FormFeature& feature : one.constraints.features)
        feature.is_resizable = true;
    const std::vector<double> sizes = {32.0, 60.0, 50.0};
    one.targets.sizes = {sizes[0], sizes[1], sizes[2]};
    for (const FeatureRotation rotation : {FeatureRotation::free, FeatureRotation::interpolated})
    {
        // Rims on a curved sheet are no plane circles: flat for this.
        one.mesh = strip_with_holes().mesh;
        set_rotation(one, rotation);
        const SurfaceDeformer deformer(one.mesh, one.constraints);
        const Deformation shape = deformer.deform(one.targets);
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Vector3 centre = shape.features[k].apply(centre_of(one, k));
            const Vector3 axis = shape.features[k].rotation() * Vector3::UnitZ();
            for (const int vertex : one.constraints.features[k].vertices)
            {
                const Vector3 spoke = shape.positions.row(vertex).transpose() - centre;
                EXPECT_NEAR(spoke.norm(), 0.5 * sizes[k], 1e-10);
                EXPECT_NEAR(spoke.dot(axis), 0.0, 1e-10);
            }
        }
        const Points live = deformer.deform(one.targets, Exactness::live).positions;
        EXPECT_LT((live - shape.positions).rowwise().norm().maxCoeff(), 3e-4);
    }
}

TEST(FeatureSizes, ASizeMovesNothingButTheSheetAroundIt)
{
    Case one = strip_with_holes();
    one.constraints.features[1].is_resizable = true;
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const Points plain = deformer.deform(one.targets).positions;
    one.targets.sizes = {std::nullopt, 60.0, std::nullopt};
    const Points sized = deformer.deform(one.targets).positions;
    const VertexIds& rim = one.constraints.features[1].vertices;
    EXPECT_GT((sized - plain).rowwise().norm().maxCoeff(), 9.0);
    const mesh::EdgeTable table(one.mesh);
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const mesh::EdgeUse& use = *table.uses(edge).begin();
        if (table.uses(edge).count() == 1 && std::count(rim.begin(), rim.end(), use.from) == 0)
            EXPECT_EQ(sized.row(use.from), plain.row(use.from)) << use.from;
    }
}

TEST(FeatureSizes, ASizeThatWouldTurnTrianglesOverIsRefusedWithTheLimit)
{
    Case one = strip_with_holes();
    one.targets.handles = {RigidMotion{}};
    one.constraints.features[1].is_resizable = true;
    one.targets.sizes = {std::nullopt, 180.0, std::nullopt};
    std::string said;
    try
    {
        solve(one);
    }
    catch (const InvalidInput& refused)
    {
        said = refused.what();
    }
    ASSERT_THAT(said, AllOf(HasSubstr("hole1"), HasSubstr("180"), HasSubstr("largest")));
    const double limit = std::stod(said.substr(said.find("possible is ") + 12));
    EXPECT_GT(limit, 75.0);   // of a strip
    EXPECT_LT(limit, 100.0);  // as wide as this
    one.targets.sizes[1] = limit;
    EXPECT_NO_THROW(solve(one));
    one.targets.sizes[1] = 1.02 * limit;
    EXPECT_THROW(solve(one), InvalidInput);
}

}  // namespace
}  // namespace sheetmorph::surface
