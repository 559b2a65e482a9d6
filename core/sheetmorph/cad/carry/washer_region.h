// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/meshing/shape_mesh.h"

#include <map>
#include <optional>
#include <set>

namespace sheetmorph::cad
{

//! Triangles of a face that surround some of its wires and otherwise lie inside the face.
struct WasherRegion
{
    std::set<int> triangles;  //!< of the mesh
    std::set<int> wires;      //!< of the face, counted from 0
    VertexIds outline;        //!< closed loop inside the face, with the triangles to its left
};

//! The mesh of one face, for the search for washers.
class FaceTriangles
{
public:
    //! \param triangles  triangles of the mesh on the face
    FaceTriangles(const ShapeMesh& mesh, int face, const std::vector<int>& triangles);

    //! Parameters of the vertices, without vertices that occur twice.
    const std::map<int, Vector2>& parameters() const { return parameters_; }

    //! The triangles around wires that touch `seeds` and have all their vertices in `moved`.
    std::optional<WasherRegion> around(const VertexIds& seeds, const std::set<int>& moved) const;

    //! Removes triangles. \returns false, without a change, if the rest would be in pieces
    bool take(const std::set<int>& triangles);

private:
    using Side = std::pair<int, int>;

    std::set<int> connected(const std::set<int>& allowed, const VertexIds& seeds) const;
    std::set<int> faults(WasherRegion& region) const;
    std::optional<Side> left_of(const Side& side, const std::set<int>& triangles) const;

    std::map<int, Vector2> parameters_;
    std::map<int, std::array<int, 3>> corners_;  // counter-clockwise in the parameters
    std::map<Side, int> triangle_;               // by its sides
    std::map<Side, int> wire_;                   // of a border side, smaller vertex first
    std::map<int, int> length_;                  // of wires, number of sides
    std::set<int> border_;                       // vertices
};

}  // namespace sheetmorph::cad
