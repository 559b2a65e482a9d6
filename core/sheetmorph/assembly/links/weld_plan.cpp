// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/link_plan.h"
#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"

#include <algorithm>
#include <map>

namespace sheetmorph
{

namespace
{

std::vector<DirectedContact> rigid_contacts(const Assembly& assembly, const PropagationPlan& plan)
{
    std::vector<DirectedContact> found;
    for (const DirectedContact& directed : plan.contacts)
        if (assembly.contacts[at(directed.contact)].type == ContactType::rigid)
            found.push_back(directed);
    return found;
}

// Rigid shapes of one part that touch are one body: which body each vertex is on, -1 for none.
std::vector<int> rigid_clusters(const Assembly& assembly, int part,
                                const std::vector<DirectedContact>& rigid)
{
    const int count = assembly.parts[at(part)].mesh.vertex_count();
    DisjointSets sets(count);
    std::vector<char> covered(at(count), 0);
    const auto cover = [&](const VertexIds& vertices)
    {
        for (const int vertex : vertices)
        {
            covered[at(vertex)] = 1;
            sets.join(vertices.front(), vertex);
        }
    };
    for (const PartFeature& feature : assembly.features)
        if (feature.part == part)
            cover(feature.vertices);
    for (const DirectedContact& directed : rigid)
        for (const PartRegion* side : {&directed.source(assembly), &directed.target(assembly)})
            if (side->part == part)
                cover(side->vertices);
    std::vector<int> cluster(at(count), -1);
    for (int i = 0; i < count; ++i)
        if (covered[at(i)])
            cluster[at(i)] = sets.root(i);
    return cluster;
}

void require_free_side(const Assembly& assembly, const DirectedContact& directed)
{
    const PartRegion& side = directed.target(assembly);
    VertexIds held;
    for (const PartRegion& fixed : assembly.fixed)
        if (fixed.part == side.part)
            for (const int vertex : side.vertices)
                if (std::find(fixed.vertices.begin(), fixed.vertices.end(), vertex)
                    != fixed.vertices.end())
                    held.push_back(vertex);
    if (!held.empty())
    {
        const Part& part = assembly.parts[at(side.part)];
        throw InvalidInput("rigid contact '" + assembly.contacts[at(directed.contact)].name
                               + "' should move vertices ",
                           held, ", which are fixed; take them out of one, or make it tied")
            .in_part(part.name, part.ids);
    }
}

void append(const Assembly& assembly, const DirectedContact& directed, RigidWeld& weld)
{
    const PartRegion& source = directed.source(assembly);
    const PartRegion& target = directed.target(assembly);
    weld.name +=
        (weld.name.empty() ? "" : "' and '") + assembly.contacts[at(directed.contact)].name;
    weld.contacts.push_back(directed.contact);
    weld.source_part = source.part;
    weld.target_part = target.part;
    weld.source.insert(weld.source.end(), source.vertices.begin(), source.vertices.end());
    weld.target.insert(weld.target.end(), target.vertices.begin(), target.vertices.end());
}

}  // namespace

std::vector<RigidWeld> plan_welds(const Assembly& assembly, const PropagationPlan& plan)
{
    const std::vector<DirectedContact> rigid = rigid_contacts(assembly, plan);
    std::map<int, std::vector<int>> clusters;
    for (const DirectedContact& directed : rigid)
        for (const PartRegion* side : {&directed.source(assembly), &directed.target(assembly)})
            if (clusters.find(side->part) == clusters.end())
                clusters[side->part] = rigid_clusters(assembly, side->part, rigid);

    // Two rigid contacts between the same parts are one weld if they touch one body on either side.
    DisjointSets groups(static_cast<int>(rigid.size()));
    std::map<std::vector<int>, int> first_of;
    for (std::size_t k = 0; k < rigid.size(); ++k)
    {
        require_free_side(assembly, rigid[k]);
        const PartRegion& source = rigid[k].source(assembly);
        const PartRegion& target = rigid[k].target(assembly);
        for (const PartRegion* side : {&source, &target})
        {
            const int body = clusters[side->part][at(side->vertices.front())];
            const std::vector<int> key = {source.part, target.part, side->part, body};
            groups.join(first_of.emplace(key, static_cast<int>(k)).first->second,
                        static_cast<int>(k));
        }
    }
    std::vector<RigidWeld> welds;
    std::vector<int> weld_of(rigid.size(), -1);
    for (std::size_t k = 0; k < rigid.size(); ++k)
    {
        int& weld = weld_of[at(groups.root(static_cast<int>(k)))];
        if (weld < 0)
        {
            weld = static_cast<int>(welds.size());
            welds.emplace_back();
        }
        append(assembly, rigid[k], welds[at(weld)]);
    }
    return welds;
}

}  // namespace sheetmorph
