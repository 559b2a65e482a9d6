// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/repair/remeshing/ridge_cuts.h"

#include <map>

namespace sheetmorph::repair
{

//! The round rims of a mesh and their circles; empty if default-constructed.
class RoundRims
{
public:
    RoundRims() = default;
    RoundRims(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table);

    int count() const { return static_cast<int>(circles_.size()); }

    //! The target edge length at the first `count` vertices that makes rims round, mm; infinite off
    //! the rims.
    std::vector<double> sizes(int count) const;

    //! Moves the vertices of the rims, including those inserted into their edges, to the circles.
    //! \param old_count  number of vertices before edges were cut
    mesh::TriangleMesh rounded(int old_count, const CutMesh& cut) const;

private:
    std::vector<fitting::CircleFit> circles_;
    std::map<int, int> circle_of_;                       // by vertex of a rim
    std::map<std::pair<int, int>, int> circle_of_edge_;  // by edge of a rim, smaller vertex first
};

}  // namespace sheetmorph::repair
