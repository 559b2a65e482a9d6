// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/system/system.h"

#include "sheetmorph/assembly/links/patch_anchors.h"
#include "sheetmorph/assembly/plan/link_blending.h"
#include "sheetmorph/assembly/system/loose_pieces.h"
#include "sheetmorph/assembly/system/seam_ties.h"
#include "sheetmorph/assembly/system/sheet_constraints.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace sheetmorph::assembly
{

namespace
{

constexpr std::size_t most_names = 4;  // chosen: a message stays on one line

// "beam', 'box' and '3 more": messages put it between quotes.
std::string name_of(const std::vector<Subject>& parts)
{
    std::string name;
    for (std::size_t k = 0; k < parts.size() && k < most_names; ++k)
        name += (k ? "', '" : "") + parts[k].name;
    if (parts.size() > most_names)
        name += "' and '" + std::to_string(parts.size() - most_names) + " more";
    return name;
}

//! Lays the parts on sheets, in the order of the assembly, and everything on them.
class Building
{
public:
    explicit Building(const SystemInput& input) : input_(input), given_(input.assembly)
    {
        system_.plan = plan_propagation(given_);
        if (is_whole())
        {
            ranks_ = ranks_by_fineness(given_);
            lead_by_coarser(given_, ranks_, system_.plan);
            refuse_thin_points();
        }
        system_.links = plan_links(given_, system_.plan, input.boxes);
        widen_thin_sources();
        blend_neighbours(given_, system_.links);
        system_.welds = plan_welds(given_, system_.plan);
        system_.pairs = plan_pairs(given_, system_.plan);
        lay_parts();
    }

    System built()
    {
        for (Sheet& sheet : system_.sheets)
        {
            lay_constraints(given_, system_, sheet);
            if (sheet.parts.size() > 1)
                lay_seams(sheet);
            hold_loose_pieces(given_.unheld, sheet);
            add_owners(sheet);
        }
        add_stages();
        return std::move(system_);
    }

private:
    bool is_whole() const { return given_.propagation.type == PropagationType::whole; }

    // A point of a thin solid lies off the middle: it is met in rounds, part by part.
    void refuse_thin_points() const
    {
        for (const PartPoint& point : given_.points)
            if (input_.is_thin[at(point.part)])
                throw in_part(
                    {label_of("point", point)
                         + " lies on a thin solid, which the propagation 'whole' does not "
                           "support",
                     "use a handle of vertices, or \"thin\": false"},
                    given_.parts[at(point.part)]);
    }

    // What touches by its wall is a row of vertices in the middle of the sheet, and a tie holds on
    // to triangles.
    void widen_thin_sources()
    {
        for (PlannedLink& link : system_.links)
            if (link.type == ContactType::tied && input_.is_thin[at(link.source_part)])
                link.source = with_triangles_below(input_.geometries[at(link.source_part)],
                                                   link.source, target_points(given_, link));
    }

    void lay_parts()
    {
        system_.owners.resize(given_.parts.size());
        std::vector<int> reached = system_.plan.order;
        std::sort(reached.begin(), reached.end());
        if (is_whole())
            lay_on_sheet(reached);
        for (int part = 0; part < static_cast<int>(given_.parts.size()); ++part)
            if (!is_whole() || !std::binary_search(reached.begin(), reached.end(), part))
                lay_on_sheet({part});
    }

    void lay_on_sheet(const std::vector<int>& parts)
    {
        Sheet sheet;
        sheet.parts = parts;
        int vertices = 0, triangles = 0;
        for (const int part : parts)
        {
            const mesh::TriangleMesh& mesh = given_.parts[at(part)].mesh;
            system_.owners[at(part)] = {static_cast<int>(system_.sheets.size()),
                                        vertices,
                                        triangles,
                                        mesh.vertex_count(),
                                        {},
                                        {},
                                        {}};
            sheet.first.push_back(vertices);
            sheet.of.push_back({"part", given_.parts[at(part)].name});
            vertices += mesh.vertex_count();
            triangles += mesh.triangle_count();
        }
        sheet.name = name_of(sheet.of);
        if (parts.size() == 1)
            lay_alone(given_.parts[at(parts.front())], sheet);
        else
            lay_together(vertices, triangles, sheet);
        system_.sheets.push_back(std::move(sheet));
    }

    static void lay_alone(const Part& part, Sheet& sheet)
    {
        sheet.mesh = part.mesh;
        sheet.ids = part.ids;
        sheet.surface.thickness = part.sheet_thickness;
        sheet.surface.poisson = part.poisson;
    }

    // Together parts have the thickness and Poisson's ratio of none: only `steel` reads them.
    void lay_together(int vertices, int triangles, Sheet& sheet) const
    {
        Points points(vertices, 3);
        Triangles corners(triangles, 3);
        for (const int index : sheet.parts)
        {
            const Part& part = given_.parts[at(index)];
            const Owner& owner = system_.owners[at(index)];
            points.middleRows(owner.first, owner.count) = part.mesh.points();
            corners.middleRows(owner.first_triangle, part.mesh.triangle_count()) =
                part.mesh.triangles().array() + owner.first;
            for (int k = 0; k < owner.count; ++k)
                sheet.ids.push_back(part.ids.empty() ? k : part.ids[at(k)]);
        }
        sheet.mesh = {std::move(points), std::move(corners)};
    }

    VertexIds moved(const PartRegion& region) const
    {
        VertexIds vertices = region.vertices;
        for (int& vertex : vertices)
            vertex += system_.owners[at(region.part)].first;
        return vertices;
    }

    // What touches a thin solid by its wall, or a row of vertices that a seam is, touches triangles
    // that the side has not whole.
    std::vector<mesh::Anchor> places_on(const PartRegion& below, const PartRegion& region) const
    {
        const mesh::PartGeometry& geometry = input_.geometries[at(below.part)];
        const Points points = rows_of(given_.parts[at(region.part)].mesh.points(), region.vertices);
        const bool is_wide =
            input_.is_thin[at(below.part)] || !has_triangles(geometry, below.vertices);
        std::vector<mesh::Anchor> places = nearest_anchors(
            geometry,
            is_wide ? with_triangles_below(geometry, below.vertices, points) : below.vertices,
            points);
        for (mesh::Anchor& place : places)
            for (int& corner : place.corners)
                corner += system_.owners[at(below.part)].first;
        return places;
    }

    void lay_seams(Sheet& sheet) const
    {
        std::vector<Seam> seams;
        for (const DirectedContact& directed : system_.plan.measured)
        {
            const Contact& contact = given_.contacts[at(directed.contact)];
            if (contact.type == ContactType::rigid)
                continue;
            const PartRegion& source = directed.source(given_);
            const PartRegion& target = directed.target(given_);
            seams.push_back({contact.name, moved(target), moved(source), places_on(source, target),
                             places_on(target, source), ranks_[at(target.part)],
                             ranks_[at(source.part)]});
        }
        sheet.surface.stitches = stitched(sheet, seams);
        sheet.surface.ties = tied(sheet, seams);
    }

    void add_owners(const Sheet& sheet)
    {
        const auto each_part = [&](const VertexIds& vertices, const auto& work)
        {
            std::set<int> parts;
            for (const int vertex : vertices)
                parts.insert(sheet.part_of(vertex));
            for (const int part : parts)
                work(system_.owners[at(part)]);
        };
        for (const int feature : sheet.features)
            system_.owners[at(given_.features[at(feature)].part)].features.push_back(feature);
        for (std::size_t k = 0; k < sheet.surface.features.size(); ++k)
            each_part(sheet.surface.features[k].vertices,
                      [&](Owner& owner) { owner.bodies.push_back(static_cast<int>(k)); });
        for (std::size_t k = 0; k < sheet.surface.handles.size(); ++k)
            each_part(sheet.surface.handles[k].vertices,
                      [&](Owner& owner) { owner.handles.push_back(static_cast<int>(k)); });
    }

    // A stage after the last that moves it.
    void add_stages()
    {
        std::vector<std::size_t> stage(system_.sheets.size(), 0);
        for (const int part : system_.plan.order)
        {
            const int index = system_.sheet_of(part);
            if (std::count(system_.order.begin(), system_.order.end(), index) > 0)
                continue;
            const Sheet& sheet = system_.sheets[at(index)];
            const auto follow = [&](int earlier)
            { stage[at(index)] = std::max(stage[at(index)], stage[at(earlier)] + 1); };
            for (const PlannedLink& link : system_.links)
                for (const LinkTarget& target : link.targets)
                    if (system_.sheet_of(target.part) == index)
                        follow(system_.sheet_of(link.source_part));
            for (const int weld : sheet.carried)
                follow(system_.sheet_of(system_.welds[at(weld)].source_part));
            for (const int leader : sheet.leaders)
                if (leader >= 0)
                    follow(system_.sheet_of(given_.features[at(leader)].part));
            system_.order.push_back(index);
            system_.stages.resize(std::max(system_.stages.size(), stage[at(index)] + 1));
            system_.stages[stage[at(index)]].push_back(index);
        }
    }

    const SystemInput& input_;
    const Assembly& given_;
    System system_;
    std::vector<int> ranks_;  // by part, where all are answered at once
};

}  // namespace

VertexIds Owner::own(const VertexIds& vertices) const
{
    VertexIds found;
    for (const int vertex : vertices)
        if (vertex >= first && vertex < first + count)
            found.push_back(vertex - first);
    return found;
}

System plan_system(const SystemInput& input)
{
    return Building(input).built();
}

}  // namespace sheetmorph::assembly
