// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/cad/carry/worst_at.h"
#include "sheetmorph/cad/meshing/shape_mesh.h"

#include <TopTools_DataMapOfShapeShape.hxx>
#include <memory>

namespace sheetmorph::cad
{

//! Largest distances between a carried shape and its deformed mesh, mm. Measured with a prototype:
//! bends by 60 degrees need an edge tolerance of 0.0005 mm, otherwise surfaces intersect
//! themselves.
struct CarryTolerances
{
    double surface = 0.01;  //!< inside a face
    double edge = 0.0005;   //!< between an edge and its surfaces
    double grain = 1e-6;    //!< coordinates of poles are multiples of it
};

//! A shape after the deformation of its mesh: the same topology on new surfaces and curves.
struct CarriedShape
{
    TopoDS_Shape shape;
    std::vector<bool> is_kept;  //!< one per face: on its old surface, moved
    std::vector<double> scale;  //!< one per face: of the radius of a cylinder, else 1
    WorstAt gap;                //!< between an edge and a fitted face, if wider than before
    TopTools_DataMapOfShapeShape image;  //!< of every vertex, edge, face, shell and solid
    //! The mesh of the shape at rest. If washers were divided from faces, they are further faces at
    //! the end.
    std::shared_ptr<const ShapeMesh> mesh;
    std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>>
        washers;  //!< the face that each comes from, its image
};

//! Carries the deformation of a mesh to the shape that it was made from. Faces and edges whose
//! vertices moved as one rigid body keep their surfaces and curves. The others become cubic splines
//! that keep the parameters of their points. A ring of triangles inside a face that moves with a
//! hole becomes a face of its own.
//! \param result  (n, 3) positions of the mesh, in the coordinates of the shape, mm
//! \throws InvalidInput if a face has no mesh, SolverError
CarriedShape carried_shape(const std::shared_ptr<const ShapeMesh>& mesh, const Points& result,
                           const CarryTolerances& tolerances, const Progress& progress);

}  // namespace sheetmorph::cad
