// SPDX-License-Identifier: LGPL-2.1-or-later
#include "panel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sheetmorph::benchmarks
{

namespace
{

constexpr double edge = 10.0;  // mm
constexpr int holes_across = 5;
constexpr int holes_along = 4;

// A flat grid in whole steps, before holes are cut and the sheet is curved.
struct Grid
{
    int columns;
    int rows;
    double radius;  // of the holes, mm: 48 vertices around one, or what the sheet has room for

    // The holes take 183 vertices each, or 0.29 of a small sheet.
    explicit Grid(int vertices)
        : columns(static_cast<int>(std::sqrt(1.3 * std::min(1.4 * vertices, vertices + 3660.0)))),
          rows(static_cast<int>(columns / 1.3)),
          radius(edge * std::min(48.0 / (2.0 * M_PI), 0.3 * columns / holes_across))
    {
    }

    int count() const { return columns * rows; }
    Vector3 place(int vertex) const
    {
        return edge * Vector3(vertex % columns, static_cast<double>(vertex / columns), 0.0);
    }
    Vector3 centre(int hole) const
    {
        const double x = (hole % holes_across + 0.5) * (columns - 1) / holes_across;
        const double y =
            (static_cast<double>(hole / holes_across) + 0.5) * (rows - 1) / holes_along;
        return edge * Vector3(x, y, 0.0);
    }
};

// Vertices inside a hole go, those near its rim move onto it.
struct Cut
{
    std::vector<int> new_id;  // of every grid vertex, -1 where it is cut away
    Points points;
    std::vector<VertexIds> rims;
};

Cut cut_holes(const Grid& grid)
{
    Cut cut{std::vector<int>(static_cast<std::size_t>(grid.count()), -1), Points(grid.count(), 3),
            std::vector<VertexIds>(holes_across * holes_along)};
    int kept = 0;
    for (int vertex = 0; vertex < grid.count(); ++vertex)
    {
        Vector3 place = grid.place(vertex);
        bool is_inside = false;
        for (int hole = 0; hole < holes_across * holes_along; ++hole)
        {
            const Vector3 centre = grid.centre(hole);
            const double distance = (place - centre).norm();
            if (std::abs(distance - grid.radius) < 0.5 * edge)
            {
                place = centre + (place - centre) * (grid.radius / distance);
                cut.rims[static_cast<std::size_t>(hole)].push_back(kept);
            }
            is_inside = is_inside || distance <= grid.radius - 0.5 * edge;
        }
        if (is_inside)
            continue;
        cut.points.row(kept) = place.transpose();
        cut.new_id[static_cast<std::size_t>(vertex)] = kept++;
    }
    cut.points.conservativeResize(kept, 3);
    return cut;
}

Triangles triangulate(const Grid& grid, const Cut& cut)
{
    std::vector<std::array<int, 3>> kept;
    const auto add = [&](int a, int b, int c)
    {
        const auto id = [&](int vertex) { return cut.new_id[static_cast<std::size_t>(vertex)]; };
        if (id(a) >= 0 && id(b) >= 0 && id(c) >= 0)
            kept.push_back({id(a), id(b), id(c)});
    };
    for (int row = 0; row + 1 < grid.rows; ++row)
        for (int column = 0; column + 1 < grid.columns; ++column)
        {
            const int corner = row * grid.columns + column;
            add(corner, corner + 1, corner + grid.columns);
            add(corner + 1, corner + grid.columns + 1, corner + grid.columns);
        }
    Triangles triangles(static_cast<Eigen::Index>(kept.size()), 3);
    for (std::size_t t = 0; t < kept.size(); ++t)
        triangles.row(static_cast<Eigen::Index>(t)) << kept[t][0], kept[t][1], kept[t][2];
    return triangles;
}

VertexIds vertices_where(const Points& points, double low, double high)
{
    VertexIds found;
    for (int vertex = 0; vertex < points.rows(); ++vertex)
        if (points(vertex, 0) >= low && points(vertex, 0) <= high)
            found.push_back(vertex);
    return found;
}

}  // namespace

Panel curved_panel(int vertices)
{
    const Grid grid(vertices);
    Cut cut = cut_holes(grid);
    const double width = edge * (grid.columns - 1);
    surface::SurfaceConstraints constraints;
    constraints.fixed = {{"fixed strip", vertices_where(cut.points, 0.0, 0.02 * width)}};
    constraints.handles = {{"handle", vertices_where(cut.points, 0.99 * width, width)}};
    for (const VertexIds& rim : cut.rims)
    {
        surface::FormFeature hole;
        hole.name = "hole" + std::to_string(constraints.features.size() + 1);
        hole.vertices = rim;
        hole.rotation = surface::FeatureRotation::interpolated;
        constraints.features.push_back(hole);
    }
    const Triangles triangles = triangulate(grid, cut);
    for (int vertex = 0; vertex < cut.points.rows(); ++vertex)
    {
        const double x = cut.points(vertex, 0) / width;
        const double y = cut.points(vertex, 1) / width;
        cut.points(vertex, 2) = 0.15 * width * std::sin(M_PI * x) * (1.0 - 0.5 * y * y);
    }
    return {mesh::TriangleMesh(cut.points, triangles), constraints};
}

}  // namespace sheetmorph::benchmarks
