// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/wave_rates.h"

#include "sheetmorph/assembly/session/deformation_session.h"
#include "assembly/all_frames.h"

#include <gtest/gtest.h>

#include <optional>

namespace sheetmorph::assembly
{

namespace
{

using frames::Frame;

// The pose further along a direction of its handles.
Pose moved(Pose pose, const PoseRate& rate, double amount)
{
    for (const auto& [name, change] : rate.handles)
    {
        RigidMotion& motion = pose.handles[name];
        motion.translation += amount * change.shift;
        motion.rotation_log += amount * change.log;
        motion.pivot += amount * change.pivot;
    }
    return pose;
}

PoseRate some_direction(const Pose& pose)
{
    PoseRate rate;
    for (const auto& [name, motion] : pose.handles)
        rate.handles[name] = {{1.0, -2.0, 3.0}, {0.02, 0.01, -0.03}, {0.5, 0.0, 0.2}, {}};
    for (auto& [name, change] : rate.handles)
        change.spin.setZero();
    return rate;
}

// Central differences of second order, taken twice.
Points difference(const DeformationSession& session, const Pose& pose, const PoseRate& rate,
                  std::size_t part)
{
    const auto once = [&](double step) -> Points
    {
        const Deformed beyond = session.deform(moved(pose, rate, step));
        const Deformed before = session.deform(moved(pose, rate, -step));
        return (beyond.parts[part].positions - before.parts[part].positions) / (2.0 * step);
    };
    return (4.0 * once(5e-3) - once(1e-2)) / 3.0;
}

// Nothing where several contacts turn one vertex: their mean rotation is more than its log tells.
std::optional<std::vector<Points>> rates_of(const DeformationSession& session, const Pose& pose,
                                            const PoseRate& rate)
{
    try
    {
        return session.rates(pose, {rate}).front();
    }
    catch (const NoDerivative&)
    {
        return std::nullopt;
    }
}

TEST(WaveRates, AreThoseOfDifferencesWhateverPassesTheMotionOn)
{
    int differentiated = 0;
    for (const Frame& frame : frames::all_with_neumann())
    {
        if (frame.name.find("thin") != std::string::npos)
            continue;
        const DeformationSession session(frame.assembly);
        const PoseRate rate = some_direction(frame.pose);
        const auto found = rates_of(session, frame.pose, rate);
        if (!found)
            continue;
        ++differentiated;
        for (std::size_t part = 0; part < frame.assembly.parts.size(); ++part)
        {
            const Points wanted = difference(session, frame.pose, rate, part);
            const double scale = std::max(1.0, wanted.cwiseAbs().maxCoeff());
            EXPECT_LT(((*found)[part] - wanted).cwiseAbs().maxCoeff(), 1e-6 * scale)
                << frame.name << ", part " << part;
        }
    }
    EXPECT_GE(differentiated, 6);
}

TEST(WaveRates, OfAThinSolidThereAreNone)
{
    const Frame frame = frames::thin_solids(frames::open_chain(ContactType::control_mesh));
    const DeformationSession session(frame.assembly);
    EXPECT_THROW(session.rates(frame.pose, {some_direction(frame.pose)}), NoDerivative);
}

}  // namespace

}  // namespace sheetmorph::assembly
