// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/whole/joined_parts.h"

#include "sheetmorph/assembly/assembly_checks.h"
#include "sheetmorph/assembly/whole/seams.h"
#include "sheetmorph/base/index.h"

#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

//! Lays the parts one after the other, in the order of the assembly, and everything on them.
class Joining
{
public:
    Joining(const Assembly& given, const PropagationPlan& plan) : given_(given)
    {
        joined_.first.assign(given.parts.size(), -1);
        for (const int part : plan.order)
            joined_.first[at(part)] = 0;
        lay_parts();
        Assembly& all = joined_.assembly;
        all.energy = given.energy;
        all.laplacian = given.laplacian;
        all.is_refined = given.is_refined;
        all.unheld = given.unheld;
        add(given.fixed, all.fixed);
        add(given.handles, all.handles);
        add_points();
        add_features();
    }

    JoinedParts joined(const PropagationPlan& plan, const std::vector<RigidWeld>& welds,
                       const std::vector<SeamPlaces>& places)
    {
        add_welds(welds);
        std::vector<Seam> seams;
        std::vector<TiedSeam> tied_seams;
        const std::vector<int> ranks = ranks_by_fineness(given_);
        for (std::size_t k = 0; k < plan.measured.size(); ++k)
        {
            const Contact& contact = given_.contacts[at(plan.measured[k].contact)];
            if (contact.type == ContactType::rigid)
                continue;
            seams.push_back({contact.name, moved(contact.a), moved(contact.b)});
            const PartRegion& source = plan.measured[k].source(given_);
            const PartRegion& target = plan.measured[k].target(given_);
            tied_seams.push_back(
                {moved(target),
                 moved(source),
                 {moved(source.part, places[k].of_target), moved(target.part, places[k].of_source)},
                 ranks[at(target.part)],
                 ranks[at(source.part)]});
        }
        Part& one = joined_.assembly.parts.front();
        one.stitches = stitched(joined_.assembly, seams);
        one.ties = tied(joined_.assembly, tied_seams);
        return std::move(joined_);
    }

private:
    bool is_reached(int part) const { return joined_.first[at(part)] >= 0; }

    VertexIds moved(const PartRegion& region) const { return moved(region.part, region.vertices); }

    VertexIds moved(int part, VertexIds vertices) const
    {
        for (int& vertex : vertices)
            vertex += joined_.first[at(part)];
        return vertices;
    }

    std::vector<mesh::Anchor> moved(int part, std::vector<mesh::Anchor> places) const
    {
        for (mesh::Anchor& place : places)
            for (int& corner : place.corners)
                corner += joined_.first[at(part)];
        return places;
    }

    // A joined part has the thickness and Poisson's ratio of none: only `steel` reads them.
    void lay_parts()
    {
        Eigen::Index vertices = 0, triangles = 0;
        for (std::size_t part = 0; part < given_.parts.size(); ++part)
            if (is_reached(static_cast<int>(part)))
            {
                vertices += given_.parts[part].mesh.vertex_count();
                triangles += given_.parts[part].mesh.triangle_count();
            }
        Points points(vertices, 3);
        Triangles corners(triangles, 3);
        Part one;
        vertices = triangles = 0;
        for (std::size_t part = 0; part < given_.parts.size(); ++part)
        {
            first_triangle_.push_back(static_cast<int>(triangles));
            if (!is_reached(static_cast<int>(part)))
                continue;
            const Part& own = given_.parts[part];
            joined_.first[part] = static_cast<int>(vertices);
            one.joined.push_back(joined_.first[part]);
            one.of.push_back({"part", own.name});
            for (int k = 0; k < own.mesh.vertex_count(); ++k)
                one.ids.push_back(own.ids.empty() ? k : own.ids[at(k)]);
            points.middleRows(vertices, own.mesh.vertex_count()) = own.mesh.points();
            corners.middleRows(triangles, own.mesh.triangle_count()) =
                own.mesh.triangles().array() + joined_.first[part];
            vertices += own.mesh.vertex_count();
            triangles += own.mesh.triangle_count();
        }
        one.name = name_of(one.of);
        one.mesh = {std::move(points), std::move(corners)};
        joined_.assembly.parts.push_back(std::move(one));
    }

    // "beam', 'box' and '3 more": messages put it between quotes.
    static std::string name_of(const std::vector<Subject>& parts)
    {
        std::string name;
        for (std::size_t k = 0; k < parts.size() && k < most_names; ++k)
            name += (k ? "', '" : "") + parts[k].name;
        if (parts.size() > most_names)
            name += "' and '" + std::to_string(parts.size() - most_names) + " more";
        return name;
    }

    template <typename OnPart>
    void add(const std::vector<OnPart>& given, std::vector<OnPart>& all) const
    {
        for (OnPart item : given)
            if (is_reached(item.part))
            {
                item.vertices = moved(item.part, std::move(item.vertices));
                item.part = 0;
                all.push_back(std::move(item));
            }
    }

    void add_points()
    {
        for (PartPoint point : given_.points)
        {
            point.constraint.triangle += first_triangle_[at(point.part)];
            point.part = 0;
            joined_.assembly.points.push_back(std::move(point));
        }
    }

    void add_features()
    {
        Assembly& all = joined_.assembly;
        for (const PartFeature& feature : given_.features)
        {
            joined_.features.push_back(
                is_reached(feature.part) ? static_cast<int>(all.features.size()) : -1);
            add<PartFeature>({feature}, all.features);
        }
        for (FeatureGroup group : given_.groups)
            if (is_reached(given_.features[at(group.features.front())].part))
            {
                for (int& feature : group.features)
                    feature = joined_.features[at(feature)];
                all.groups.push_back(std::move(group));
            }
        for (FeaturePair pair : given_.pairs)
            if (is_reached(given_.features[at(pair.a)].part))
            {
                pair.a = joined_.features[at(pair.a)];
                pair.b = joined_.features[at(pair.b)];
                all.pairs.push_back(std::move(pair));
            }
    }

    void add_welds(const std::vector<RigidWeld>& welds)
    {
        Assembly& all = joined_.assembly;
        joined_.welds = static_cast<int>(all.features.size());
        for (const RigidWeld& weld : welds)
        {
            PartFeature stack;
            stack.name = unused_name(all, weld.name);
            stack.of = weld.of;
            stack.vertices = moved(weld.source_part, weld.source);
            const VertexIds target = moved(weld.target_part, weld.target);
            stack.vertices.insert(stack.vertices.end(), target.begin(), target.end());
            all.features.push_back(std::move(stack));
        }
    }

    static constexpr std::size_t most_names = 4;  // chosen: a message stays on one line

    const Assembly& given_;
    JoinedParts joined_;
    std::vector<int> first_triangle_;
};

}  // namespace

JoinedParts joined_parts(const Assembly& assembly, const PropagationPlan& plan,
                         const std::vector<RigidWeld>& welds, const std::vector<SeamPlaces>& places)
{
    return Joining(assembly, plan).joined(plan, welds, places);
}

}  // namespace sheetmorph::assembly
