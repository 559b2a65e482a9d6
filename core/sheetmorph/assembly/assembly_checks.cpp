// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/assembly_checks.h"

#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/limits.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace sheetmorph::assembly
{

namespace
{

template <typename Named>
void check_names(const std::string& kind, const std::vector<Named>& list)
{
    std::set<std::string> seen;
    for (const Named& item : list)
    {
        if (item.name.empty())
            throw InvalidInput("a " + kind + " has no name", "give it one");
        if (!seen.insert(item.name).second)
            throw InvalidInput(Text::about("two " + kind + "s are called '" + item.name + "'",
                                           {{kind, item.name}}),
                               "rename one");
    }
}

template <typename OfPart>
void check_parts(const std::string& kind, const std::vector<OfPart>& list, std::size_t count)
{
    for (const OfPart& item : list)
        if (item.part < 0 || static_cast<std::size_t>(item.part) >= count)
            throw InvalidInput(label_of(kind, item) + " is on part " + std::to_string(item.part)
                               + ", which does not exist");
}

template <typename OfPart>
void check_vertices(const std::string& kind, const std::vector<OfPart>& list,
                    const Assembly& assembly)
{
    for (const OfPart& item : list)
    {
        const Part& part = assembly.parts[static_cast<std::size_t>(item.part)];
        const Text what = label_of(kind, item);
        if (item.vertices.empty())
            throw in_part({what + " has no vertices", "pick at least one or delete it"}, part);
        const int count = part.mesh.vertex_count();
        const auto outside = [count](int vertex) { return vertex < 0 || vertex >= count; };
        const auto found = std::find_if(item.vertices.begin(), item.vertices.end(), outside);
        if (found != item.vertices.end())
            throw in_part({what + " names vertex " + std::to_string(*found)
                               + ", which the mesh does not have (it has 0 to "
                               + std::to_string(count - 1) + ")",
                           "pick it again"},
                          part);
    }
}

void check_meshes(const Assembly& assembly)
{
    for (const Part& part : assembly.parts)
        if (part.mesh.vertex_count() == 0)
            throw InvalidInput(Text::about("part", part.name) + " has no vertices", "remove it");
        else if (!part.ids.empty() && part.ids.size() != at(part.mesh.vertex_count()))
            throw InvalidInput(Text::about("part", part.name) + " has "
                                   + std::to_string(part.ids.size()) + " vertex numbers and "
                                   + std::to_string(part.mesh.vertex_count()) + " vertices",
                               "give every vertex its number, or none");
}

// Before anything moves them to a skin or to the other side of a plane of symmetry.
void check_points(const Assembly& assembly)
{
    for (const PartPoint& point : assembly.points)
    {
        const Part& part = assembly.parts[at(point.part)];
        const int triangle = point.constraint.triangle;
        if (triangle < 0 || triangle >= part.mesh.triangle_count())
            throw in_part(
                {label_of("point", point) + " lies on triangle " + std::to_string(triangle)
                     + ", which the mesh does not have (it has 0 to "
                     + std::to_string(part.mesh.triangle_count() - 1) + ")",
                 "pick it again"},
                part);
        if (!are_numbers(point.constraint.barycentric))
            throw in_part(
                {label_of("point", point) + ": its barycentric coordinates are not finite numbers"},
                part);
    }
}

void check_side(const Assembly& assembly, const Text& what, const PartRegion& side)
{
    if (side.part < 0 || static_cast<std::size_t>(side.part) >= assembly.parts.size())
        throw InvalidInput(what + " is on part " + std::to_string(side.part)
                           + ", which does not exist");
    const Part& part = assembly.parts[static_cast<std::size_t>(side.part)];
    if (side.vertices.empty())
        throw InvalidInput(what + " has no vertices on part '" + part.name + "'",
                           "pick at least one or delete the contact");
    for (const int vertex : side.vertices)
        if (vertex < 0 || vertex >= part.mesh.vertex_count())
            throw InvalidInput(what + " names vertex " + std::to_string(vertex) + " of part '"
                                   + part.name + "', which does not have it",
                               "pick the side again");
}

void check_contacts(const Assembly& assembly)
{
    for (const Contact& contact : assembly.contacts)
    {
        const Text what = Text::about("contact", contact.name);
        check_side(assembly, what, contact.a);
        check_side(assembly, what, contact.b);
        if (contact.a.part == contact.b.part)
            throw InvalidInput(what + " joins a part with itself", "pick two different parts");
    }
}

void check_propagation(const Assembly& assembly)
{
    const Propagation& propagation = assembly.propagation;
    if (propagation.type == PropagationType::whole
        && (assembly.energy == surface::Energy::steel || assembly.is_refined))
        throw InvalidInput("the propagation 'whole' supports neither the energy 'steel' nor refine",
                           "use the propagation 'local', or leave those out");
    if (propagation.levels < 1 || propagation.levels > 5)
        throw InvalidInput("a control mesh has 1 to 5 levels, not "
                           + std::to_string(propagation.levels));
    // Chosen: beyond, the smoothness or the fit would be lost in rounding.
    if (!(propagation.smoothness >= 1e-12 && propagation.smoothness <= 1e6))
        throw InvalidInput("the control meshes' smoothness must be from 1e-12 to 1e6",
                           "0.05 is usual");
}

void check_followers(const Assembly& assembly)
{
    for (const PartRegion& follower : assembly.followers)
        check_side(assembly,
                   Text::about("contact 'follower " + follower.name + "'",
                               subjects_of("follower", follower)),
                   follower);
}

bool has_direction(surface::FeatureMotion::Type type)
{
    return type == surface::FeatureMotion::Type::plane || type == surface::FeatureMotion::Type::line
           || type == surface::FeatureMotion::Type::axis;
}

void check_motions(const Assembly& assembly)
{
    for (const PartFeature& feature : assembly.features)
    {
        const surface::FeatureMotion& motion = feature.motion;
        if (!has_direction(motion.type))
            continue;
        if (!motion.point.allFinite() || !(std::abs(motion.direction.norm() - 1.0) < 1e-9))
            throw InvalidInput(label_of("feature", feature)
                               + ": its motion needs a direction of length 1 and a finite point");
    }
}

void check_feature_index(const Assembly& assembly, const Text& what, int feature)
{
    if (feature < 0 || static_cast<std::size_t>(feature) >= assembly.features.size())
        throw InvalidInput(what + " names feature " + std::to_string(feature)
                           + ", which does not exist");
}

void check_groups(const Assembly& assembly)
{
    for (const FeatureGroup& group : assembly.groups)
    {
        const Text what = Text::about("group", group.name);
        if (group.features.size() < 2)
            throw InvalidInput(what + " has fewer than two features", "add one or delete it");
        for (const int feature : group.features)
        {
            check_feature_index(assembly, what, feature);
            const PartFeature& first = assembly.features[at(group.features.front())];
            const PartFeature& other = assembly.features[at(feature)];
            if (first.part != other.part)
                throw InvalidInput(what + " joins " + label_of("feature", first) + " of part '"
                                       + assembly.parts[at(first.part)].name + "' and "
                                       + label_of("feature", other) + " of part '"
                                       + assembly.parts[at(other.part)].name + "'",
                                   "a group is on one part, join parts by a contact of type "
                                   "rigid");
        }
    }
}

void check_pairs(const Assembly& assembly)
{
    for (const FeaturePair& pair : assembly.pairs)
    {
        const Text what = Text::about("pair", pair.name);
        check_feature_index(assembly, what, pair.a);
        check_feature_index(assembly, what, pair.b);
        if (pair.a == pair.b)
            throw InvalidInput(
                what + " names " + label_of("feature", assembly.features[at(pair.a)]) + " twice",
                "choose two features");
    }
}

void check_symmetry(const Assembly& assembly)
{
    if (!assembly.symmetry)
        return;
    const SymmetryPlane& plane = *assembly.symmetry;
    if (!plane.point.allFinite() || !(std::abs(plane.normal.norm() - 1.0) < 1e-9))
        throw InvalidInput("the plane of symmetry needs a finite point and a normal of length 1",
                           "give both");
}

}  // namespace

void check_assembly(const Assembly& assembly)
{
    const std::size_t count = assembly.parts.size();
    if (count == 0)
        throw InvalidInput("the assembly has no parts", "add one");
    if (assembly.primary < 0 || static_cast<std::size_t>(assembly.primary) >= count)
        throw InvalidInput(
            "the primary part " + std::to_string(assembly.primary) + " does not exist",
            "choose one of the " + std::to_string(count) + " parts");
    check_names("part", assembly.parts);
    check_names("fixed region", assembly.fixed);
    check_names("handle", assembly.handles);
    check_names("feature", assembly.features);
    check_names("point", assembly.points);
    check_parts("fixed region", assembly.fixed, count);
    check_parts("handle", assembly.handles, count);
    check_parts("feature", assembly.features, count);
    check_parts("point", assembly.points, count);
    check_meshes(assembly);
    check_points(assembly);
    check_vertices("fixed region", assembly.fixed, assembly);
    check_vertices("handle", assembly.handles, assembly);
    check_vertices("feature", assembly.features, assembly);
    check_names("contact", assembly.contacts);
    check_contacts(assembly);
    check_names("group", assembly.groups);
    check_names("pair", assembly.pairs);
    check_motions(assembly);
    check_groups(assembly);
    check_pairs(assembly);
    check_symmetry(assembly);
    check_followers(assembly);
    check_propagation(assembly);
}

std::string unused_name(const Assembly& assembly, const std::string& wanted)
{
    std::string name = wanted;
    const auto is_taken = [&](const PartFeature& feature) { return feature.name == name; };
    while (std::any_of(assembly.features.begin(), assembly.features.end(), is_taken))
        name += "'";
    return name;
}

}  // namespace sheetmorph::assembly
