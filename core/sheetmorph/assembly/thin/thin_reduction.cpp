// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/thin/thin_reduction.h"

#include "sheetmorph/assembly/assembly_checks.h"
#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/search/picking.h"

#include <algorithm>
#include <map>

namespace sheetmorph::assembly
{

namespace
{

bool is_same_wish(const Part& a, const Part& b)
{
    return a.name == b.name && a.thin == b.thin && a.thickness == b.thickness
           && a.mesh.points().rows() == b.mesh.points().rows()
           && a.mesh.triangles().rows() == b.mesh.triangles().rows()
           && a.mesh.points() == b.mesh.points() && a.mesh.triangles() == b.mesh.triangles();
}

std::shared_ptr<const ThinPart> found_part(const Part& part)
{
    recognise::ThinFinding finding = recognise::find_thin_solid(part.mesh, part.thickness);
    if (finding.solid)
        return std::make_shared<const ThinPart>(part.mesh, std::move(*finding.solid));
    if (part.thin == Thin::yes)
        throw in_part(InvalidInput("it is not a thin solid: " + finding.reason), part);
    return nullptr;
}

//! The regions of one thin part, each on its skin.
class SkinRegions
{
public:
    explicit SkinRegions(const ThinPart& part)
        : part_(part),
          owner_(part.skin().vertices.size(), nullptr),
          claims_(at(part.mesh().vertex_count()), 0)
    {
    }

    template <typename Region>
    void claim(const Region& region)
    {
        for (const int vertex : part_.on_skin(region.vertices).own)
            owner_[at(vertex)] = &region;
        count(region.vertices);
    }

    void count(const VertexIds& vertices)
    {
        for (const int vertex : vertices)
            ++claims_[at(vertex)];
    }

    //! Skin vertices nearest to vertices that other regions have too: what touches on the whole
    //! part touches on its skin.
    VertexIds shared(const VertexIds& vertices) const
    {
        VertexIds found;
        for (const int vertex : vertices)
            if (const auto& anchors = part_.anchors(vertex);
                claims_[at(vertex)] > 1 && !anchors.empty())
            {
                Eigen::Index nearest = 0;
                anchors.front().weights.maxCoeff(&nearest);
                found.push_back(anchors.front().corners[static_cast<std::size_t>(nearest)]);
            }
        return found;
    }

    //! The region's own skin vertices, those below it that are nobody else's, and shared ones.
    template <typename Region>
    VertexIds of(const Region& region)
    {
        const SkinRegion found = part_.on_skin(region.vertices);
        VertexIds vertices = found.own;
        for (const int vertex : found.below)
            if (owner_[at(vertex)] == nullptr || owner_[at(vertex)] == &region)
            {
                owner_[at(vertex)] = &region;
                vertices.push_back(vertex);
            }
        if (vertices.empty())
            vertices = found.below;
        merge_into(vertices, shared(region.vertices));
        return vertices;
    }

private:
    const ThinPart& part_;
    std::vector<const void*> owner_;
    std::vector<int> claims_;  // by vertex of the whole part: how many regions have it
};

//! Moves everything on one thin part to its skin.
class Reduction
{
public:
    Reduction(const Assembly& whole, const ThinPart& thin, int part)
        : whole_(whole), thin_(thin), part_(part), regions_(thin)
    {
        each(whole_.fixed, [&](const auto& region, std::size_t) { regions_.claim(region); });
        each(whole_.handles, [&](const auto& region, std::size_t) { regions_.claim(region); });
        each(whole_.features, [&](const auto& region, std::size_t) { regions_.claim(region); });
        for (const Contact& contact : whole_.contacts)
            for (const PartRegion* side : {&contact.a, &contact.b})
                if (side->part == part_ && contact.type == ContactType::rigid)
                    regions_.count(side->vertices);
    }

    void write_to(Assembly& reduced)
    {
        write_mesh(reduced.parts[at(part_)]);
        move(whole_.fixed, reduced.fixed);
        move(whole_.handles, reduced.handles);
        move(whole_.features, reduced.features);
        each(whole_.followers, [&](const PartRegion& region, std::size_t k)
             { reduced.followers[k].vertices = every_vertex_below(region.vertices); });
        each(whole_.points, [&](const PartPoint& point, std::size_t k)
             { reduced.points[k].constraint = on_skin(point.constraint); });
        for (std::size_t k = 0; k < whole_.contacts.size(); ++k)
        {
            const bool is_rigid = whole_.contacts[k].type == ContactType::rigid;
            move_side(whole_.contacts[k].a, reduced.contacts[k].a, is_rigid);
            move_side(whole_.contacts[k].b, reduced.contacts[k].b, is_rigid);
        }
    }

private:
    template <typename Region, typename Work>
    void each(const std::vector<Region>& regions, Work work)
    {
        for (std::size_t k = 0; k < regions.size(); ++k)
            if (regions[k].part == part_)
                work(regions[k], k);
    }

