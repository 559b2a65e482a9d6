// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <array>
#include <limits>

namespace sheetmorph::pick
{

//! A vertex and where it is seen, as Screen::seen has it.
struct Seen
{
    Vector3 place;
    int vertex;
};

//! Vertices in equal cells of the screen, from which triangles take those they hide.
class VertexCells
{
public:
    //! \param seen  finite places
    explicit VertexCells(const std::vector<Seen>& seen);

    //! Takes away the vertices that lie behind a triangle by more than 1e-6 of depth.
    //! \param corners  as they are seen; a triangle with one behind the eye hides nothing
    void hide_behind(const std::array<Vector3, 3>& corners);

    //! Those that are left, in no order.
    VertexIds left() const;

    //! The box, px and depth, around all vertices at first.
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
    int count_ = 1;  // of cells along a side
    std::vector<Cell> cells_;
    std::vector<Seen> members_;
};

}  // namespace sheetmorph::pick
