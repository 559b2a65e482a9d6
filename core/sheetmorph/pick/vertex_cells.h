// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <array>
#include <limits>

namespace sheetmorph::pick
{

//! A vertex and its screen point, as Screen::seen() returns it.
struct Seen
{
    Vector3 place;
    int vertex;
};

//! Vertices in a regular grid on the screen, from which hidden ones are removed triangle by
//! triangle.
class VertexCells
{
public:
    //! \param seen  finite points
    explicit VertexCells(const std::vector<Seen>& seen);

    //! Removes the vertices behind a triangle, by more than 1e-6 of depth.
    //! \param corners  screen points; a triangle with a corner behind the eye hides nothing
    void hide_behind(const std::array<Vector3, 3>& corners);

    //! The remaining vertices, in undefined order.
    VertexIds left() const;

    //! The bounding box of all initial vertices: px, px, depth.
    Vector3 low() const { return {extent_[0].low, extent_[1].low, extent_[2].low}; }
    Vector3 high() const { return {extent_[0].high, extent_[1].high, extent_[2].high}; }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();

    struct Range
    {
        double low = infinite;
        double high = -infinite;

        void add(double value);
    };

    struct Cell
    {
        int first = 0, end = 0;  // in members_
        double farthest = -infinite;
    };

    void sort(const std::vector<Seen>& seen);
    Cell& cell_at(const Vector3& place);
    int cell_of(double value, int c) const;
    bool overlaps(const Range& range, int c) const;
    Range width_in(int row, const std::array<Vector3, 3>& corners) const;
    void hide_in(Cell& cell, const std::array<Vector3, 3>& corners, double nearest);

    std::array<Range, 3> extent_;  // in x, y and depth
    std::array<double, 2> cells_per_px_;
    int count_ = 1;  // cells along a side
    std::vector<Cell> cells_;
    std::vector<Seen> members_;
};

}  // namespace sheetmorph::pick
