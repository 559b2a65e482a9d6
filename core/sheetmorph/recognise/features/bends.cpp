// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/bends.h"

#include "sheetmorph/base/angles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

namespace sheetmorph::recognise
{

namespace
{

constexpr int none = -1;
// Total turn, radians. Chosen: below 5 degrees it is a wavy flat; a hem turns by 180 degrees, and
// more than 200 are a tube.
constexpr double least_turn = 0.08;
constexpr double most_turn = 1.1 * pi;

// Cosine between the axis and an edge at which the bend ends. Chosen: 11 degrees, because meshers
// place vertices on the ends of a bend but edges of triangles may lean.
constexpr double along_axis = 0.98;

// Chosen. at_end: largest distance of an end edge from the end, relative to the turn; a bend of ten
// facets still has its last one there. least_flat: smallest length of end edges that a flat
// adjoins, relative to the length; the rest may be cut out.
constexpr double at_end = 0.1;
constexpr double least_flat = 0.5;

// Largest distance of the strip's vertices from the cylinder, relative to its radius. Chosen: ten
// times below FeatureTolerances::surface, because the vertices of a drawn bend lie on it and those
// of the adjacent flats do not.
constexpr double on_cylinder = 1e-3;

// Criteria for the two skins of one bend. Chosen: their axes are parallel to 1.8 degrees; distance
// of the axes, relative to the thickness, and difference of the turns, relative to the larger one,
// both 15 %, because meshes of the two skins differ; overlap along the axis, relative to the
// length, 80 %, because reliefs may shorten one.
constexpr double parallel = 0.9995;
constexpr double off_axis = 0.15;
constexpr double other_turn = 0.15;
constexpr double least_common = 0.8;

// A cylinder with a flat at either end.
struct Strip
{
    SurfaceRegion region;
    Feature feature;
    Vector3 middle;  // unit vector from the axis to the middle of the bend
    double turn = 0.0;
};

// Angles about the axis, measured from the middle of the bend.
class Angles
{
public:
    Angles(const FacetGraph& graph, const SurfaceRegion& region)
        : surface_(region.surface), middle_(Vector3::Zero())
    {
        for (const int t : region.triangles)
            middle_ += graph.area(t) * surface_.normal(graph.centroid(t));
        middle_ -= middle_.dot(surface_.axis) * surface_.axis;
        middle_.normalize();
        across_ = surface_.axis.cross(middle_);
    }

    const Vector3& middle() const { return middle_; }

    double at(const Vector3& place) const
    {
        const Vector3 out = place - surface_.point;
        return std::atan2(out.dot(across_), out.dot(middle_));
    }

private:
    const fitting::Surface& surface_;
    Vector3 middle_, across_;
};

class BendFinder
{
public:
    BendFinder(const FacetGraph& graph, const std::vector<SurfaceRegion>& surfaces,
               const FeatureTolerances& tolerances)
        : graph_(graph),
          tolerances_(tolerances),
          region_(static_cast<std::size_t>(graph.triangle_count()), none),
          is_curved_(surfaces.size())
    {
        for (std::size_t r = 0; r < surfaces.size(); ++r)
        {
            is_curved_[r] = surfaces[r].surface.kind != fitting::Surface::Kind::plane;
            for (const int t : surfaces[r].triangles)
                region_[t] = static_cast<int>(r);
        }
    }

    std::optional<Strip> strip(const SurfaceRegion& found) const
    {
        if (found.surface.kind != fitting::Surface::Kind::cylinder)
            return std::nullopt;
        const SurfaceRegion region = whole(found);
        Strip strip{region, feature_of(graph_, region), Vector3::Zero()};
        const Angles angles(graph_, region);
        double low = pi, high = -pi;
        for (const int vertex : strip.feature.vertices)
        {
            low = std::min(low, angles.at(graph_.point(vertex)));
            high = std::max(high, angles.at(graph_.point(vertex)));
        }
        strip.turn = high - low;
        strip.middle = angles.middle();
        strip.feature.kind = FeatureKind::bend;
        strip.feature.angle = strip.turn;
        if (strip.turn < least_turn || strip.turn > most_turn)
            return std::nullopt;
        double at_low = 0.0, at_high = 0.0;
        const std::vector<char> is_in = mask(region);
        for (const int t : region.triangles)
            for (int k = 0; k < 3; ++k)
            {
                const double length = ends(t, k, is_in) ? flat_beyond(region.surface, t, k) : 0.0;
                const double angle = length > 0.0 ? angles.at(middle_of(t, k)) : 0.0;
                at_low += angle < low + at_end * strip.turn ? length : 0.0;
                at_high += angle > high - at_end * strip.turn ? length : 0.0;
            }
        if (std::min(at_low, at_high) < least_flat * strip.feature.length)
            return std::nullopt;
        return strip;
    }

private:
    Vector3 middle_of(int triangle, int k) const
    {
        const Triangles& corners = graph_.mesh().triangles();
        return 0.5
               * (graph_.point(corners(triangle, k))
                  + graph_.point(corners(triangle, (k + 1) % 3)));
    }

    std::vector<char> mask(const SurfaceRegion& region) const
    {
        std::vector<char> is_in(region_.size(), 0);
        for (const int t : region.triangles)
            is_in[t] = 1;
        return is_in;
    }

