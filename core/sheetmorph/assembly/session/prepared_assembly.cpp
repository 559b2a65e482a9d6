// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/prepared_assembly.h"

#include "sheetmorph/assembly/assembly_checks.h"
#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/links/patch_anchors.h"
#include "sheetmorph/assembly/plan/link_blending.h"
#include "sheetmorph/assembly/plan/loose_pieces.h"
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

Points target_points(const Assembly& assembly, const PlannedLink& link)
{
    Eigen::Index count = 0;
    for (const LinkTarget& target : link.targets)
        count += static_cast<Eigen::Index>(target.vertices.size());
    Points points(count, 3);
    Eigen::Index row = 0;
    for (const LinkTarget& target : link.targets)
    {
        const Points rows = rows_of(assembly.parts[at(target.part)].mesh.points(), target.vertices);
        points.middleRows(row, rows.rows()) = rows;
        row += rows.rows();
    }
    return points;
}

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

//! A part's deformer, and that of an earlier session if there is one.
struct DeformerInput
{
    const Part& part;
    const surface::SurfaceConstraints& constraints;
    std::shared_ptr<const surface::SurfaceDeformer> earlier;
};

std::shared_ptr<const surface::SurfaceDeformer> built_deformer(const DeformerInput& input,
                                                               const Progress& progress)
{
    const Part& part = input.part;
    try
    {
        return std::make_shared<const surface::SurfaceDeformer>(part.mesh, input.constraints,
                                                                progress, input.earlier.get());
    }
    catch (const InvalidInput& fault)
    {
        throw in_part(fault, part);
    }
    catch (const SolverError& fault)
    {
        throw on_part(fault, part);
    }
}

