// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! Longest edge over height from which on a triangle counts as a sliver.
constexpr double sliver_aspect = 25.0;

//! What a connected piece of a mesh is, its near vertices taken as one.
enum class PieceKind
{
    open_shell,  //!< it has open edges
    thin_solid,  //!< closed, a sheet with two skins (told by diagnose_sheets alone)
    solid        //!< closed otherwise
};

struct PieceDiagnosis
{
    PieceKind kind = PieceKind::open_shell;
    int triangles = 0;
    double area = 0.0;           //!< mm^2
    double volume = 0.0;         //!< mm^3, > 0; of closed pieces only
    bool is_inside_out = false;  //!< closed, and most of it faces inwards
    double thickness = 0.0;      //!< of a thin solid: the one of its largest sheet, mm
    double thinnest = 0.0;       //!< of a thin solid: nine tenths of it are between these, mm
    double thickest = 0.0;
};

//! How long the edges of a mesh are, mm.
struct EdgeLengths
{
    double shortest = 0.0, median = 0.0, longest = 0.0;
};

//! Closed round rims of holes and pins: at borders and creases.
struct RimDiagnosis
{
    int count = 0;
    double smallest_radius = 0.0, largest_radius = 0.0;  //!< mm
    int fewest_vertices = 0;                             //!< of any rim
};

//! What a mesh is and what is wrong with it. Counts are of the mesh as it stands unless they say
//! otherwise.
struct Diagnosis
{
    double size = 0.0;       //!< diagonal of the bounding box of the triangles, mm
    double tolerance = 0.0;  //!< vertices nearer than this are one place, mm
    EdgeLengths edges;
    RimDiagnosis rims;
    int unused_vertices = 0;
    int duplicate_vertices = 0;       //!< in exactly the place of an earlier one
    int near_duplicate_vertices = 0;  //!< pairs of different places within the tolerance
    int duplicate_triangles = 0;      //!< over the same three vertices as one before
    int degenerate_triangles = 0;     //!< repeat a vertex or are thinner than 1e-5
    int slivers = 0;                  //!< longest edge / height > 25, degenerate ones left out
    int flipped_triangles = 0;        //!< the fewest to turn so that each piece faces one way
    bool is_one_sided = false;        //!< no turning makes a piece face one way
    int t_junctions = 0;              //!< vertices inside open edges, equal vertices taken as one
    int open_edges = 0;
    int non_manifold_edges = 0;          //!< with three triangles or more
    int open_edges_welded = 0;           //!< what would be left once near vertices are one
    int non_manifold_edges_welded = 0;   //!< the same
    std::vector<PieceDiagnosis> pieces;  //!< the welded mesh's, by their first triangle
};

//! The mesh with near vertices as one if it has open edges; as it stands if it is closed. Its
//! vertices and triangles keep their numbers.
TriangleMesh without_cuts(const TriangleMesh& mesh, double tolerance);

//! Looks at a mesh; changes nothing.
//! \param tolerance  mm, >= 0
//! \throws InvalidInput for a tolerance that is negative or not finite
Diagnosis diagnose(const TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph::mesh
