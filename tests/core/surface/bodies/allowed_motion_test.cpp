// SPDX-License-Identifier: LGPL-2.1-or-later
// The motion that a feature's motion or link allows, nearest to a wanted one.
#include "sheetmorph/surface/bodies/allowed_motion.h"

#include "sheetmorph/surface/bodies/vertex_roles.h"
#include "surface/free_strip.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;

class Draw
{
public:
    explicit Draw(unsigned seed) : bits_(seed) {}

    double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(bits_); }
    Vector3 vector() { return {number(), number(), number()}; }
    Matrix3 rotation() { return Eigen::AngleAxisd(number(), vector().normalized()).matrix(); }
    BodyState near(const BodyState& state)
    {
        return {rotation() * state.rotation, state.centre + 20.0 * vector()};
    }

private:
    std::mt19937 bits_;
};

// Angle between two rotations, radians.
double between(const Matrix3& one, const Matrix3& other)
{
    return Eigen::AngleAxisd(one * other.transpose()).angle();
}

void expect_same(const BodyState& found, const BodyState& expected)
{
    EXPECT_LT((found.rotation - expected.rotation).norm(), 1e-12);
    EXPECT_LT((found.centre - expected.centre).norm(), 1e-10);
}

// Three holes of which the last two are one body, so that its centre is not that of either.
Case grouped()
{
    Case one = cases::strip_with_holes();
    one.constraints.groups = {{1, 2}};
    return one;
}

const Body& body_of(const VertexRoles& roles, int feature)
{
    for (const Body& body : roles.bodies)
        if (std::count(body.features.begin(), body.features.end(), feature) > 0)
            return body;
    throw std::logic_error("no body");
}

TEST(AllowedMotion, ARestrictedBodyIsWhereItsMotionAllowsAndNowhereNearer)
{
    Draw draw(1);
    for (const auto type :
         {FeatureMotion::Type::plane, FeatureMotion::Type::line, FeatureMotion::Type::axis})
        for (int round = 0; round < 10; ++round)
        {
            Case one = grouped();
            const Vector3 along = draw.vector().normalized();
            const Vector3 point(150.0, 40.0, 5.0);
            one.constraints.features[1].motion = {type, point, along};
            const VertexRoles roles = assign_roles(one.mesh, one.constraints);
            const PlacementInput part{one.mesh, one.constraints, roles};
            const Body& body = body_of(roles, 1);
            const Vector3 centre = cases::centre_of(one, 1);
            ASSERT_GT((body.centre - centre).norm(), 10.0);
            const BodyState wanted = draw.near({Matrix3::Identity(), body.centre});
            const BodyState found = nearest_restricted(part, body, wanted);
            const Vector3 shift = moved_point(body, found, centre) - centre;
            EXPECT_TRUE(type != FeatureMotion::Type::plane || std::abs(shift.dot(along)) < 1e-10);
            EXPECT_TRUE(type != FeatureMotion::Type::line || shift.cross(along).norm() < 1e-10);
            EXPECT_TRUE(type != FeatureMotion::Type::axis
                        || (moved_point(body, found, point) - point).norm() < 1e-10);
            EXPECT_TRUE(type == FeatureMotion::Type::line
                        || (found.rotation * along - along).norm() < 1e-12);
            expect_same(nearest_restricted(part, body, found), found);
            const Vector3 target = moved_point(body, wanted, centre);
            for (int other = 0; other < 20; ++other)
            {
                const BodyState allowed = nearest_restricted(part, body, draw.near(found));
                const double miss = (moved_point(body, found, centre) - target).norm();
                const double other_miss = (moved_point(body, allowed, centre) - target).norm();
                EXPECT_TRUE(type == FeatureMotion::Type::axis || miss <= other_miss + 1e-10);
                EXPECT_LE(between(found.rotation, wanted.rotation),
                          between(allowed.rotation, wanted.rotation) + 1e-7);
            }
        }
}

// The body that the last hole is, which follows a leader in another part.
struct Follower
{
    Case one = cases::strip_with_holes();
    Vector3 centre, direction;
    VertexRoles roles;

    Follower(FeatureLinkType type, Draw& draw)
        : centre(draw.vector() * 50.0), direction(draw.vector().normalized())
    {
        one.constraints.groups = {{1, 2}};
        one.constraints.links = {{"link", type, 2, -1, centre, direction}};
        roles = assign_roles(one.mesh, one.constraints);
    }

    PlacementInput part() const { return {one.mesh, one.constraints, roles}; }
    const Body& body() const { return body_of(roles, 2); }
};

TEST(AllowedMotion, AFollowerKeepsItsDistanceAndNoPlaceIsNearer)
{
    Draw draw(2);
    for (int round = 0; round < 20; ++round)
    {
        const Follower pair(FeatureLinkType::distance, draw);
        const Body& body = pair.body();
        const Vector3 own = cases::centre_of(pair.one, 2);
        const double distance = (own - pair.centre).norm();
        const BodyState leader = draw.near({Matrix3::Identity(), pair.centre});
        const BodyState wanted = draw.near(carried_along(body, leader));
        const BodyState found = nearest_following(pair.part(), body, leader, wanted);
        const Vector3 place = moved_point(body, found, own);
        EXPECT_NEAR((place - leader.centre).norm(), distance, 1e-10);
        EXPECT_LT((found.rotation - wanted.rotation).norm(), 1e-12);
        expect_same(nearest_following(pair.part(), body, leader, found), found);
        const Vector3 target = moved_point(body, wanted, own);
        for (int other = 0; other < 20; ++other)
        {
            const Vector3 allowed = leader.centre + distance * draw.vector().normalized();
            EXPECT_LE((place - target).norm(), (allowed - target).norm() + 1e-10);
        }
    }
}

TEST(AllowedMotion, AFollowerOnAnAxisTurnsAboutItAndSlidesAlongIt)
{
    Draw draw(3);
    for (int round = 0; round < 20; ++round)
    {
        const Follower pair(FeatureLinkType::coaxial, draw);
        const Body& body = pair.body();
        const BodyState leader = draw.near({Matrix3::Identity(), pair.centre});
        const Vector3 axis = leader.rotation * pair.direction;
        const auto found =
            nearest_following(pair.part(), body, leader, draw.near(carried_along(body, leader)));
        for (const double along : {-3.0, 0.0, 8.0})
        {
            const Vector3 moved =
                moved_point(body, found, pair.centre + along * pair.direction) - leader.centre;
            EXPECT_LT(moved.cross(axis).norm(), 1e-10);
        }
        EXPECT_LT((found.rotation * pair.direction - axis).norm(), 1e-12);
        // What is allowed already stays.
        const double slide = 5.0 * draw.number(), turn = draw.number();
        const BodyState carried = carried_along(body, leader);
        const Matrix3 spin = Eigen::AngleAxisd(turn, axis).matrix();
        const BodyState allowed{
            spin * carried.rotation,
            leader.centre + spin * (carried.centre - leader.centre) + slide * axis};
        expect_same(nearest_following(pair.part(), body, leader, allowed), allowed);
    }
}

}  // namespace
}  // namespace sheetmorph::surface
