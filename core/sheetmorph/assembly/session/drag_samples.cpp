// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/drag_samples.h"

#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/vertex_sets.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace sheetmorph
{

namespace
{

constexpr int pose_count = 128;
constexpr double farthest_turn = 75.0 / 360.0 * M_PI;  // as a logarithm (2.6)
constexpr double farthest_shift = 0.35;                // of the part's size

//! Points in a ball, the same ones every time.
class Ball
{
public:
    Vector3 operator()(double radius)
    {
        Vector3 point;
        do
            point = Vector3(share(), share(), share());
        while (point.squaredNorm() > 1.0);
        return radius * point;
    }

private:
    double share()
    {
        return 2.0 * static_cast<double>(bits_()) / static_cast<double>(std::mt19937::max()) - 1.0;
    }
    std::mt19937 bits_{1};
};

// About the middle of the handle.
RigidMotion sampled(const TriangleMesh& mesh, const PartHandle& handle, const RigidMotion& start,
                    Ball& ball)
{
    RigidMotion motion;
    motion.pivot = rows_of(mesh.points(), handle.vertices).colwise().mean().transpose();
    motion.rotation_log = start.rotation_log + ball(farthest_turn);
    motion.translation =
        start.apply(motion.pivot) - motion.pivot + ball(farthest_shift * mesh.size());
    return motion;
}

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
    Ball ball;
    for (int k = 0; k < pose_count; ++k)
    {
        Pose pose = start;
        for (const std::string& name : others)
            pose.handles.erase(name);
        for (const PartHandle& handle : prepared.assembly.handles)
            if (dragged.count(handle.name) > 0 && others.count(handle.name) == 0)
            {
                RigidMotion& motion = pose.handles[handle.name];
                motion =
                    sampled(prepared.assembly.parts[at(handle.part)].mesh, handle, motion, ball);
            }
        poses.push_back(told_pose(prepared, pose));
    }
    return poses;
}

}  // namespace

DragSamples::DragSamples(const PreparedAssembly& prepared, const std::set<std::string>& dragged,
                         const Pose& start)
    : prepared_(prepared),
      is_needed_(prepared.parts.size(), 0),
      is_learnt_(prepared.parts.size(), 0)
{
    find_needed();
    if (std::none_of(is_needed_.begin(), is_needed_.end(), [](char needed) { return needed != 0; }))
        return;
    poses_ = sampled_poses(prepared, dragged, start);
    for (const Pose& pose : poses_)
    {
        waves_.emplace_back(prepared, pose, Exactness::live);
        waves_.back().begin_reading(read_);
    }
}

// Parts that links or several welds drive - one weld alone takes fewer fields (surface_response.h)
// -, and all parts before them.
void DragSamples::find_needed()
{
    for (auto part = prepared_.plan.order.rbegin(); part != prepared_.plan.order.rend(); ++part)
    {
        const PartProblem& problem = prepared_.parts[at(*part)].problem;
        if (problem.propagated.empty() && problem.carried.size() < 2 && !is_needed_[at(*part)])
            continue;
        is_needed_[at(*part)] = 1;
        for (const PlannedLink& link : prepared_.planned)
            for (const LinkTarget& target : link.targets)
                if (target.part == *part)
                    is_needed_[at(link.source_part)] = 1;
        for (const RigidWeld& weld : prepared_.welds)
            if (weld.target_part == *part)
                is_needed_[at(weld.source_part)] = 1;
    }
}

bool DragSamples::can_learn(int part) const
{
    const PreparedPart& ready = prepared_.parts[at(part)];
    if (!is_needed_[at(part)] || ready.thin || !ready.deformer || !ready.deformer->can_be_sampled())
        return false;
    for (const PlannedLink& link : prepared_.planned)
        for (const LinkTarget& target : link.targets)
            if (target.part == part && !is_learnt_[at(link.source_part)])
                return false;
    return std::all_of(ready.problem.carried.begin(), ready.problem.carried.end(),
                       [&](int weld)
                       { return is_learnt_[at(prepared_.welds[at(weld)].source_part)] != 0; });
}

VertexIds DragSamples::reads_of(int part) const
{
    VertexIds reads;
    for (std::size_t k = 0; k < prepared_.planned.size(); ++k)
        if (prepared_.planned[k].source_part == part)
            merge_into(reads, prepared_.links[k].link->reads());
    return reads;
}

std::shared_ptr<const SampledResponse> DragSamples::learn(int part, const Progress& progress)
{
    if (!can_learn(part))
        return nullptr;
    std::vector<SurfaceTargets> samples;
    for (const Wave& wave : waves_)
        samples.push_back(wave.targets_of(part));
    std::shared_ptr<const SampledResponse> response =
        prepared_.parts[at(part)].deformer->sampled_response(samples, reads_of(part), progress);
    waves_.remove_if([&](Wave& wave) { return !wave.read(part, *response); });
    if (waves_.empty())
        return nullptr;
    is_learnt_[at(part)] = 1;
    return response;
}

}  // namespace sheetmorph
