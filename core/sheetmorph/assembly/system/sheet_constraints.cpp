// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/system/sheet_constraints.h"

#include "sheetmorph/assembly/plan/feature_sizes.h"
#include "sheetmorph/base/index.h"

#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

//! Puts what the assembly says about the parts of one sheet on that sheet.
class Laying
{
public:
    Laying(const Assembly& assembly, const System& system, int index)
        : assembly_(assembly), system_(system), index_(index)
    {
    }

    bool is_here(int part) const { return system_.owners[at(part)].sheet == index_; }

    VertexIds moved(int part, VertexIds vertices) const
    {
        for (int& vertex : vertices)
            vertex += system_.owners[at(part)].first;
        return vertices;
    }

    template <typename OnPart>
    VertexIds moved(const OnPart& entry) const
    {
        return moved(entry.part, entry.vertices);
    }

    void lay_own(Sheet& sheet) const
    {
        surface::SurfaceConstraints& surface = sheet.surface;
        surface.energy = assembly_.energy;
        surface.is_refined = assembly_.is_refined;
        surface.laplacian = assembly_.laplacian;
        each(assembly_.fixed,
             [&](const PartRegion& fixed, int)
             {
                 surface.fixed.push_back({fixed.name, moved(fixed), "fixed region", false,
                                          subjects_of("fixed region", fixed)});
             });
        each(
            assembly_.handles,
            [&](const PartHandle& handle, int k)
            {
                surface.handles.push_back({handle.name, moved(handle), "handle",
                                           handle.is_rotation_free, subjects_of("handle", handle)});
                sheet.handles.push_back(k);
            });
        each(assembly_.features,
             [&](const PartFeature& feature, int k)
             {
                 surface.features.push_back({feature.name, moved(feature), feature.rotation,
                                             "feature", feature.motion, is_sized(feature),
                                             subjects_of("feature", feature)});
                 sheet.features.push_back(k);
             });
        each(assembly_.points,
             [&](const PartPoint& point, int k)
             {
                 surface.points.push_back(point.constraint);
                 surface.points.back().triangle += system_.owners[at(point.part)].first_triangle;
                 surface.points.back().name = point.name;
                 surface.points.back().of = subjects_of("point", point);
                 sheet.points.push_back(k);
             });
        lay_groups(sheet);
    }

    // A stack on this sheet alone is a body of it.
    void lay_welds(Sheet& sheet) const
    {
        std::vector<surface::FormFeature> held;
        for (std::size_t k = 0; k < system_.welds.size(); ++k)
        {
            const RigidWeld& weld = system_.welds[k];
            const bool is_source = is_here(weld.source_part), is_target = is_here(weld.target_part);
            const int index = static_cast<int>(k);
            if (!is_source && !is_target)
                continue;
            VertexIds side = is_source ? moved(weld.source_part, weld.source) : VertexIds();
            if (is_target)
                for (const int vertex : moved(weld.target_part, weld.target))
                    side.push_back(vertex);
            if (is_source && is_target)
                add_carrier(sheet, index, side);
            else if (weld.is_held)
            {
                sheet.surface.fixed.push_back(region_of(weld, side));
                // As a body, so that what else would move a part of it is refused.
                held.push_back(body_of(weld, side));
                sheet.held.push_back(index);
            }
            else if (is_target)
            {
                sheet.surface.handles.push_back(region_of(weld, side));
                sheet.carried.push_back(index);
            }
            else
                add_carrier(sheet, index, side);
        }
        sheet.surface.features.insert(sheet.surface.features.end(), held.begin(), held.end());
    }

