// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/wave.h"

#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/system/sheet_targets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"

#include <algorithm>

namespace sheetmorph::assembly
{

Wave::Wave(const PreparedAssembly& prepared, const Pose& pose, Exactness exactness,
           Progress progress)
    : prepared_(prepared),
      system_(prepared.system),
      pose_(pose),
      exactness_(exactness),
      progress_(std::move(progress)),
      links_(prepared.links.size()),
      welds_(system_.welds.size()),
      motions_(prepared.assembly.features.size()),
      answers_(system_.sheets.size())
{
}

void Wave::start(Deformed& result)
{
    result_ = &result;
    result.parts.resize(prepared_.assembly.parts.size());
    result.middles.resize(prepared_.assembly.parts.size());
    result.features.resize(prepared_.assembly.features.size());
    result.contacts.clear();
    result.spread = 0.0;
}

Deformed Wave::run()
{
    Deformed result;
    start(result);
    begin_reading(own_read_);
    answer_in_order();
    set_others_at_rest();
    for (int part = 0; part < static_cast<int>(result.parts.size()); ++part)
    {
        mark_preview(part);
        report_features(part);
    }
    if (exactness_ == Exactness::exact)
        report_contacts();
    return result;
}

void Wave::answer_in_order()
{
    const Progress whole = progress_;
    const auto count = static_cast<double>(system_.order.size());
    for (std::size_t k = 0; k < system_.order.size(); ++k)
    {
        const auto done = static_cast<double>(k);
        progress_ = whole.part(done / count, (done + 1.0) / count);
        answer(system_.order[k], nullptr);
        pass_on(system_.order[k]);
    }
}

const Sheet& Wave::sheet(int index) const
{
    return system_.sheets[at(index)];
}

bool Wave::is_shared(int index) const
{
    return sheet(index).parts.size() > 1;
}

const ThinSolver* Wave::thin_of(int index) const
{
    return is_shared(index) ? nullptr : prepared_.parts[at(sheet(index).parts.front())].thin.get();
}

// What the deformer of a sheet makes: the result of a part, unless several share the sheet.
surface::Deformation& Wave::solved(int index) const
{
    return is_shared(index) ? (*read_)[at(index)] : solved_part(sheet(index).parts.front());
}

// What is solved of a part: the middle of a thin solid, the whole of any other part.
surface::Deformation& Wave::solved_part(int part) const
{
    const bool is_thin = prepared_.parts[at(part)].thin != nullptr;
    return is_thin ? result_->middles[at(part)] : result_->parts[at(part)];
}

// To the parts what is theirs of a sheet; the whole of a thin solid follows its middle.
void Wave::hand_out(int index, const surface::SurfaceTargets& targets) const
{
    for (const int part : sheet(index).parts)
    {
        const Owner& owner = system_.owners[at(part)];
        surface::Deformation& shape = solved_part(part);
        if (is_shared(index))
        {
            const surface::Deformation& all = solved(index);
            shape.positions = all.positions.middleRows(owner.first, owner.count);
            const bool has_logs = all.rotation_logs.rows() > 0;
            shape.rotation_logs = all.rotation_logs.middleRows(has_logs ? owner.first : 0,
                                                               has_logs ? owner.count : 0);
            shape.convergence = all.convergence;
            shape.features.clear();
            for (const int body : owner.bodies)
                shape.features.push_back(all.features[at(body)]);
        }
        const auto& thin = prepared_.parts[at(part)].thin;
        if (!thin)
            continue;
        surface::SurfaceTargets own;
        for (const int handle : owner.handles)
            own.handles.push_back(targets.handles[at(handle)]);
        for (const int body : owner.bodies)
            own.sizes.push_back(targets.sizes[at(body)]);
        thin->expand(shape, own, exactness_, result_->parts[at(part)]);
    }
}

void Wave::set_others_at_rest() const
{
    for (int index = 0; index < static_cast<int>(system_.sheets.size()); ++index)
        if (system_.plan.level[at(sheet(index).parts.front())] < 0)
            set_at_rest(index);
}

// Left alone if an earlier frame has put it there.
void Wave::set_at_rest(int index) const
{
    const Sheet& resting = sheet(index);
    surface::Deformation& shape = solved(index);
    if (!is_shared(index) && shape.positions.rows() == resting.mesh.vertex_count())
        return;
    shape = {resting.mesh.points(), Points::Zero(resting.mesh.vertex_count(), 3), {}};
    for (const surface::FormFeature& feature : resting.surface.features)
    {
        RigidMotion none;
        none.pivot = rows_of(resting.mesh.points(), feature.vertices).colwise().mean().transpose();
        shape.features.push_back(none);
    }
    surface::SurfaceTargets none;
    none.handles.resize(resting.surface.handles.size());
    none.sizes.resize(resting.surface.features.size());
    hand_out(index, none);
}

surface::SurfaceTargets Wave::targets_of(int index) const
{
    return targets_of_sheet(prepared_.assembly, sheet(index), pose_, {links_, welds_, motions_});
}

// The one place that chooses how a sheet is answered (resources/docs/answers.md).
// \returns whether its response was taken
bool Wave::answer(int index, const std::shared_ptr<const surface::Response>& response)
{
    if (!prepared_.deformers[at(index)])
    {
        set_at_rest(index);
        return false;
    }
    try
    {
        if (exactness_ == Exactness::live && response && respond(index, response))
            return true;
        substitute(index);
        return false;
    }
    catch (const InvalidInput& fault)
    {
        throw in_sheet(fault, sheet(index));
    }
}

void Wave::substitute(int index)
{
    if (exactness_ == Exactness::exact)
        result_->spread =
            std::max(result_->spread, spread_of_targets(sheet(index), {links_, welds_, motions_}));
    const surface::SurfaceTargets targets = targets_of(index);
    const surface::SurfaceDeformer& deformer = *prepared_.deformers[at(index)];
    const ThinSolver* thin = thin_of(index);
    solved(index) = thin != nullptr ? thin->solve(deformer, targets, exactness_, progress_)
                                    : deformer.deform(targets, exactness_, progress_);
    hand_out(index, targets);
}

const surface::Deformation& Wave::read_of(int index) const
{
    return is_in_read_[at(index)] ? (*read_)[at(index)] : solved(index);
}

// What later sheets need of this one.
void Wave::pass_on(int index)
{
    for (std::size_t k = 0; k < links_.size(); ++k)
        if (system_.sheet_of(system_.links[k].source_part) == index)
            pass_on_link(k);
    pass_on_motions(index);
}

void Wave::pass_on_link(std::size_t link)
{
    const surface::Deformation& source = read_of(system_.sheet_of(system_.links[link].source_part));
    links_[link] = prepared_.links[link].link->transfer(source, exactness_);
}

void Wave::pass_on_motions(int index)
{
    const surface::Deformation& shape = read_of(index);
    const Sheet& passing = sheet(index);
    for (std::size_t k = 0; k < passing.carriers.size(); ++k)
        welds_[at(passing.carriers[k])] = shape.features[passing.features.size() + k];
    for (std::size_t k = 0; k < passing.features.size(); ++k)
        motions_[at(passing.features[k])] = shape.features[k];
}

// The part at rest with the sizes of the pose.
Points Wave::sized_rest(int index) const
{
    Points rest = prepared_.whole().parts[at(index)].mesh.points();
    for (const int feature : system_.owners[at(index)].features)
        if (const std::optional<SizedForm> form = sized_form(feature))
            for (Eigen::Index k = 0; k < form->rest.rows(); ++k)
                rest.row(
                    prepared_.whole().features[at(feature)].vertices[static_cast<std::size_t>(k)]) =
                    form->rest.row(k);
    return rest;
}

std::optional<SizedForm> Wave::sized_form(int index) const
{
    const PartFeature& feature = prepared_.whole().features[at(index)];
    const std::optional<forms::FeatureShape>& shape = prepared_.shapes[at(index)];
    const std::optional<double> size = size_in_pose(feature, pose_);
    if (!shape || !size)
        return std::nullopt;
    const Points rest =
        rows_of(prepared_.whole().parts[at(feature.part)].mesh.points(), feature.vertices);
    return SizedForm{*shape, *size, shape->resized(rest, *size)};
}

void Wave::report_feature(int part, std::size_t own, const Points& rest)
{
    const surface::Deformation& shape = result_->parts[at(part)];
    const int global = system_.owners[at(part)].features[own];
    const PartFeature& feature = prepared_.whole().features[at(global)];
    FeatureResult& result = result_->features[at(global)];
    result = {};
    result.name = feature.name;
    result.part = feature.part;
    result.motion = shape.features[own];
    if (prepared_.shapes[at(global)])
        result.size = size_in_pose(feature, pose_);
    if (rest.rows() == 0)
        return;
    result.edge_error =
        edge_error(rest, prepared_.parts[at(part)].edges[own], shape.positions, result.motion);
    if (const std::optional<SizedForm> form = sized_form(global))
        result.outline_error = outline_error(*form, rows_of(shape.positions, feature.vertices),
                                             result.motion.rotation());
}

// What is shown live of a part whose exact answer is refined besides.
void Wave::mark_preview(int part)
{
    const int index = system_.sheet_of(part);
    result_->parts[at(part)].is_preview = exactness_ == Exactness::live
                                          && prepared_.deformers[at(index)]
                                          && sheet(index).surface.has_previews();
}

void Wave::report_features(int part)
{
    const Owner& owner = system_.owners[at(part)];
    const bool is_measured = exactness_ == Exactness::exact && prepared_.deformers[at(owner.sheet)];
    const Points rest = is_measured ? sized_rest(part) : Points();
    for (std::size_t f = 0; f < owner.features.size(); ++f)
        report_feature(part, f, rest);
}

void Wave::report_contacts()
{
    for (std::size_t k = 0; k < prepared_.gauges.size(); ++k)
    {
        const DirectedContact& contact = system_.plan.measured[k];
        const int source = contact.source(prepared_.whole()).part;
        const int target = contact.target(prepared_.whole()).part;
        result_->contacts.push_back(prepared_.gauges[k].measure(
            result_->parts[at(source)], result_->parts[at(target)].positions));
    }
}

}  // namespace sheetmorph::assembly
