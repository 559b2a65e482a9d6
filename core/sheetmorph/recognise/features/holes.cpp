// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/holes.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/fitting/outline.h"
#include "sheetmorph/recognise/features/hole_wall.h"
#include "sheetmorph/recognise/features/outer_borders.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace sheetmorph::recognise
{

namespace
{

constexpr int none = -1;

// Largest share of the outline's area that the wall of a collar or of a through hole may cover,
// seen along the axis. From geometry: a wall along the axis covers none, the bottom of a blind hole
// all. Chosen: a ledge in a hole may leave 15 % open; a collar may narrow to 70 % of its radius
// (half the area).
constexpr double collar_cover = 0.5;
constexpr double through_cover = 0.85;

// Minimum height of a collar, relative to the scatter of a measured mesh. From the normal
// distribution: the scatter of a rim spans six standard deviations. A lower one is a bent rim.
constexpr double lowest_collar = 6.0;

// Radii of a hole within which its smooth collar ends. From geometry: a collar drawn with a radius
// of up to 0.3 of the hole's ends there.
constexpr double beyond_collar = 1.3;

// Largest deviation from a plane of a rim on a curved sheet, relative to the square root of its
// area. From geometry: a hole as wide as a tube deviates by half its radius, 0.28 of that root.
// Chosen: twice as much.
constexpr double most_bulge = 0.6;

class RimFinder
{
public:
    RimFinder(const FacetGraph& graph, const FeatureTolerances& tolerances)
        : graph_(graph),
          tolerances_(tolerances),
          labels_(smooth_regions(graph, tolerances.crease_angle)),
          loops_(region_loops(graph, labels_)),
          free_loops_(region_loops(graph, std::vector<int>(labels_.size(), 0))),
          borders_(graph, free_loops_)
    {
        for (const RegionLoop& loop : loops_)
            if (loop.inwards < -clearly_inwards)
                rims_.push_back(&loop);
    }

    std::vector<Feature> found()
    {
        const WallTracer tracer(graph_, labels_, rims_);
        for (const RegionLoop* loop : rims_)
            if (!loop->is_free())
                take_walled(*loop, tracer);
        for (const RegionLoop& loop : free_loops_)
            if (loop.is_free())
                take_free(loop);
        for (const RegionLoop& loop : loops_)
            if (!loop.is_free() && loop.inwards > clearly_inwards)
                take_edge(loop);
        return std::move(features_);
    }

private:
    std::optional<Feature> outlined(const RegionLoop& loop) const;
    Feature plain_hole(const RegionLoop& loop) const;
    void take_walled(const RegionLoop& loop, const WallTracer& tracer);
    void take_free(const RegionLoop& loop);
    void take_edge(const RegionLoop& loop);
    void add_wall(Feature& feature, const HoleWall& wall);
    bool has_merged(const Feature& feature, const HoleWall& wall);
    bool is_blind_hole(const RegionLoop& loop, const HoleWall& wall) const;
    bool spreads_beyond(const RegionLoop& loop, double radius) const;
    bool is_in_range(const Feature& feature) const;

    const FacetGraph& graph_;
    const FeatureTolerances& tolerances_;
    std::vector<int> labels_;
    std::vector<RegionLoop> loops_;
    // of the whole part, because noise creates creases near them
    std::vector<RegionLoop> free_loops_;
    OuterBorders borders_;
    std::vector<const RegionLoop*> rims_;
    std::vector<Feature> features_;
    std::map<int, std::size_t> owner_;  // by triangle of a wall: its feature
};

bool RimFinder::is_in_range(const Feature& feature) const
{
    const double half =
        0.5 * (feature.kind == FeatureKind::round_hole ? 2.0 * feature.radius : feature.width);
    return half >= tolerances_.smallest_radius && half <= tolerances_.largest_radius;
}

// A hole whose kind follows from the loop's outline; nothing if the loop has too few vertices or
// deviates too far from a plane.
std::optional<Feature> RimFinder::outlined(const RegionLoop& loop) const
{
    if (loop.vertices.size() < 4)
        return std::nullopt;
    const Points rim = graph_.mesh().points()(loop.vertices, Eigen::indexing::all);
    const fitting::Outline outline =
        fitting::fit_outline(rim, tolerances_.roundness, graph_.scatter());
    const int count = static_cast<int>(loop.vertices.size());
    if (outline.kind != fitting::OutlineKind::rectangular
        && count < tolerances_.fewest_rim_vertices)
        return std::nullopt;
    if (outline.bulge > most_bulge * std::sqrt(loop.area))
        return std::nullopt;
    Feature feature;
    feature.kind = hole_kind(outline.kind);
    feature.center = outline.center;
    feature.axis = outline.axis;
    feature.radius = outline.radius;
    feature.length = outline.length;
    feature.width = outline.width;
    feature.residual = std::max(outline.residual, outline.bulge);
    feature.rims = {loop.vertices};
    feature.vertices = loop.vertices;
    std::sort(feature.vertices.begin(), feature.vertices.end());
    return feature;
}

// A hole of no particular shape for a free rim with too few vertices or too far from a plane.
Feature RimFinder::plain_hole(const RegionLoop& loop) const
{
    const Points rim = graph_.mesh().points()(loop.vertices, Eigen::indexing::all);
    Feature feature;
    feature.kind = FeatureKind::hole;
    feature.center = rim.colwise().mean().transpose();
    feature.axis = loop.normal;
    feature.length = feature.width = 2.0 * std::sqrt(loop.area / pi);
    feature.rims = {loop.vertices};
    feature.vertices = loop.vertices;
    make_set(feature.vertices);
    return feature;
}

void RimFinder::add_wall(Feature& feature, const HoleWall& wall)
{
    for (const int triangle : wall.triangles)
        for (int k = 0; k < 3; ++k)
            feature.vertices.push_back(graph_.mesh().triangles()(triangle, k));
    make_set(feature.vertices);
}

// If the wall already belongs to a hole, adds this rim to that hole as its second rim. The
// dimensions of the narrower rim apply.
bool RimFinder::has_merged(const Feature& feature, const HoleWall& wall)
{
    std::optional<std::size_t> other;
    for (const int triangle : wall.triangles)
        if (const auto place = owner_.find(triangle); place != owner_.end() && !other)
            other = place->second;
    if (!other)
        return false;
    Feature& first = features_[*other];
    const double depth = std::abs((feature.center - first.center).dot(first.axis));
    const std::size_t before = first.rims.size();
    // Chosen: rims of one radius differ by rounding, and the first one stays.
    const bool is_narrower = feature.width < (1.0 - 1e-6) * first.width;
    if (is_narrower || (first.kind == FeatureKind::hole && feature.kind != FeatureKind::hole))
    {
        Feature narrower = feature;
        narrower.rims.insert(narrower.rims.end(), first.rims.begin(), first.rims.end());
        narrower.vertices = first.vertices;
        narrower.depth = first.depth;
        first = std::move(narrower);
    }
    else
        first.rims.push_back(feature.rims.front());
    first.depth = before == 1 ? depth : std::max(first.depth, depth);
    VertexIds& all = first.vertices;
    all.insert(all.end(), feature.vertices.begin(), feature.vertices.end());
    add_wall(first, wall);
    for (const int triangle : wall.triangles)
        owner_.emplace(triangle, *other);
    return true;
}

// Whether the bottom lies on the inner side of the surface. Only a solid has an inner side.
bool RimFinder::is_blind_hole(const RegionLoop& loop, const HoleWall& wall) const
{
    if (!graph_.is_solid())
        return false;
    Vector3 outside = Vector3::Zero();
    for (const int triangle : loop.triangles)
        outside += graph_.normal(triangle) * graph_.area(triangle);
    return wall.height * loop.normal.dot(outside) < 0.0;
}

void RimFinder::take_walled(const RegionLoop& loop, const WallTracer& tracer)
{
    std::optional<Feature> feature = outlined(loop);
    if (!feature || std::count(loop.across.begin(), loop.across.end(), none) > loop.free_edges)
        return;
    const HoleWall wall = tracer.behind(loop);
    const bool is_through = (wall.leads_out && wall.covered < through_cover)
                            || (wall.is_open && wall.covered < collar_cover
                                && std::abs(wall.height) >= lowest_collar * graph_.scatter());
    const bool is_hole = is_through || is_blind_hole(loop, wall);
    if (is_through && borders_.has(loop))
        return;
    if (!is_hole)
    {
        if (wall.triangles.empty() || wall.leads_out)
            return;
        feature->kind = raised_kind(feature->length, feature->width);
        feature->residual = 0.0;
    }
    else if (!is_in_range(*feature) || has_merged(*feature, wall))
        return;
    feature->depth = std::abs(wall.height);
    add_wall(*feature, wall);
    for (const int triangle : wall.triangles)
        if (is_hole)
            owner_.emplace(triangle, features_.size());
    features_.push_back(std::move(*feature));
}

// Whether most of the loop's region is farther than beyond_collar radii from its axis, as the sheet
// around a smooth collar is.
bool RimFinder::spreads_beyond(const RegionLoop& loop, double radius) const
{
    double beyond = 0.0;
    double all = 0.0;
    for (int t = 0; t < graph_.triangle_count(); ++t)
        if (labels_[t] == labels_[loop.triangles.front()])
        {
            const Vector3 off = graph_.centroid(t) - loop.center;
            const double away = (off - loop.normal.dot(off) * loop.normal).norm();
            all += graph_.area(t);
            beyond += away > beyond_collar * radius ? graph_.area(t) : 0.0;
        }
    return beyond > 0.5 * all;
}

void RimFinder::take_free(const RegionLoop& loop)
{
    std::optional<Feature> feature = outlined(loop);
    if (!feature && loop.inwards < -clearly_inwards)
        feature = plain_hole(loop);
    if (!feature)
        return;
    for (const int triangle : loop.triangles)
        if (owner_.count(triangle))
        {
            features_[owner_[triangle]].rims.push_back(loop.vertices);  // the end of its collar
            return;
        }
    const bool is_round = feature->kind == FeatureKind::round_hole;
    const bool is_hole =
        (loop.inwards < -clearly_inwards
         || (loop.inwards < clearly_inwards && is_round && spreads_beyond(loop, feature->radius)))
        && !borders_.has(loop);
    if (!is_hole && is_round)
        feature->kind = FeatureKind::round_edge;
    if ((is_hole && is_in_range(*feature)) || (!is_hole && is_round))
        features_.push_back(std::move(*feature));
}

void RimFinder::take_edge(const RegionLoop& loop)
{
    std::optional<Feature> feature = outlined(loop);
    if (!feature || feature->kind != FeatureKind::round_hole)
        return;
    feature->kind = FeatureKind::round_edge;
    features_.push_back(std::move(*feature));
}

}  // namespace

std::vector<Feature> find_rims(const FacetGraph& graph, const FeatureTolerances& tolerances)
{
    return RimFinder(graph, tolerances).found();
}

}  // namespace sheetmorph::recognise
