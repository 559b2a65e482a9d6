// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/contacts/part_shape.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::recognise
{

namespace
{

// If the cosine between the direction to the nearest point and the normal there is smaller, that
// point lies sideways of the vertex and not opposite it. From geometry: 60 degrees. At the border
// of a sheet the nearest point is sideways if it is nearer to the plane than to the point.
constexpr double sideways = 0.5;

// Relative to the reach. At smaller distances, rounding determines the direction to the nearest
// point. Chosen: gaps of a fiftieth are contact, and files round coordinates to less.
constexpr double touching = 0.02;

}  // namespace

PartShape::PartShape(const ContactPart& part, double weld)
    : graph_(part.mesh, weld),
      tree_(graph_.mesh()),
      thickness_(part.thickness),
      triangles_(graph_.mesh())
{
    const int count = graph_.mesh().vertex_count();
    const Triangles& corners = graph_.mesh().triangles();
    is_free_.assign(static_cast<std::size_t>(count), 0);
    area_at_.assign(static_cast<std::size_t>(count), 0.0);
    for (Eigen::Index k = 0; k < corners.size(); ++k)
        area_at_[corners.data()[k]] += graph_.area(static_cast<int>(k / 3)) / 3.0;
    for (int edge = 0; edge < graph_.edges().count(); ++edge)
        if (graph_.edges().uses(edge).count() == 1)
        {
            const mesh::EdgeUse& use = *graph_.edges().uses(edge).begin();
            is_free_[use.from] = is_free_[use.to] = 1;
        }
    bool is_first = true;
    for (int v = 0; v < count; ++v)
    {
        if (triangles_.at(v).is_empty())
            continue;
        low_ = is_first ? graph_.point(v) : Vector3(low_.cwiseMin(graph_.point(v)));
        high_ = is_first ? graph_.point(v) : Vector3(high_.cwiseMax(graph_.point(v)));
        is_first = false;
    }
}

// The outsides of two solids must face each other; a sheet may face with either side.
bool PartShape::faces(int vertex, const PartShape& other, int triangle, double cosine) const
{
    const Vector3 normal = other.graph_.normal(triangle);
    const bool are_solid = graph_.is_solid() && other.graph_.is_solid();
    for (const int t : triangles_.at(vertex))
    {
        const double turn = normal.dot(graph_.normal(t));
        if (are_solid ? -turn >= cosine : std::abs(turn) >= cosine)
            return true;
    }
    return false;
}

bool PartShape::is_sideways(int vertex, const PartShape& other, const mesh::Hit& hit) const
{
    const Vector3 way = hit.point - graph_.point(vertex);
    return std::abs(way.dot(other.graph_.normal(hit.triangle))) < sideways * way.norm();
}

std::vector<Touch> PartShape::touches(const PartShape& other, double reach,
                                      double facing_angle) const
{
    std::vector<Touch> found;
    const double cosine = std::cos(facing_angle);
    const Vector3 low = other.low_.array() - reach;
    const Vector3 high = other.high_.array() + reach;
    for (int v = 0; v < graph_.mesh().vertex_count(); ++v)
    {
        const Vector3 point = graph_.point(v);
        if (triangles_.at(v).is_empty() || (point.array() < low.array()).any()
            || (point.array() > high.array()).any())
            continue;
        const std::optional<mesh::Hit> hit = other.tree_.nearest_point(point, reach);
        if (!hit || (hit->distance > touching * reach && is_sideways(v, other, *hit)))
            continue;
        const bool is_facing = faces(v, other, hit->triangle, cosine);
        if (is_facing || is_free(v))
            found.push_back({v, hit->triangle, hit->distance, !is_facing});
    }
    return found;
}

}  // namespace sheetmorph::recognise
