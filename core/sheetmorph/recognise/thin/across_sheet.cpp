// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/across_sheet.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/search/triangle_queries.h"
#include "sheetmorph/mesh/topology/submesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_set>

namespace sheetmorph::recognise
{

using mesh::Hit;

namespace
{

// Tolerance of equal distances, relative to the distance plus a thousandth of the size. From files
// with seven digits, whose rounding must not choose between points.
constexpr double equally_near = 1e-7;

// Offsets of ray origins towards the facet's centroid, in thicknesses: one close to the point, one
// beyond the corner of a sharp fold. From geometry: at the outer edge of a fold by 90 degrees, the
// other flange lies behind the first thickness instead of the other skin. Chosen: a fifth more.
constexpr double beside[] = {0.05, 1.2};

// One ray is enough for all facets of a plane. At a fold, however flat, each plane needs its own.
// From files with seven digits: normals of a plane differ by about 1e-6 radians (1 - 1e-6^2 / 2).
constexpr double alike = 1.0 - 1e-12;

// Depth of the ray origin below the surface, relative to the size of the mesh. Chosen between the
// rounding of a place on a facet (1e-16) and the thickness of the thinnest sheets (1e-4).
constexpr double first_step = 1e-7;

// A skin reached through the material faces away from the start of the walk: smallest cosine
// between its normal and the direction from the start. Chosen below 0: at a point beside the start,
// rounding and facets turn the cosine by up to half a degree.
constexpr double from_behind = -0.01;

// A walk ends at this many times the distance of the nearest point that faces the start. Chosen
// above farthest_skin, with a margin for facets that the walk enters from a corner.
constexpr double far_enough = 3.0;

mesh::TriangleCorners corners_of(const Points& points, const Triangles& triangles, int facet)
{
    const auto corner = [&](int k) { return Vector3(points.row(triangles(facet, k))); };
    return {corner(0), corner(1), corner(2)};
}

Hit nearest_on(const Points& points, const Triangles& triangles, int facet, const Vector3& point)
{
    Hit hit = mesh::nearest_on_triangle(point, corners_of(points, triangles, facet));
    hit.triangle = facet;
    return hit;
}

// The nearest points that a walk reaches. Points that face the start count only if there are no
// others.
class NearPlaces
{
public:
    explicit NearPlaces(double size) : size_(size) {}

    void add(const Hit& hit, bool is_behind)
    {
        (is_behind ? behind_ : facing_).push_back(hit);
        double& least = is_behind ? nearest_ : nearest_facing_;
        least = std::min(least, hit.distance);
    }

    // Distance beyond which the walk may stop.
    double limit() const
    {
        return std::min(nearest_ + rounding(nearest_), far_enough * nearest_facing_);
    }

    // All nearest points in order of their triangle, so that rounding does not choose between them.
    std::vector<Hit> nearest() const
    {
        std::vector<Hit> hits = behind_.empty() ? facing_ : behind_;
        std::sort(hits.begin(), hits.end(),
                  [](const Hit& a, const Hit& b) { return a.triangle < b.triangle; });
        const double least = behind_.empty() ? nearest_facing_ : nearest_;
        std::vector<Hit> kept;
        for (const Hit& hit : hits)
        {
            const auto is_same = [&](const Hit& one)
            { return (one.point - hit.point).norm() < 1e3 * rounding(least); };
            if (hit.distance <= least + rounding(least)
                && std::none_of(kept.begin(), kept.end(), is_same))
                kept.push_back(hit);
        }
        return kept;
    }

private:
    double rounding(double distance) const { return equally_near * (distance + 1e-3 * size_); }

    double size_;
    std::vector<Hit> behind_, facing_;
    double nearest_ = std::numeric_limits<double>::infinity(), nearest_facing_ = nearest_;
};

}  // namespace

// Facets in order of the length of the walk from a point. On the target skin the facets' own
// distances count, because the walk descends to the nearest point.
class AcrossSheet::Walk
{
public:
    Walk(const AcrossSheet& across, const Vector3& point, const Points& positions)
        : across_(across), point_(point), positions_(positions)
    {
    }

    const Vector3& point() const { return point_; }

    void push(int facet, double way)
    {
        if (facet < 0 || !seen_.insert(facet).second)
            return;
        const Hit hit = nearest_on(positions_, across_.mesh_.triangles(), facet, point_);
        waiting_.push({std::max(way, hit.distance), hit});
    }

    void push_neighbours(const Hit& hit, double way, std::optional<SolidSide> only = {})
    {
        for (int k = 0; k < 3; ++k)
            if (const int facet = across_.graph_.across(hit.triangle, k);
                facet >= 0 && (!only || across_.side(facet) == *only))
                push(facet, way);
    }

    // The next facet and the length of the walk to it; nothing if that exceeds `limit`.
    std::optional<std::pair<double, Hit>> pop(double limit)
    {
        if (waiting_.empty() || waiting_.top().way > limit)
            return std::nullopt;
        const Step step = waiting_.top();
        waiting_.pop();
        return std::pair(step.way, step.hit);
    }

private:
    struct Step
    {
        double way;
        Hit hit;

