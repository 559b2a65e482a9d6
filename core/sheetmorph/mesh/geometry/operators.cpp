// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/operators.h"

#include "sheetmorph/mesh/geometry/thinness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace sheetmorph::mesh
{

namespace
{

// Replaces negative and zero cotangent weights. Chosen: small against the weight of a regular edge,
// cot(60 degrees) = 0.58, but a vertex with no other edges stays connected to its neighbours.
constexpr double smallest_weight = 1e-3;

struct Corners
{
    std::array<Vector3, 3> at;
    double longest;     // squared edge length
    double twice_area;  // without a lower limit

    Corners(const TriangleMesh& mesh, int triangle)
        : Corners({Vector3(mesh.points().row(mesh.triangles()(triangle, 0)).transpose()),
                   Vector3(mesh.points().row(mesh.triangles()(triangle, 1)).transpose()),
                   Vector3(mesh.points().row(mesh.triangles()(triangle, 2)).transpose())})
    {
    }

    explicit Corners(const std::array<Vector3, 3>& corners) : at(corners)
    {
        longest = 0.0;
        for (int k = 0; k < 3; ++k)
            longest = std::max(longest, (at[(k + 1) % 3] - at[k]).squaredNorm());
        twice_area = (at[1] - at[0]).cross(at[2] - at[0]).norm();
    }

    double corner_dot(int k) const
    {
        return (at[(k + 1) % 3] - at[k]).dot(at[(k + 2) % 3] - at[k]);
    }
};

bool repeats_a_vertex(const Triangles& triangles, int t)
{
    return triangles(t, 0) == triangles(t, 1) || triangles(t, 1) == triangles(t, 2)
           || triangles(t, 2) == triangles(t, 0);
}

// Area of each corner of a triangle: its Voronoi area if the triangle is not obtuse. In an obtuse
// triangle, half of the area at the obtuse corner and a quarter at the others.
Vector3 mixed_shares(const Corners& corners)
{
    const double area = 0.5 * corners.twice_area;
    for (int k = 0; k < 3; ++k)
        if (corners.corner_dot(k) <= 0.0)
        {
            Vector3 shares = Vector3::Constant(0.25 * area);
            shares(k) = 0.5 * area;
            return shares;
        }
    Vector3 shares = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
        const int a = (k + 1) % 3;
        const int b = (k + 2) % 3;
        const double cotangent = corners.corner_dot(k) / corners.twice_area;
        const double part = 0.125 * cotangent * (corners.at[a] - corners.at[b]).squaredNorm();
        shares(a) += part;
        shares(b) += part;
    }
    return shares;
}

// Vertices of at least one non-degenerate triangle.
std::vector<char> sound_vertices(const TriangleMesh& mesh)
{
    std::vector<char> sound(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const Corners corners(mesh, t);
        if (!repeats_a_vertex(mesh.triangles(), t)
            && corners.twice_area > thinnest_for_operators * corners.longest)
            for (int k = 0; k < 3; ++k)
                sound[static_cast<std::size_t>(mesh.triangles()(t, k))] = 1;
    }
    return sound;
}

Eigen::SparseMatrix<double> stiffness_of(int vertex_count,
                                         std::vector<Eigen::Triplet<double>> edges)
{
    const std::size_t count = edges.size();
    for (std::size_t k = 0; k < count; ++k)
    {
        const Eigen::Triplet<double> edge = edges[k];
        edges.emplace_back(edge.col(), edge.row(), edge.value());
        edges.emplace_back(edge.row(), edge.row(), -edge.value());
        edges.emplace_back(edge.col(), edge.col(), -edge.value());
    }
    Eigen::SparseMatrix<double> stiffness(vertex_count, vertex_count);
    stiffness.setFromTriplets(edges.begin(), edges.end());
    return stiffness;
}

// Off-diagonal entries, one per side of a triangle.
std::vector<Eigen::Triplet<double>> edge_entries(const TriangleMesh& mesh, const Points& weights)
{
    std::vector<Eigen::Triplet<double>> edges;
    edges.reserve(static_cast<std::size_t>(12 * mesh.triangle_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            if (weights(t, k) != 0.0)
                edges.emplace_back(mesh.triangles()(t, (k + 1) % 3),
                                   mesh.triangles()(t, (k + 2) % 3), -weights(t, k));
    return edges;
}

}  // namespace

Points half_cotangents(const TriangleMesh& mesh)
{
    const std::vector<char> sound = sound_vertices(mesh);
    Points weights = Points::Zero(mesh.triangle_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        bool counts = !repeats_a_vertex(mesh.triangles(), t);
        for (int k = 0; k < 3; ++k)
            counts = counts && sound[static_cast<std::size_t>(mesh.triangles()(t, k))];
        if (!counts)
            continue;
        const Corners corners(mesh, t);
        const double sine = std::max(corners.twice_area, thinnest_for_operators * corners.longest);
        for (int k = 0; k < 3; ++k)
            weights(t, k) = 0.5 * corners.corner_dot(k) / sine;
    }
    return weights;
}

Eigen::SparseMatrix<double> cotangent_stiffness(const TriangleMesh& mesh,
                                                const Points& half_cotangents)
{
    return stiffness_of(mesh.vertex_count(), edge_entries(mesh, half_cotangents));
}

Eigen::SparseMatrix<double> non_negative_stiffness(const TriangleMesh& mesh,
                                                   const Points& half_cotangents)
{
    // Includes edges between right angles, whose weight is zero.
    std::vector<Eigen::Triplet<double>> edges;
    edges.reserve(static_cast<std::size_t>(6 * mesh.triangle_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3 && !half_cotangents.row(t).isZero(0.0); ++k)
        {
            const int a = mesh.triangles()(t, (k + 1) % 3);
            const int b = mesh.triangles()(t, (k + 2) % 3);
            edges.emplace_back(std::min(a, b), std::max(a, b), half_cotangents(t, k));
        }
    Eigen::SparseMatrix<double> weights(mesh.vertex_count(), mesh.vertex_count());
    weights.setFromTriplets(edges.begin(), edges.end());
    edges.clear();
    for (int column = 0; column < weights.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator edge(weights, column); edge; ++edge)
            edges.emplace_back(static_cast<int>(edge.row()), column,
                               -std::max(edge.value(), smallest_weight));
    return stiffness_of(mesh.vertex_count(), std::move(edges));
}

Vector3 mixed_voronoi_shares(const std::array<Vector3, 3>& corners)
{
    const Corners of(corners);
    return of.twice_area > 0.0 ? mixed_shares(of) : Vector3(Vector3::Zero());
}

Eigen::VectorXd voronoi_areas(const TriangleMesh& mesh)
{
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
    Eigen::VectorXd extent = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const Corners corners(mesh, t);
        if (repeats_a_vertex(mesh.triangles(), t) || corners.longest == 0.0)
            continue;
        const Vector3 shares = mixed_voronoi_shares(corners.at);
        for (int k = 0; k < 3; ++k)
        {
            areas(mesh.triangles()(t, k)) += shares(k);
            double& reach = extent(mesh.triangles()(t, k));
            reach = std::max(reach, corners.longest);
        }
    }
    for (Eigen::Index i = 0; i < areas.size(); ++i)
        areas(i) = extent(i) == 0.0 ? 1.0 : std::max(areas(i), thinnest_for_operators * extent(i));
    return areas;
}

Points apply_stiffness(const TriangleMesh& mesh, const Points& half_cotangents,
                       const Points& points)
{
    Points result = Points::Zero(mesh.vertex_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = mesh.triangles()(t, (k + 1) % 3);
            const int b = mesh.triangles()(t, (k + 2) % 3);
            const Eigen::RowVector3d flow = half_cotangents(t, k) * (points.row(a) - points.row(b));
            result.row(a) += flow;
            result.row(b) -= flow;
        }
    return result;
}

}  // namespace sheetmorph::mesh