    template <typename Region>
    void move(const std::vector<Region>& from, std::vector<Region>& to)
    {
        each(from,
             [&](const Region& region, std::size_t k) { to[k].vertices = regions_.of(region); });
    }

    void move_side(const PartRegion& from, PartRegion& to, bool is_rigid)
    {
        if (from.part != part_)
            return;
        to.vertices = every_vertex_below(from.vertices);
        if (is_rigid)
            merge_into(to.vertices, regions_.shared(from.vertices));
    }

    VertexIds every_vertex_below(const VertexIds& vertices) const
    {
        const SkinRegion found = thin_.on_skin(vertices);
        VertexIds all = found.own;
        all.insert(all.end(), found.below.begin(), found.below.end());
        std::sort(all.begin(), all.end());
        return all;
    }

    void write_mesh(Part& part) const
    {
        const VertexIds& vertices = thin_.skin().vertices;
        const std::vector<int> ids = part.ids;
        part.mesh = thin_.middle();
        if (part.sheet_thickness == 0.0)
            part.sheet_thickness = thin_.solid().thickness;
        part.ids = vertices;
        for (std::size_t k = 0; k < vertices.size() && !ids.empty(); ++k)
            part.ids[k] = ids[at(vertices[k])];
    }

    surface::PointConstraint on_skin(surface::PointConstraint point) const
    {
        const mesh::TriangleMesh& mesh = thin_.mesh();
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            place += point.barycentric(k)
                     * mesh.points().row(mesh.triangles()(point.triangle, k)).transpose();
        if (thin_.solid().facets[at(point.triangle)] == recognise::SolidSide::main)
        {
            const auto& facets = thin_.solid().facets;
            point.triangle = static_cast<int>(std::count(
                facets.begin(), facets.begin() + point.triangle, recognise::SolidSide::main));
            return point;
        }
        const mesh::Hit foot = *mesh::PickingTree(thin_.skin().mesh).nearest_point(place);
        point.triangle = foot.triangle;
        point.barycentric = foot.barycentric;
        return point;
    }

    const Assembly& whole_;
    const ThinPart& thin_;
    int part_;
    SkinRegions regions_;
};

// Features of one part that share vertices are one rigid body. On the skin they may share none, so
// that a group has to say it.
void group_touching_features(Assembly& assembly, int part)
{
    std::vector<int> first_owner(at(assembly.parts[at(part)].mesh.vertex_count()), -1);
    DisjointSets sets(static_cast<int>(assembly.features.size()));
    for (std::size_t k = 0; k < assembly.features.size(); ++k)
        for (const int vertex :
             assembly.features[k].part == part ? assembly.features[k].vertices : VertexIds())
        {
            int& owner = first_owner[at(vertex)];
            owner = owner < 0 ? static_cast<int>(k) : owner;
            sets.join(owner, static_cast<int>(k));
        }
    std::map<int, FeatureGroup> groups;
    for (int k = 0; k < static_cast<int>(assembly.features.size()); ++k)
        groups[sets.root(k)].features.push_back(k);
    for (auto& [first, group] : groups)
        if (group.features.size() > 1)
            assembly.groups.push_back(std::move(group));
}

}  // namespace

ThinParts find_thin_parts(const Assembly& assembly, const Assembly* earlier_assembly,
                          const ThinParts& earlier)
{
    ThinParts found;
    for (const Part& part : assembly.parts)
    {
        found.emplace_back();
        if (part.thin == Thin::no)
            continue;
        for (std::size_t k = 0; k < earlier.size() && !found.back(); ++k)
            if (is_same_wish(earlier_assembly->parts[k], part))
                found.back() = earlier[k];
        if (!found.back())
            found.back() = found_part(part);
    }
    return found;
}

Assembly with_lumps(Assembly assembly, const ThinParts& thin)
{
    for (PartFeature& feature : assembly.features)
        if (const auto& part = thin[at(feature.part)])
            feature.vertices = part->with_walls(feature.vertices);
    for (std::size_t part = 0; part < thin.size(); ++part)
        for (std::size_t k = 0; thin[part] && k < thin[part]->solid().lumps.size(); ++k)
        {
            PartFeature lump;
            lump.name =
                unused_name(assembly, assembly.parts[part].name + " lump " + std::to_string(k + 1));
            lump.part = static_cast<int>(part);
            lump.of = {{"part", assembly.parts[part].name}};
            lump.vertices = thin[part]->solid().lumps[k];
            assembly.features.push_back(lump);
        }
    for (std::size_t part = 0; part < thin.size(); ++part)
        if (thin[part])
            group_touching_features(assembly, static_cast<int>(part));
    return assembly;
}

Assembly reduced_to_skins(const Assembly& whole, const ThinParts& thin)
{
    Assembly reduced = whole;
    for (std::size_t part = 0; part < thin.size(); ++part)
        if (thin[part])
            Reduction(whole, *thin[part], static_cast<int>(part)).write_to(reduced);
    return reduced;
}

}  // namespace sheetmorph::assembly
