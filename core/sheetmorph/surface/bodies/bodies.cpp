// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/bodies.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/vertex_sets.h"

#include <algorithm>
#include <map>

namespace sheetmorph::surface
{

namespace
{

//! Vertices that move rigidly together: those of a feature, of a handle with a free rotation, or of
//! a carried stitch.
struct Seed
{
    const VertexIds* vertices = nullptr;
    int feature = -1;
    int handle = -1;
    int stitch = -1;
};

// Adds the stitches that touch bodies or prescribed vertices.
void add_carried_stitches(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints,
                          std::vector<Seed>& seeds)
{
    std::vector<char> carries(constraints.stitches.empty() ? 0 : at(mesh.vertex_count()), 0);
    if (carries.empty())
        return;
    for (const Seed& seed : seeds)
        for (const int vertex : *seed.vertices)
            carries[at(vertex)] = 1;
    for (const auto* regions : {&constraints.fixed, &constraints.handles, &constraints.propagated})
        for (const KnownRegion& region : *regions)
            for (const int vertex : region.vertices)
                carries[at(vertex)] = 1;
    for (std::size_t k = 0; k < constraints.stitches.size(); ++k)
    {
        const VertexIds& vertices = constraints.stitches[k].vertices;
        if (std::any_of(vertices.begin(), vertices.end(),
                        [&](int vertex) { return carries[at(vertex)] != 0; }))
            seeds.push_back({&vertices, -1, -1, static_cast<int>(k)});
    }
}

std::vector<Seed> seeds_of(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints)
{
    std::vector<Seed> seeds;
    for (std::size_t k = 0; k < constraints.features.size(); ++k)
        seeds.push_back({&constraints.features[k].vertices, static_cast<int>(k), -1});
    for (std::size_t k = 0; k < constraints.handles.size(); ++k)
        if (constraints.handles[k].is_rotation_free)
            seeds.push_back({&constraints.handles[k].vertices, -1, static_cast<int>(k)});
    add_carried_stitches(mesh, constraints, seeds);
    return seeds;
}

DisjointSets joined_seeds(const std::vector<Seed>& seeds, const mesh::TriangleMesh& mesh,
                          const SurfaceConstraints& constraints)
{
    DisjointSets sets(static_cast<int>(seeds.size()));
    std::vector<int> first_owner(at(mesh.vertex_count()), -1);
    for (std::size_t k = 0; k < seeds.size(); ++k)
        for (const int vertex : *seeds[k].vertices)
        {
            int& owner = first_owner[at(vertex)];
            if (owner < 0)
                owner = static_cast<int>(k);
            sets.join(owner, static_cast<int>(k));
        }
    for (const std::vector<int>& group : constraints.groups)
        for (const int feature : group)
            sets.join(group.front(), feature);
    return sets;
}

void settle(Body& body, const mesh::TriangleMesh& mesh)
{
    make_set(body.vertices);
    body.centre = centre_of(mesh, body.vertices);
}

[[noreturn]] void refuse_torn(const Body& body, const SurfaceConstraints& constraints,
                              const std::vector<Text>& movers)
{
    throw InvalidInput(names_of(body, constraints) + " touches both " + movers[0] + " and "
                           + movers[1] + ", which can move differently",
                       "let it touch only one of them", FaultCode::torn);
}

Text motion_label(const FormFeature& feature)
{
    static const char* const names[] = {"free", "fixed", "translation", "plane", "line", "axis"};
    return Text::about(std::string("the motion \"") + names[static_cast<int>(feature.motion.type)]
                           + "\" of '" + feature.name + "'",
                       feature.of);
}

bool is_same(const FeatureMotion& a, const FeatureMotion& b)
{
    return a.type == b.type && a.point == b.point && a.direction == b.direction;
}

//! The requests of all features of one body.
struct Wishes
{
    int prescribed = -1;
    int restricted = -1;
    bool interpolated = false;
    std::vector<Text> movers;  //!< drivers of which at most one is possible
};

Wishes wishes_of(const Body& body, const SurfaceConstraints& constraints)
{
    Wishes wishes;
    for (const int index : body.features)
    {
        const FormFeature& feature = constraints.features[at(index)];
        const FeatureMotion::Type type = feature.motion.type;
        wishes.interpolated |= feature.rotation == FeatureRotation::interpolated;
        const bool turns_as_told = feature.rotation == FeatureRotation::prescribed;
        if (turns_as_told)
        {
            wishes.movers.push_back(
                Text::about("the rotation prescribed for '" + feature.name + "'", feature.of));
            wishes.prescribed = index;
        }
        if (type == FeatureMotion::Type::free)
            continue;
        const bool is_bent_only = type == FeatureMotion::Type::plane
                                  || type == FeatureMotion::Type::line
                                  || type == FeatureMotion::Type::axis;
        const bool is_repeated =
            wishes.restricted >= 0
            && is_same(constraints.features[at(wishes.restricted)].motion, feature.motion);
        if (!is_repeated && !(turns_as_told && is_bent_only))
            wishes.movers.push_back(motion_label(feature));
        wishes.restricted = index;
    }
    return wishes;
}

void refuse_contradictions(const Body& body, const Drivers& drivers, const Wishes& wishes,
                           const SurfaceConstraints& constraints)
{
    std::vector<Text> movers;
    if (drivers.fixed)
        movers.emplace_back("a fixed region");
    for (const int handle : drivers.handles)
        movers.push_back(constraints.handles[at(handle)].label());
    if (body.handle >= 0)
        movers.push_back(constraints.handles[at(body.handle)].label());
    movers.insert(movers.end(), wishes.movers.begin(), wishes.movers.end());
    const bool is_fixed_twice =
        drivers.fixed && movers.size() == 2 && wishes.restricted >= 0
        && constraints.features[at(wishes.restricted)].motion.type == FeatureMotion::Type::fixed;
    if (movers.size() > 1 && !is_fixed_twice)
        refuse_torn(body, constraints, movers);
    if (!movers.empty() && wishes.restricted >= 0 && (drivers.fixed || !drivers.handles.empty())
        && !is_fixed_twice)
        refuse_torn(body, constraints,
                    {movers[0], motion_label(constraints.features[at(wishes.restricted)])});
}

void decide_rotation(Body& body, const Drivers& drivers, const Wishes& wishes)
{
    body.motion = Body::Motion::free;
    if (wishes.prescribed >= 0)
    {
        body.motion = Body::Motion::prescribed;
        body.driver = wishes.prescribed;
    }
    else if ((wishes.interpolated && body.handle < 0) || drivers.turned)
        body.motion = Body::Motion::interpolated;
    if (drivers.propagated && body.handle < 0)
        body.motion = Body::Motion::propagated;
}

// Applies the restriction that the features' motions impose on the body.
void decide_restriction(Body& body, const Wishes& wishes, const SurfaceConstraints& constraints)
{
    if (wishes.restricted < 0)
        return;
    switch (constraints.features[at(wishes.restricted)].motion.type)
    {
        case FeatureMotion::Type::fixed:
            body.motion = Body::Motion::fixed;
            return;
        case FeatureMotion::Type::translation:
            body.driver = wishes.restricted;
            if (body.motion != Body::Motion::propagated)
                body.motion = Body::Motion::prescribed;
            return;
        default:
            body.restricted = wishes.restricted;
            body.is_bound = body.motion != Body::Motion::propagated;
    }
}

}  // namespace

Vector3 centre_of(const mesh::TriangleMesh& mesh, const VertexIds& vertices)
{
    Vector3 centre = Vector3::Zero();
    for (const int vertex : vertices)
        centre += mesh.points().row(vertex).transpose();
    return centre / static_cast<double>(vertices.size());
}

Text names_of(const Body& body, const SurfaceConstraints& constraints)
{
    Text text("");
    const auto add = [&text](const Text& label) { text += text.is_empty() ? label : ", " + label; };
    for (const int feature : body.features)
        add(constraints.features[at(feature)].label());
    if (body.handle >= 0)
        add(constraints.handles[at(body.handle)].label());
    std::map<std::string, int> seams;
    for (const int stitch : body.stitches)
        seams.emplace(constraints.stitches[at(stitch)].label().full(), stitch);
    for (const auto& [label, stitch] : seams)
        add(constraints.stitches[at(stitch)].label());
    if (body.features.size() > 1)
        text += " (one body, since they share vertices or a group)";
    return text;
}

std::vector<Body> merge_bodies(const mesh::TriangleMesh& mesh,
                               const SurfaceConstraints& constraints)
{
    const std::vector<Seed> seeds = seeds_of(mesh, constraints);
    DisjointSets sets = joined_seeds(seeds, mesh, constraints);
    std::vector<Body> bodies;
    std::vector<int> body_of(seeds.size(), -1);
    for (std::size_t k = 0; k < seeds.size(); ++k)
    {
        int& index = body_of[at(sets.root(static_cast<int>(k)))];
        if (index < 0)
        {
            index = static_cast<int>(bodies.size());
            bodies.emplace_back();
        }
        Body& body = bodies[at(index)];
        if (seeds[k].feature >= 0)
            body.features.push_back(seeds[k].feature);
        else if (seeds[k].stitch >= 0)
            body.stitches.push_back(seeds[k].stitch);
        else if (body.handle >= 0)
            refuse_torn(body, constraints,
                        {constraints.handles[at(body.handle)].label(),
                         constraints.handles[at(seeds[k].handle)].label()});
        else
            body.handle = seeds[k].handle;
        body.vertices.insert(body.vertices.end(), seeds[k].vertices->begin(),
                             seeds[k].vertices->end());
    }
    for (Body& body : bodies)
        settle(body, mesh);
    return bodies;
}

void decide_motion(Body& body, const Drivers& drivers, const SurfaceConstraints& constraints)
{
    const Wishes wishes = wishes_of(body, constraints);
    refuse_contradictions(body, drivers, wishes, constraints);
    if (drivers.fixed)
        body.motion = Body::Motion::fixed;
    else if (!drivers.handles.empty())
    {
        body.motion = Body::Motion::handle;
        body.driver = *drivers.handles.begin();
    }
    else
    {
        decide_rotation(body, drivers, wishes);
        decide_restriction(body, wishes, constraints);
        body.is_bound |= body.handle >= 0;
    }
}

}  // namespace sheetmorph::surface
