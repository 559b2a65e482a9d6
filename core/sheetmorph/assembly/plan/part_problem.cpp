// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/part_problem.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/rotation.h"

#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

void add_carrier(PartProblem& problem, int index, const RigidWeld& weld, const VertexIds& side)
{
    problem.own.surface.features.push_back(
        {weld.name, side, surface::FeatureRotation::free, "rigid contact", {}, false, weld.of});
    problem.carriers.push_back(index);
}

void add_welds(PartProblem& problem, int part, const std::vector<RigidWeld>& welds)
{
    std::vector<surface::FormFeature> held;
    for (std::size_t k = 0; k < welds.size(); ++k)
    {
        const RigidWeld& weld = welds[k];
        if (weld.is_held && (weld.target_part == part || weld.source_part == part))
        {
            const VertexIds& side = weld.target_part == part ? weld.target : weld.source;
            problem.own.surface.fixed.push_back({weld.name, side, "rigid contact", false, weld.of});
            // As a body, so that what else would move a part of it is refused.
            held.push_back({weld.name,
                            side,
                            surface::FeatureRotation::free,
                            "rigid contact",
                            {},
                            false,
                            weld.of});
            problem.held.push_back(static_cast<int>(k));
            continue;
        }
        if (weld.target_part == part)
        {
            problem.own.surface.handles.push_back(
                {weld.name, weld.target, "rigid contact", false, weld.of});
            problem.carried.push_back(static_cast<int>(k));
        }
        if (weld.source_part == part)
            add_carrier(problem, static_cast<int>(k), weld, weld.source);
    }
    problem.own.surface.features.insert(problem.own.surface.features.end(), held.begin(),
                                        held.end());
}

void add_pairs(const Assembly& assembly, int part, const std::vector<PlannedPair>& pairs,
               PartProblem& problem)
{
    for (const PlannedPair& pair : pairs)
    {
        if (assembly.features[at(pair.follower)].part != part)
            continue;
        const bool is_led_here = assembly.features[at(pair.leader)].part == part;
        surface::FeatureLink link;
        link.name = pair.name;
        link.of = pair.of;
        link.type = pair.type;
        link.follower = local_feature(problem.own, pair.follower);
        link.leader = is_led_here ? local_feature(problem.own, pair.leader) : -1;
        link.centre = pair.centre;
        link.direction = pair.direction;
        problem.own.surface.links.push_back(link);
        problem.own.leaders.push_back(is_led_here ? -1 : pair.leader);
    }
}

//! The rows that want one vertex, all of the highest rank.
struct Claim
{
    std::vector<LinkRow> rows;
    ContactType type = ContactType::control_mesh;
};

void claim(std::vector<Claim>& claims, int vertex, const LinkRow& row, ContactType type)
{
    Claim& of_vertex = claims[at(vertex)];
    if (!of_vertex.rows.empty() && of_vertex.type != type)
    {
        if (type != ContactType::tied)
            return;
        of_vertex.rows.clear();
    }
    of_vertex.type = type;
    of_vertex.rows.push_back(row);
}

std::vector<Claim> claims_on(const Assembly& assembly, int part,
                             const std::vector<PlannedLink>& links)
{
    std::vector<Claim> claims(at(assembly.parts[at(part)].mesh.vertex_count()));
    for (std::size_t k = 0; k < links.size(); ++k)
    {
        Eigen::Index row = 0;
        for (const LinkTarget& target : links[k].targets)
            for (std::size_t v = 0; v < target.vertices.size(); ++v, ++row)
            {
                const double weight = target.weights.empty() ? 1.0 : target.weights[v];
                if (target.part == part)
                    claim(claims, target.vertices[v], {static_cast<int>(k), row, weight},
                          links[k].type);
            }
    }
    return claims;
}

// A vertex belongs to the region of the first link that claims it.
void add_propagated(PartProblem& problem, const std::vector<Claim>& claims,
                    const std::vector<PlannedLink>& links)
{
    std::vector<int> region_of(links.size(), -1);
    for (std::size_t vertex = 0; vertex < claims.size(); ++vertex)
    {
        if (claims[vertex].rows.empty())
            continue;
        const int link = claims[vertex].rows.front().link;
        int& region = region_of[at(link)];
        if (region < 0)
        {
            region = static_cast<int>(problem.propagated.size());
            problem.propagated.emplace_back();
            std::vector<Subject> of;
            if (links[at(link)].contact >= 0)
                of.push_back({"contact", links[at(link)].name});
            problem.own.surface.propagated.push_back(
                {links[at(link)].name, {}, "contact", false, std::move(of)});
        }
        problem.own.surface.propagated[at(region)].vertices.push_back(static_cast<int>(vertex));
        problem.propagated[at(region)].push_back(claims[vertex].rows);
    }
}

Eigen::RowVector3d mean_row(const std::vector<LinkRow>& rows, const EarlierParts& earlier,
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

Matrix3 mean_rotation(const std::vector<LinkRow>& rows, const EarlierParts& earlier)
{
    Matrix3 sum = Matrix3::Zero();
    for (const LinkRow& row : rows)
        sum += row.weight * earlier.links[at(row.link)].rotation(row.row);
    return rows.size() == 1 ? sum : nearest_rotation(sum);
}

// Of one row alone, whose rotation is its log's.
bool is_told_by_log(const std::vector<LinkRow>& rows, const EarlierParts& earlier)
{
    return rows.size() == 1 && earlier.links[at(rows.front().link)].rotations.empty();
}

}  // namespace

PartProblem problem_of_part(const Assembly& assembly, int part, const Passages& passages)
{
    PartProblem problem;
    problem.own = constraints_of_part(assembly, part);
    add_welds(problem, part, passages.welds);
    add_pairs(assembly, part, passages.pairs, problem);
    add_propagated(problem, claims_on(assembly, part, passages.links), passages.links);
    return problem;
}

PartProblem problem_in_whole(const Assembly& assembly, int part,
                             const std::vector<RigidWeld>& welds)
{
    PartProblem problem;
    problem.own = constraints_of_part(assembly, part);
    for (std::size_t k = 0; k < welds.size(); ++k)
        if (welds[k].source_part == part || welds[k].target_part == part)
            add_carrier(problem, static_cast<int>(k), welds[k],
                        welds[k].source_part == part ? welds[k].source : welds[k].target);
    return problem;
}

surface::SurfaceTargets targets_in_order(const Assembly& assembly, const PartProblem& problem,
                                         const Pose& pose, const EarlierParts& earlier)
{
    surface::SurfaceTargets targets = targets_of_part(assembly, problem.own, pose);
    for (const int weld : problem.carried)
        targets.handles.push_back(earlier.welds[at(weld)]);
    targets.feature_logs.resize(problem.own.surface.features.size(), Vector3::Zero());
    targets.sizes.resize(problem.own.surface.features.size());
    for (const int leader : problem.own.leaders)
        targets.leaders.push_back(leader < 0 ? RigidMotion{} : earlier.features[at(leader)]);
    for (const auto& region : problem.propagated)
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

double spread_of_targets(const PartProblem& problem, const EarlierParts& earlier)
{
    const auto target = [&](const LinkRow& row)
    { return earlier.links[at(row.link)].positions.row(row.row); };
    double worst = 0.0;
    for (const auto& region : problem.propagated)
        for (const std::vector<LinkRow>& rows : region)
            for (const LinkRow& a : rows)
                for (const LinkRow& b : rows)
                    worst = std::max(worst, (target(a) - target(b)).norm());
    return worst;
}

}  // namespace sheetmorph::assembly
