// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/pick/vertex_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sheetmorph::pick
{

namespace
{

// Difference of depths (-1 to 1) of points on one surface. Chosen: 0.001 mm in a parallel view of a
// scene 2 m deep, less than every thickness and far above the rounding of a depth (1e-15).
constexpr double touching = 1e-6;
constexpr double vertices_per_cell = 2.0;  // chosen: few cells are empty, few hold many vertices
constexpr int most_cells = 1024;           // along a side; chosen: about the pixels of a screen

bool is_hidden(const Vector3& place, const std::array<Vector3, 3>& corners)
{
    double weights[3];
    bool is_left = false, is_right = false;
    for (int k = 0; k < 3; ++k)
    {
        const Vector3& a = corners[(k + 1) % 3];
        const Vector3& b = corners[(k + 2) % 3];
        weights[k] =
            (a.x() - place.x()) * (b.y() - place.y()) - (a.y() - place.y()) * (b.x() - place.x());
        is_left = is_left || weights[k] > 0.0;
        is_right = is_right || weights[k] < 0.0;
        if (is_left && is_right)
            return false;
    }
    const double sum = weights[0] + weights[1] + weights[2];
    if (sum == 0.0)
        return false;
    double depth = 0.0;
    for (int k = 0; k < 3; ++k)
        depth += weights[k] * corners[k].z();
    return depth / sum < place.z() - touching;
}

}  // namespace

void VertexCells::Range::add(double value)
{
    low = std::min(low, value);
    high = std::max(high, value);
}

VertexCells::VertexCells(const std::vector<Seen>& seen)
{
    const double side = std::sqrt(static_cast<double>(seen.size()) / vertices_per_cell);
    count_ = std::clamp(static_cast<int>(side), 1, most_cells);
    for (const Seen& one : seen)
        for (int c = 0; c < 3; ++c)
            extent_[c].add(one.place(c));
    for (int c = 0; c < 2; ++c)
    {
        const double extent = extent_[c].high - extent_[c].low;
        cells_per_px_[c] = extent > 0.0 ? count_ / extent : 0.0;
    }
    sort(seen);
}

void VertexCells::hide_behind(const std::array<Vector3, 3>& corners)
{
    Range width, height, depth;
    for (const Vector3& corner : corners)
    {
        width.add(corner.x());
        height.add(corner.y());
        depth.add(corner.z());
    }
    if (!(depth.high < infinite) || !overlaps(height, 1) || !overlaps(width, 0))
        return;
    const int first = cell_of(height.low, 1);
    const int last = cell_of(height.high, 1);
    for (int row = first; row <= last; ++row)
    {
        if (last > first + 2)
            width = width_in(row, corners);
        if (!overlaps(width, 0))
            continue;
        Cell* const cells = cells_.data() + static_cast<std::size_t>(row) * count_;
        const int end = cell_of(width.high, 0);
        for (int column = cell_of(width.low, 0); column <= end; ++column)
            if (cells[column].farthest - touching > depth.low)
                hide_in(cells[column], corners, depth.low);
    }
}

VertexIds VertexCells::left() const
{
    VertexIds vertices;
    for (const Cell& cell : cells_)
        for (int k = cell.first; k < cell.end; ++k)
            vertices.push_back(members_[static_cast<std::size_t>(k)].vertex);
    return vertices;
}

void VertexCells::sort(const std::vector<Seen>& seen)
{
    cells_.resize(static_cast<std::size_t>(count_) * count_);
    for (const Seen& one : seen)
        ++cell_at(one.place).end;
    int next = 0;
    for (Cell& cell : cells_)
    {
        cell.first = next;
        next += cell.end;
        cell.end = cell.first;
    }
    members_.resize(seen.size());
    for (const Seen& one : seen)
    {
        Cell& cell = cell_at(one.place);
        members_[cell.end++] = one;
        cell.farthest = std::max(cell.farthest, one.place.z());
    }
}

VertexCells::Cell& VertexCells::cell_at(const Vector3& place)
{
    return cells_[static_cast<std::size_t>(cell_of(place.y(), 1) * count_ + cell_of(place.x(), 0))];
}

int VertexCells::cell_of(double value, int c) const
{
    const double cell = (value - extent_[c].low) * cells_per_px_[c];
    return static_cast<int>(std::clamp(cell, 0.0, count_ - 1.0));
}

bool VertexCells::overlaps(const Range& range, int c) const
{
    return range.low <= extent_[c].high && range.high >= extent_[c].low;
}

// The horizontal extent of a triangle within a row of cells.
VertexCells::Range VertexCells::width_in(int row, const std::array<Vector3, 3>& corners) const
{
    const double height = (extent_[1].high - extent_[1].low) / count_;
    // The first and last rows include everything beyond. A margin of 0.1 % of a cell protects
    // against rounding.
    const double low = row == 0 ? -infinite : extent_[1].low + (row - 0.001) * height;
    const double high = row == count_ - 1 ? infinite : extent_[1].low + (row + 1.001) * height;
    Range width;
    for (int k = 0; k < 3; ++k)
    {
        const Vector3& a = corners[k];
        const Vector3& b = corners[(k + 1) % 3];
        if (std::max(a.y(), b.y()) < low || std::min(a.y(), b.y()) > high)
            continue;
        for (const double y : {std::clamp(a.y(), low, high), std::clamp(b.y(), low, high)})
        {
            const double rise = b.y() - a.y();
            const double along = rise != 0.0 ? (y - a.y()) / rise : 0.0;
            width.add(a.x() + along * (b.x() - a.x()));
        }
        if (a.y() == b.y())
            width.add(b.x());
    }
    return width;
}

void VertexCells::hide_in(Cell& cell, const std::array<Vector3, 3>& corners, double nearest)
{
    for (int k = cell.first; k < cell.end;)
    {
        const Vector3& place = members_[k].place;
        if (place.z() - touching > nearest && is_hidden(place, corners))
            std::swap(members_[k], members_[--cell.end]);
        else
            ++k;
    }
    if (cell.first == cell.end)
        cell.farthest = -infinite;
}

}  // namespace sheetmorph::pick