    bool ends(int triangle, int k, const std::vector<char>& is_in) const
    {
        const int other = graph_.across(triangle, k);
        return other != none && !is_in[other] && !graph_.is_thin(other);
    }

    bool is_on(const fitting::Surface& surface, int triangle) const
    {
        const double reach = on_cylinder * surface.radius + graph_.scatter();
        for (int k = 0; k < 3; ++k)
            if (surface.distance(graph_.point(graph_.mesh().triangles()(triangle, k))) > reach)
                return false;
        const Vector3 normal = surface.normal(graph_.centroid(triangle));
        return std::abs(normal.dot(graph_.normal(triangle))) > along_surface;
    }

    // Adds the first facets of the bend: they turn so little that region growing assigned them to
    // the flats.
    SurfaceRegion whole(SurfaceRegion region) const
    {
        std::vector<char> is_in = mask(region);
        for (std::size_t i = 0; i < region.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k)
                if (ends(region.triangles[i], k, is_in))
                {
                    const int other = graph_.across(region.triangles[i], k);
                    if (is_curved(other) || !is_on(region.surface, other))
                        continue;
                    is_in[other] = 1;
                    region.area += graph_.area(other);
                    region.triangles.push_back(other);
                }
        return region;
    }

    bool is_curved(int triangle) const
    {
        return region_[triangle] != none && is_curved_[region_[triangle]];
    }

    // The length of a side that is parallel to the axis, if a flat continues smoothly beyond it;
    // else 0. Unit mm.
    double flat_beyond(const fitting::Surface& surface, int triangle, int k) const
    {
        const int other = graph_.across(triangle, k);
        if (is_curved(other))
            return 0.0;
        const Triangles& corners = graph_.mesh().triangles();
        const Vector3 side =
            graph_.point(corners(triangle, (k + 1) % 3)) - graph_.point(corners(triangle, k));
        const double length = side.norm();
        const double straight = std::cos(tolerances_.plane_angle + graph_.unsure(other));
        const bool goes_on =
            std::abs(surface.normal(middle_of(triangle, k)).dot(graph_.normal(other))) > straight;
        return goes_on && std::abs(side.dot(surface.axis)) > along_axis * length ? length : 0.0;
    }

    const FacetGraph& graph_;
    const FeatureTolerances& tolerances_;
    std::vector<int> region_;  // by triangle
    std::vector<char> is_curved_;
};

// The thickness of a bend with these inner and outer skins, mm; nothing if they do not match.
std::optional<double> thickness_between(const Strip& inner, const Strip& outer)
{
    const fitting::Surface& in = inner.region.surface;
    const fitting::Surface& out = outer.region.surface;
    const double thickness = out.radius - in.radius;
    if (!inner.feature.is_hollow || outer.feature.is_hollow || thickness <= 0.0
        || thickness > inner.feature.length || std::abs(in.axis.dot(out.axis)) < parallel
        || inner.middle.dot(outer.middle) < std::cos(0.5 * inner.turn))
        return std::nullopt;
    const Vector3 between = outer.feature.center - inner.feature.center;
    const double shifted = std::abs(between.dot(in.axis));
    const double apart = (between - between.dot(in.axis) * in.axis).norm();
    const double longest = std::max(inner.feature.length, outer.feature.length);
    const double common = 0.5 * (inner.feature.length + outer.feature.length) - shifted;
    if (apart > off_axis * thickness || common < least_common * longest
        || std::abs(inner.turn - outer.turn) > other_turn * std::max(inner.turn, outer.turn))
        return std::nullopt;
    return thickness;
}

Feature joined(const Feature& inner, const Feature& outer)
{
    Feature whole = inner;
    whole.depth = outer.radius - inner.radius;
    whole.residual = std::max(inner.residual, outer.residual);
    whole.area = inner.area + outer.area;
    whole.is_hollow = false;
    whole.vertices.clear();
    std::set_union(inner.vertices.begin(), inner.vertices.end(), outer.vertices.begin(),
                   outer.vertices.end(), std::back_inserter(whole.vertices));
    return whole;
}

// Pairs each inner skin with the nearest outer skin around it.
std::vector<Feature> bends_of_solid(const std::vector<Strip>& strips)
{
    std::vector<Feature> bends;
    for (const Strip& inner : strips)
    {
        const Strip* nearest = nullptr;
        double thickness = std::numeric_limits<double>::max();
        for (const Strip& outer : strips)
            if (const auto between = thickness_between(inner, outer);
                between && *between < thickness)
            {
                nearest = &outer;
                thickness = *between;
            }
        if (nearest != nullptr)
            bends.push_back(joined(inner.feature, nearest->feature));
    }
    return bends;
}

}  // namespace

std::vector<Feature> find_bends(const FacetGraph& graph, const std::vector<SurfaceRegion>& surfaces,
                                const FeatureTolerances& tolerances)
{
    const BendFinder finder(graph, surfaces, tolerances);
    std::vector<Strip> strips;
    for (const SurfaceRegion& region : surfaces)
        if (auto strip = finder.strip(region))
            strips.push_back(std::move(*strip));
    if (graph.is_solid())
        return bends_of_solid(strips);
    std::vector<Feature> bends;
    for (Strip& strip : strips)
        bends.push_back(std::move(strip.feature));
    return bends;
}

}  // namespace sheetmorph::recognise
