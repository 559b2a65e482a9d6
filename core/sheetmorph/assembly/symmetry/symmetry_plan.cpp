// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/symmetry/symmetry_plan.h"

#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/assembly/plan/feature_sizes.h"
#include "sheetmorph/assembly/symmetry/mirror_finder.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

namespace sheetmorph::assembly
{

namespace
{

constexpr int none = -1;

// Poses use names, so the mirror of 'tip' must not take the name of an entry 'tip (mirrored)'.
template <typename Entry>
std::string mirrored_name(const Entry& entry, const std::vector<Entry>& all)
{
    std::string name = entry.name + " (mirrored)";
    const auto is_taken = [&](const Entry& other) { return other.name == name; };
    while (std::any_of(all.begin(), all.end(), is_taken))
        name += "'";
    return name;
}

std::set<int> as_set(const VertexIds& vertices)
{
    return {vertices.begin(), vertices.end()};
}

bool share_vertices(const VertexIds& a, const VertexIds& b)
{
    const std::set<int> of_a = as_set(a);
    return std::any_of(b.begin(), b.end(), [&](int v) { return of_a.count(v) > 0; });
}

//! Completes an assembly.
class Completion
{
public:
    explicit Completion(Assembly& assembly)
        : assembly_(assembly), given_(assembly), mirror_(*assembly.symmetry), finder_(given_)
    {
    }

    SymmetryPlan run()
    {
        complete_handles();
        complete_points();
        complete_features();
        complete_fixed();
        complete_groups();
        complete_pairs();
        return std::move(plan_);
    }

private:
    [[noreturn]] void refuse(int part, const Text& what) const
    {
        throw in_part(
            {what + " has no mirror on the other side of the symmetry plane: "
                 + Text::listed("vertices ", finder_.missing()) + " have no counterpart there",
             "make the mesh symmetric, or remove the symmetry"},
            given_.parts[at(part)]);
    }

    [[noreturn]] void refuse_overlap(const Text& what, const Text& other) const
    {
        throw InvalidInput("the mirror of " + what + " covers a part of " + other,
                           "pick them so that they mirror each other, or apart");
    }

    // The declared entry that mirrors entry `index`; none if it must be added.
    template <typename Named>
    int counterpart(const std::vector<Named>& list, std::size_t index, const PartRegion& mirrored,
                    const std::string& kind) const
    {
        for (std::size_t k = 0; k < list.size(); ++k)
        {
            if (list[k].part != mirrored.part
                || !share_vertices(list[k].vertices, mirrored.vertices))
                continue;
            if (as_set(list[k].vertices) == as_set(mirrored.vertices))
                return static_cast<int>(k);
            if (kind == "handle")
                refuse_overlap(label_of(kind, list[index]), label_of(kind, list[k]));
        }
        return none;
    }

    void complete_handles()
    {
        for (std::size_t k = 0; k < given_.handles.size(); ++k)
        {
            const PartHandle& handle = given_.handles[k];
            const Text what = label_of("handle", handle);
            const std::optional<PartRegion> mirrored = finder_.region(handle.part, handle.vertices);
            if (!mirrored)
                refuse(handle.part, what);
            for (const PartRegion& fixed : given_.fixed)
                if (fixed.part == mirrored->part
                    && share_vertices(fixed.vertices, mirrored->vertices)
                    && !(fixed.part == handle.part
                         && share_vertices(fixed.vertices, handle.vertices)))
                    refuse_overlap(what, label_of("fixed region", fixed));
            int other = counterpart(given_.handles, k, *mirrored, "handle");
            if (other == none)
            {
                other = static_cast<int>(assembly_.handles.size());
                assembly_.handles.push_back(
                    {mirrored_name(handle, assembly_.handles), mirrored->part, mirrored->vertices,
                     handle.is_rotation_free, subjects_of("handle", handle)});
            }
            else if (given_.handles[at(other)].is_rotation_free != handle.is_rotation_free)
                refuse_difference("handle", handle.name, given_.handles[at(other)].name,
                                  "rotation");
            add(plan_.handles, static_cast<int>(k), other);
        }
    }

    void complete_points()
    {
        for (std::size_t k = 0; k < given_.points.size(); ++k)
        {
            const PartPoint& point = given_.points[k];
            std::optional<PartPoint> mirrored = finder_.point(point);
            if (!mirrored)
                throw InvalidInput(label_of("point", point)
                                   + " has no mirror on the other side of the symmetry plane; "
                                     "make the mesh symmetric, or remove the symmetry");
            const Vector3 place = finder_.position(*mirrored);
            int other = none;
            for (std::size_t o = 0; o < given_.points.size(); ++o)
                if (given_.points[o].part == mirrored->part
                    && finder_.is_near(finder_.position(given_.points[o]), place))
                    other = static_cast<int>(o);
            if (other == none)
            {
                other = static_cast<int>(assembly_.points.size());
                mirrored->name = mirrored_name(point, assembly_.points);
                mirrored->of = subjects_of("point", point);
                mirrored->constraint.name = mirrored->name;
                assembly_.points.push_back(*mirrored);
            }
            add(plan_.points, static_cast<int>(k), other);
        }
        for (const PartPoint& point : assembly_.points)
            plan_.places.push_back(finder_.position(point));
    }

