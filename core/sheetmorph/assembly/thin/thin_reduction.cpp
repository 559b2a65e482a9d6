// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/thin/thin_reduction.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/search/picking.h"

#include <algorithm>

namespace sheetmorph
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
    ThinFinding finding = find_thin_solid(part.mesh, part.thickness);
    if (finding.solid)
        return std::make_shared<const ThinPart>(part.mesh, std::move(*finding.solid));
    if (part.thin == Thin::yes)
        throw InvalidInput("part '" + part.name + "': it is no thin solid: " + finding.reason);
    return nullptr;
}

//! The regions of one thin part, each on its skin.
class SkinRegions
{
public:
    explicit SkinRegions(const ThinPart& part)
        : part_(part), owner_(part.skin().vertices.size(), nullptr)
    {
    }

    template <typename Region>
    void claim(const Region& region)
    {
        for (const int vertex : part_.on_skin(region.vertices).own)
            owner_[at(vertex)] = &region;
    }

    //! The region's own skin vertices, and those below it that are nobody else's.
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
        std::sort(vertices.begin(), vertices.end());
        return vertices;
    }

private:
    const ThinPart& part_;
    std::vector<const void*> owner_;
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
            move_side(whole_.contacts[k].a, reduced.contacts[k].a);
            move_side(whole_.contacts[k].b, reduced.contacts[k].b);
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

    void move_side(const PartRegion& from, PartRegion& to)
    {
        if (from.part == part_)
            to.vertices = every_vertex_below(from.vertices);
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
        part.ids = vertices;
        for (std::size_t k = 0; k < vertices.size() && !ids.empty(); ++k)
            part.ids[k] = ids[at(vertices[k])];
    }

    PointConstraint on_skin(PointConstraint point) const
    {
        const TriangleMesh& mesh = thin_.mesh();
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            place += point.barycentric(k)
                     * mesh.points().row(mesh.triangles()(point.triangle, k)).transpose();
        if (thin_.solid().facets[at(point.triangle)] == SolidSide::main)
        {
            const auto& facets = thin_.solid().facets;
            point.triangle = static_cast<int>(
                std::count(facets.begin(), facets.begin() + point.triangle, SolidSide::main));
            return point;
        }
        const Hit foot = *PickingTree(thin_.skin().mesh).nearest_point(place);
        point.triangle = foot.triangle;
        point.barycentric = foot.barycentric;
        return point;
    }

    const Assembly& whole_;
    const ThinPart& thin_;
    int part_;
    SkinRegions regions_;
};

std::string unused_name(const Assembly& assembly, const std::string& wanted)
{
    std::string name = wanted;
    const auto is_taken = [&](const PartFeature& feature) { return feature.name == name; };
    while (std::any_of(assembly.features.begin(), assembly.features.end(), is_taken))
        name += "'";
    return name;
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
            lump.vertices = thin[part]->solid().lumps[k];
            assembly.features.push_back(lump);
        }
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

}  // namespace sheetmorph
