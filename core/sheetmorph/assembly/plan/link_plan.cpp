// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/link_plan.h"

#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/topology/boundary.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace sheetmorph::assembly
{

namespace
{

VertexIds all_vertices(const Part& part)
{
    VertexIds ids(at(part.mesh.vertex_count()));
    std::iota(ids.begin(), ids.end(), 0);
    return ids;
}

bool has_features(const Assembly& assembly, int part)
{
    return std::any_of(assembly.features.begin(), assembly.features.end(),
                       [&](const PartFeature& feature) { return feature.part == part; });
}

// Boundary vertices that neither a region nor a feature of the part holds.
VertexIds unconstrained_boundary(const Assembly& assembly, int part)
{
    const mesh::TriangleMesh& mesh = assembly.parts[at(part)].mesh;
    std::vector<char> is_open(at(mesh.vertex_count()), 0);
    for (const mesh::BoundaryEdge& edge : mesh::boundary_edges(mesh))
        is_open[at(edge.from)] = is_open[at(edge.to)] = 1;
    const auto close = [&](const auto& regions)
    {
        for (const auto& region : regions)
            if (region.part == part)
                for (const int vertex : region.vertices)
                    is_open[at(vertex)] = 0;
    };
    close(assembly.fixed);
    close(assembly.handles);
    close(assembly.features);
    VertexIds found;
    for (int i = 0; i < mesh.vertex_count(); ++i)
        if (is_open[at(i)])
            found.push_back(i);
    return found;
}

[[noreturn]] void refuse_closed_part(const Part& part)
{
    throw in_part({"mode 3 finds no unconstrained boundary vertex to drive",
                   "use mode 2 and mark regions or contacts"},
                  part);
}

VertexIds follower_vertices(const Assembly& assembly, int part)
{
    VertexIds found;
    for (const PartRegion& region : assembly.followers)
        if (region.part == part)
            merge_into(found, region.vertices);
    return found;
}

VertexIds single_targets(const Assembly& assembly, int part)
{
    const Part& of = assembly.parts[at(part)];
    const bool featured = has_features(assembly, part);
    Mode mode = of.mode;
    if (mode == Mode::automatic)
        mode = featured ? Mode::boundaries : Mode::all;
    if (mode == Mode::all && featured)
        throw in_part({"mode 1 would bend its features", "use mode 2 or 3"}, of);
    if (mode == Mode::all)
        return all_vertices(of);
    VertexIds found = mode == Mode::regions ? follower_vertices(assembly, part)
                                            : unconstrained_boundary(assembly, part);
    if (found.empty() && mode == Mode::boundaries)
        refuse_closed_part(of);
    if (found.empty())
        throw in_part(
            InvalidInput("mode 2 with a single control mesh needs a region of role follower"), of);
    return found;
}

std::vector<PlannedLink> single_link(const Assembly& assembly)
{
    PlannedLink link;
    link.name = "single control mesh";
    link.source_part = assembly.primary;
    link.source = all_vertices(assembly.parts[at(assembly.primary)]);
    for (int part = 0; part < static_cast<int>(assembly.parts.size()); ++part)
        if (part != assembly.primary)
            link.targets.push_back({part, single_targets(assembly, part)});
    if (link.targets.empty())
        return {};
    return {link};
}

// Mode 1 decides every vertex from one place, so there must be only one, and nothing rigid.
void require_mode_all(const Assembly& assembly, int part, std::size_t contacts)
{
    const Part& of = assembly.parts[at(part)];
    if (has_features(assembly, part))
        throw in_part({"mode 1 would bend its features", "use mode 2"}, of);
    if (contacts != 1)
        throw in_part({"mode 1 works with one contact, this part has " + std::to_string(contacts),
                       "use mode 2"},
                      of);
}

Points both_sides(const Assembly& assembly, const PlannedLink& link, int target_part)
{
    return stacked(rows_of(assembly.parts[at(link.source_part)].mesh.points(), link.source),
                   rows_of(assembly.parts[at(target_part)].mesh.points(), link.enclosed));
}

// The unconstrained boundary vertices inside the box around both sides of a contact.
VertexIds inside_both_sides(const Assembly& assembly, const PlannedLink& link, int part,
                            const ControlBoxes& boxes)
{
    const VertexIds candidates = unconstrained_boundary(assembly, part);
    const volume::OrientedBox box =
        boxes.around(both_sides(assembly, link, part), link.source_part);
    const std::vector<char> is_inside =
        inside(box, rows_of(assembly.parts[at(part)].mesh.points(), candidates));
    VertexIds found;
    for (std::size_t k = 0; k < candidates.size(); ++k)
        if (is_inside[k])
            found.push_back(candidates[k]);
    return found;
}

PlannedLink local_link(const Assembly& assembly, const DirectedContact& directed,
                       const ControlBoxes& boxes)
{
    const PartRegion& source = directed.source(assembly);
    const PartRegion& target = directed.target(assembly);
    const Contact& contact = assembly.contacts[at(directed.contact)];
    PlannedLink link;
    link.name = contact.name;
    link.contact = directed.contact;
    link.type = contact.type;
    link.source_part = source.part;
    link.source = source.vertices;
    link.enclosed = target.vertices;
    const Part& part = assembly.parts[at(target.part)];
    VertexIds vertices = target.vertices;
    if (part.mode == Mode::all)
        vertices = all_vertices(part);
    else if (part.mode == Mode::boundaries && contact.type == ContactType::control_mesh)
        vertices = inside_both_sides(assembly, link, target.part, boxes);
    link.targets = {{target.part, vertices}};
    return link;
}

double distance_to(const mesh::TriangleMesh& mesh, const VertexIds& from, const VertexIds& to)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const int a : from)
        for (const int b : to)
            nearest = std::min(nearest, (mesh.points().row(a) - mesh.points().row(b)).norm());
    return nearest;
}

