// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/prepared_assembly.h"

#include "sheetmorph/assembly/assembly_checks.h"
#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/plan/pose_checks.h"
#include "sheetmorph/assembly/session/reuse.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <numeric>

namespace sheetmorph::assembly
{

namespace
{

PreparedLink described_link(const Assembly& assembly, const PlannedLink& planned,
                            const ControlBoxes& boxes)
{
    PreparedLink link;
    link.type = planned.type;
    link.source = planned.source;
    link.targets = target_points(assembly, planned);
    if (planned.type == ContactType::control_mesh)
        link.options = {box_of_link(assembly, planned, boxes), assembly.propagation.levels,
                        assembly.propagation.smoothness};
    return link;
}

// "contact 'w' from part 'a' to part 'b'"
Text link_label(const Assembly& assembly, const PlannedLink& link)
{
    Text label = link.contact < 0 ? Text("the " + link.name) : Text::about("contact", link.name);
    label += " from part '" + assembly.parts[at(link.source_part)].name + "'";
    return link.targets.size() == 1
               ? label + " to part '" + assembly.parts[at(link.targets.front().part)].name + "'"
               : label;
}

std::shared_ptr<const MotionLink> built_link(const mesh::PartGeometry& source,
                                             const PreparedLink& link, const Text& label)
{
    const MotionLinkInput input{source, link.source, link.targets};
    try
    {
        if (link.type == ContactType::tied)
            return tied_link(input);
        return control_mesh_link(input, link.options);
    }
    catch (const InvalidInput& fault)
    {
        throw InvalidInput(label + ": " + fault.what(),
                           "pick other vertices for the contact, or make it rigid");
    }
}

std::shared_ptr<const surface::SurfaceDeformer> built_deformer(
    const Sheet& sheet, const surface::SurfaceDeformer* earlier, const Progress& progress)
{
    try
    {
        return std::make_shared<const surface::SurfaceDeformer>(sheet.mesh, sheet.surface, progress,
                                                                earlier);
    }
    catch (const InvalidInput& fault)
    {
        throw in_sheet(fault, sheet);
    }
    catch (const SolverError& fault)
    {
        throw on_sheet(fault, sheet);
    }
}

std::vector<FeatureEdges> feature_edges(const Assembly& whole, int part, const Owner& owner)
{
    std::vector<VertexIds> features;
    for (const int feature : owner.features)
        features.push_back(whole.features[at(feature)].vertices);
    return edges_of_features(whole.parts[at(part)].mesh, features);
}

// Takes the thin solids among the parts down to their middles.
void reduce(PreparedAssembly& prepared, const PreparedAssembly* previous)
{
    prepared.thin = find_thin_parts(prepared.assembly, previous ? &previous->whole() : nullptr,
                                    previous ? previous->thin : ThinParts());
    const auto is_none = [](const auto& part) { return part == nullptr; };
    if (std::all_of(prepared.thin.begin(), prepared.thin.end(), is_none))
        return;
    prepared.with_thin_parts = with_lumps(std::move(prepared.assembly), prepared.thin);
    prepared.assembly = reduced_to_skins(*prepared.with_thin_parts, prepared.thin);
}

// By part, while the assembly is prepared.
using Geometries = std::deque<mesh::PartGeometry>;

Geometries geometries_of(const Assembly& assembly)
{
    Geometries geometries;
    for (const Part& part : assembly.parts)
        geometries.emplace_back(part.mesh);
    return geometries;
}

// What is told of poses: how contacts fare, and where handles meet fixed regions.
void add_gauges(PreparedAssembly& prepared)
{
    for (const DirectedContact& contact : prepared.system.plan.measured)
        prepared.gauges.emplace_back(prepared.whole(), contact);
    prepared.overlaps = overlaps_of(prepared.whole());
}

System system_of(const PreparedAssembly& prepared, const Geometries& geometries,
                 const ControlBoxes& boxes)
{
    std::vector<char> is_thin;
    for (const auto& thin : prepared.thin)
        is_thin.push_back(thin != nullptr);
    return plan_system({prepared.assembly, is_thin, geometries, boxes});
}

//! Collects what has to be built, and times it.
class Preparation
{
public:
    Preparation(PreparedAssembly& prepared, const Geometries& geometries,
                const PreparedAssembly* previous)
        : prepared_(prepared), geometries_(geometries), previous_(previous)
    {
        prepared_.timings.reserve(prepared.deformers.size() + prepared.links.size());
    }

    void add_part(int index)
    {
        PreparedPart& part = prepared_.parts[at(index)];
        part.edges = feature_edges(prepared_.whole(), index, prepared_.system.owners[at(index)]);
        if (const auto& thin = prepared_.thin[at(index)])
            part.thin = std::make_shared<const ThinSolver>(
                ThinSolverInput{thin, prepared_.whole(), prepared_.system, index});
    }

