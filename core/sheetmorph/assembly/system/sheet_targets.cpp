// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/system/sheet_targets.h"

#include "sheetmorph/assembly/plan/feature_sizes.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/rotation.h"

#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

template <typename Value>
Value value_or(const std::map<std::string, Value>& values, const std::string& name,
               const Value& otherwise)
{
    const auto found = values.find(name);
    return found == values.end() ? otherwise : found->second;
}

// Handles that the pose leaves out do not move, prescribed rotations are none, sizes those of the
// description.
surface::SurfaceTargets own_targets(const Assembly& assembly, const Sheet& sheet, const Pose& pose)
{
    surface::SurfaceTargets targets;
    for (const int handle : sheet.handles)
        targets.handles.push_back(
            value_or(pose.handles, assembly.handles[at(handle)].name, RigidMotion{}));
    for (const int feature : sheet.features)
        targets.feature_logs.push_back(value_or(
            pose.feature_logs, assembly.features[at(feature)].name, Vector3(Vector3::Zero())));
    for (const int feature : sheet.features)
        targets.sizes.push_back(size_in_pose(assembly.features[at(feature)], pose));
    for (const int point : sheet.points)
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

Eigen::RowVector3d mean_row(const std::vector<LinkRow>& rows, const EarlierSheets& earlier,
                            Points volume::LinkedTargets::*values)
{
    const auto value = [&](const LinkRow& row)
    { return (earlier.links[at(row.link)].*values).row(row.row); };
    if (rows.size() == 1)
        return value(rows.front());
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double weights = 0.0;
    for (const LinkRow& row : rows)
    {
        sum += row.weight * value(row);
        weights += row.weight;
    }
    return sum / weights;
}

Matrix3 mean_rotation(const std::vector<LinkRow>& rows, const EarlierSheets& earlier)
{
    Matrix3 sum = Matrix3::Zero();
    for (const LinkRow& row : rows)
        sum += row.weight * earlier.links[at(row.link)].rotation(row.row);
    return rows.size() == 1 ? sum : nearest_rotation(sum);
}

// Of one row alone, whose rotation is its log's.
bool is_told_by_log(const std::vector<LinkRow>& rows, const EarlierSheets& earlier)
{
    return rows.size() == 1 && earlier.links[at(rows.front().link)].rotations.empty();
}

}  // namespace

surface::SurfaceTargets targets_of_sheet(const Assembly& assembly, const Sheet& sheet,
                                         const Pose& pose, const EarlierSheets& earlier)
{
    surface::SurfaceTargets targets = own_targets(assembly, sheet, pose);
    for (const int weld : sheet.carried)
        targets.handles.push_back(earlier.welds[at(weld)]);
    targets.feature_logs.resize(sheet.surface.features.size(), Vector3::Zero());
    targets.sizes.resize(sheet.surface.features.size());
    for (const int leader : sheet.leaders)
        targets.leaders.push_back(leader < 0 ? RigidMotion{} : earlier.features[at(leader)]);
    for (const auto& region : sheet.propagated)
    {
        const auto count = static_cast<Eigen::Index>(region.size());
        surface::PropagatedTarget target{Points(count, 3), Points(count, 3), {}};
        for (Eigen::Index k = 0; k < count; ++k)
        {
            const std::vector<LinkRow>& rows = region[static_cast<std::size_t>(k)];
            target.positions.row(k) = mean_row(rows, earlier, &volume::LinkedTargets::positions);
            target.rotation_logs.row(k) = mean_row(rows, earlier, &volume::LinkedTargets::logs);
        }
        if (!std::all_of(region.begin(), region.end(),
                         [&](const auto& rows) { return is_told_by_log(rows, earlier); }))
            for (const std::vector<LinkRow>& rows : region)
                target.rotations.push_back(mean_rotation(rows, earlier));
        targets.propagated.push_back(std::move(target));
    }
    return targets;
}

double spread_of_targets(const Sheet& sheet, const EarlierSheets& earlier)
{
    const auto target = [&](const LinkRow& row)
    { return earlier.links[at(row.link)].positions.row(row.row); };
    double worst = 0.0;
    for (const auto& region : sheet.propagated)
        for (const std::vector<LinkRow>& rows : region)
            for (const LinkRow& a : rows)
                for (const LinkRow& b : rows)
                    worst = std::max(worst, (target(a) - target(b)).norm());
    return worst;
}

}  // namespace sheetmorph::assembly
