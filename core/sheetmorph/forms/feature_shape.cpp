// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/forms/feature_shape.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/limits.h"
#include "sheetmorph/fitting/cylinder.h"
#include "sheetmorph/forms/feature_patch.h"
#include "sheetmorph/mesh/geometry/facets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sheetmorph::forms
{

using fitting::RimProfile;

namespace
{

// Relative to the radius: vertices this near to the outline belong to the rim or wall. From
// geometry: a vertex on the chord of a 16-gon deviates by 1 - cos(pi / 16) = 0.019.
constexpr double rim_tolerance = 0.02;

// Relative to the radius: minimum height of a wall. Chosen: a sheet is thicker than a twentieth of
// the radius of a usual hole; lower vertices are a bent rim.
constexpr double lowest_wall = 0.05;

// Relative to the radius: largest misalignment of the two rims of a wall. Chosen: axes of two fits
// to coarse rims differ by less; a larger one is an oblique hole.
constexpr double most_offset = 0.05;

Vector3 point_of(const FeaturePatch& patch, int vertex)
{
    return patch.mesh().points().row(vertex).transpose();
}

//! The rim or wall of a feature.
struct Core
{
    RimProfile profile;
    VertexIds vertices;
    std::vector<VertexIds> rims;  //!< the flat circles or slots among the vertices, in order
    bool has_wall = false;
};

double slack_of(const RimProfile& profile)
{
    return std::max(rim_tolerance * profile.radius, profile.tolerance);
}

// The vertices of the feature that are nearest to the axis.
VertexIds innermost(const FeaturePatch& patch, const RimProfile& profile)
{
    double least = std::numeric_limits<double>::infinity();
    for (const int vertex : patch.feature())
        least = std::min(least, profile.distance(point_of(patch, vertex)));
    const double slack = std::max(rim_tolerance * profile.radius, 2.0 * profile.residual);
    VertexIds found;
    for (const int vertex : patch.feature())
        if (profile.distance(point_of(patch, vertex)) <= least + slack)
            found.push_back(vertex);
    return found;
}

double spread_along(const FeaturePatch& patch, const RimProfile& profile, const VertexIds& vertices)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const int vertex : vertices)
    {
        const double height = profile.height(point_of(patch, vertex));
        low = std::min(low, height);
        high = std::max(high, height);
    }
    return high - low;
}

bool lie_on(const FeaturePatch& patch, const RimProfile& profile, const VertexIds& vertices)
{
    return std::all_of(
        vertices.begin(), vertices.end(),
        [&](int vertex)
        { return std::abs(profile.distance(point_of(patch, vertex))) <= slack_of(profile); });
}

// The outline halfway between two rims; nothing if they are not aligned.
std::optional<RimProfile> between(const RimProfile& one, const RimProfile& other)
{
    const Vector3 way = other.centre - one.centre;
    const Vector3 second = other.frame.col(2).dot(one.frame.col(2)) < 0.0
                               ? Vector3(-other.frame.col(2))
                               : Vector3(other.frame.col(2));
    Vector3 axis = (one.frame.col(2) + second).normalized();
    if (way.norm() > 2.0 * one.radius)
        axis = way.dot(axis) < 0.0 ? Vector3(-way.normalized()) : Vector3(way.normalized());
    if ((way - way.dot(axis) * axis).norm() > most_offset * one.radius
        || axis.dot(one.frame.col(2)) < 1.0 - most_offset)
        return std::nullopt;
    RimProfile profile = one;
    profile.centre += 0.5 * way;
    profile.frame.col(2) = axis;
    const Vector3 across = axis.cross(one.frame.col(0));
    profile.frame.col(1) = across.normalized();
    profile.frame.col(0) = profile.frame.col(1).cross(axis);
    return profile;
}

