// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/fitting/outline.h"

namespace sheetmorph::recognise
{

//! What a part of a sheet is. A hole is seen by its rims, whether the mesh is
//! open there (a sheet without thickness) or has a wall to another skin (a thin
//! solid); a round edge is a circle around which the sheet lies inside or
//! straight on: the end of a tube, the border of a disc.
enum class FeatureKind
{
    round_hole,
    slotted_hole,
    rectangular_hole,
    hole,  //!< of any other outline
    round_edge,
    plane,
    cylinder,
    cone,
    sphere,
    flange,  //!< a strip between a fold and a free edge
    bead,    //!< a raised strip inside a sheet
    emboss,  //!< any other raised place
    bend,    //!< a cylindrical strip between two flats, both skins of a solid
};

//! "round hole", "slotted hole", ...: what files and people call a kind.
const char* name_of(FeatureKind kind);

//! What a hole with such a rim is.
FeatureKind hole_kind(fitting::OutlineKind outline);

//! What a raised place of this length and width is called: a bead or an emboss.
FeatureKind raised_kind(double length, double width);

//! A feature found on a mesh. Lengths in mm, angles in radians; what a kind has
//! not is zero.
struct Feature
{
    FeatureKind kind = FeatureKind::hole;
    Vector3 center = Vector3::Zero();  //!< of its rim, surface or strip
    Vector3 axis = Vector3::UnitZ();   //!< of length 1: of a hole, cylinder, cone;
                                       //!< else its normal
    double radius = 0.0;          //!< of a circle; half the width of a slot; corners of a rectangle
    double length = 0.0;          //!< the longer extent across the axis; along it for
                                  //!< cylinder and cone
    double width = 0.0;           //!< the shorter one
    double depth = 0.0;           //!< between both rims of a hole or skins of a bend; height of a
                                  //!< bead or emboss
    double angle = 0.0;           //!< of a cone, between axis and surface; of a bend, its turn
    double residual = 0.0;        //!< largest distance of one of its vertices from the fitted form
    double scatter = 0.0;         //!< of the vertices of its mesh as measured, see tolerances.h
    double area = 0.0;            //!< of a surface, mm^2
    bool is_hollow = false;       //!< cylinder, cone, sphere of a closed part: seen from inside
    std::vector<VertexIds> rims;  //!< closed loops in order around; the first is the named one
    VertexIds vertices;           //!< ascending, rims and walls included
    Convergence convergence = {};   //!< of a surface: growing its triangles and fitting it in turn
    std::vector<VertexIds> washer;  //!< ring k: the vertices one triangle around ring k - 1
};

}  // namespace sheetmorph::recognise
