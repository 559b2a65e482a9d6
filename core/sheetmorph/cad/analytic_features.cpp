// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/analytic_features.h"
#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/topology/boundary.h"
#include "sheetmorph/mesh/topology/edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace sheetmorph::cad
{

namespace
{

// Two surfaces of one file are the same within this, relative to the part. From OpenCASCADE, whose
// readers treat points 1e-7 mm apart as one (Precision::Confusion), on a part of 1 mm.
constexpr double same_within = 1e-7;

Vector3 across(const CadSurface& surface, const Vector3& point)
{
    const Vector3 from = point - surface.point;
    return from - from.dot(surface.axis) * surface.axis;
}

double distance_to(const CadSurface& surface, const Vector3& point)
{
    const Vector3 from = point - surface.point;
    const double along = from.dot(surface.axis), away = across(surface, point).norm();
    switch (surface.kind)
    {
        case SurfaceKind::plane:
            return std::abs(along);
        case SurfaceKind::cylinder:
            return std::abs(away - surface.radius);
        case SurfaceKind::cone:
            return std::abs(away * std::cos(surface.half_angle)
                            - std::abs(along) * std::sin(surface.half_angle));
        case SurfaceKind::sphere:
            return std::abs(from.norm() - surface.radius);
        default:
            return 0.0;
    }
}

bool is_same(const CadSurface& a, const CadSurface& b, double size)
{
    const double near = same_within * size;
    if (a.kind != b.kind || a.kind == SurfaceKind::other || a.kind == SurfaceKind::torus)
        return false;
    if (std::abs(a.radius - b.radius) > near || std::abs(a.half_angle - b.half_angle) > same_within)
        return false;
    if (a.kind == SurfaceKind::sphere)
        return (a.point - b.point).norm() <= near;
    if (a.axis.cross(b.axis).norm() > same_within)
        return false;
    if (a.kind == SurfaceKind::cone)
        return (a.point - b.point).norm() <= near;
    return a.kind == SurfaceKind::plane ? distance_to(a, b.point) <= near
                                        : across(a, b.point).norm() <= near;
}

Vector3 upward(const Vector3& axis)
{
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    return axis(largest) < 0 ? Vector3(-axis) : axis;
}

// The features of one part; the constructor groups its faces.
class FeatureFinder
{
public:
    explicit FeatureFinder(const CadPart& part)
        : part_(part), edges_(part.mesh), groups_(static_cast<int>(part.surfaces.size()))
    {
        const double size = std::max(1.0, part.mesh.size());
        for (int e = 0; e < edges_.count(); ++e)
        {
            const mesh::EdgeUses uses = edges_.uses(e);
            if (uses.count() != 2)
                continue;
            const int a = face_of(uses.first[0].triangle), b = face_of(uses.first[1].triangle);
            if (a != b && is_same(surface(a), surface(b), size))
                groups_.join(a, b);
        }
        for (int t = 0; t < part.mesh.triangle_count(); ++t)
            triangles_[groups_.root(face_of(t))].push_back(t);
    }

    std::vector<CadFeature> find()
    {
        std::vector<CadFeature> found;
        for (const auto& [group, triangles] : triangles_)
            if (const SurfaceKind kind = surface(group).kind;
                kind != SurfaceKind::other && kind != SurfaceKind::torus)
                found.push_back(feature(group, triangles));
        if (!part_.is_closed)
            add_rims(found);
        std::stable_sort(found.begin(), found.end(),
                         [](const CadFeature& a, const CadFeature& b)
                         {
                             const bool is_hole_a = a.kind == CadFeatureKind::round_hole;
                             const bool is_hole_b = b.kind == CadFeatureKind::round_hole;
                             return is_hole_a != is_hole_b ? is_hole_a : a.vertices < b.vertices;
                         });
        return found;
    }

private:
    int face_of(int t) const { return part_.face_of_triangle[static_cast<std::size_t>(t)]; }
    const CadSurface& surface(int f) const { return part_.surfaces[static_cast<std::size_t>(f)]; }
    Vector3 point(int v) const { return part_.mesh.points().row(v).transpose(); }

    CadFeature feature(int group, const std::vector<int>& triangles)
    {
        const CadSurface& shape = surface(group);
        CadFeature found;
        found.axis = upward(shape.axis);
        found.radius = shape.kind == SurfaceKind::cone ? 0.0 : shape.radius;
        found.half_angle = shape.half_angle;
        measure(found, shape, triangles);
        switch (shape.kind)
        {
            case SurfaceKind::plane:
                found.kind = CadFeatureKind::plane;
                break;
            case SurfaceKind::cone:
                found.kind = CadFeatureKind::cone;
                break;
            case SurfaceKind::sphere:
                found.kind = CadFeatureKind::sphere;
                break;
            default:
                found.kind = part_.is_closed && found.is_hollow && goes_around(group, triangles)
                                 ? CadFeatureKind::round_hole
                                 : CadFeatureKind::cylinder;
        }
        return found;
    }

    void measure(CadFeature& found, const CadSurface& shape,
                 const std::vector<int>& triangles) const
    {
        double low = 0.0, high = 0.0, facing = 0.0, area = 0.0;
        Vector3 middle = Vector3::Zero();
        for (const int t : triangles)
        {
            const auto row = part_.mesh.triangles().row(t);
            const Vector3 a = point(row(0)), b = point(row(1)), c = point(row(2));
            const Vector3 normal = 0.5 * (b - a).cross(c - a), centre = (a + b + c) / 3.0;
            const Vector3 outward = shape.kind == SurfaceKind::sphere
                                        ? Vector3(centre - shape.point)
                                        : across(shape, centre);
            facing += normal.dot(outward);
            area += normal.norm();
            middle += normal.norm() * centre;
            found.vertices.insert(found.vertices.end(), {row(0), row(1), row(2)});
        }
        make_set(found.vertices);
        for (const int v : found.vertices)
        {
            const double along = (point(v) - shape.point).dot(shape.axis);
            low = v == found.vertices.front() ? along : std::min(low, along);
            high = v == found.vertices.front() ? along : std::max(high, along);
            found.residual = std::max(found.residual, distance_to(shape, point(v)));
        }
        if (shape.kind == SurfaceKind::plane)
            found.centre = area > 0 ? Vector3(middle / area) : point(found.vertices.front());
        else
        {
            const bool is_round = shape.kind == SurfaceKind::sphere;
            found.is_hollow = facing < 0.0;
            found.length = is_round ? 0.0 : high - low;
            found.centre =
                is_round ? shape.point : Vector3(shape.point + 0.5 * (low + high) * shape.axis);
        }
    }

    // Whether a closed border of a group goes around the group's axis.
    bool goes_around(int group, const std::vector<int>& triangles)
    {
        std::map<int, std::vector<int>> next;
        for (const int t : triangles)
            for (int k = 0; k < 3; ++k)
            {
                const mesh::EdgeUses uses = edges_.uses(edges_.edge_of(t, k));
                const auto is_inside = [&](const mesh::EdgeUse& use)
                { return use.triangle != t && groups_.root(face_of(use.triangle)) == group; };
                if (std::none_of(uses.begin(), uses.end(), is_inside))
                    next[part_.mesh.triangles()(t, k)].push_back(
                        part_.mesh.triangles()(t, (k + 1) % 3));
            }
        while (!next.empty())
        {
            VertexIds loop{next.begin()->first};
            for (auto it = next.begin(); it != next.end(); it = next.find(loop.back()))
            {
                loop.push_back(it->second.back());
                it->second.pop_back();
                if (it->second.empty())
                    next.erase(it);
            }
            if (loop.front() == loop.back() && turns(loop, surface(group)) != 0)
                return true;
        }
        return false;
    }

    // Number of turns of a closed loop around an axis. The last vertex of the loop equals the
    // first.
    int turns(const VertexIds& loop, const CadSurface& about) const
    {
        double angle = 0.0;
        for (std::size_t i = 0; i + 1 < loop.size(); ++i)
        {
            const Vector3 a = across(about, point(loop[i])), b = across(about, point(loop[i + 1]));
            angle += std::atan2(about.axis.dot(a.cross(b)), a.dot(b));
        }
        return static_cast<int>(std::lround(angle / (2.0 * M_PI)));
    }

    // The circular holes of a sheet without thickness; the sheet lies outside them.
    void add_rims(std::vector<CadFeature>& found) const
    {
        const double tolerance = same_within * std::max(1.0, part_.mesh.size());
        for (const VertexIds& loop : mesh::boundary_loops(part_.mesh))
        {
            VertexIds sorted = loop;
            std::sort(sorted.begin(), sorted.end());
            for (const CadCircle& circle : part_.circles)
            {
                CadSurface about;
                about.point = circle.centre;
                about.axis = circle.axis;
                about.radius = circle.radius;
                double residual = 0.0;
                for (const int v : loop)
                    residual = std::max(residual, distance_to_circle(about, point(v)));
                if (residual > tolerance)
                    continue;
                if (lies_outside(loop, about))
                    found.push_back({CadFeatureKind::round_hole, circle.centre, upward(circle.axis),
                                     circle.radius, 0.0, 0.0, true, sorted, residual});
                break;
            }
        }
    }

    static double distance_to_circle(const CadSurface& about, const Vector3& at)
    {
        const double along = (at - about.point).dot(about.axis);
        return std::hypot(across(about, at).norm() - about.radius, along);
    }

    bool lies_outside(const VertexIds& loop, const CadSurface& about) const
    {
        for (int e = 0; e < edges_.count(); ++e)
        {
            const mesh::EdgeUses uses = edges_.uses(e);
            if (uses.count() == 1 && uses.first->from == loop[0])
                return across(about, point(uses.first->opposite)).norm()
                       > about.radius * (1.0 + 1e-6);
        }
        return false;
    }

    const CadPart& part_;
    mesh::EdgeTable edges_;
    DisjointSets groups_;
    std::map<int, std::vector<int>> triangles_;
};

}  // namespace

std::vector<CadFeature> analytic_features(const CadPart& part)
{
    return part.mesh.triangle_count() > 0 ? FeatureFinder(part).find() : std::vector<CadFeature>();
}

}  // namespace sheetmorph::cad
