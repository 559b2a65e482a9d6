// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/features/region_loops.h"

namespace sheetmorph::recognise
{

//! The borders at which a whole piece of sheet ends. A flange folded inwards makes such a border
//! look like the rim of a hole: the sheet surrounds it, but little of it.
class OuterBorders
{
public:
    //! \param free_loops  the rims of the mesh; only read during construction
    OuterBorders(const FacetGraph& graph, const std::vector<RegionLoop>& free_loops);

    //! Whether the loop is an outer border. Seen along its axis, the piece then covers less area
    //! outside the loop than the loop encloses. In addition, the loop is the largest rim of its
    //! piece, or the piece closes it like the bottom of a dish.
    bool has(const RegionLoop& loop) const;

private:
    int piece_of(const RegionLoop& loop) const { return piece_[loop.triangles.front()]; }

    const FacetGraph& graph_;
    std::vector<int> piece_;       // by triangle
    std::vector<double> largest_;  // by piece: extent of its largest rim, mm
};

}  // namespace sheetmorph::recognise