    [[noreturn]] void refuse_difference(const std::string& kind, const std::string& a,
                                        const std::string& b, const std::string& what) const
    {
        throw InvalidInput(
            Text::about("the " + kind + "s '" + a + "' and '" + b + "'", {{kind, a}, {kind, b}})
            + " mirror each other, but differ in their " + what + "; declare them alike");
    }

    surface::FeatureMotion mirrored_motion(surface::FeatureMotion motion) const
    {
        motion.point = mirror_.point(motion.point);
        motion.direction = mirror_.vector(motion.direction);
        return motion;
    }

    // If one side has a size, both have.
    void make_alike(PartFeature& feature, PartFeature& other) const
    {
        if (feature.rotation != other.rotation)
            refuse_difference("feature", feature.name, other.name, "rotation");
        const Vector3 along = mirror_.vector(feature.motion.direction);
        const bool has_direction = feature.motion.type == surface::FeatureMotion::Type::plane
                                   || feature.motion.type == surface::FeatureMotion::Type::line
                                   || feature.motion.type == surface::FeatureMotion::Type::axis;
        if (feature.motion.type != other.motion.type
            || (has_direction && along.cross(other.motion.direction).norm() > 1e-6))
            refuse_difference("feature", feature.name, other.name, "motion");
        if (feature.size && other.size && *feature.size != *other.size)
            refuse_difference("feature", feature.name, other.name, "size");
        other.size = feature.size = feature.size ? feature.size : other.size;
        other.is_resizable = feature.is_resizable = is_sized(feature) || is_sized(other);
    }

    void complete_features()
    {
        counterparts_.assign(given_.features.size(), none);
        for (std::size_t k = 0; k < given_.features.size(); ++k)
        {
            const PartFeature& feature = given_.features[k];
            const bool is_told = feature.rotation == surface::FeatureRotation::prescribed
                                 || is_sized(feature)
                                 || feature.motion.type != surface::FeatureMotion::Type::free;
            const std::optional<PartRegion> mirrored =
                finder_.region(feature.part, feature.vertices);
            if (!mirrored && is_told)
                refuse(feature.part, label_of("feature", feature));
            if (!mirrored)
                continue;
            int other = counterpart(given_.features, k, *mirrored, "feature");
            if (other == none)
            {
                other = static_cast<int>(assembly_.features.size());
                assembly_.features.push_back(feature);
                PartFeature& added = assembly_.features.back();
                added.name = mirrored_name(feature, assembly_.features);
                added.of = subjects_of("feature", feature);
                added.part = mirrored->part;
                added.vertices = mirrored->vertices;
                added.motion = mirrored_motion(feature.motion);
            }
            else
                make_alike(assembly_.features[k], assembly_.features[at(other)]);
            counterparts_[k] = other;
            add(plan_.features, static_cast<int>(k), other);
        }
    }

    void complete_fixed()
    {
        for (const PartRegion& fixed : given_.fixed)
        {
            std::optional<PartRegion> mirrored = finder_.region(fixed.part, fixed.vertices);
            if (!mirrored || counterpart(given_.fixed, 0, *mirrored, "fixed region") != none)
                continue;
            mirrored->name = mirrored_name(fixed, assembly_.fixed);
            mirrored->of = subjects_of("fixed region", fixed);
            assembly_.fixed.push_back(*mirrored);
        }
    }

    int mirrored_feature(int feature) const { return counterparts_[at(feature)]; }

    void complete_groups()
    {
        for (const FeatureGroup& group : given_.groups)
        {
            FeatureGroup mirrored{mirrored_name(group, assembly_.groups), {}};
            for (const int feature : group.features)
                mirrored.features.push_back(mirrored_feature(feature));
            const auto is_same = [&](const FeatureGroup& other)
            { return as_set(other.features) == as_set(mirrored.features); };
            const bool is_whole =
                std::find(mirrored.features.begin(), mirrored.features.end(), none)
                == mirrored.features.end();
            if (is_whole && std::none_of(given_.groups.begin(), given_.groups.end(), is_same))
                assembly_.groups.push_back(mirrored);
        }
    }

    void complete_pairs()
    {
        for (const FeaturePair& pair : given_.pairs)
        {
            const FeaturePair mirrored{mirrored_name(pair, assembly_.pairs), pair.type,
                                       mirrored_feature(pair.a), mirrored_feature(pair.b),
                                       subjects_of("pair", pair)};
            const auto is_same = [&](const FeaturePair& other)
            {
                return other.type == mirrored.type
                       && std::set<int>{other.a, other.b} == std::set<int>{mirrored.a, mirrored.b};
            };
            if (mirrored.a != none && mirrored.b != none
                && std::none_of(given_.pairs.begin(), given_.pairs.end(), is_same))
                assembly_.pairs.push_back(mirrored);
        }
    }

    // (a, b) and (b, a) are the same.
    static void add(std::vector<std::pair<int, int>>& list, int a, int b)
    {
        const std::pair<int, int> turned{b, a};
        if (a == b || std::find(list.begin(), list.end(), turned) == list.end())
            list.emplace_back(a, b);
    }

    Assembly& assembly_;
    const Assembly given_;
    Mirror mirror_;
    MirrorFinder finder_;
    SymmetryPlan plan_;
    std::vector<int> counterparts_;  // by declared feature
};

}  // namespace

SymmetryPlan complete_by_symmetry(Assembly& assembly)
{
    return Completion(assembly).run();
}

}  // namespace sheetmorph::assembly