// A wall with its two rims, from vertices at the same distance from the axis.
std::optional<Core> wall(const FeaturePatch& patch, const VertexIds& vertices)
{
    Core core{{}, vertices, patch.loops_of(vertices), true};
    if (core.rims.size() != 2)
        return std::nullopt;
    const std::optional<RimProfile> one =
        fitting::fit_rim(patch.points_of(core.rims[0]), patch.scatter());
    const std::optional<RimProfile> other =
        fitting::fit_rim(patch.points_of(core.rims[1]), patch.scatter());
    if (!one || !other || one->is_circle() != other->is_circle())
        return std::nullopt;
    const std::optional<RimProfile> profile = between(*one, *other);
    if (!profile)
        return std::nullopt;
    const std::optional<RimProfile> refitted = fitting::refit(*profile, patch.points_of(vertices));
    if (!refitted)
        return std::nullopt;
    core.profile = *refitted;
    return core;
}

// Whether a free rim belongs to a hole: the sheet then continues outwards and not along the axis.
bool goes_outwards(const FeaturePatch& patch, const RimProfile& profile, const VertexIds& loop)
{
    double outwards = 0.0;
    for (const int vertex : patch.neighbours_of(loop))
        outwards += profile.distance(point_of(patch, vertex))
                    - std::abs(profile.height(point_of(patch, vertex)));
    return outwards > 0.0;
}

std::optional<Core> core_around(const FeaturePatch& patch, const VertexIds& loop)
{
    const std::optional<RimProfile> profile =
        fitting::fit_rim(patch.points_of(loop), patch.scatter());
    if (!profile)
        return std::nullopt;
    if (patch.is_disk() || (patch.is_free() && goes_outwards(patch, *profile, loop)))
        return Core{*profile, loop, {loop}, false};
    const VertexIds inner = innermost(patch, *profile);
    if (spread_along(patch, *profile, inner) > lowest_wall * profile->radius
        && patch.has_triangles(inner))
    {
        const std::optional<Core> found = wall(patch, inner);
        return found && lie_on(patch, found->profile, inner) ? found : std::nullopt;
    }
    if (!lie_on(patch, *profile, inner)
        || !std::is_permutation(inner.begin(), inner.end(), loop.begin(), loop.end()))
        return std::nullopt;
    return Core{*profile, loop, {loop}, false};
}

// A wall belongs to a hole if the sheet continues outwards at both ends; else it is a pipe or a
// boss.
bool is_hole(const FeaturePatch& patch, const Core& core)
{
    if (core.rims.empty())
        return false;
    for (const VertexIds& rim : core.rims)
    {
        double outwards = 0.0;
        for (const int vertex : patch.neighbours_of(rim))
            if (std::find(core.vertices.begin(), core.vertices.end(), vertex)
                == core.vertices.end())
                outwards += core.profile.distance(point_of(patch, vertex));
        if (!(outwards > 0.0))
            return false;
    }
    return true;
}

// Full growth on the rim and outside it. Inside a filled rim, growth decreases linearly to zero at
// the axis.
Vector3 growth_at(const FeatureShape& shape, const RimProfile& profile, const Vector3& point,
                  bool is_rim)
{
    if (shape.kind == FeatureShape::Kind::slot)
        return 0.5 * profile.place_along(point) * profile.frame.col(0);
    const double out = profile.distance(point) / profile.radius;
    const double share = !is_rim && out < -rim_tolerance ? 1.0 + out : 1.0;
    const double per_radius = shape.kind == FeatureShape::Kind::hole ? 0.5 : 1.0;
    return per_radius * share * profile.outward(point);
}

// By vertex of the patch: displacement to the exact outline, mm.
Points rounding_of(const FeaturePatch& patch, const Core& core)
{
    Points rounding = Points::Zero(patch.mesh().vertex_count(), 3);
    for (const int vertex : core.vertices)
    {
        const Vector3 point = point_of(patch, vertex);
        rounding.row(vertex) =
            (-core.profile.distance(point) * core.profile.outward(point)).transpose();
    }
    for (const VertexIds& rim : core.rims)
    {
        double mean = 0.0;
        for (const int vertex : rim)
            mean += core.profile.height(point_of(patch, vertex)) / static_cast<double>(rim.size());
        for (const int vertex : rim)
            rounding.row(vertex) += (mean - core.profile.height(point_of(patch, vertex)))
                                    * core.profile.frame.col(2).transpose();
    }
    return rounding;
}