// A follower region goes with the nearest contact of its part.
void add_followers(const Assembly& assembly, std::vector<PlannedLink>& links)
{
    for (const PartRegion& follower : assembly.followers)
    {
        PlannedLink* nearest = nullptr;
        double shortest = std::numeric_limits<double>::infinity();
        const mesh::TriangleMesh& mesh = assembly.parts[at(follower.part)].mesh;
        for (PlannedLink& link : links)
            if (link.targets.front().part == follower.part)
            {
                const double gap = distance_to(mesh, follower.vertices, link.enclosed);
                if (gap < shortest)
                {
                    shortest = gap;
                    nearest = &link;
                }
            }
        if (nearest == nullptr)
            throw InvalidInput(label_of("follower", follower) + " on part '"
                                   + assembly.parts[at(follower.part)].name
                                   + "' has no contact to follow",
                               "add one of type control mesh or tied");
        VertexIds& vertices = nearest->targets.front().vertices;
        merge_into(vertices, follower.vertices);
    }
}

void require_boundary_found(const Assembly& assembly, const std::vector<PlannedLink>& links)
{
    for (const PlannedLink& link : links)
        if (link.targets.front().vertices.empty())
            refuse_closed_part(assembly.parts[at(link.targets.front().part)]);
}

}  // namespace

std::vector<PlannedLink> plan_links(const Assembly& assembly, const PropagationPlan& plan,
                                    const ControlBoxes& boxes)
{
    if (assembly.propagation.type == PropagationType::single)
        return single_link(assembly);
    if (assembly.propagation.type == PropagationType::whole)
        return {};
    std::vector<PlannedLink> links;
    for (const int part : plan.order)
    {
        const std::vector<DirectedContact> incoming = plan.into(assembly, part);
        if (assembly.parts[at(part)].mode == Mode::all && !incoming.empty())
            require_mode_all(assembly, part, incoming.size());
        for (const DirectedContact& directed : incoming)
            if (assembly.contacts[at(directed.contact)].type != ContactType::rigid)
                links.push_back(local_link(assembly, directed, boxes));
    }
    std::sort(links.begin(), links.end(),
              [](const PlannedLink& a, const PlannedLink& b) { return a.name < b.name; });
    require_boundary_found(assembly, links);
    add_followers(assembly, links);
    return links;
}

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

volume::OrientedBox box_of_link(const Assembly& assembly, const PlannedLink& link,
                                const ControlBoxes& boxes)
{
    if (link.contact < 0)
        return boxes.around_everything();
    const LinkTarget& target = link.targets.front();
    const Points targets = rows_of(assembly.parts[at(target.part)].mesh.points(), target.vertices);
    return boxes.around(stacked(both_sides(assembly, link, target.part), targets),
                        link.source_part);
}

}  // namespace sheetmorph::assembly
