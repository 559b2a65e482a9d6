// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! A triangle with a larger ratio of longest edge to height counts as a sliver. Chosen: its
//! smallest angle is below 2.3 degrees, and its cotangents reach 25 (1.7 at most in a good mesh).
constexpr double sliver_aspect = 25.0;

//! Kind of a connected piece of a mesh whose near vertices are merged.
enum class PieceKind
{
    open_shell,  //!< with open edges
    thin_solid,  //!< closed, a sheet with two skins; only diagnose_sheets() detects it
    solid        //!< any other closed piece
};

struct PieceDiagnosis
{
    PieceKind kind = PieceKind::open_shell;
    int triangles = 0;
    double area = 0.0;           //!< mm^2
    double volume = 0.0;         //!< mm^3, > 0; only of closed pieces
    bool is_inside_out = false;  //!< closed, and most triangles face inwards
    double thickness = 0.0;      //!< of a thin solid: thickness of its largest sheet, mm
    double thinnest = 0.0;       //!< of a thin solid: 5 % and 95 % quantiles of the thickness, mm
    double thickest = 0.0;
};

//! Statistics of the edge lengths of a mesh, mm.
struct EdgeLengths
{
    double shortest = 0.0, median = 0.0, longest = 0.0;
};

//! Closed round rims of holes and pins, at borders and creases.
struct RimDiagnosis
{
    int count = 0;
    double smallest_radius = 0.0, largest_radius = 0.0;  //!< mm
    int fewest_vertices = 0;                             //!< of any rim
};

//! Properties and faults of a mesh. Counts refer to the unmodified mesh unless stated otherwise.
struct Diagnosis
{
    double size = 0.0;       //!< diagonal of the bounding box of the triangles, mm
    double tolerance = 0.0;  //!< vertices nearer than this count as one, mm
    EdgeLengths edges;
    RimDiagnosis rims;
    int unused_vertices = 0;
    int duplicate_vertices = 0;       //!< at exactly the position of an earlier one
    int near_duplicate_vertices = 0;  //!< pairs of different positions within the tolerance
    int duplicate_triangles = 0;      //!< with the same three vertices as an earlier one
    int degenerate_triangles = 0;     //!< repeat a vertex or are thinner than 1e-5
    int slivers = 0;                  //!< longest edge / height > 25, not degenerate
    int flipped_triangles = 0;        //!< fewest flips that orient every piece consistently
    bool is_one_sided = false;        //!< whether a piece cannot be oriented consistently
    int t_junctions = 0;              //!< vertices inside open edges, after merging equal vertices
    int open_edges = 0;
    int non_manifold_edges = 0;          //!< with three or more triangles
    int open_edges_welded = 0;           //!< left after merging near vertices
    int non_manifold_edges_welded = 0;   //!< left after merging near vertices
    std::vector<PieceDiagnosis> pieces;  //!< of the merged mesh, by first triangle
};

//! Merges near vertices if the mesh has open edges; a closed mesh stays as it is. Vertices and
//! triangles keep their indices.
TriangleMesh without_cuts(const TriangleMesh& mesh, double tolerance);

//! Diagnoses a mesh without changing it.
//! \param tolerance  mm, >= 0
//! \throws InvalidInput for a tolerance that is negative or not finite
Diagnosis diagnose(const TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph::mesh
