// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/link_plan.h"
#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/vertex_sets.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace sheetmorph::assembly
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

// The rigid body of each vertex of one part, -1 for none. Rigid shapes that touch form one body.
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
    for (const PartHandle& handle : assembly.handles)
        if (handle.part == part && handle.is_rotation_free)
            cover(handle.vertices);
    for (const FeatureGroup& group : assembly.groups)
        for (const int feature : group.features)
            if (assembly.features[at(feature)].part == part)
                sets.join(assembly.features[at(group.features.front())].vertices.front(),
                          assembly.features[at(feature)].vertices.front());
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

//! Rigid bodies of several parts, joined by rigid contacts. A stack moves as one.
class Stacks
{
public:
    Stacks(const Assembly& assembly, const PropagationPlan& plan)
        : assembly_(assembly),
          rigid_(rigid_contacts(assembly, plan)),
          sets_(static_cast<int>(rigid_.size())),
          rank_(assembly.parts.size())
    {
        // Parts that are not reached are not in the order; they follow at the end.
        for (std::size_t part = 0; part < rank_.size(); ++part)
            rank_[part] = static_cast<int>(plan.order.size() + part);
        for (std::size_t k = 0; k < plan.order.size(); ++k)
            rank_[at(plan.order[k])] = static_cast<int>(k);
        for (std::size_t k = 0; k < rigid_.size(); ++k)
            for (const PartRegion* side : sides_of(k))
            {
                if (clusters_.find(side->part) == clusters_.end())
                    clusters_[side->part] = rigid_clusters(assembly, side->part, rigid_);
                const std::pair body(side->part, clusters_[side->part][at(side->vertices.front())]);
                sets_.join(first_of_.emplace(body, static_cast<int>(k)).first->second,
                           static_cast<int>(k));
            }
    }

    //! Welds from the part of each stack that is deformed first to every other part.
    std::vector<RigidWeld> welds()
    {
        const std::set<int> held = held_stacks();
        std::vector<RigidWeld> found;
        for (int stack = 0; stack < static_cast<int>(rigid_.size()); ++stack)
        {
            if (sets_.root(stack) != stack)
                continue;
            const std::map<int, VertexIds> sides = sides_by_rank(stack);
            const auto& [first, source] = *sides.begin();
            for (auto side = std::next(sides.begin()); side != sides.end(); ++side)
            {
                RigidWeld weld;
                weld.contacts = contacts_of(stack);
                weld.source_part = part_at(first);
                weld.source = source;
                weld.target_part = part_at(side->first);
                weld.target = side->second;
                weld.is_held = held.count(stack) > 0;
                set_name(weld);
                found.push_back(std::move(weld));
            }
        }
        return found;
    }

private:
    std::array<const PartRegion*, 2> sides_of(std::size_t k) const
    {
        return {&rigid_[k].source(assembly_), &rigid_[k].target(assembly_)};
    }

    int part_at(int rank) const
    {
        return static_cast<int>(std::find(rank_.begin(), rank_.end(), rank) - rank_.begin());
    }

    // The sides of a stack, by the rank of their parts in the order of propagation.
    std::map<int, VertexIds> sides_by_rank(int stack)
    {
        std::map<int, VertexIds> found;
        for (std::size_t k = 0; k < rigid_.size(); ++k)
            if (sets_.root(static_cast<int>(k)) == stack)
                for (const PartRegion* side : sides_of(k))
                    merge_into(found[rank_[at(side->part)]], side->vertices);
        return found;
    }

    std::vector<int> contacts_of(int stack)
    {
        std::vector<int> found;
        for (std::size_t k = 0; k < rigid_.size(); ++k)
            if (sets_.root(static_cast<int>(k)) == stack)
                found.push_back(rigid_[k].contact);
        return found;
    }

    // Fixed stacks: with a vertex of a fixed region, or of a feature that is fixed.
    std::set<int> held_stacks()
    {
        std::set<int> found;
        for (const PartRegion& fixed : assembly_.fixed)
            add_touched(fixed.part, fixed.vertices, found);
        for (const PartFeature& feature : assembly_.features)
            if (feature.motion.type == surface::FeatureMotion::Type::fixed)
                add_touched(feature.part, feature.vertices, found);
        return found;
    }

    void add_touched(int part, const VertexIds& vertices, std::set<int>& stacks)
    {
        const auto clusters = clusters_.find(part);
        if (clusters == clusters_.end())
            return;
        for (const int vertex : vertices)
        {
            const auto first = first_of_.find({part, clusters->second[at(vertex)]});
            if (first != first_of_.end())
                stacks.insert(sets_.root(first->second));
        }
    }

    // Names the weld after some of the contacts on the part that it moves.
    void set_name(RigidWeld& weld) const
    {
        std::size_t count = 0;
        for (const int index : weld.contacts)
        {
            const Contact& contact = assembly_.contacts[at(index)];
            if (contact.a.part != weld.target_part && contact.b.part != weld.target_part)
                continue;
            weld.of.push_back({"contact", contact.name});
            if (count++ < most_names)
                weld.name += (weld.name.empty() ? "" : "' and '") + contact.name;
        }
        if (count > most_names)
            weld.name += "' and '" + std::to_string(count - most_names) + " more";
    }

    static constexpr std::size_t most_names = 4;  // chosen: a message stays on one line

    const Assembly& assembly_;
    std::vector<DirectedContact> rigid_;
    DisjointSets sets_;      // of rigid contacts; a set is a stack
    std::vector<int> rank_;  // by part
    std::map<int, std::vector<int>> clusters_;
    std::map<std::pair<int, int>, int> first_of_;  // by part and cluster: one of its rigid contacts
};

}  // namespace

std::vector<RigidWeld> plan_welds(const Assembly& assembly, const PropagationPlan& plan)
{
    return Stacks(assembly, plan).welds();
}

}  // namespace sheetmorph::assembly
