// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/feature_sizes.h"

#include "sheetmorph/fitting/circle.h"
#include "assembly/frames.h"
#include "assembly/refusals.h"

#include <gmock/gmock.h>

namespace sheetmorph::assembly
{

namespace
{

using frames::Frame;
using testing::HasSubstr;

// A flat plate with three holes of 24 mm, held and lifted.
Frame flat_plate()
{
    Frame frame{"plate", {}, {}};
    const shapes::PlateWithHoles plate = shapes::plate_with_holes({3, 16, 4, 60.0, 12.0});
    frame.assembly.parts.push_back({"plate", plate.mesh, {}, Mode::automatic});
    for (int k = 0; k < 3; ++k)
        frame.assembly.features.push_back({"hole" + std::to_string(k),
                                           0,
                                           plate.rims[static_cast<std::size_t>(k)],
                                           surface::FeatureRotation::free,
                                           {},
                                           {},
                                           false});
    frame.assembly.fixed = {{"root", 0, plate.left}};
    frame.assembly.handles = {{"tip", 0, plate.right, false}};
    frame.pose.handles["tip"] = frames::motion({0.0, 0.0, 20.0}, {0, 1, 0}, -10.0, {180, 30, 0});
    return frame;
}

fitting::CircleFit rim_of(const Frame& frame, const Deformed& shape, int hole)
{
    const PartFeature& feature = frame.assembly.features[static_cast<std::size_t>(hole)];
    return fitting::fit_circle(shape.parts[0].positions(feature.vertices, Eigen::indexing::all));
}

}  // namespace

TEST(FeatureSizes, OfTheDescriptionAndOfThePoseMakeExactCircles)
{
    Frame frame = flat_plate();
    frame.assembly.features[0].size = 20.0;
    frame.assembly.features[1].size = 24.0;
    frame.pose.sizes["hole1"] = 30.0;
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    const std::vector<double> radii = {10.0, 15.0, 12.0};
    for (int hole = 0; hole < 3; ++hole)
    {
        const FeatureResult& result = shape.features[static_cast<std::size_t>(hole)];
        const fitting::CircleFit circle = rim_of(frame, shape, hole);
        EXPECT_NEAR(circle.radius, radii[static_cast<std::size_t>(hole)], 1e-10);
        EXPECT_LT(circle.residual, 1e-10);
        EXPECT_LT(result.edge_error, 1e-10);
        EXPECT_LT(result.outline_error, 1e-10);
        EXPECT_EQ(result.size.has_value(), hole < 2);
    }
    EXPECT_EQ(*shape.features[1].size, 30.0);
}

TEST(FeatureSizes, AloneMoveAPartThatNobodyDrags)
{
    Frame frame = flat_plate();
    frame.assembly.handles.clear();
    frame.pose = {};
    frame.assembly.features[2].is_resizable = true;
    EXPECT_LT((DeformationSession(frame.assembly).deform({}).parts[0].positions
               - frame.assembly.parts[0].mesh.points())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-10);
    frame.pose.sizes["hole2"] = 28.0;
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    EXPECT_NEAR(rim_of(frame, shape, 2).radius, 14.0, 1e-10);
}

TEST(FeatureSizes, OfWhatIsNoHoleSlotOrCylinderAreRefused)
{
    Frame frame = flat_plate();
    frame.assembly.features[0].size = 20.0;
    frame.assembly.features[0].vertices.resize(9);
    EXPECT_THAT(refusal(frame), HasSubstr("part 'plate': feature 'hole0' has a size, but its "
                                          "vertices are not a hole, slot or cylinder"));
}

TEST(FeatureSizes, ThatNoHoleCanHaveAreRefused)
{
    Frame frame = flat_plate();
    frame.assembly.features[0].size = 20.0;
    frame.pose.sizes["hole0"] = -1.0;
    EXPECT_THAT(refusal(frame), HasSubstr("cannot have a diameter of -1 mm; give more than 0 mm"));
    frame.pose.sizes = {{"hole1", 20.0}};
    EXPECT_THAT(refusal(frame), HasSubstr("not a feature whose size can be set"));
}

TEST(FeatureSizes, TooLargeForTheSheetAreRefusedWithTheLimit)
{
    Frame frame = flat_plate();
    frame.assembly.features[0].size = 400.0;
    EXPECT_THAT(refusal(frame), HasSubstr("hole0"));
}

}  // namespace sheetmorph::assembly
