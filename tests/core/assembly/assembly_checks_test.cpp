// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/assembly_checks.h"

#include "sheetmorph/base/errors.h"
#include "assembly/all_frames.h"

#include <functional>
#include <gmock/gmock.h>
#include <limits>

namespace sheetmorph::assembly
{

using namespace surface;
namespace
{

using frames::Frame;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

auto prepares(const Assembly& assembly)
{
    return [assembly] { DeformationSession session(assembly); };
}

TEST(AssemblyChecks, RefusesIdsOutOfRangeOfPartsThatNothingReaches)
{
    Frame frame = frames::ring(ContactType::tied);
    frame.assembly.contacts.clear();
    for (const int vertex : {-5, 1000000})
    {
        Frame wrong = frame;
        wrong.assembly.features.push_back(
            {"wild", 2, {0, vertex}, FeatureRotation::interpolated, {}, {}, false});
        EXPECT_THAT(prepares(wrong.assembly),
                    ThrowsMessage<InvalidInput>(AllOf(HasSubstr("'wild'"), HasSubstr("'third'"),
                                                      HasSubstr(std::to_string(vertex)))));
    }
}

TEST(AssemblyChecks, SaysWhyAModeIsNotPossible)
{
    Frame featured = frames::single(Mode::all);
    featured.assembly.features.push_back(
        {"hole", 1, {0, 1, 2}, FeatureRotation::interpolated, {}, {}, false});
    EXPECT_THAT(prepares(featured.assembly),
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("'second'"), HasSubstr("mode 1"))));
    Frame two_contacts = frames::with_modes(frames::ring(ContactType::tied), Mode::all);
    two_contacts.assembly.features.resize(3);
    EXPECT_THAT(prepares(two_contacts.assembly),
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("'third'"), HasSubstr("has 2"))));
    Frame closed = frames::single(Mode::boundaries);
    closed.assembly.parts[1].mesh = shapes::sphere(2, 20.0);
    closed.assembly.features.clear();
    closed.assembly.contacts.clear();
    EXPECT_THAT(prepares(closed.assembly),
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("'second'"), HasSubstr("mode 3"))));
    Frame unmarked = frames::single(Mode::regions);
    unmarked.assembly.followers.clear();
    EXPECT_THAT(prepares(unmarked.assembly),
                ThrowsMessage<InvalidInput>(HasSubstr("role follower")));
}

TEST(AssemblyChecks, RefusesContactsThatJoinNothingOrAPartWithItself)
{
    Frame empty = frames::ring(ContactType::tied);
    empty.assembly.contacts[2].b.vertices.clear();
    EXPECT_THAT(prepares(empty.assembly),
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("'first - fourth'"),
                                                  HasSubstr("'fourth'"), HasSubstr("pick"))));
    Frame self = frames::ring(ContactType::tied);
    self.assembly.contacts[2].b = self.assembly.contacts[2].a;
    EXPECT_THAT(prepares(self.assembly), ThrowsMessage<InvalidInput>(HasSubstr("with itself")));
    Frame levels = frames::ring(ContactType::tied);
    levels.assembly.propagation.levels = 9;
    EXPECT_THAT(prepares(levels.assembly), ThrowsMessage<InvalidInput>(HasSubstr("1 to 5")));
}

// An assembly with something of every kind, which is taken.
Assembly with_everything()
{
    Assembly assembly = frames::ring(ContactType::tied).assembly;
    assembly.points = {{"probe", 0, {"probe", 3, {0.2, 0.3, 0.5}, false, false}}};
    assembly.features[0].motion = {FeatureMotion::Type::plane, {0, 0, 0}, {0, 0, 1}};
    assembly.groups = {{"pair of holes", {1, 2}}};
    assembly.pairs = {{"pin", FeatureLinkType::distance, 0, 3}};
    assembly.symmetry = SymmetryPlane{{90.0, 30.0, 0.0}, {0.0, 1.0, 0.0}};
    assembly.followers = {{"along", 3, {0, 1, 2}}};
    return assembly;
}

using Spoil = std::function<void(Assembly&)>;

void expect_refused(const std::vector<std::pair<const char*, Spoil>>& cases)
{
    ASSERT_NO_THROW(check_assembly(with_everything()));
    for (const auto& [told, spoil] : cases)
    {
        Assembly wrong = with_everything();
        spoil(wrong);
        EXPECT_THAT([&] { check_assembly(wrong); }, ThrowsMessage<InvalidInput>(HasSubstr(told)))
            << told;
    }
}

