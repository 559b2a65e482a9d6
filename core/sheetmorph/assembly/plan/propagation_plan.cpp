// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/propagation_plan.h"

#include "sheetmorph/assembly/plan/feature_sizes.h"
#include "sheetmorph/base/index.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph::assembly
{

namespace
{

std::vector<std::vector<int>> neighbours(const Assembly& assembly)
{
    std::vector<std::vector<int>> found(assembly.parts.size());
    for (const Contact& contact : assembly.contacts)
    {
        found[at(contact.a.part)].push_back(contact.b.part);
        found[at(contact.b.part)].push_back(contact.a.part);
    }
    for (const FeaturePair& pair : assembly.pairs)
    {
        const int a = assembly.features[at(pair.a)].part;
        const int b = assembly.features[at(pair.b)].part;
        if (a == b)
            continue;
        found[at(a)].push_back(b);
        found[at(b)].push_back(a);
    }
    return found;
}

std::vector<int> parts_by_name(const Assembly& assembly)
{
    std::vector<int> parts(assembly.parts.size());
    std::iota(parts.begin(), parts.end(), 0);
    std::sort(parts.begin(), parts.end(),
              [&](int a, int b)
              { return assembly.parts[at(a)].name < assembly.parts[at(b)].name; });
    return parts;
}

// Adds everything that can be reached from `root`, level by level.
void reach_from(int root, const Assembly& assembly, PropagationPlan& plan)
{
    const std::vector<std::vector<int>> touching = neighbours(assembly);
    const auto by_name = [&](int a, int b)
    { return assembly.parts[at(a)].name < assembly.parts[at(b)].name; };
    std::vector<int> front = {root};
    for (int depth = 0; !front.empty(); ++depth)
    {
        std::vector<int> next;
        for (const int part : front)
        {
            plan.level[at(part)] = depth;
            plan.order.push_back(part);
        }
        for (const int part : front)
            for (const int other : touching[at(part)])
                if (plan.level[at(other)] < 0
                    && std::find(next.begin(), next.end(), other) == next.end())
                    next.push_back(other);
        std::sort(next.begin(), next.end(), by_name);
        front = std::move(next);
    }
}

void direct_contacts(const Assembly& assembly, PropagationPlan& plan)
{
    std::vector<int> rank(assembly.parts.size(), -1);
    for (std::size_t k = 0; k < plan.order.size(); ++k)
        rank[at(plan.order[k])] = static_cast<int>(k);
    for (std::size_t k = 0; k < assembly.contacts.size(); ++k)
    {
        const int rank_a = rank[at(assembly.contacts[k].a.part)];
        const int rank_b = rank[at(assembly.contacts[k].b.part)];
        if (rank_a >= 0 && rank_b >= 0)
            plan.measured.push_back({static_cast<int>(k), rank_b < rank_a});
    }
    if (assembly.propagation.type != PropagationType::single)
        plan.contacts = plan.measured;
}

// Whether a pose can move a part by what is on it.
bool has_driver(const Assembly& assembly, int part)
{
    const auto is_here = [part](const auto& entry) { return entry.part == part; };
    const auto moves = [&](const PartFeature& feature)
    {
        return is_here(feature)
               && (feature.rotation == surface::FeatureRotation::prescribed || is_sized(feature));
    };
    return std::any_of(assembly.handles.begin(), assembly.handles.end(), is_here)
           || std::any_of(assembly.points.begin(), assembly.points.end(), is_here)
           || std::any_of(assembly.features.begin(), assembly.features.end(), moves);
}

void reach_all(const Assembly& assembly, PropagationPlan& plan)
{
    plan.order.push_back(assembly.primary);
    plan.level[at(assembly.primary)] = 0;
    for (int part = 0; part < static_cast<int>(assembly.parts.size()); ++part)
        if (part != assembly.primary)
        {
            plan.order.push_back(part);
            plan.level[at(part)] = 1;
        }
}

}  // namespace

const PartRegion& DirectedContact::source(const Assembly& assembly) const
{
    const Contact& given = assembly.contacts[at(contact)];
    return is_reversed ? given.b : given.a;
}

const PartRegion& DirectedContact::target(const Assembly& assembly) const
{
    const Contact& given = assembly.contacts[at(contact)];
    return is_reversed ? given.a : given.b;
}

std::vector<DirectedContact> PropagationPlan::into(const Assembly& assembly, int part) const
{
    std::vector<DirectedContact> found;
    for (const DirectedContact& contact : contacts)
        if (contact.target(assembly).part == part)
            found.push_back(contact);
    return found;
}

PropagationPlan plan_propagation(const Assembly& assembly)
{
    PropagationPlan plan;
    plan.level.assign(assembly.parts.size(), -1);
    if (assembly.propagation.type == PropagationType::single)
    {
        reach_all(assembly, plan);
        direct_contacts(assembly, plan);
        return plan;
    }
    reach_from(assembly.primary, assembly, plan);
    for (const int part : parts_by_name(assembly))
        if (plan.level[at(part)] < 0 && has_driver(assembly, part))
            reach_from(part, assembly, plan);
    direct_contacts(assembly, plan);
    for (int part = 0; part < static_cast<int>(assembly.parts.size()); ++part)
        if (plan.level[at(part)] < 0)
            plan.unreached.push_back(part);
    return plan;
}

}  // namespace sheetmorph::assembly