    void add_sheet(std::size_t index)
    {
        const Sheet& sheet = prepared_.system.sheets[index];
        auto& deformer = prepared_.deformers[index];
        if (!sheet.is_driven())
            return;
        const auto earlier = earlier_deformer(previous_, sheet);
        if (earlier && is_deformer_of(*earlier, sheet.mesh, sheet.surface))
            deformer = earlier;
        else
            add("part " + sheet.name, sheet.mesh.vertex_count(),
                [&deformer, &sheet, earlier](const Progress& progress)
                { deformer = built_deformer(sheet, earlier.get(), progress); });
    }

    void add_link(std::size_t index)
    {
        PreparedLink& link = prepared_.links[index];
        const std::size_t part = at(prepared_.system.links[index].source_part);
        const mesh::PartGeometry& source = geometries_[part];
        link.link = reusable_link(previous_, prepared_.assembly.parts[part], link);
        if (!link.link)
            add("contact " + prepared_.system.links[index].name, effort(link),
                [&link, &source,
                 label = link_label(prepared_.assembly, prepared_.system.links[index])](
                    const Progress&) { link.link = built_link(source, link, label); });
    }

    // What takes longest first, so that no thread is left with it at the end.
    void run(const Progress& progress)
    {
        std::vector<std::size_t> order(tasks_.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::stable_sort(order.begin(), order.end(),
                         [this](std::size_t a, std::size_t b)
                         { return efforts_[a] > efforts_[b]; });
        std::vector<Task> tasks;
        for (const std::size_t task : order)
            tasks.push_back(std::move(tasks_[task]));
        run_tasks(tasks, progress);
    }

private:
    // About as many vertices of a part take as long: a point of a control mesh four.
    static Eigen::Index effort(const PreparedLink& link)
    {
        if (link.type == ContactType::tied)
            return link.targets.rows();
        return 4 * (3 * static_cast<Eigen::Index>(link.source.size()) + 7 * link.targets.rows());
    }

    void add(const std::string& name, Eigen::Index effort,
             const std::function<void(const Progress&)>& work)
    {
        efforts_.push_back(effort);
        prepared_.timings.push_back({name, 0.0});
        Timing& timing = prepared_.timings.back();
        tasks_.push_back({"preparing " + name, [work, &timing](const Progress& progress)
                          {
                              const auto start = std::chrono::steady_clock::now();
                              work(progress);
                              const std::chrono::duration<double> taken =
                                  std::chrono::steady_clock::now() - start;
                              timing.seconds = taken.count();
                          }});
    }

    PreparedAssembly& prepared_;
    const Geometries& geometries_;
    const PreparedAssembly* previous_;
    std::vector<Task> tasks_;
    std::vector<Eigen::Index> efforts_;
};

}  // namespace

PreparedAssembly prepare_assembly(Assembly assembly, const Progress& progress,
                                  const PreparedAssembly* previous)
{
    check_assembly(assembly);
    PreparedAssembly prepared;
    if (assembly.symmetry)
    {
        prepared.symmetry = complete_by_symmetry(assembly);
        check_assembly(assembly);
    }
    prepared.assembly = std::move(assembly);
    reduce(prepared, previous);
    prepared.shapes = shapes_of_sized(prepared.whole());
    const Assembly& given = prepared.assembly;
    const ControlBoxes boxes(given);
    const Geometries geometries = geometries_of(given);
    prepared.system = system_of(prepared, geometries, boxes);
    add_gauges(prepared);
    for (const PlannedLink& planned : prepared.system.links)
        prepared.links.push_back(described_link(given, planned, boxes));
    prepared.parts.resize(given.parts.size());
    prepared.deformers.resize(prepared.system.sheets.size());
    Preparation preparation(prepared, geometries, previous);
    for (int part = 0; part < static_cast<int>(given.parts.size()); ++part)
        preparation.add_part(part);
    for (std::size_t sheet = 0; sheet < prepared.deformers.size(); ++sheet)
        preparation.add_sheet(sheet);
    for (std::size_t link = 0; link < prepared.links.size(); ++link)
        preparation.add_link(link);
    preparation.run(progress);
    progress.report(1.0, "ready");
    return prepared;
}

Pose told_pose(const PreparedAssembly& prepared, const Pose& pose)
{
    check_pose_names(prepared.assembly, pose);
    check_sizes(prepared.assembly, prepared.shapes, pose);
    Pose told =
        prepared.symmetry ? symmetric_pose(prepared.assembly, *prepared.symmetry, pose) : pose;
    check_overlaps(prepared.whole(), prepared.overlaps, told);
    return told;
}

std::set<std::string> with_mirrors(const PreparedAssembly& prepared,
                                   const std::vector<std::string>& handles)
{
    std::set<std::string> names(handles.begin(), handles.end());
    if (!prepared.symmetry)
        return names;
    const std::set<std::string> given = names;
    for (const auto& [a, b] : prepared.symmetry->handles)
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)})
            if (given.count(prepared.assembly.handles[at(one)].name) > 0)
                names.insert(prepared.assembly.handles[at(other)].name);
    return names;
}

}  // namespace sheetmorph::assembly
