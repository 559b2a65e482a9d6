// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/wave.h"

#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"

#include <algorithm>

namespace sheetmorph::assembly
{

Wave::Wave(const PreparedAssembly& prepared, const Pose& pose, Exactness exactness,
           Progress progress)
    : prepared_(prepared),
      pose_(pose),
      exactness_(exactness),
      progress_(std::move(progress)),
      links_(prepared.links.size()),
      welds_(prepared.welds.size()),
      motions_(prepared.assembly.features.size()),
      answers_(prepared.parts.size())
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
    if (prepared_.joined)
        take(Wave(*prepared_.joined, pose_, exactness_, progress_).run());
    else
        answer_in_order();
    for (const int part : prepared_.plan.unreached)
        set_at_rest(part);
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
    const auto count = static_cast<double>(prepared_.plan.order.size());
    for (std::size_t k = 0; k < prepared_.plan.order.size(); ++k)
    {
        const auto done = static_cast<double>(k);
        progress_ = whole.part(done / count, (done + 1.0) / count);
        answer(prepared_.plan.order[k], nullptr);
        pass_on(prepared_.plan.order[k]);
    }
}

// Every part's own of what was solved at once.
void Wave::take(const Deformed& joined)
{
    const surface::Deformation& all = joined.parts.front();
    const JoinedParts& places = prepared_.places;
    for (const int part : prepared_.plan.order)
    {
        const PartProblem& problem = prepared_.parts[at(part)].problem;
        const int first = places.first[at(part)];
        const int count = prepared_.assembly.parts[at(part)].mesh.vertex_count();
        surface::Deformation& shape = solved(part);
        shape.positions = all.positions.middleRows(first, count);
        shape.rotation_logs = all.rotation_logs.rows() == 0
                                  ? Points(0, 3)
                                  : Points(all.rotation_logs.middleRows(first, count));
        shape.convergence = all.convergence;
        shape.features.clear();
        for (const int feature : problem.own.features)
            shape.features.push_back(joined.features[at(places.features[at(feature)])].motion);
        for (const int weld : problem.carriers)
            shape.features.push_back(joined.features[at(places.welds + weld)].motion);
        expand(part, targets_of(part));
        result_->parts[at(part)].is_preview = all.is_preview;
    }
}

// What the deformer of a part makes: the middle of a thin solid, the whole of any other part.
surface::Deformation& Wave::solved(int part) const
{
    const bool is_thin = prepared_.parts[at(part)].thin != nullptr;
    return is_thin ? result_->middles[at(part)] : result_->parts[at(part)];
}

// The whole of a thin solid follows its middle.
void Wave::expand(int part, const surface::SurfaceTargets& targets) const
{
    if (const auto& thin = prepared_.parts[at(part)].thin)
        thin->expand(result_->middles[at(part)], targets, exactness_, result_->parts[at(part)]);
}

// Left alone if an earlier frame has put it there.
void Wave::set_at_rest(int part) const
{
    surface::Deformation& shape = solved(part);
    const mesh::TriangleMesh& mesh = prepared_.assembly.parts[at(part)].mesh;
    if (shape.positions.rows() == mesh.vertex_count())
        return;
    shape = {mesh.points(), Points::Zero(mesh.vertex_count(), 3), {}};
    for (const surface::FormFeature& feature :
         prepared_.parts[at(part)].problem.own.surface.features)
    {
        RigidMotion none;
        none.pivot = rows_of(mesh.points(), feature.vertices).colwise().mean().transpose();
        shape.features.push_back(none);
    }
    surface::SurfaceTargets none;
    none.handles.resize(prepared_.parts[at(part)].problem.own.surface.handles.size());
    expand(part, none);
}

surface::SurfaceTargets Wave::targets_of(int part) const
{
    return targets_in_order(prepared_.assembly, prepared_.parts[at(part)].problem, pose_,
                            {links_, welds_, motions_});
}

// The one place that chooses how a part is answered (resources/docs/answers.md).
// \returns whether its response was taken
bool Wave::answer(int index, const std::shared_ptr<const surface::Response>& response)
{
    const PreparedPart& part = prepared_.parts[at(index)];
    if (!part.deformer)
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
        throw in_part(fault, prepared_.assembly.parts[at(index)]);
    }
}

void Wave::substitute(int index)
{
    const PreparedPart& part = prepared_.parts[at(index)];
    if (exactness_ == Exactness::exact)
        result_->spread =
            std::max(result_->spread, spread_of_targets(part.problem, {links_, welds_, motions_}));
    const surface::SurfaceTargets targets = targets_of(index);
    solved(index) = part.thin ? part.thin->solve(*part.deformer, targets, exactness_, progress_)
                              : part.deformer->deform(targets, exactness_, progress_);
    expand(index, targets);
}

const surface::Deformation& Wave::read_of(int part) const
{
    const bool is_in_read = !is_in_read_.empty() && is_in_read_[at(part)];
    return is_in_read ? (*read_)[at(part)] : solved(part);
}

// What later parts need of this one.
void Wave::pass_on(int index)
{
    for (std::size_t k = 0; k < links_.size(); ++k)
        if (prepared_.planned[k].source_part == index)
            pass_on_link(k);
    pass_on_motions(index);
}

void Wave::pass_on_link(std::size_t link)
{
    const surface::Deformation& source = read_of(prepared_.planned[link].source_part);
    links_[link] = prepared_.links[link].link->transfer(source, exactness_);
}

void Wave::pass_on_motions(int index)
{
    const surface::Deformation& shape = read_of(index);
    const PartProblem& problem = prepared_.parts[at(index)].problem;
    for (std::size_t k = 0; k < problem.carriers.size(); ++k)
        welds_[at(problem.carriers[k])] = shape.features[problem.own.features.size() + k];
    for (std::size_t k = 0; k < problem.own.features.size(); ++k)
        motions_[at(problem.own.features[k])] = shape.features[k];
}

// The part at rest with the sizes of the pose.
Points Wave::sized_rest(int index) const
{
    Points rest = prepared_.whole().parts[at(index)].mesh.points();
    for (const int feature : prepared_.parts[at(index)].problem.own.features)
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
    const int global = prepared_.parts[at(part)].problem.own.features[own];
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
void Wave::mark_preview(int index)
{
    if (prepared_.joined)
        return;
    const PreparedPart& part = prepared_.parts[at(index)];
    result_->parts[at(index)].is_preview =
        exactness_ == Exactness::live && part.deformer && part.problem.own.surface.has_previews();
}

void Wave::report_features(int index)
{
    const PreparedPart& part = prepared_.parts[at(index)];
    const bool is_measured = exactness_ == Exactness::exact && prepared_.is_solved(index);
    const Points rest = is_measured ? sized_rest(index) : Points();
    for (std::size_t f = 0; f < part.problem.own.features.size(); ++f)
        report_feature(index, f, rest);
}

void Wave::report_contacts()
{
    for (std::size_t k = 0; k < prepared_.gauges.size(); ++k)
    {
        const DirectedContact& contact = prepared_.plan.measured[k];
        const int source = contact.source(prepared_.whole()).part;
        const int target = contact.target(prepared_.whole()).part;
        result_->contacts.push_back(prepared_.gauges[k].measure(
            result_->parts[at(source)], result_->parts[at(target)].positions));
    }
}

}  // namespace sheetmorph::assembly
