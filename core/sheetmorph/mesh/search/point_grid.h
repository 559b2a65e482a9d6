// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <array>
#include <cstdint>

namespace sheetmorph::mesh
{

//! A hashed spatial grid of points. Box queries are fast if the box is not much larger than a cell.
class PointGrid
{
public:
    //! \param points  (n, 3) mm; referenced, not copied
    //! \param chosen  rows to insert; ascending
    //! \param side    cell size, mm
    PointGrid(const Points& points, const VertexIds& chosen, double side);
    PointGrid(const Points& points, double side);

    double side() const { return side_; }

    //! Calls use(i) for every point inside a box or on its border, in undefined order.
    template <typename Use>
    void for_each_in(const Vector3& low, const Vector3& high, const Use& use) const
    {
        const Cell first = cell_of(low), last = cell_of(high);
        if (count_between(first, last) > static_cast<double>(entries_.size()))
        {
            for (const Entry& entry : entries_)
                if (is_in(entry.point, low, high))
                    use(entry.point);
            return;
        }
        for (std::int64_t x = first[0]; x <= last[0]; ++x)
            for (std::int64_t y = first[1]; y <= last[1]; ++y)
                for (std::int64_t z = first[2]; z <= last[2]; ++z)
                {
                    const Cell cell = {x, y, z};
                    const std::size_t slot = slot_of(cell);
                    for (std::size_t k = starts_[slot]; k < starts_[slot + 1]; ++k)
                        // Different cells may share a slot.
                        if (entries_[k].cell == cell && is_in(entries_[k].point, low, high))
                            use(entries_[k].point);
                }
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    struct Entry
    {
        Cell cell;
        int point;
    };

    Cell cell_of(const Vector3& place) const;
    static double count_between(const Cell& first, const Cell& last);
    std::size_t slot_of(const Cell& cell) const;
    bool is_in(int point, const Vector3& low, const Vector3& high) const
    {
        const auto place = points_.row(point).transpose().array();
        return (place >= low.array()).all() && (place <= high.array()).all();
    }

    const Points& points_;
    Vector3 low_;
    double side_;
    std::vector<Entry> entries_;  // sorted by slot
    // First entry of every slot, and the end; the number of slots is a power of two.
    std::vector<std::size_t> starts_;
};

}  // namespace sheetmorph::mesh
