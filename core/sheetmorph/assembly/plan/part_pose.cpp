// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/part_pose.h"

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

template <typename Value>
Value value_or(const std::map<std::string, Value>& values, const std::string& name,
               const Value& otherwise)
{
    const auto found = values.find(name);
    return found == values.end() ? otherwise : found->second;
}

// Whether a pose can move the part by this feature.
bool moves(const surface::FormFeature& feature)
{
    return feature.rotation == surface::FeatureRotation::prescribed || feature.is_resizable;
}

surface::FormFeature form_feature(const PartFeature& feature)
{
    return {feature.name,
            feature.vertices,
            feature.rotation,
            "feature",
            feature.motion,
            is_sized(feature),
            subjects_of("feature", feature)};
}

void add_groups(const Assembly& assembly, int part, PartConstraints& found)
{
    for (const FeatureGroup& group : assembly.groups)
    {
        if (assembly.features[at(group.features.front())].part != part)
            continue;
        found.surface.groups.emplace_back();
        for (const int feature : group.features)
            found.surface.groups.back().push_back(local_feature(found, feature));
    }
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
        if (handle.is_rotation_free
            && !value_or(pose.handles, handle.name, RigidMotion{}).rotation_log.isZero(0.0))
            throw InvalidInput(
                "the pose turns the " + label_of("handle", handle) + ", whose rotation is free",
                "leave its rotation out, or make it "
                "one that the pose gives");
}

void add_fixed(const Assembly& assembly, int part, surface::SurfaceConstraints& surface)
{
    for (const PartRegion& region : assembly.fixed)
        if (region.part == part)
            surface.fixed.push_back({region.name, region.vertices, "fixed region", false,
                                     subjects_of("fixed region", region)});
}

}  // namespace

int local_feature(const PartConstraints& constraints, int feature)
{
    const std::vector<int>& features = constraints.features;
    return static_cast<int>(std::find(features.begin(), features.end(), feature)
                            - features.begin());
}

bool PartConstraints::is_driven() const
{
    const auto is_led = [](const surface::FeatureLink& link) { return link.leader < 0; };
    return !surface.handles.empty() || !surface.points.empty() || !surface.propagated.empty()
           || std::any_of(surface.features.begin(), surface.features.end(), moves)
           || std::any_of(surface.links.begin(), surface.links.end(), is_led);
}

PartConstraints constraints_of_part(const Assembly& assembly, int part)
{
    PartConstraints found;
    found.surface.energy = assembly.energy;
    found.surface.is_refined = assembly.is_refined;
    found.surface.laplacian = assembly.laplacian;
    found.surface.thickness = assembly.parts[at(part)].sheet_thickness;
    found.surface.poisson = assembly.parts[at(part)].poisson;
    add_fixed(assembly, part, found.surface);
    for (std::size_t k = 0; k < assembly.handles.size(); ++k)
        if (assembly.handles[k].part == part)
        {
            const PartHandle& handle = assembly.handles[k];
            found.surface.handles.push_back({handle.name, handle.vertices, "handle",
                                             handle.is_rotation_free,
                                             subjects_of("handle", handle)});
            found.handles.push_back(static_cast<int>(k));
        }
    for (std::size_t k = 0; k < assembly.features.size(); ++k)
        if (assembly.features[k].part == part)
        {
            found.surface.features.push_back(form_feature(assembly.features[k]));
            found.features.push_back(static_cast<int>(k));
        }
    for (std::size_t k = 0; k < assembly.points.size(); ++k)
        if (assembly.points[k].part == part)
        {
            found.surface.points.push_back(assembly.points[k].constraint);
            found.surface.points.back().name = assembly.points[k].name;
            found.surface.points.back().of = subjects_of("point", assembly.points[k]);
            found.points.push_back(static_cast<int>(k));
        }
    for (const PartRegion& stitch : assembly.parts[at(part)].stitches)
        found.surface.stitches.push_back(
            {stitch.name, stitch.vertices, "contact", false, subjects_of("contact", stitch)});
    found.surface.ties = assembly.parts[at(part)].ties;
    add_groups(assembly, part, found);
    return found;
}

surface::SurfaceTargets targets_of_part(const Assembly& assembly,
                                        const PartConstraints& constraints, const Pose& pose)
{
    surface::SurfaceTargets targets;
    for (const int handle : constraints.handles)
        targets.handles.push_back(
            value_or(pose.handles, assembly.handles[at(handle)].name, RigidMotion{}));
    for (const int feature : constraints.features)
        targets.feature_logs.push_back(value_or(
            pose.feature_logs, assembly.features[at(feature)].name, Vector3(Vector3::Zero())));
    for (const int feature : constraints.features)
        targets.sizes.push_back(size_in_pose(assembly.features[at(feature)], pose));
    for (const int point : constraints.points)
    {
        const std::string& name = assembly.points[at(point)].name;
        const auto target = pose.points.find(name);
        if (target == pose.points.end())
            throw InvalidInput(label_of("point", assembly.points[at(point)]) + " has no target",
                               "give it one in the pose");
        targets.points.push_back(target->second);
    }
    return targets;
}

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