TEST(AssemblyChecks, EveryWrongPlaceIsNamed)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_refused({
        {"no parts", [](Assembly& a) { a.parts.clear(); }},
        {"primary part 4", [](Assembly& a) { a.primary = 4; }},
        {"primary part -1", [](Assembly& a) { a.primary = -1; }},
        {"two parts are called 'first'", [](Assembly& a) { a.parts[1].name = "first"; }},
        {"a handle has no name", [](Assembly& a) { a.handles[0].name.clear(); }},
        {"fixed region 'root' is on part -1", [](Assembly& a) { a.fixed[0].part = -1; }},
        {"fixed region 'root' is on part 4", [](Assembly& a) { a.fixed[0].part = 4; }},
        {"handle 'tip' is on part 9", [](Assembly& a) { a.handles[0].part = 9; }},
        {"feature 'first hole1' is on part -3", [](Assembly& a) { a.features[1].part = -3; }},
        {"point 'probe' is on part 7", [](Assembly& a) { a.points[0].part = 7; }},
        {"part 'second' has no vertices",
         [](Assembly& a) { a.parts[1].mesh = mesh::TriangleMesh(); }},
        {"part 'second' has 2 vertex numbers",
         [](Assembly& a) {
             a.parts[1].ids = {1, 2};
         }},
        {"triangle -1", [](Assembly& a) { a.points[0].constraint.triangle = -1; }},
        {"triangle 99999", [](Assembly& a) { a.points[0].constraint.triangle = 99999; }},
        {"barycentric", [=](Assembly& a) { a.points[0].constraint.barycentric.y() = nan; }},
        {"fixed region 'root' has no vertices", [](Assembly& a) { a.fixed[0].vertices.clear(); }},
        {"handle 'tip' names vertex -7", [](Assembly& a) { a.handles[0].vertices[2] = -7; }},
        {"contact 'first - second' is on part -2", [](Assembly& a) { a.contacts[0].a.part = -2; }},
        {"contact 'first - second' is on part 4", [](Assembly& a) { a.contacts[0].b.part = 4; }},
        {"names vertex 88888", [](Assembly& a) { a.contacts[0].b.vertices[0] = 88888; }},
        {"names vertex -1", [](Assembly& a) { a.contacts[0].a.vertices[0] = -1; }},
        {"follower along", [](Assembly& a) { a.followers[0].vertices.clear(); }},
    });
}

TEST(AssemblyChecks, EveryWrongRelationIsNamed)
{
    const double infinite = std::numeric_limits<double>::infinity();
    expect_refused({
        {"feature 'first hole0'", [](Assembly& a) { a.features[0].motion.direction *= 2.0; }},
        {"feature 'first hole0'", [](Assembly& a) { a.features[0].motion.direction *= 0.5; }},
        {"feature 'first hole0'", [=](Assembly& a) { a.features[0].motion.point.x() = infinite; }},
        {"group 'pair of holes' has fewer", [](Assembly& a) { a.groups[0].features = {1}; }},
        {"group 'pair of holes' names feature -1",
         [](Assembly& a) {
             a.groups[0].features = {1, -1};
         }},
        {"group 'pair of holes' names feature 50",
         [](Assembly& a) {
             a.groups[0].features = {1, 50};
         }},
        {"a group is on one part",
         [](Assembly& a) {
             a.groups[0].features = {1, 3};
         }},
        {"pair 'pin' names feature -4", [](Assembly& a) { a.pairs[0].a = -4; }},
        {"pair 'pin' names feature 50", [](Assembly& a) { a.pairs[0].b = 50; }},
        {"twice; choose two", [](Assembly& a) { a.pairs[0].b = a.pairs[0].a; }},
        {"plane of symmetry", [](Assembly& a) { a.symmetry->normal *= 1.1; }},
        {"plane of symmetry", [](Assembly& a) { a.symmetry->normal *= 0.9; }},
        {"plane of symmetry", [=](Assembly& a) { a.symmetry->point.z() = infinite; }},
    });
}

TEST(AssemblyChecks, EveryWrongPropagationIsNamed)
{
    expect_refused({
        {"1 to 5 levels", [](Assembly& a) { a.propagation.levels = 0; }},
        {"smoothness", [](Assembly& a) { a.propagation.smoothness = 0.0; }},
        {"smoothness", [](Assembly& a) { a.propagation.smoothness = 1e7; }},
        {"the propagation 'whole'",
         [](Assembly& a)
         {
             a.propagation.type = PropagationType::whole;
             a.energy = Energy::steel;
         }},
        {"the propagation 'whole'",
         [](Assembly& a)
         {
             a.propagation.type = PropagationType::whole;
             a.is_refined = true;
         }},
    });
}

// A motion that needs no direction may have any.
TEST(AssemblyChecks, DirectionsThatAreNotReadMayBeAnything)
{
    Assembly assembly = with_everything();
    assembly.features[0].motion = {FeatureMotion::Type::translation, {0, 0, 0}, {0, 0, 0}};
    EXPECT_NO_THROW(check_assembly(assembly));
}

}  // namespace
}  // namespace sheetmorph::assembly
