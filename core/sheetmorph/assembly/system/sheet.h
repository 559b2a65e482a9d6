// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/labels.h"

namespace sheetmorph::assembly
{

//! One row of what a link makes of its targets.
struct LinkRow
{
    int link = 0;
    Eigen::Index row = 0;
    double weight = 1.0;
};

//! A mesh that is solved by itself, with all its constraints: one part of the assembly, or several
//! that lie in it one after the other.
struct Sheet
{
    std::string name;         //!< of its parts, for messages
    std::vector<int> parts;   //!< ascending
    std::vector<int> first;   //!< their first vertices
    std::vector<Subject> of;  //!< the parts as entries of the user
    std::vector<int> ids;     //!< (n) vertex ids in the files of the parts; empty: 0..n-1
    mesh::TriangleMesh mesh;

    surface::SurfaceConstraints surface;
    std::vector<int> handles;   //!< index into Assembly::handles, in the order of surface.handles
    std::vector<int> features;  //!< index into Assembly::features
    std::vector<int> points;    //!< index into Assembly::points
    std::vector<int> leaders;   //!< by link: the leading feature if on another sheet, else -1
    std::vector<int> carried;   //!< welds that move this sheet: handles after `handles`
    std::vector<int> carriers;  //!< welds that are bodies of it: features after `features`
    std::vector<int> held;      //!< welds that a fixed region of some part holds: fixed here too

    //! Pieces that nothing else holds: fixed, or features at the end.
    std::vector<VertexIds> loose;

    //! By propagated region and vertex: the rows whose weighted mean is its target. On one vertex
    //! tied comes before control mesh; of equal rank all count.
    std::vector<std::vector<std::vector<LinkRow>>> propagated;

    //! Whether a pose can move the sheet.
    bool is_driven() const;

    //! The part that has a vertex of the sheet.
    int part_of(int vertex) const;

    //! The parts that have some of the vertices, as entries of the user; all of them for none.
    std::vector<Subject> subjects_of(const VertexIds& vertices) const;
};

//! The same fault with the sheet's parts in front and its vertices as their files number them.
InvalidInput in_sheet(const InvalidInput& fault, const Sheet& sheet);
SolverError on_sheet(const SolverError& fault, const Sheet& sheet);

}  // namespace sheetmorph::assembly
