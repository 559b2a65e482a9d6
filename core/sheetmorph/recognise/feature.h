// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/fitting/outline.h"

namespace sheetmorph::recognise
{

//! Kinds of features on a part. A hole is recognised from its rims. Its rim is either free (a sheet
//! without thickness) or joined by a wall to the other skin (a thin solid). A round edge is a
//! circle; the sheet lies inside it (the border of a disc) or continues along its axis (the end of
//! a tube).
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
    emboss,  //!< any other raised or sunk region
    bend,    //!< a cylindrical strip between two flats; in a solid, both skins
};

//! The name in files and on screen: "round hole", "slotted hole", ...
const char* name_of(FeatureKind kind);

//! The kind of hole that has a rim with this outline.
FeatureKind hole_kind(fitting::OutlineKind outline);

//! A raised region at least twice as long as wide is a bead, any other an emboss.
FeatureKind raised_kind(double length, double width);

//! A feature found on a mesh. Lengths in mm, angles in radians. Values that a kind does not have
//! are zero.
struct Feature
{
    FeatureKind kind = FeatureKind::hole;
    Vector3 center = Vector3::Zero();  //!< of its rim, surface or strip
    Vector3 axis = Vector3::UnitZ();   //!< of a hole, cylinder or cone; else the normal; length 1
    double radius = 0.0;  //!< of a circle; half the width of a slot; of a rectangle's corners
    double length = 0.0;  //!< the longer extent across the axis; of a cylinder or cone along it
    double width = 0.0;   //!< the shorter extent across the axis
    double depth = 0.0;   //!< between rims of a hole or skins of a bend; height of a bead or emboss
    double angle = 0.0;   //!< of a cone, between axis and surface; of a bend, its total turn
    double residual = 0.0;          //!< largest distance of a vertex from the fitted shape
    double scatter = 0.0;           //!< measurement noise of the mesh, see tolerances.h
    double area = 0.0;              //!< of a surface, mm^2
    bool is_hollow = false;         //!< cylinder, cone or sphere of a closed part, seen from inside
    std::vector<VertexIds> rims;    //!< closed loops in order; the feature's own rim comes first
    VertexIds vertices;             //!< ascending, with rims and walls
    Convergence convergence = {};   //!< of the alternation of growing and fitting a surface
    std::vector<VertexIds> washer;  //!< ring k: the vertices one triangle around ring k - 1
};

}  // namespace sheetmorph::recognise
