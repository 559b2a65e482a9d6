// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/drag_samples.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/surface/live/drawn_motions.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::assembly
{

namespace
{

// Poses that pass through the parts. Chosen as in drawn_motions.cpp: as many as for one handle, and
// the rotation that more than two handles may have.
constexpr int passed_poses = 128;
constexpr double farthest_passed = 75.0 * degree;  // from there

// With a plane of symmetry the pose of one of two mirrored handles tells that of the other.
std::set<std::string> mirrored(const PreparedAssembly& prepared)
{
    std::set<std::string> names;
    if (prepared.symmetry)
        for (const auto& [a, b] : prepared.symmetry->handles)
            if (a != b)
                names.insert(prepared.assembly.handles[at(std::max(a, b))].name);
    return names;
}

std::vector<Pose> sampled_poses(const PreparedAssembly& prepared,
                                const std::set<std::string>& dragged, const Pose& start)
{
    const std::set<std::string> others = mirrored(prepared);
    std::vector<Pose> poses;
    surface::DrawnMotions drawn;
    for (int k = 0; k < passed_poses; ++k)
    {
        Pose pose = start;
        for (const std::string& name : others)
            pose.handles.erase(name);
        for (const PartHandle& handle : prepared.assembly.handles)
            if (dragged.count(handle.name) > 0 && others.count(handle.name) == 0)
            {
                RigidMotion& motion = pose.handles[handle.name];
                motion = drawn.next(prepared.assembly.parts[at(handle.part)].mesh, handle.vertices,
                                    motion, handle.is_rotation_free ? 0.0 : farthest_passed);
            }
        poses.push_back(told_pose(prepared, pose));
    }
    return poses;
}

// Whether links drive a sheet: then it learns from what earlier sheets pass on.
bool needs_waves(const Sheet& sheet)
{
    return !sheet.propagated.empty();
}

// Whether the motion of an earlier sheet, as it is, drives one.
bool is_led(const Sheet& sheet)
{
    return !sheet.carried.empty()
           || std::any_of(sheet.leaders.begin(), sheet.leaders.end(),
                          [](int leader) { return leader >= 0; });
}

}  // namespace

DragSamples::DragSamples(const PreparedAssembly& prepared, const std::set<std::string>& dragged,
                         const Pose& start, bool passes)
    : prepared_(prepared),
      dragged_(dragged),
      start_(start),
      at_start_(prepared, start_, Exactness::live),
      is_learnt_(prepared.deformers.size(), 0)
{
    const std::vector<Sheet>& sheets = prepared.system.sheets;
    // Where nothing rigid joins sheets, no sheet asks what another is at the start.
    if (std::any_of(sheets.begin(), sheets.end(), is_led))
        at_start_.run();
    if (!passes || std::none_of(sheets.begin(), sheets.end(), needs_waves))
        return;
    poses_ = sampled_poses(prepared, dragged, start);
    for (const Pose& pose : poses_)
    {
        waves_.emplace_back(prepared, pose, Exactness::live);
        waves_.back().begin_reading(read_);
    }
}

// Whether every sheet that drives this one is learnt, so that the waves have reached it.
bool DragSamples::is_passed_on(int sheet) const
{
    if (waves_.empty())
        return false;
    const System& system = prepared_.system;
    for (const PlannedLink& link : system.links)
        for (const LinkTarget& target : link.targets)
            if (system.sheet_of(target.part) == sheet
                && !is_learnt_[at(system.sheet_of(link.source_part))])
                return false;
    const std::vector<int>& carried = system.sheets[at(sheet)].carried;
    return std::all_of(
        carried.begin(), carried.end(),
        [&](int weld)
        { return is_learnt_[at(system.sheet_of(system.welds[at(weld)].source_part))] != 0; });
}

// The sheet's own dragged handles and the welds that carry it, on their own.
void DragSamples::add_own(int sheet, std::vector<surface::SurfaceTargets>& samples) const
{
    const std::vector<int>& handles = prepared_.system.sheets[at(sheet)].handles;
    const surface::SurfaceTargets start = at_start_.targets_of(sheet);
    std::vector<int> turning;
    for (std::size_t k = 0; k < start.handles.size(); ++k)
        if (k >= handles.size()
            || dragged_.count(prepared_.assembly.handles[at(handles[k])].name) != 0)
            turning.push_back(static_cast<int>(k));
    const surface::SurfaceDeformer& deformer = *prepared_.deformers[at(sheet)];
    for (surface::SurfaceTargets& pose :
         surface::own_poses(deformer.rest(), deformer.constraints(), start, turning))
        samples.push_back(std::move(pose));
}

// Thin solids among parts that share a sheet read all its rotations.
surface::ResponseReaders DragSamples::readers_of(int sheet) const
{
    surface::ResponseReaders readers;
    const System& system = prepared_.system;
    for (std::size_t k = 0; k < system.links.size(); ++k)
        if (system.sheet_of(system.links[k].source_part) == sheet)
            merge_into(readers.vertices, prepared_.links[k].link->reads());
    const std::vector<int>& parts = system.sheets[at(sheet)].parts;
    for (const int part : parts)
        if (const auto& thin = prepared_.parts[at(part)].thin; thin && parts.size() > 1)
            readers.all_logs = true;
        else if (thin)
            merge_into(readers.vertices, thin->read_logs());
    return readers;
}

std::shared_ptr<const surface::Response> DragSamples::learn(int sheet, const Progress& progress)
{
    const auto& deformer = prepared_.deformers[at(sheet)];
    if (!deformer || !deformer->can_respond())
        return nullptr;
    const bool passes = is_passed_on(sheet);
    std::vector<surface::SurfaceTargets> samples;
    if (passes)
        for (const Wave& wave : waves_)
            samples.push_back(wave.targets_of(sheet));
    if (!needs_waves(prepared_.system.sheets[at(sheet)]))
        add_own(sheet, samples);
    if (samples.empty())
        return nullptr;
    std::shared_ptr<const surface::Response> response =
        deformer->response(samples, readers_of(sheet), progress);
    if (!response->is_learnt())
        return nullptr;
    if (passes)
        waves_.remove_if([&](Wave& wave) { return !wave.read(sheet, *response); });
    is_learnt_[at(sheet)] = passes;
    return response;
}

}  // namespace sheetmorph::assembly
