// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/reachable_size.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rotation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace sheetmorph::surface
{

namespace
{

// Bisection to 6e-8 of the interval. Chosen: far below the four digits of the message. The reported
// size was verified.
constexpr int halvings = 24;

Vector3 corner(const Points& points, const Triangles& triangles, int triangle, int k)
{
    return points.row(triangles(triangle, k)).transpose();
}

Vector3 normal(const Points& points, const Triangles& triangles, int triangle)
{
    const Vector3 first = corner(points, triangles, triangle, 0);
    return (corner(points, triangles, triangle, 1) - first)
        .cross(corner(points, triangles, triangle, 2) - first);
}

Vector3 middle(const mesh::TriangleMesh& mesh, int triangle)
{
    return (corner(mesh.points(), mesh.triangles(), triangle, 0)
            + corner(mesh.points(), mesh.triangles(), triangle, 1)
            + corner(mesh.points(), mesh.triangles(), triangle, 2))
           / 3.0;
}

// The elements of the first list that are not in the second; both ascending.
std::vector<int> without(const std::vector<int>& list, const std::vector<int>& taken)
{
    std::vector<int> left;
    std::set_difference(list.begin(), list.end(), taken.begin(), taken.end(),
                        std::back_inserter(left));
    return left;
}

// The feature with a size whose vertices are nearest to a triangle.
int nearest_sized(const PreparedSurface& part, const SizeChanges& sizes, int triangle)
{
    const Vector3 where = middle(part.rest, triangle);
    double nearest = std::numeric_limits<double>::infinity();
    int found = 0;
    for (std::size_t k = 0; k < sizes.size(); ++k)
        for (std::size_t i = 0; sizes[k] && i < part.constraints.features[k].vertices.size(); ++i)
        {
            const int vertex = part.constraints.features[k].vertices[i];
            const double distance =
                (part.rest.points().row(vertex).transpose() - where).squaredNorm();
            if (distance < nearest)
            {
                nearest = distance;
                found = static_cast<int>(k);
            }
        }
    return found;
}

std::string rounded(double value)
{
    std::ostringstream text;
    text.precision(6);
    text << value;
    return text.str();
}

//! A feature with a size that is not possible.
struct Excess
{
    const PreparedSurface& part;
    const Deformation& unsized;
    const SizeChanges& sizes;
    std::size_t feature;
};

// The triangles that sizes invert.
std::vector<int> overturned_by(const PreparedSurface& part, const SizeChanges& sizes,
                               const Deformation& unsized)
{
    Deformation sized = unsized;
    part.growth.lay(sizes, sized);
    const std::vector<int> overturned = overturned_triangles(part.rest, sized);
    return overturned.empty() ? overturned
                              : without(overturned, overturned_triangles(part.rest, unsized));
}

std::vector<int> overturned_at(const Excess& excess, double size)
{
    SizeChanges sizes = excess.sizes;
    sizes[excess.feature] = size - excess.part.shapes[excess.feature]->size;
    return overturned_by(excess.part, sizes, excess.unsized);
}

bool is_reached(const Excess& excess, double size)
{
    return overturned_at(excess, size).empty();
}

//! The possible size nearest to the requested one, mm, if there is any, and the triangles that are
//! inverted just beyond it.
struct Limit
{
    std::optional<double> size;
    std::vector<int> overturned;
};

// Bisects between the size at rest and the requested one, if the size at rest is possible; rounds
// the result towards rest.
Limit limit(const Excess& excess)
{
    double reached = excess.part.shapes[excess.feature]->size;
    double refused = reached + *excess.sizes[excess.feature];
    if (const std::vector<int> overturned = overturned_at(excess, reached); !overturned.empty())
        return {std::nullopt, overturned};
    for (int halving = 0; halving < halvings; ++halving)
    {
        const double tried = 0.5 * (reached + refused);
        (is_reached(excess, tried) ? reached : refused) = tried;
    }
    // Four digits, for the message.
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(reached))) - 3.0);
    const double towards_rest =
        reached < refused ? std::floor(reached / unit) * unit : std::ceil(reached / unit) * unit;
    return {is_reached(excess, towards_rest) ? towards_rest : reached,
            overturned_at(excess, refused)};
}

// Whether a vertex is among the corners.
bool touches(const std::set<int>& corners, const VertexIds& vertices)
{
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](int vertex) { return corners.count(vertex) > 0; });
}

// Names the regions and features at corners of inverted triangles: ": fixed region 'a' holds the
// sheet around it".
std::string holders(const PreparedSurface& part, std::size_t feature, const std::vector<int>& over)
{
    std::set<int> corners;
    for (const int triangle : over)
        for (int k = 0; k < 3; ++k)
            corners.insert(part.rest.triangles()(triangle, k));
    const SurfaceConstraints& constraints = part.constraints;
    for (const int vertex : constraints.features[feature].vertices)
        corners.erase(vertex);
    std::vector<std::string> labels;
    for (const std::vector<KnownRegion>* regions :
         {&constraints.fixed, &constraints.handles, &constraints.propagated})
        for (const KnownRegion& region : *regions)
            if (touches(corners, region.vertices))
                labels.push_back(region.label().full());
    for (std::size_t k = 0; k < constraints.features.size(); ++k)
        if (k != feature && touches(corners, constraints.features[k].vertices))
            labels.push_back(constraints.features[k].label().full());
    if (labels.empty())
        return "";
    std::string text = ", because " + labels.front();
    for (std::size_t k = 1; k < labels.size(); ++k)
        text += (k + 1 < labels.size() ? ", " : " and ") + labels[k];
    return text + (labels.size() > 1 ? " hold" : " holds") + " the sheet around it";
}

}  // namespace

std::vector<int> overturned_triangles(const mesh::TriangleMesh& rest,
                                      const Deformation& deformation)
{
    std::vector<int> overturned;
    for (int triangle = 0; triangle < rest.triangle_count(); ++triangle)
    {
        Vector3 log = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            log += corner(deformation.rotation_logs, rest.triangles(), triangle, k) / 3.0;
        const Vector3 before = normal(rest.points(), rest.triangles(), triangle);
        const Vector3 now = normal(deformation.positions, rest.triangles(), triangle);
        if (now.dot(rotation_from_log(log) * before) < 0.0)
            overturned.push_back(triangle);
    }
    return overturned;
}

void require_reachable_sizes(const PreparedSurface& part, const SizeChanges& sizes,
                             const Deformation& unsized)
{
    const std::vector<int> overturned = overturned_by(part, sizes, unsized);
    if (overturned.empty())
        return;
    const auto feature = static_cast<std::size_t>(nearest_sized(part, sizes, overturned.front()));
    const Limit found = limit({part, unsized, sizes, feature});
    const std::string word = *sizes[feature] > 0.0 ? "largest" : "smallest";
    throw InvalidInput(
        part.constraints.features[feature].label() + ": a " + part.shapes[feature]->measure()
            + " of " + rounded(part.shapes[feature]->size + *sizes[feature]) + " mm would flip "
            + Text::shortened("triangles " + list_ids(overturned),
                              std::to_string(overturned.size())
                                  + (overturned.size() == 1 ? " triangle" : " triangles")),
        (found.size ? "the " + word + " possible is " + rounded(*found.size) + " mm"
                    : "the other sizes of this pose flip triangles too")
            + holders(part, feature, found.overturned));
}

}  // namespace sheetmorph::surface
