// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/meshing/cad_meshing.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

namespace sheetmorph::cad
{

//! A number with three digits, for messages.
std::string short_number(double value);

//! How many triangles a shape needs, before it is meshed: from the lengths and curvatures of its
//! edges and the areas and principal curvatures of its faces, at a few places of each.
class MeshEstimate
{
public:
    explicit MeshEstimate(const TopoDS_Shape& shape);

    //! The triangles for some sizes, all above 0; within a factor of about 3.
    double triangles(const CadMeshing& meshing) const;

    //! \throws InvalidInput "what; what to do" if more than three million triangles are needed
    void check(const CadMeshing& meshing) const;

private:
    // A piece of an edge (mm), or of a face (mm^2, and its two curvatures), 1/mm.
    struct Piece
    {
        double length, curvature;
    };
    struct Patch
    {
        double area, first, second;
    };

    void add(const TopoDS_Edge& edge);
    void add(const TopoDS_Face& face);

    std::vector<Piece> pieces_;
    std::vector<Patch> patches_;
};

}  // namespace sheetmorph::cad