        bool operator<(const Step& other) const
        {
            return std::pair(other.way, other.hit.triangle) < std::pair(way, hit.triangle);
        }
    };

    const AcrossSheet& across_;
    Vector3 point_;
    const Points& positions_;
    std::priority_queue<Step> waiting_;
    std::unordered_set<int> seen_;
};

AcrossSheet::AcrossSheet(const mesh::TriangleMesh& mesh, const ThinSolid& solid)
    : mesh_(mesh),
      solid_(solid),
      size_(mesh.size()),
      graph_(FacetGraph::of_solids(mesh)),
      around_(mesh)
{
    std::map<int, std::vector<int>> facets;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (thickness_at(t) > 0.0)
            facets[graph_.component(t)].push_back(t);
    for (auto& [component, own] : facets)
    {
        mesh::PickingTree tree(mesh::submesh(mesh, own).mesh);
        thin_.emplace(component, Component{std::move(own), std::move(tree)});
    }
}

// The facet of a skin straight through the material, from the point of `facet` nearest to `point`;
// -1 if there is none.
int AcrossSheet::facet_behind(int facet, const Vector3& point, SolidSide skin) const
{
    if (graph_.is_thin(facet))
        return -1;
    const Component& component = thin_.at(graph_.component(facet));
    const Vector3 inwards = -graph_.normal(facet);
    const Vector3 start = nearest_on(mesh_.points(), mesh_.triangles(), facet, point).point;
    const Vector3 way = graph_.centroid(facet) - start;
    const double step = first_step * size_;
    for (const double thicknesses : beside)
    {
        const double share =
            std::min(1.0, thicknesses * thickness_at(facet) / std::max(way.norm(), 1e-300));
        const std::optional<Hit> hit =
            component.tree.nearest_hit(start + share * way + step * inwards, inwards);
        if (hit && side(component.facets[at(hit->triangle)]) == skin)
            return component.facets[at(hit->triangle)];
    }
    return -1;
}

double AcrossSheet::thickness(int vertex) const
{
    for (const int facet : around_.at(vertex))
        if (const double found = thickness_at(facet); found > 0.0)
            return found;
    return 0.0;
}

std::vector<Hit> AcrossSheet::places(int vertex, SolidSide skin) const
{
    const Vector3 point = mesh_.points().row(vertex).transpose();
    const bool is_on_lump = solid_.vertices[at(vertex)] == SolidSide::lump;
    Walk walk(*this, point, mesh_.points());
    for (const int facet : around_.at(vertex))
        if (thickness_at(facet) > 0.0)
            walk.push(facet, 0.0);
    NearPlaces found(size_);
    std::vector<Vector3> crossed;
    while (const auto step = walk.pop(found.limit()))
    {
        const auto& [way, hit] = *step;
        const int facet = hit.triangle;
        if (side(facet) != skin)
        {
            if (!crosses(facet, skin, walk, crossed))
                walk.push_neighbours(hit, way);
            continue;
        }
        const double along = (hit.point - point).dot(graph_.normal(facet));
        found.add(hit, is_on_lump || along >= from_behind * hit.distance);
        walk.push_neighbours(hit, 0.0, skin);
    }
    return found.nearest();
}

// Casts a ray from a facet to the skin across its sheet. If the ray reaches that skin, the walk
// continues there.
// \param crossed  normals of the facets whose rays reached it
bool AcrossSheet::crosses(int facet, SolidSide skin, Walk& walk,
                          std::vector<Vector3>& crossed) const
{
    const SolidSide other = skin == SolidSide::main ? SolidSide::opposite : SolidSide::main;
    if (side(facet) != other)
        return false;
    const Vector3 normal = graph_.normal(facet);
    const auto faces_alike = [&](const Vector3& one) { return one.dot(normal) > alike; };
    if (std::any_of(crossed.begin(), crossed.end(), faces_alike))
        return true;
    const int behind = facet_behind(facet, walk.point(), skin);
    if (behind < 0)
        return false;
    walk.push(behind, 0.0);
    const double distance =
        nearest_on(mesh_.points(), mesh_.triangles(), behind, walk.point()).distance;
    if (distance > farthest_skin * thickness_at(facet))
        return false;
    crossed.push_back(normal);
    return true;
}

Hit AcrossSheet::nearest_around(int facet, const Vector3& point, const Points& positions) const
{
    Walk walk(*this, point, positions);
    walk.push(facet, 0.0);
    Hit nearest;
    nearest.distance = std::numeric_limits<double>::infinity();
    while (const auto step = walk.pop(nearest.distance))
    {
        if (step->second.distance < nearest.distance)
            nearest = step->second;
        walk.push_neighbours(step->second, 0.0, side(facet));
    }
    return nearest;
}

}  // namespace sheetmorph::recognise
