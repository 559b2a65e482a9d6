// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/assembly_checks.h"

#include "sheetmorph/base/errors.h"
#include "assembly/all_frames.h"

#include <gmock/gmock.h>

namespace sheetmorph
{
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

}  // namespace
}  // namespace sheetmorph