FeatureShape shape_of(const FeaturePatch& patch, const Core& core)
{
    FeatureShape shape;
    const RimProfile& profile = core.profile;
    if (!profile.is_circle())
    {
        shape.kind = FeatureShape::Kind::slot;
        shape.size = 2.0 * (profile.half_segment + profile.radius);
        shape.smallest = 2.0 * profile.radius;
    }
    else
    {
        const bool is_rim = !core.has_wall || is_hole(patch, core);
        shape.kind = is_rim ? FeatureShape::Kind::hole : FeatureShape::Kind::cylinder;
        shape.size = is_rim ? 2.0 * profile.radius : profile.radius;
    }
    shape.centre = profile.centre;
    shape.axis = profile.frame.col(2);
    shape.along = profile.frame.col(0);
    const Points rounding = rounding_of(patch, core);
    const auto count = static_cast<Eigen::Index>(patch.rows().size());
    shape.growth.resize(count, 3);
    shape.rounding.resize(count, 3);
    for (Eigen::Index row = 0; row < count; ++row)
    {
        const int vertex = patch.rows()[static_cast<std::size_t>(row)];
        const bool is_rim =
            std::find(core.vertices.begin(), core.vertices.end(), vertex) != core.vertices.end();
        shape.growth.row(row) =
            growth_at(shape, profile, point_of(patch, vertex), is_rim).transpose();
        shape.rounding.row(row) = rounding.row(vertex);
        if (is_rim)
            shape.rim.push_back(static_cast<int>(row));
    }
    return shape;
}

}  // namespace

std::string FeatureShape::measure() const
{
    const std::array<const char*, 3> names = {"diameter", "length", "radius"};
    return names[static_cast<std::size_t>(kind)];
}

Points FeatureShape::resized(const Points& rest, double wanted) const
{
    if (rest.rows() != growth.rows())
        throw InvalidInput("there are " + std::to_string(rest.rows()) + " places, the feature has "
                           + std::to_string(growth.rows()) + " vertices");
    if (!(std::abs(wanted) <= largest_number))
        throw InvalidInput("the size of a feature must be a finite number of mm");
    return rest + (wanted - size) * growth + rounding;
}

double FeatureShape::outline_error(const Points& placed, double wanted) const
{
    RimProfile profile;
    profile.centre = centre;
    profile.frame << along, axis.cross(along), axis;
    const bool is_slot = kind == Kind::slot;
    profile.half_segment = is_slot ? 0.5 * (wanted - smallest) : 0.0;
    profile.radius = is_slot ? 0.5 * smallest : kind == Kind::hole ? 0.5 * wanted : wanted;
    double worst = 0.0;
    for (const int row : rim)
        worst = std::max(worst, std::abs(profile.distance(placed.row(row).transpose())));
    return worst;
}

std::optional<FeatureShape> feature_shape(const mesh::TriangleMesh& mesh, const VertexIds& vertices,
                                          double scatter)
{
    const FeaturePatch patch(mesh, vertices, scatter);
    for (const VertexIds& loop : patch.loops())
    {
        const std::optional<Core> core = core_around(patch, loop);
        if (core)
            return shape_of(patch, *core);
    }
    const std::optional<RimProfile> cylinder =
        fitting::fit_cylinder(mesh::facets_of(patch.covered_mesh()));
    if (!cylinder || !lie_on(patch, *cylinder, patch.feature()))
        return std::nullopt;
    return shape_of(patch, {*cylinder, patch.feature(), {}, true});
}

}  // namespace sheetmorph::forms
