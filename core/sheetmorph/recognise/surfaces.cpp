// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace sheetmorph
{

namespace
{

constexpr int none = -1;
constexpr double pi = 3.14159265358979323846;
constexpr std::size_t patch_size = 14;
constexpr std::size_t fewest_triangles = 6;

// Cosine of the largest angle between a triangle and the curved surface it lies
// in (30 degrees: half the bend of a coarse one).
constexpr double along_surface = 0.866;

// Of 36 directions around an axis, those that a curved region reaches at least
// (a quarter bend with some rows of triangles reaches 3).
constexpr int directions = 36;
constexpr int fewest_directions = 3;

// Over the scatter of a measured mesh: how far its vertices may be off a surface.
constexpr double within_scatter = 4.0;

// Distance from a plane over the size of the part.
constexpr double flatness = 1e-3;

class SurfaceGrower
{
public:
    SurfaceGrower(const FacetGraph& graph, const FeatureTolerances& tolerances)
        : graph_(graph),
          tolerances_(tolerances),
          size_(graph.mesh().size()),
          is_taken_(static_cast<std::size_t>(graph.triangle_count()), 0),
          stamp_(is_taken_.size(), none)
    {
    }

    std::vector<SurfaceRegion> found()
    {
        for (int t = 0; t < graph_.triangle_count(); ++t)
            if (!is_taken_[t] && !graph_.is_thin(t))
                try_curved(t);
        std::vector<int> order(is_taken_.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return graph_.area(a) > graph_.area(b); });
        for (const int t : order)
            if (!is_taken_[t] && !graph_.is_thin(t))
                try_plane(t);
        return std::move(regions_);
    }

private:
    std::vector<int> patch_around(int seed);
    void try_curved(int seed);
    void try_plane(int seed);
    std::vector<int> grown(int seed, const Surface& surface);
    bool is_near(const Surface& surface, int triangle) const;
    bool is_curved(const Surface& surface, const std::vector<int>& triangles) const;
    void keep(const Surface& surface, std::vector<int> triangles);
    double area_of(const std::vector<int>& triangles) const;

    const FacetGraph& graph_;
    const FeatureTolerances& tolerances_;
    double size_;
    std::vector<char> is_taken_;
    std::vector<int> stamp_;  // of a triangle: the last search that reached it
    int search_ = 0;
    std::vector<SurfaceRegion> regions_;
};

std::vector<int> SurfaceGrower::patch_around(int seed)
{
    std::vector<int> patch = {seed};
    stamp_[seed] = ++search_;
    for (std::size_t i = 0; i < patch.size() && patch.size() < patch_size; ++i)
        for (int k = 0; k < 3; ++k)
        {
            const int other = graph_.across(patch[i], k);
            if (other == none || is_taken_[other] || stamp_[other] == search_
                || graph_.bend(patch[i], k) > tolerances_.smooth_angle || graph_.is_thin(other))
                continue;
            stamp_[other] = search_;
            patch.push_back(other);
        }
    return patch;
}

double SurfaceGrower::area_of(const std::vector<int>& triangles) const
{
    double area = 0.0;
    for (const int t : triangles)
        area += graph_.area(t);
    return area;
}

bool SurfaceGrower::is_near(const Surface& surface, int triangle) const
{
    const bool is_plane = surface.kind == FeatureKind::plane;
    const Vector3 middle = graph_.centroid(triangle);
    const double reach =
        (is_plane ? flatness * size_ : tolerances_.surface * surface.radius_at(middle))
        + within_scatter * graph_.scatter();
    const double cosine = is_plane ? std::cos(tolerances_.plane_angle) : along_surface;
    if (std::abs(surface.normal(middle).dot(graph_.normal(triangle))) < cosine)
        return false;
    for (int k = 0; k < 3; ++k)
        if (surface.distance(graph_.point(graph_.mesh().triangles()(triangle, k))) > reach)
            return false;
    return true;
}

std::vector<int> SurfaceGrower::grown(int seed, const Surface& surface)
{
    std::vector<int> region = {seed};
    stamp_[seed] = ++search_;
    for (std::size_t i = 0; i < region.size(); ++i)
        for (int k = 0; k < 3; ++k)
        {
            const int other = graph_.across(region[i], k);
            if (other == none || is_taken_[other] || stamp_[other] == search_
                || graph_.bend(region[i], k) > tolerances_.smooth_angle)
                continue;
            stamp_[other] = search_;
            if (graph_.is_thin(other) || is_near(surface, other))
                region.push_back(other);
        }
    return region;
}

bool SurfaceGrower::is_curved(const Surface& surface, const std::vector<int>& triangles) const
{
    if (surface.kind == FeatureKind::sphere)
        return triangles.size() >= 2 * fewest_triangles;
    const Vector3 u = surface.axis.unitOrthogonal();
    const Vector3 v = surface.axis.cross(u);
    std::set<int> seen;
    for (const int t : triangles)
    {
        const Vector3 normal = surface.normal(graph_.centroid(t));
        const double turn = std::atan2(normal.dot(v), normal.dot(u)) / (2.0 * pi) + 0.5;
        seen.insert(static_cast<int>(turn * directions));
    }
    return static_cast<int>(seen.size()) >= fewest_directions;
}

void SurfaceGrower::keep(const Surface& surface, std::vector<int> triangles)
{
    for (const int t : triangles)
        is_taken_[t] = 1;
    std::sort(triangles.begin(), triangles.end());
    const double area = area_of(triangles);
    regions_.push_back({surface, std::move(triangles), area});
}

void SurfaceGrower::try_curved(int seed)
{
    const std::vector<int> patch = patch_around(seed);
    if (patch.size() < fewest_triangles)
        return;
    std::optional<Surface> best;
    std::vector<int> most;
    for (const FeatureKind kind : {FeatureKind::cylinder, FeatureKind::sphere, FeatureKind::cone})
    {
        std::optional<Surface> surface = fit_surface(graph_, patch, kind);
        std::vector<int> region;
        for (int round = 0; round < 3 && surface; ++round)
        {
            if (surface->radius > 2.0 * size_ || !is_near(*surface, seed))
                region.clear();
            else
                region = grown(seed, *surface);
            surface =
                region.size() < fewest_triangles ? std::nullopt : fit_surface(graph_, region, kind);
        }
        if (surface && is_near(*surface, seed) && region.size() > most.size() + most.size() / 10
            && is_curved(*surface, region))
        {
            most = region;
            best = surface;
        }
    }
    if (best && area_of(most) >= 0.25 * tolerances_.smallest_area * graph_.total_area())
        keep(*best, most);
}

void SurfaceGrower::try_plane(int seed)
{
    Surface surface;
    surface.axis = graph_.normal(seed);
    surface.point = graph_.centroid(seed);
    std::vector<int> region = grown(seed, surface);
    const std::optional<Surface> fitted = fit_surface(graph_, region, FeatureKind::plane);
    if (fitted && is_near(*fitted, seed))
    {
        surface = *fitted;
        region = grown(seed, surface);
    }
    if (area_of(region) >= tolerances_.smallest_area * graph_.total_area())
        keep(surface, region);
}

// How far the vertices reach along the axis and across it, and the middle of that.
void measure_extent(const FacetGraph& graph, const Surface& surface, Feature& feature)
{
    Matrix3 frame;
    const Vector3 across = surface.axis.unitOrthogonal();
    frame << surface.axis, across, surface.axis.cross(across);
    Vector3 low = Vector3::Constant(1e300);
    Vector3 high = -low;
    for (const int vertex : feature.vertices)
    {
        const Vector3 off = frame.transpose() * (graph.point(vertex) - surface.point);
        low = low.cwiseMin(off);
        high = high.cwiseMax(off);
        feature.residual = std::max(feature.residual, surface.distance(graph.point(vertex)));
    }
    const Vector3 extent = high - low;
    const Vector3 middle = 0.5 * (low + high);
    const bool is_plane = surface.kind == FeatureKind::plane;
    feature.length = is_plane ? std::max(extent.y(), extent.z()) : extent.x();
    feature.width = is_plane ? std::min(extent.y(), extent.z()) : 0.0;
    feature.center = surface.point;
    if (is_plane)
        feature.center += frame * middle.cwiseProduct(Vector3(0, 1, 1));
    else if (surface.kind != FeatureKind::sphere)
        feature.center += middle.x() * surface.axis;
    if (surface.kind == FeatureKind::cone)
        feature.radius = middle.x() * std::tan(surface.angle);
}

}  // namespace

std::vector<SurfaceRegion> find_surfaces(const FacetGraph& graph,
                                         const FeatureTolerances& tolerances)
{
    return SurfaceGrower(graph, tolerances).found();
}

Feature feature_of(const FacetGraph& graph, const SurfaceRegion& region)
{
    Feature feature;
    feature.kind = region.surface.kind;
    feature.axis = region.surface.axis;
    feature.radius = region.surface.radius;
    feature.angle = region.surface.angle;
    feature.area = region.area;
    double inside = 0.0;
    std::set<int> vertices;
    for (const int t : region.triangles)
    {
        const Vector3 normal = region.surface.normal(graph.centroid(t));
        inside += graph.area(t) * normal.dot(graph.normal(t));
        for (int k = 0; k < 3; ++k)
            vertices.insert(graph.mesh().triangles()(t, k));
    }
    feature.vertices.assign(vertices.begin(), vertices.end());
    feature.is_hollow = graph.is_solid() && inside < 0.0;
    measure_extent(graph, region.surface, feature);
    return feature;
}

}  // namespace sheetmorph
