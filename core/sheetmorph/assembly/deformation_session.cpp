// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/deformation_session.h"

#include "sheetmorph/assembly/control_box.h"
#include "sheetmorph/assembly/prepared_assembly.h"
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

//! One pose on its way through the propagation order.
class Wave
{
public:
    Wave(const PreparedAssembly& prepared, const Pose& pose, Exactness exactness)
        : prepared_(prepared),
          pose_(pose),
          exactness_(exactness),
          links_(prepared.links.size()),
          welds_(prepared.welds.size())
    {
        result_.parts.resize(prepared.assembly.parts.size());
        result_.features.resize(prepared.assembly.features.size());
    }

    Deformed run()
    {
        for (const int part : prepared_.plan.order)
        {
            result_.parts[at(part)] = deform_part(part);
            pass_on(part);
        }
        for (const int part : prepared_.plan.unreached)
            result_.parts[at(part)] = at_rest(part);
        for (int part = 0; part < static_cast<int>(result_.parts.size()); ++part)
            report_features(part);
        if (exactness_ == Exactness::exact)
            report_contacts();
        return std::move(result_);
    }

private:
    Deformation at_rest(int part) const
    {
        const TriangleMesh& mesh = prepared_.assembly.parts[at(part)].mesh;
        Deformation rest{mesh.points(), Points::Zero(mesh.vertex_count(), 3), {}};
        for (const FormFeature& feature : prepared_.parts[at(part)].problem.own.surface.features)
        {
            RigidMotion none;
            none.pivot = rows_of(mesh.points(), feature.vertices).colwise().mean().transpose();
            rest.features.push_back(none);
        }
        return rest;
    }

    Deformation deform_part(int index)
    {
        const PreparedPart& part = prepared_.parts[at(index)];
        if (!part.deformer)
            return at_rest(index);
        const EarlierParts earlier{links_, welds_};
        try
        {
            if (exactness_ == Exactness::exact)
                result_.spread = std::max(result_.spread, spread_of_targets(part.problem, earlier));
            return part.deformer->deform(
                targets_in_order(prepared_.assembly, part.problem, pose_, earlier), exactness_);
        }
        catch (const InvalidInput& fault)
        {
            const Part& named = prepared_.assembly.parts[at(index)];
            throw fault.in_part(named.name, named.ids);
        }
    }

    // What later parts need of this one.
    void pass_on(int index)
    {
        const Deformation& shape = result_.parts[at(index)];
        for (std::size_t k = 0; k < links_.size(); ++k)
            if (prepared_.planned[k].source_part == index)
                links_[k] = prepared_.links[k].link->transfer(shape);
        const PartProblem& problem = prepared_.parts[at(index)].problem;
        for (std::size_t k = 0; k < problem.carriers.size(); ++k)
            welds_[at(problem.carriers[k])] = shape.features[problem.own.features.size() + k];
    }

    void report_features(int index)
    {
        const PreparedPart& part = prepared_.parts[at(index)];
        const Deformation& shape = result_.parts[at(index)];
        for (std::size_t f = 0; f < part.problem.own.features.size(); ++f)
        {
            const std::size_t global = at(part.problem.own.features[f]);
            const PartFeature& feature = prepared_.assembly.features[global];
            const bool is_measured = exactness_ == Exactness::exact;
            const double error =
                !is_measured ? 0.0
                             : edge_error(prepared_.assembly.parts[at(index)].mesh, part.edges[f],
                                          shape.positions, shape.features[f]);
            result_.features[global] = {feature.name, feature.part, shape.features[f], error};
        }
    }

    void report_contacts()
    {
        for (std::size_t k = 0; k < prepared_.gauges.size(); ++k)
        {
            const DirectedContact& contact = prepared_.plan.measured[k];
            const int source = contact.source(prepared_.assembly).part;
            const int target = contact.target(prepared_.assembly).part;
            result_.contacts.push_back(prepared_.gauges[k].measure(
                result_.parts[at(source)], result_.parts[at(target)].positions));
        }
    }

    const PreparedAssembly& prepared_;
    const Pose& pose_;
    Exactness exactness_;
    std::vector<LinkedTargets> links_;
    std::vector<RigidMotion> welds_;
    Deformed result_;
};

}  // namespace

struct DeformationSession::Precomputed : PreparedAssembly
{
    explicit Precomputed(PreparedAssembly prepared) : PreparedAssembly(std::move(prepared)) {}
};

DeformationSession::DeformationSession(Assembly assembly, const Progress& progress,
                                       const DeformationSession* previous)
    : data_(std::make_unique<const Precomputed>(prepare_assembly(
        std::move(assembly), progress, previous != nullptr ? previous->data_.get() : nullptr)))
{
}

DeformationSession::~DeformationSession() = default;
DeformationSession::DeformationSession(DeformationSession&&) noexcept = default;
DeformationSession& DeformationSession::operator=(DeformationSession&&) noexcept = default;

Deformed DeformationSession::deform(const Pose& pose, Exactness exactness) const
{
    check_pose_names(data_->assembly, pose);
    return Wave(*data_, pose, exactness).run();
}

std::optional<ShownControlMesh> DeformationSession::control_mesh(int contact,
                                                                 const Deformed& pose) const
{
    for (std::size_t k = 0; k < data_->planned.size(); ++k)
        if (data_->planned[k].contact == contact)
            return data_->links[k].link->control_mesh(
                pose.parts[at(data_->planned[k].source_part)]);
    return std::nullopt;
}

const Assembly& DeformationSession::assembly() const
{
    return data_->assembly;
}

const PropagationPlan& DeformationSession::plan() const
{
    return data_->plan;
}

const std::vector<Timing>& DeformationSession::timings() const
{
    return data_->timings;
}

}  // namespace sheetmorph
