// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/point_grid.h"

#include "sheetmorph/base/index.h"

#include <cmath>
#include <numeric>

namespace sheetmorph::mesh
{

namespace
{

VertexIds all_rows(const Points& points)
{
    VertexIds rows(at(points.rows()));
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

}  // namespace

PointGrid::PointGrid(const Points& points, double side) : PointGrid(points, all_rows(points), side)
{
}

PointGrid::PointGrid(const Points& points, const VertexIds& chosen, double side)
    : points_(points), side_(side), entries_(chosen.size())
{
    low_ = points.rows() > 0 ? Vector3(points.colwise().minCoeff().transpose()) : Vector3::Zero();
    std::size_t slots = 1;
    while (slots < chosen.size())
        slots *= 2;
    starts_.assign(slots + 1, 0);
    std::vector<Cell> cells;
    for (const int point : chosen)
    {
        cells.push_back(cell_of(points.row(point).transpose()));
        ++starts_[slot_of(cells.back()) + 1];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t k = 0; k < chosen.size(); ++k)
        entries_[next[slot_of(cells[k])]++] = {cells[k], chosen[k]};
}

// Clamps cell indices to a range in which doubles are exact (integers up to 2^53 = 9e15); farther
// points fall in the last cell.
PointGrid::Cell PointGrid::cell_of(const Vector3& place) const
{
    constexpr double last = 1e15;  // from doubles: below 2^53
    const Vector3 cell = ((place - low_) / side_).cwiseMax(-1.0).cwiseMin(last);
    return {static_cast<std::int64_t>(std::floor(cell.x())),
            static_cast<std::int64_t>(std::floor(cell.y())),
            static_cast<std::int64_t>(std::floor(cell.z()))};
}

double PointGrid::count_between(const Cell& first, const Cell& last)
{
    double count = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        count *= static_cast<double>(last[axis] - first[axis] + 1);
    return count;
}

std::size_t PointGrid::slot_of(const Cell& cell) const
{
    std::uint64_t key = 0;
    for (const std::int64_t index : cell)
        key = (key ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15U;
    return (key ^ key >> 32U) & (starts_.size() - 2);
}

}  // namespace sheetmorph::mesh
