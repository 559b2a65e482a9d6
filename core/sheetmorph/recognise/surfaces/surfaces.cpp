// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/surfaces/surfaces.h"

#include "sheetmorph/recognise/facets/coarse_facets.h"
#include "sheetmorph/recognise/surfaces/surface_grower.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace sheetmorph::recognise
{

namespace
{

FeatureKind kind_of(const fitting::Surface& surface)
{
    switch (surface.kind)
    {
        case fitting::Surface::Kind::cylinder:
            return FeatureKind::cylinder;
        case fitting::Surface::Kind::cone:
            return FeatureKind::cone;
        case fitting::Surface::Kind::sphere:
            return FeatureKind::sphere;
        case fitting::Surface::Kind::plane:
            break;
    }
    return FeatureKind::plane;
}

// Extent of the vertices along and across the axis, and its centre.
void measure_extent(const FacetGraph& graph, const fitting::Surface& surface, Feature& feature)
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
    const bool is_plane = surface.kind == fitting::Surface::Kind::plane;
    feature.length = is_plane ? std::max(extent.y(), extent.z()) : extent.x();
    feature.width = is_plane ? std::min(extent.y(), extent.z()) : 0.0;
    feature.center = surface.point;
    if (is_plane)
        feature.center += frame * middle.cwiseProduct(Vector3(0, 1, 1));
    else if (surface.kind != fitting::Surface::Kind::sphere)
        feature.center += middle.x() * surface.axis;
    if (surface.kind == fitting::Surface::Kind::cone)
        feature.radius = middle.x() * std::tan(surface.angle);
}

}  // namespace

std::vector<SurfaceRegion> find_surfaces(const FacetGraph& graph,
                                         const FeatureTolerances& tolerances)
{
    const std::optional<CoarseFacets> coarse = CoarseFacets::of(graph);
    if (!coarse)
        return SurfaceGrower(graph, tolerances).found();
    std::vector<SurfaceRegion> regions = SurfaceGrower(coarse->graph(), tolerances).found();
    for (SurfaceRegion& region : regions)
    {
        region.triangles = coarse->fine_triangles(region.triangles);
        region.area = 0.0;
        for (const int t : region.triangles)
            region.area += graph.area(t);
    }
    regions.erase(
        std::remove_if(regions.begin(), regions.end(),
                       [](const SurfaceRegion& region) { return region.triangles.empty(); }),
        regions.end());
    return regions;
}

Feature feature_of(const FacetGraph& graph, const SurfaceRegion& region)
{
    Feature feature;
    feature.kind = kind_of(region.surface);
    feature.axis = region.surface.axis;
    feature.radius = region.surface.radius;
    feature.angle = region.surface.angle;
    feature.area = region.area;
    feature.convergence = region.convergence;
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

}  // namespace sheetmorph::recognise
