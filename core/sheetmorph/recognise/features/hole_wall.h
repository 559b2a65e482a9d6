// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/features/region_loops.h"

#include <set>
#include <utility>

namespace sheetmorph::recognise
{

//! The surface behind a loop, inside its outline.
struct HoleWall
{
    std::vector<int> triangles;  //!< ascending
    bool leads_out = false;      //!< the wall reaches the rim of another skin or leaves the outline
    bool is_open = false;        //!< the wall has free edges of its own
    double covered = 0.0;        //!< projected area of the wall, relative to the outline's area
    //! largest distance of its vertices from the loop's plane, mm, signed by the loop's normal
    double height = 0.0;
};

//! Traces the surface inside loops that are rims of holes.
class WallTracer
{
public:
    //! \param loops  candidates for rims of holes
    WallTracer(const FacetGraph& graph, const std::vector<int>& labels,
               const std::vector<const RegionLoop*>& loops);

    HoleWall behind(const RegionLoop& loop) const;

private:
    bool is_outside(const RegionLoop& loop, int triangle) const;
    void measure(const RegionLoop& loop, HoleWall& wall) const;

    const FacetGraph& graph_;
    const std::vector<int>& labels_;
    std::set<std::pair<int, int>> doors_;  // (triangle of a region, its edge on a rim)
};

}  // namespace sheetmorph::recognise
