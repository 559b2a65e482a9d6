// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/deformation_session.h"

#include "sheetmorph/assembly/plan/pose_checks.h"
#include "sheetmorph/assembly/session/live_drag.h"
#include "sheetmorph/assembly/session/wave.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/freed_memory.h"
#include "sheetmorph/surface/bodies/bodies.h"
#include "sheetmorph/surface/steel/steel_answer.h"

#include <algorithm>
#include <map>

namespace sheetmorph::assembly
{

namespace
{

// A pose of another session may have other meshes.
void require_shapes_of(const PreparedAssembly& prepared, const Deformed& pose)
{
    const auto is_of =
        [](const std::vector<surface::Deformation>& shapes, std::size_t k, const Part& part)
    { return k < shapes.size() && shapes[k].positions.rows() == part.mesh.vertex_count(); };
    for (std::size_t k = 0; k < prepared.parts.size(); ++k)
    {
        const bool is_thin = prepared.parts[k].thin != nullptr;
        if (!is_of(pose.parts, k, prepared.whole().parts[k])
            || (is_thin && !is_of(pose.middles, k, prepared.assembly.parts[k])))
            throw InvalidInput("these shapes are not of this session: part '"
                                   + prepared.assembly.parts[k].name
                                   + "' has another number of vertices",
                               "deform it with this session");
    }
}

}  // namespace

DeformationSession::DeformationSession(Assembly assembly, const Progress& progress,
                                       const DeformationSession* previous)
    : data_(std::make_shared<const PreparedAssembly>(prepare_assembly(
        std::move(assembly), progress, previous != nullptr ? previous->data_.get() : nullptr)))
{
    return_freed_memory();
}

DeformationSession::~DeformationSession() = default;
DeformationSession::DeformationSession(DeformationSession&&) noexcept = default;
DeformationSession& DeformationSession::operator=(DeformationSession&&) noexcept = default;

Deformed DeformationSession::deform(const Pose& pose, Exactness exactness,
                                    const Progress& progress) const
{
    const Pose told = told_pose(*data_, pose);
    return Wave(*data_, told, exactness, progress).run();
}

std::unique_ptr<LiveDrag> DeformationSession::begin_drag(const std::vector<std::string>& handles,
                                                         const Pose& start,
                                                         const DragOptions& options) const
{
    for (const std::string& name : handles)
        check_pose_names(data_->assembly, Pose{{{name, RigidMotion{}}}, {}, {}, {}});
    return std::make_unique<LiveDrag>(data_, with_mirrors(*data_, handles),
                                      told_pose(*data_, start), options);
}

std::optional<ShownControlMesh> DeformationSession::control_mesh(int contact,
                                                                 const Deformed& pose) const
{
    require_shapes_of(*data_, pose);
    const std::vector<PlannedLink>& links = data_->system.links;
    for (std::size_t k = 0; k < links.size(); ++k)
        if (links[k].contact == contact)
        {
            const std::size_t source = at(links[k].source_part);
            const bool is_thin = data_->parts[source].thin != nullptr;
            return data_->links[k].link->control_mesh(is_thin ? pose.middles[source]
                                                              : pose.parts[source]);
        }
    return std::nullopt;
}

const Assembly& DeformationSession::assembly() const
{
    return data_->whole();
}

const recognise::ThinSolid* DeformationSession::thin_solid(int part) const
{
    if (part < 0 || at(part) >= data_->thin.size())
        throw InvalidInput("part " + std::to_string(part) + " does not exist");
    const auto& thin = data_->thin[at(part)];
    return thin ? &thin->solid() : nullptr;
}

const mesh::TriangleMesh& DeformationSession::sheet(int part) const
{
    if (part < 0 || at(part) >= data_->assembly.parts.size())
        throw InvalidInput("part " + std::to_string(part) + " does not exist");
    return data_->assembly.parts[at(part)].mesh;
}

double DeformationSession::sheet_thickness(int part) const
{
    const mesh::TriangleMesh& mesh = sheet(part);
    return surface::sheet_thickness(data_->assembly.parts[at(part)].sheet_thickness, mesh);
}

const std::vector<std::optional<forms::FeatureShape>>& DeformationSession::shapes() const
{
    return data_->shapes;
}

std::vector<JoinedBody> DeformationSession::joined_bodies() const
{
    std::vector<JoinedBody> found;
    for (const Sheet& sheet : data_->system.sheets)
        for (const surface::Body& body : surface::merge_bodies(sheet.mesh, sheet.surface))
        {
            std::map<std::string, std::vector<Subject>> labels;
            for (const int feature : body.features)
            {
                const Text label = sheet.surface.features[at(feature)].label();
                labels.emplace(label.full(), label.subjects());
            }
            if (labels.size() < 2)
                continue;
            JoinedBody& joined = found.emplace_back();
            for (const auto& [label, subjects] : labels)
            {
                joined.labels.push_back(label);
                joined.of.insert(joined.of.end(), subjects.begin(), subjects.end());
            }
        }
    return found;
}

std::vector<LoosePieces> DeformationSession::loose_pieces() const
{
    std::vector<LoosePieces> of_part;
    for (std::size_t part = 0; part < data_->parts.size(); ++part)
        of_part.push_back({static_cast<int>(part), 0, 0, Vector3::Zero()});
    for (const Sheet& sheet : data_->system.sheets)
        for (const VertexIds& piece : sheet.loose)
        {
            LoosePieces& pieces = of_part[at(sheet.part_of(piece.front()))];
            if (++pieces.pieces == 1)
                pieces.place = sheet.mesh.points().row(piece.front()).transpose();
            pieces.vertices += static_cast<int>(piece.size());
        }
    std::vector<LoosePieces> found;
    std::copy_if(of_part.begin(), of_part.end(), std::back_inserter(found),
                 [](const LoosePieces& pieces) { return pieces.pieces > 0; });
    return found;
}

bool DeformationSession::is_held(int part) const
{
    if (part < 0 || at(part) >= data_->parts.size())
        throw InvalidInput("part " + std::to_string(part) + " does not exist");
    const System& system = data_->system;
    const int sheet = system.sheet_of(part);
    const auto is_there = [&](const PartRegion& fixed)
    { return system.sheet_of(fixed.part) == sheet; };
    const std::vector<PartRegion>& fixed = data_->assembly.fixed;
    return !system.sheets[at(sheet)].held.empty()
           || std::any_of(fixed.begin(), fixed.end(), is_there);
}

const PropagationPlan& DeformationSession::plan() const
{
    return data_->system.plan;
}

const std::vector<Timing>& DeformationSession::timings() const
{
    return data_->timings;
}

}  // namespace sheetmorph::assembly
