// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/meshing/shape_mesh.h"

#include <map>
#include <optional>
#include <set>

namespace sheetmorph::cad
{

//! Triangles of a face that go around some of its wires, and lie within the face else.
struct WasherRegion
{
    std::set<int> triangles;  //!< of the mesh
    std::set<int> wires;      //!< of the face, counted from 0
    VertexIds outline;        //!< a closed loop inside the face; the triangles lie left of it
};

//! The mesh of one face, where washers are looked for.
class FaceTriangles
{
public:
    //! \param triangles  of the mesh, that lie on the face
    FaceTriangles(const ShapeMesh& mesh, int face, const std::vector<int>& triangles);

    //! The parameters of a vertex; of one that comes twice, none are told.
    const std::map<int, Vector2>& parameters() const { return parameters_; }

    //! The triangles around wires that touch `seeds`, all of whose vertices are in `moved`.
    std::optional<WasherRegion> around(const VertexIds& seeds, const std::set<int>& moved) const;

    //! Takes triangles away. \returns false, and takes none, if what is left is in pieces
    bool take(const std::set<int>& triangles);

private:
    using Side = std::pair<int, int>;

    std::set<int> connected(const std::set<int>& allowed, const VertexIds& seeds) const;
    std::set<int> faults(WasherRegion& region) const;
    std::optional<Side> left_of(const Side& side, const std::set<int>& triangles) const;

    std::map<int, Vector2> parameters_;
    std::map<int, std::array<int, 3>> corners_;  // counter-clockwise in the parameters
    std::map<Side, int> triangle_;               // by its sides
    std::map<Side, int> wire_;                   // of a side on a border, smaller vertex first
    std::map<int, int> length_;                  // of wires, in sides
    std::set<int> border_;                       // vertices
};

}  // namespace sheetmorph::cad