    void lay_pairs(Sheet& sheet) const
    {
        for (const PlannedPair& pair : system_.pairs)
        {
            if (!is_here(assembly_.features[at(pair.follower)].part))
                continue;
            const bool is_led_here = is_here(assembly_.features[at(pair.leader)].part);
            surface::FeatureLink link;
            link.name = pair.name;
            link.of = pair.of;
            link.type = pair.type;
            link.follower = local_feature(sheet, pair.follower);
            link.leader = is_led_here ? local_feature(sheet, pair.leader) : -1;
            link.centre = pair.centre;
            link.direction = pair.direction;
            sheet.surface.links.push_back(link);
            sheet.leaders.push_back(is_led_here ? -1 : pair.leader);
        }
    }

private:
    template <typename OnPart, typename Work>
    void each(const std::vector<OnPart>& entries, const Work& work) const
    {
        for (std::size_t k = 0; k < entries.size(); ++k)
            if (is_here(entries[k].part))
                work(entries[k], static_cast<int>(k));
    }

    static int local_feature(const Sheet& sheet, int feature)
    {
        return static_cast<int>(std::find(sheet.features.begin(), sheet.features.end(), feature)
                                - sheet.features.begin());
    }

    void lay_groups(Sheet& sheet) const
    {
        for (const FeatureGroup& group : assembly_.groups)
        {
            if (!is_here(assembly_.features[at(group.features.front())].part))
                continue;
            sheet.surface.groups.emplace_back();
            for (const int feature : group.features)
                sheet.surface.groups.back().push_back(local_feature(sheet, feature));
        }
    }

    static surface::KnownRegion region_of(const RigidWeld& weld, const VertexIds& side)
    {
        return {weld.name, side, "rigid contact", false, weld.of};
    }

    static surface::FormFeature body_of(const RigidWeld& weld, const VertexIds& side)
    {
        return {weld.name, side,   surface::FeatureRotation::free, "rigid contact", {},
                false,     weld.of};
    }

    void add_carrier(Sheet& sheet, int weld, const VertexIds& side) const
    {
        sheet.surface.features.push_back(body_of(system_.welds[at(weld)], side));
        sheet.carriers.push_back(weld);
    }

    const Assembly& assembly_;
    const System& system_;
    int index_;
};

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

std::vector<Claim> claims_on(const Sheet& sheet, const Laying& laying,
                             const std::vector<PlannedLink>& links)
{
    std::vector<Claim> claims(at(sheet.mesh.vertex_count()));
    for (std::size_t k = 0; k < links.size(); ++k)
    {
        Eigen::Index row = 0;
        for (const LinkTarget& target : links[k].targets)
        {
            const bool is_here = laying.is_here(target.part);
            const VertexIds vertices = is_here ? laying.moved(target) : VertexIds();
            for (std::size_t v = 0; v < vertices.size(); ++v)
            {
                const double weight = target.weights.empty() ? 1.0 : target.weights[v];
                claim(claims, vertices[v],
                      {static_cast<int>(k), row + static_cast<Eigen::Index>(v), weight},
                      links[k].type);
            }
            row += static_cast<Eigen::Index>(target.vertices.size());
        }
    }
    return claims;
}

// A vertex belongs to the region of the first link that claims it.
void add_propagated(Sheet& sheet, const std::vector<Claim>& claims,
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
            region = static_cast<int>(sheet.propagated.size());
            sheet.propagated.emplace_back();
            std::vector<Subject> of;
            if (links[at(link)].contact >= 0)
                of.push_back({"contact", links[at(link)].name});
            sheet.surface.propagated.push_back(
                {links[at(link)].name, {}, "contact", false, std::move(of)});
        }
        sheet.surface.propagated[at(region)].vertices.push_back(static_cast<int>(vertex));
        sheet.propagated[at(region)].push_back(claims[vertex].rows);
    }
}

}  // namespace

void lay_constraints(const Assembly& assembly, const System& system, Sheet& sheet)
{
    const Laying laying(assembly, system, system.owners[at(sheet.parts.front())].sheet);
    laying.lay_own(sheet);
    laying.lay_welds(sheet);
    laying.lay_pairs(sheet);
    add_propagated(sheet, claims_on(sheet, laying, system.links), system.links);
}

}  // namespace sheetmorph::assembly
