// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/t_junctions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace sheetmorph
{

namespace
{

using Cell = std::array<int, 3>;

// The vertices of a mesh in a grid of cells about as long as its open edges are.
class VertexGrid
{
public:
    VertexGrid(const TriangleMesh& mesh, const std::vector<BoundaryEdge>& edges)
        : points_(mesh.points()),
          low_(points_.colwise().minCoeff()),
          side_(std::max(2.0 * median_length(edges), mesh.size() / 256.0))
    {
        std::vector<char> is_used(static_cast<std::size_t>(mesh.vertex_count()), 0);
        for (Eigen::Index k = 0; k < mesh.triangles().size(); ++k)
            is_used[mesh.triangles().data()[k]] = 1;
        for (int i = 0; i < mesh.vertex_count(); ++i)
            if (is_used[i])
                vertices_.emplace_back(cell_of(points_.row(i)), i);
        std::sort(vertices_.begin(), vertices_.end());
    }

    // The vertices in the cells an edge runs through, and a little beside it, ascending.
    VertexIds along(const BoundaryEdge& edge, double beside) const
    {
        const Vector3 from = points_.row(edge.from);
        const Vector3 way = points_.row(edge.to).transpose() - from;
        const int steps = static_cast<int>(std::ceil(way.norm() / side_));
        std::vector<Cell> cells;
        for (int k = 0; k < steps; ++k)
        {
            const Vector3 one = from + way * (double(k) / steps);
            const Vector3 two = from + way * (double(k + 1) / steps);
            const Cell low = cell_of(one.cwiseMin(two).array() - beside);
            const Cell high = cell_of(one.cwiseMax(two).array() + beside);
            for (int x = low[0]; x <= high[0]; ++x)
                for (int y = low[1]; y <= high[1]; ++y)
                    for (int z = low[2]; z <= high[2]; ++z)
                        cells.push_back({x, y, z});
        }
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        return vertices_in(cells);
    }

private:
    double median_length(const std::vector<BoundaryEdge>& edges) const
    {
        std::vector<double> lengths;
        for (const BoundaryEdge& edge : edges)
            lengths.push_back((points_.row(edge.to) - points_.row(edge.from)).norm());
        const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
        std::nth_element(lengths.begin(), middle, lengths.end());
        return *middle;
    }

    Cell cell_of(const Vector3& place) const
    {
        const Vector3 cell = (place - low_) / side_;
        return {int(std::floor(cell.x())), int(std::floor(cell.y())), int(std::floor(cell.z()))};
    }

    VertexIds vertices_in(const std::vector<Cell>& cells) const
    {
        VertexIds found;
        for (const Cell& cell : cells)
            for (auto entry =
                     std::lower_bound(vertices_.begin(), vertices_.end(), std::pair(cell, -1));
                 entry != vertices_.end() && entry->first == cell; ++entry)
                found.push_back(entry->second);
        std::sort(found.begin(), found.end());
        return found;
    }

    const Points& points_;
    Vector3 low_;
    double side_;
    std::vector<std::pair<Cell, int>> vertices_;
};

// Whether a vertex is inside an edge, away from its ends.
bool is_inside(const Vector3& vertex, const Vector3& from, const Vector3& to, double tolerance)
{
    const Vector3 way = to - from;
    const double along = (vertex - from).dot(way) / way.squaredNorm();
    return along > 0.0 && along < 1.0 && (vertex - from).norm() > tolerance
           && (vertex - to).norm() > tolerance && (vertex - from - along * way).norm() <= tolerance;
}

}  // namespace

std::vector<TJunction> t_junctions(const TriangleMesh& mesh, double tolerance)
{
    return junctions_on(mesh, boundary_edges(mesh), tolerance);
}

std::vector<TJunction> junctions_on(const TriangleMesh& mesh,
                                    const std::vector<BoundaryEdge>& edges, double tolerance)
{
    if (edges.empty() || mesh.size() == 0.0)
        return {};
    const VertexGrid grid(mesh, edges);
    const Points& points = mesh.points();
    std::vector<TJunction> found;
    for (const BoundaryEdge& edge : edges)
        for (const int vertex : grid.along(edge, tolerance))
            if (vertex != edge.from && vertex != edge.to
                && is_inside(points.row(vertex), points.row(edge.from), points.row(edge.to),
                             tolerance))
                found.push_back({edge.from, edge.to, vertex});
    return found;
}

}  // namespace sheetmorph
