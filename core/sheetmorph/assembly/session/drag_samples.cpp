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

// Whether links drive a part: then it learns from what earlier parts pass on.
bool needs_waves(const PartProblem& problem)
{
    return !problem.propagated.empty();
}

}  // namespace

DragSamples::DragSamples(const PreparedAssembly& prepared, const std::set<std::string>& dragged,
                         const Pose& start, bool passes)
    : prepared_(prepared),
      dragged_(dragged),
      start_(start),
      at_start_(prepared, start_, Exactness::live),
      is_learnt_(prepared.parts.size(), 0)
{
    // Where nothing rigid joins parts, no part asks what another is at the start.
    if (!prepared.welds.empty() || !prepared.pairs.empty())
        at_start_.run();
    const bool any =
        std::any_of(prepared.parts.begin(), prepared.parts.end(),
                    [](const PreparedPart& part) { return needs_waves(part.problem); });
    if (!passes || !any)
        return;
    poses_ = sampled_poses(prepared, dragged, start);
    for (const Pose& pose : poses_)
    {
        waves_.emplace_back(prepared, pose, Exactness::live);
        waves_.back().begin_reading(read_);
    }
}

// Whether every part that drives this one is learnt, so that the waves have reached it.
bool DragSamples::is_passed_on(int part) const
{
    if (waves_.empty())
        return false;
    for (const PlannedLink& link : prepared_.planned)
        for (const LinkTarget& target : link.targets)
            if (target.part == part && !is_learnt_[at(link.source_part)])
                return false;
    const std::vector<int>& carried = prepared_.parts[at(part)].problem.carried;
    return std::all_of(carried.begin(), carried.end(),
                       [&](int weld)
                       { return is_learnt_[at(prepared_.welds[at(weld)].source_part)] != 0; });
}

// The part's own dragged handles and the welds that carry it, on their own.
void DragSamples::add_own(int part, std::vector<surface::SurfaceTargets>& samples) const
{
    const PartProblem& problem = prepared_.parts[at(part)].problem;
    const surface::SurfaceTargets start = at_start_.targets_of(part);
    std::vector<int> turning;
    for (std::size_t k = 0; k < start.handles.size(); ++k)
        if (k >= problem.own.handles.size()
            || dragged_.count(prepared_.assembly.handles[at(problem.own.handles[k])].name) != 0)
            turning.push_back(static_cast<int>(k));
    const surface::SurfaceDeformer& deformer = *prepared_.parts[at(part)].deformer;
    for (surface::SurfaceTargets& pose :
         surface::own_poses(deformer.rest(), deformer.constraints(), start, turning))
        samples.push_back(std::move(pose));
}

VertexIds DragSamples::reads_of(int part) const
{
    VertexIds reads;
    for (std::size_t k = 0; k < prepared_.planned.size(); ++k)
        if (prepared_.planned[k].source_part == part)
            merge_into(reads, prepared_.links[k].link->reads());
    if (const auto& thin = prepared_.parts[at(part)].thin)
        merge_into(reads, thin->read_logs());
    return reads;
}

std::shared_ptr<const surface::Response> DragSamples::learn(int part, const Progress& progress)
{
    const PreparedPart& ready = prepared_.parts[at(part)];
    if (!ready.deformer || !ready.deformer->can_respond())
        return nullptr;
    const bool passes = is_passed_on(part);
    std::vector<surface::SurfaceTargets> samples;
    if (passes)
        for (const Wave& wave : waves_)
            samples.push_back(wave.targets_of(part));
    if (ready.problem.propagated.empty())
        add_own(part, samples);
    if (samples.empty())
        return nullptr;
    std::shared_ptr<const surface::Response> response =
        ready.deformer->response(samples, {reads_of(part), prepared_.carries_thin}, progress);
    if (!response->is_learnt())
        return nullptr;
    if (passes)
        waves_.remove_if([&](Wave& wave) { return !wave.read(part, *response); });
    is_learnt_[at(part)] = passes;
    return response;
}

}  // namespace sheetmorph::assembly
