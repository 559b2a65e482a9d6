// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/repair/remeshing/ridge_cuts.h"

#include <map>

namespace sheetmorph::repair
{

//! The round rims of a mesh and their circles; none if default-constructed.
class RoundRims
{
public:
    RoundRims() = default;
    RoundRims(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table);

    int count() const { return static_cast<int>(circles_.size()); }

    //! The edge length wanted at the first `count` vertices, so that rims are round; infinite off
    //! the rims.
    std::vector<double> sizes(int count) const;

    //! The mesh with the vertices of the rims, those put into their edges included, on the circles.
    //! \param old_count  vertices before edges were cut
    mesh::TriangleMesh rounded(int old_count, const CutMesh& cut) const;

private:
    std::vector<fitting::CircleFit> circles_;
    std::map<int, int> circle_of_;                       // of a rim's vertex
    std::map<std::pair<int, int>, int> circle_of_edge_;  // of a rim's edge, smaller vertex first
};

}  // namespace sheetmorph::repair
