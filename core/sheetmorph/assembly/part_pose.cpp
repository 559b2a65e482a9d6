// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/part_pose.h"

#include "sheetmorph/base/errors.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

template <typename Named>
bool has_name(const std::vector<Named>& list, const std::string& name)
{
    return std::any_of(list.begin(), list.end(),
                       [&](const Named& item) { return item.name == name; });
}

template <typename Value>
Value value_or(const std::map<std::string, Value>& values, const std::string& name,
               const Value& otherwise)
{
    const auto found = values.find(name);
    return found == values.end() ? otherwise : found->second;
}

}  // namespace

bool PartConstraints::is_driven() const
{
    return !surface.handles.empty() || !surface.points.empty() || !surface.propagated.empty()
           || std::any_of(surface.features.begin(), surface.features.end(),
                          [](const FormFeature& feature) { return feature.is_prescribed; });
}

PartConstraints constraints_of_part(const Assembly& assembly, int part)
{
    PartConstraints found;
    found.surface.energy = assembly.energy;
    for (const PartRegion& region : assembly.fixed)
        if (region.part == part)
            found.surface.fixed.push_back({region.name, region.vertices, "fixed region"});
    for (std::size_t k = 0; k < assembly.handles.size(); ++k)
        if (assembly.handles[k].part == part)
        {
            found.surface.handles.push_back(
                {assembly.handles[k].name, assembly.handles[k].vertices, "handle"});
            found.handles.push_back(static_cast<int>(k));
        }
    for (std::size_t k = 0; k < assembly.features.size(); ++k)
        if (assembly.features[k].part == part)
        {
            const PartFeature& feature = assembly.features[k];
            found.surface.features.push_back(
                {feature.name, feature.vertices, feature.is_prescribed, "feature"});
            found.features.push_back(static_cast<int>(k));
        }
    for (std::size_t k = 0; k < assembly.points.size(); ++k)
        if (assembly.points[k].part == part)
        {
            found.surface.points.push_back(assembly.points[k].constraint);
            found.surface.points.back().name = assembly.points[k].name;
            found.points.push_back(static_cast<int>(k));
        }
    return found;
}

SurfaceTargets targets_of_part(const Assembly& assembly, const PartConstraints& constraints,
                               const Pose& pose)
{
    SurfaceTargets targets;
    for (const int handle : constraints.handles)
        targets.handles.push_back(
            value_or(pose.handles, assembly.handles[at(handle)].name, RigidMotion{}));
    for (const int feature : constraints.features)
        targets.feature_logs.push_back(value_or(
            pose.feature_logs, assembly.features[at(feature)].name, Vector3(Vector3::Zero())));
    for (const int point : constraints.points)
    {
        const std::string& name = assembly.points[at(point)].name;
        const auto target = pose.points.find(name);
        if (target == pose.points.end())
            throw InvalidInput("point '" + name + "' has no target; give it one in the pose");
        targets.points.push_back(target->second);
    }
    return targets;
}

void check_pose_names(const Assembly& assembly, const Pose& pose)
{
    for (const auto& [name, motion] : pose.handles)
        if (!has_name(assembly.handles, name))
            throw InvalidInput("the pose moves a handle '" + name
                               + "' that the assembly does not have");
    for (const auto& [name, log] : pose.feature_logs)
    {
        const auto prescribed = [&n = name](const PartFeature& feature)
        { return feature.name == n && feature.is_prescribed; };
        if (!std::any_of(assembly.features.begin(), assembly.features.end(), prescribed))
            throw InvalidInput("the pose turns '" + name
                               + "', which is not a feature with a prescribed rotation");
    }
    for (const auto& [name, target] : pose.points)
        if (!has_name(assembly.points, name))
            throw InvalidInput("the pose places a point '" + name
                               + "' that the assembly does not have");
}

}  // namespace sheetmorph
