// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/symmetry/symmetry_plan.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"

namespace sheetmorph::assembly
{

namespace
{

// How exactly both sides must agree if the pose prescribes both, relative. From the accuracy that
// SheetMorph promises, 1e-9 of the size.
constexpr double agreement = 1e-9;

bool is_still(const RigidMotion& motion)
{
    return motion.translation.isZero(0.0) && motion.rotation_log.isZero(0.0);
}

bool agree(const Vector3& a, const Vector3& b)
{
    return (a - b).norm() <= agreement * (1.0 + a.norm() + b.norm());
}

bool agree(const RigidMotion& a, const RigidMotion& b)
{
    return agree(a.rotation_log, b.rotation_log) && agree(a.apply(b.pivot), b.apply(b.pivot));
}

[[noreturn]] void refuse(const std::string& kind, const std::string& a, const std::string& b)
{
    throw InvalidInput(Text::about("the pose moves the " + kind + "s '" + a + "' and '" + b + "'",
                                   {{kind, a}, {kind, b}})
                           + ", which mirror each other, in different ways",
                       "give one of them a motion, or both the same");
}

//! Completes a pose that moves only one side of the plane.
class Mirrored
{
public:
    Mirrored(const Assembly& assembly, const SymmetryPlan& plan, Pose pose)
        : assembly_(assembly), plan_(plan), mirror_(*assembly.symmetry), pose_(std::move(pose))
    {
    }

    Pose run()
    {
        for (const auto& [a, b] : plan_.handles)
            mirror_handles(assembly_.handles[at(a)].name, assembly_.handles[at(b)].name);
        for (const auto& [a, b] : plan_.points)
            mirror_points(a, b);
        for (const auto& [a, b] : plan_.features)
        {
            const std::string& one = assembly_.features[at(a)].name;
            const std::string& other = assembly_.features[at(b)].name;
            if (assembly_.features[at(a)].rotation == surface::FeatureRotation::prescribed)
                mirror_logs(one, other);
            mirror_sizes(one, other);
        }
        return std::move(pose_);
    }

private:
    void mirror_handles(const std::string& a, const std::string& b)
    {
        const RigidMotion one = pose_.handles[a];
        if (a == b)
        {
            pose_.handles[a] = mirror_.symmetric_motion(one);
            return;
        }
        const RigidMotion other = pose_.handles[b];
        if (!is_still(one) && !is_still(other) && !agree(mirror_.motion(one), other))
            refuse("handle", a, b);
        if (is_still(one))
            pose_.handles[a] = mirror_.motion(other);
        else
            pose_.handles[b] = mirror_.motion(one);
    }

    void mirror_logs(const std::string& a, const std::string& b)
    {
        Vector3& one = pose_.feature_logs.try_emplace(a, Vector3::Zero()).first->second;
        if (a == b)
        {
            one = mirror_.symmetric_log(one);
            return;
        }
        Vector3& other = pose_.feature_logs.try_emplace(b, Vector3::Zero()).first->second;
        if (!one.isZero(0.0) && !other.isZero(0.0) && !agree(mirror_.log(one), other))
            refuse("feature", a, b);
        if (one.isZero(0.0))
            one = mirror_.log(other);
        else
            other = mirror_.log(one);
    }

    void mirror_sizes(const std::string& a, const std::string& b)
    {
        const auto one = pose_.sizes.find(a);
        const auto other = pose_.sizes.find(b);
        if (one != pose_.sizes.end() && other != pose_.sizes.end() && one->second != other->second)
            refuse("feature", a, b);
        if (one != pose_.sizes.end())
            pose_.sizes[b] = one->second;
        else if (other != pose_.sizes.end())
            pose_.sizes[a] = other->second;
    }

    // A point without a target stays at rest, because the solver needs a target for every point.
    surface::PointTarget target_of(int point) const
    {
        const auto found = pose_.points.find(assembly_.points[at(point)].name);
        return found == pose_.points.end()
                   ? surface::PointTarget{plan_.places[at(point)], Vector3::Zero()}
                   : found->second;
    }

    bool stays(int point, const surface::PointTarget& target) const
    {
        return target.rotation_log.isZero(0.0) && agree(target.position, plan_.places[at(point)]);
    }

    void mirror_points(int a, int b)
    {
        const surface::PointTarget one = target_of(a);
        const surface::PointTarget other = target_of(b);
        surface::PointTarget& told_a = pose_.points[assembly_.points[at(a)].name];
        surface::PointTarget& told_b = pose_.points[assembly_.points[at(b)].name];
        if (a == b)
        {
            const Vector3& place = plan_.places[at(a)];
            told_a = {place + mirror_.symmetric_vector(one.position - place),
                      mirror_.symmetric_log(one.rotation_log)};
            return;
        }
        const surface::PointTarget mirrored{mirror_.point(one.position),
                                            mirror_.log(one.rotation_log)};
        if (stays(a, one))
        {
            told_a = {mirror_.point(other.position), mirror_.log(other.rotation_log)};
            told_b = other;
            return;
        }
        if (!stays(b, other)
            && !(agree(mirrored.position, other.position)
                 && agree(mirrored.rotation_log, other.rotation_log)))
            refuse("point", assembly_.points[at(a)].name, assembly_.points[at(b)].name);
        told_a = one;
        told_b = mirrored;
    }

    const Assembly& assembly_;
    const SymmetryPlan& plan_;
    Mirror mirror_;
    Pose pose_;
};

}  // namespace

Pose symmetric_pose(const Assembly& assembly, const SymmetryPlan& plan, Pose pose)
{
    return Mirrored(assembly, plan, std::move(pose)).run();
}

}  // namespace sheetmorph::assembly