std::vector<FeatureEdges> own_feature_edges(const Assembly& whole, int part,
                                            const PartProblem& problem)
{
    std::vector<VertexIds> features;
    for (const int feature : problem.own.features)
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

// What touches by its wall is a row of vertices in the middle of the sheet, and a tie holds on to
// triangles.
void widen_thin_sources(PreparedAssembly& prepared, const Geometries& geometries)
{
    for (PlannedLink& link : prepared.planned)
        if (link.type == ContactType::tied && prepared.thin[at(link.source_part)])
            link.source = with_triangles_below(geometries[at(link.source_part)], link.source,
                                               target_points(prepared.assembly, link));
}

bool is_whole(const Assembly& assembly)
{
    return assembly.propagation.type == PropagationType::whole;
}

// What touches a thin solid by its wall, or a row of vertices that a seam is, touches triangles
// that the side has not whole.
bool is_wide(const PreparedAssembly& prepared, const PartRegion& source,
             const mesh::PartGeometry& geometry)
{
    return prepared.thin[at(source.part)] != nullptr
           || (is_whole(prepared.assembly) && !has_triangles(geometry, source.vertices));
}

// What is told of poses: how contacts fare, and where handles meet fixed regions.
void add_gauges(PreparedAssembly& prepared)
{
    for (const DirectedContact& contact : prepared.plan.measured)
        prepared.gauges.emplace_back(prepared.whole(), contact);
    prepared.overlaps = overlaps_of(prepared.whole());
}

// By measured contact that is not rigid: where its sides lie on each other.
std::vector<SeamPlaces> seam_places(const PreparedAssembly& prepared, const Geometries& geometries)
{
    const Assembly& given = prepared.assembly;
    const auto on = [&](const PartRegion& below, const PartRegion& region)
    {
        const mesh::PartGeometry& geometry = geometries[at(below.part)];
        const Points points = rows_of(given.parts[at(region.part)].mesh.points(), region.vertices);
        return nearest_anchors(geometry,
                               is_wide(prepared, below, geometry)
                                   ? with_triangles_below(geometry, below.vertices, points)
                                   : below.vertices,
                               points);
    };
    std::vector<SeamPlaces> places;
    for (const DirectedContact& contact : prepared.plan.measured)
    {
        const PartRegion &source = contact.source(given), &target = contact.target(given);
        const bool is_rigid = given.contacts[at(contact.contact)].type == ContactType::rigid;
        places.push_back(is_rigid ? SeamPlaces{}
                                  : SeamPlaces{on(source, target), on(target, source)});
    }
    return places;
}

// A point of a thin solid lies off the middle: it is met in rounds, part by part.
void refuse_thin_points(const PreparedAssembly& prepared)
{
    for (const PartPoint& point : prepared.assembly.points)
        if (prepared.thin[at(point.part)])
            throw in_part({label_of("point", point)
                               + " lies on a thin solid, which the propagation 'whole' does not "
                                 "support",
                           "use a handle of vertices, or \"thin\": false"},
                          prepared.assembly.parts[at(point.part)]);
}

// All parts as one, taking over from `previous` what fits.
void join(PreparedAssembly& prepared, const Geometries& geometries, const Progress& progress,
          const PreparedAssembly* previous)
{
    refuse_thin_points(prepared);
    prepared.places = joined_parts(prepared.assembly, prepared.plan, prepared.welds,
                                   seam_places(prepared, geometries));
    Assembly one = std::move(prepared.places.assembly);
    auto joined = std::make_shared<PreparedAssembly>(prepare_assembly(
        std::move(one), progress, previous != nullptr ? previous->joined.get() : nullptr));
    joined->carries_thin = prepared.with_thin_parts.has_value();
    prepared.joined = std::move(joined);
    prepared.timings.insert(prepared.timings.end(), prepared.joined->timings.begin(),
                            prepared.joined->timings.end());
}

// A stage after the last that moves it.
void add_stages(PreparedAssembly& prepared)
{
    std::vector<std::size_t> stage(prepared.parts.size(), 0);
    for (const int part : prepared.plan.order)
    {
        const PartProblem& problem = prepared.parts[at(part)].problem;
        const auto follow = [&](int earlier)
        { stage[at(part)] = std::max(stage[at(part)], stage[at(earlier)] + 1); };
        for (const PlannedLink& link : prepared.planned)
            for (const LinkTarget& target : link.targets)
                if (target.part == part)
                    follow(link.source_part);
        for (const int weld : problem.carried)
            follow(prepared.welds[at(weld)].source_part);
        for (const int leader : problem.own.leaders)
            if (leader >= 0)
                follow(prepared.assembly.features[at(leader)].part);
        prepared.stages.resize(std::max(prepared.stages.size(), stage[at(part)] + 1));
        prepared.stages[stage[at(part)]].push_back(part);
    }
}

void add_problems(PreparedAssembly& prepared)
{
    const Assembly& given = prepared.assembly;
    const Passages passages{prepared.planned, prepared.welds, prepared.pairs};
    for (int part = 0; part < static_cast<int>(given.parts.size()); ++part)
    {
        const bool is_alone = !is_whole(given);
        prepared.parts.push_back({is_alone ? problem_of_part(given, part, passages)
                                           : problem_in_whole(given, part, prepared.welds),
                                  {},
                                  nullptr,
                                  nullptr});
        if (is_alone)
            hold_loose_pieces(given.parts[at(part)], given.unheld, prepared.parts.back().problem);
    }
    add_stages(prepared);
}

//! Collects what has to be built, and times it.
class Preparation
{
public:
    Preparation(PreparedAssembly& prepared, const Geometries& geometries,
                const PreparedAssembly* previous)
        : prepared_(prepared), geometries_(geometries), previous_(previous)
    {
        prepared_.timings.reserve(prepared.parts.size() + prepared.links.size());
    }

    void add_part(int index)
    {
        PreparedPart& part = prepared_.parts[at(index)];
        const Part& of = prepared_.assembly.parts[at(index)];
        part.edges = own_feature_edges(prepared_.whole(), index, part.problem);
        if (const auto& thin = prepared_.thin[at(index)])
            part.thin = std::make_shared<const ThinSolver>(
                ThinSolverInput{thin, prepared_.whole(), part.problem, prepared_.welds, index});
        if (!part.problem.is_driven() || is_whole(prepared_.assembly))
            return;
        const DeformerInput input{of, part.problem.own.surface, earlier_deformer(previous_, of)};
        if (input.earlier && is_deformer_of(*input.earlier, of.mesh, input.constraints))
            part.deformer = input.earlier;
        else
            add("part " + of.name, of.mesh.vertex_count(),
                [&part, input](const Progress& progress)
                { part.deformer = built_deformer(input, progress); });
    }

    void add_link(std::size_t index)
    {
        PreparedLink& link = prepared_.links[index];
        const std::size_t part = at(prepared_.planned[index].source_part);
        const mesh::PartGeometry& source = geometries_[part];
        link.link = reusable_link(previous_, prepared_.assembly.parts[part], link);
        if (!link.link)
            add("contact " + prepared_.planned[index].name, effort(link),
                [&link, &source, label = link_label(prepared_.assembly, prepared_.planned[index])](
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
    prepared.plan = plan_propagation(given);
    if (is_whole(given))
        lead_by_coarser(given, prepared.plan);
    const ControlBoxes boxes(given);
    prepared.planned = plan_links(given, prepared.plan, boxes);
    const Geometries geometries = geometries_of(given);
    widen_thin_sources(prepared, geometries);
    blend_neighbours(given, prepared.planned);
    prepared.welds = plan_welds(given, prepared.plan);
    if (!is_whole(given))
        prepared.pairs = plan_pairs(given, prepared.plan);
    add_gauges(prepared);
    for (const PlannedLink& planned : prepared.planned)
        prepared.links.push_back(described_link(given, planned, boxes));
    add_problems(prepared);
    Preparation preparation(prepared, geometries, previous);
    for (int part = 0; part < static_cast<int>(given.parts.size()); ++part)
        preparation.add_part(part);
    for (std::size_t link = 0; link < prepared.links.size(); ++link)
        preparation.add_link(link);
    preparation.run(progress);
    if (is_whole(given))
        join(prepared, geometries, progress, previous);
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
