// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/strips.h"

#include "sheetmorph/fitting/outline.h"
#include "sheetmorph/recognise/features/hole_wall.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace sheetmorph::recognise
{

namespace
{

constexpr int none = -1;

// Of a flange: largest width and smallest free border, relative to the length of its fold; largest
// area, relative to the part. Chosen: a flange is a narrow strip along a fold, free on its far
// side, and less than a third of the part; otherwise it is a wall of the part.
constexpr double widest = 0.6;
constexpr double least_free = 0.8;
constexpr double largest = 0.35;

// A sharper bend (radians, 17 degrees) is a fold even if it is below the crease angle. From
// geometry: in a coarse mesh, five rows of facets form a right angle.
constexpr double folded = 0.3;

// Minimum area of a plane that may have beads, relative to the part's area. Chosen: ten times
// FeatureTolerances::smallest_area, which a bead needs itself.
constexpr double least_base = 0.04;

// Minimum share of its outline that a raised region covers, seen from above. Chosen: with less than
// a half, most of it is open and it is a hole.
constexpr double least_cover = 0.5;

// A region between creases and bends.
struct Strip
{
    std::vector<int> triangles;
    double area = 0.0;
    double fold = 0.0;  // length of its border along folds, mm
    double free = 0.0;
};

class StripFinder
{
public:
    StripFinder(const FacetGraph& graph, const std::vector<SurfaceRegion>& surfaces, double crease)
        : graph_(graph), crease_(crease), label_(graph.triangle_count(), none)
    {
        // Bends are cylinders. A strip ends at them.
        for (const SurfaceRegion& region : surfaces)
            if (region.surface.kind == fitting::Surface::Kind::cylinder)
                for (const int t : region.triangles)
                    label_[t] = bend_label;
    }

    std::vector<Strip> found()
    {
        std::vector<Strip> strips;
        for (int t = 0; t < graph_.triangle_count(); ++t)
            if (label_[t] == none)
                strips.push_back(strip_from(t, static_cast<int>(strips.size())));
        return strips;
    }

private:
    static constexpr int bend_label = -2;

    bool goes_on(int triangle, int k) const
    {
        const int other = graph_.across(triangle, k);
        return other != none && label_[other] != bend_label && graph_.bend(triangle, k) < crease_;
    }

    Strip strip_from(int seed, int label)
    {
        Strip strip;
        strip.triangles = {seed};
        label_[seed] = label;
        for (std::size_t i = 0; i < strip.triangles.size(); ++i)
        {
            const int t = strip.triangles[i];
            strip.area += graph_.area(t);
            for (int k = 0; k < 3; ++k)
            {
                const int other = graph_.across(t, k);
                const Triangles& corners = graph_.mesh().triangles();
                const double length =
                    (graph_.point(corners(t, (k + 1) % 3)) - graph_.point(corners(t, k))).norm();
                const int edge = graph_.edges().edge_of(t, k);
                if (goes_on(t, k) && label_[other] == none)
                {
                    label_[other] = label;
                    strip.triangles.push_back(other);
                }
                else if (edge >= 0 && graph_.edges().uses(edge).count() == 1)
                    strip.free += length;
                else if (!goes_on(t, k))
                    strip.fold += length;
            }
        }
        return strip;
    }

    const FacetGraph& graph_;
    double crease_;
    std::vector<int> label_;
};

VertexIds corners_of(const FacetGraph& graph, const std::vector<int>& triangles)
{
    std::set<int> vertices;
    for (const int t : triangles)
        for (int k = 0; k < 3; ++k)
            vertices.insert(graph.mesh().triangles()(t, k));
    return {vertices.begin(), vertices.end()};
}

Feature flange_of(const FacetGraph& graph, const Strip& strip)
{
    SurfaceRegion region;
    region.surface =
        *fitting::fit_surface(sample_of(graph, strip.triangles), fitting::Surface::Kind::plane);
    region.triangles = strip.triangles;
    region.area = strip.area;
    Feature feature = feature_of(graph, region);
    feature.kind = FeatureKind::flange;
    feature.length = strip.fold;
    feature.width = strip.area / strip.fold;
    return feature;
}

std::optional<Feature> raised_inside(const FacetGraph& graph, const RegionLoop& loop,
                                     const HoleWall& wall)
{
    if (wall.triangles.empty() || wall.leads_out || wall.covered < least_cover)
        return std::nullopt;
    const fitting::Outline outline =
        fitting::fit_outline(graph.mesh().points()(loop.vertices, Eigen::indexing::all));
    Feature feature;
    feature.kind = raised_kind(outline.length, outline.width);
    feature.center = outline.center;
    feature.axis = loop.normal;
    feature.length = outline.length;
    feature.width = outline.width;
    feature.depth = std::abs(wall.height);
    feature.rims = {loop.vertices};
    feature.vertices = corners_of(graph, wall.triangles);
    return feature;
}

}  // namespace

std::vector<Feature> find_flanges(const FacetGraph& graph,
                                  const std::vector<SurfaceRegion>& surfaces,
                                  const FeatureTolerances& tolerances)
{
    std::vector<Feature> flanges;
    if (graph.is_solid())
        return flanges;
    for (const Strip& strip :
         StripFinder(graph, surfaces, std::min(folded, tolerances.crease_angle)).found())
        if (strip.fold > 0.0 && strip.free >= least_free * strip.fold
            && strip.area <= widest * strip.fold * strip.fold
            && strip.area <= largest * graph.total_area()
            && strip.area >= tolerances.smallest_area * graph.total_area())
            flanges.push_back(flange_of(graph, strip));
    return flanges;
}

std::vector<Feature> find_embosses(const FacetGraph& graph,
                                   const std::vector<SurfaceRegion>& surfaces,
                                   const FeatureTolerances& tolerances)
{
    std::vector<Feature> found;
    for (const SurfaceRegion& base : surfaces)
    {
        if (base.surface.kind != fitting::Surface::Kind::plane
            || base.area < least_base * graph.total_area())
            continue;
        std::vector<int> labels(static_cast<std::size_t>(graph.triangle_count()), 1);
        for (const int t : base.triangles)
            labels[t] = 0;
        const WallTracer tracer(graph, labels, {});
        for (const RegionLoop& loop : region_loops(graph, labels))
            if (loop.region == 0 && loop.inwards < -clearly_inwards && !loop.is_free()
                && loop.area >= tolerances.smallest_area * graph.total_area())
                if (auto raised = raised_inside(graph, loop, tracer.behind(loop)))
                    found.push_back(std::move(*raised));
    }
    return found;
}

}  // namespace sheetmorph::recognise
