// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/pose_checks.h"

#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/assembly/plan/feature_sizes.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"

#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

template <typename Named>
bool has_name(const std::vector<Named>& list, const std::string& name)
{
    return std::any_of(list.begin(), list.end(),
                       [&](const Named& item) { return item.name == name; });
}

bool is_prescribed(const PartFeature& feature)
{
    return feature.rotation == surface::FeatureRotation::prescribed;
}

template <typename Condition>
bool has_feature(const Assembly& assembly, const std::string& name, Condition condition)
{
    return std::any_of(assembly.features.begin(), assembly.features.end(),
                       [&](const PartFeature& feature)
                       { return feature.name == name && condition(feature); });
}

void check_handles(const Assembly& assembly, const Pose& pose)
{
    for (const auto& [name, motion] : pose.handles)
        if (!has_name(assembly.handles, name))
            throw InvalidInput(
                Text::about("the pose moves a handle '" + name + "'", {{"handle", name}})
                + " that the assembly does not have");
    for (const PartHandle& handle : assembly.handles)
        if (const auto motion = pose.handles.find(handle.name);
            handle.is_rotation_free && motion != pose.handles.end()
            && !motion->second.rotation_log.isZero(0.0))
            throw InvalidInput(
                "the pose turns the " + label_of("handle", handle) + ", whose rotation is free",
                "leave its rotation out, or make it "
                "one that the pose gives");
}

}  // namespace

void check_pose_names(const Assembly& assembly, const Pose& pose)
{
    check_handles(assembly, pose);
    for (const auto& [name, log] : pose.feature_logs)
        if (!has_feature(assembly, name, is_prescribed))
            throw InvalidInput(Text::about("the pose turns '" + name + "'", {{"feature", name}})
                               + ", which is not a feature with a prescribed rotation");
    for (const auto& [name, size] : pose.sizes)
        if (!has_feature(assembly, name, is_sized))
            throw InvalidInput(Text::about("the pose gives '" + name + "'", {{"feature", name}})
                               + " a size, which is not a feature whose size can be set");
    for (const auto& [name, target] : pose.points)
        if (!has_name(assembly.points, name))
            throw InvalidInput(
                Text::about("the pose places a point '" + name + "'", {{"point", name}})
                + " that the assembly does not have");
}

}  // namespace sheetmorph::assembly
