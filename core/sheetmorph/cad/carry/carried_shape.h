// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/cad/carry/worst_at.h"
#include "sheetmorph/cad/meshing/shape_mesh.h"

#include <TopTools_DataMapOfShapeShape.hxx>
#include <memory>

namespace sheetmorph::cad
{

//! How near a carried shape comes to its deformed mesh, mm.
struct CarryTolerances
{
    double surface = 0.01;  //!< inside a face
    double edge = 0.0005;   //!< between an edge and the surfaces beside it
    double grain = 1e-6;    //!< coordinates of poles are multiples of it
};

//! A shape after its mesh was deformed: the same topology on new surfaces and curves.
struct CarriedShape
{
    TopoDS_Shape shape;
    std::vector<bool> is_kept;  //!< one a face: on the surface it had, moved
    std::vector<double> scale;  //!< one a face: of the radius of a cylinder, else 1
    WorstAt gap;  //!< between an edge and a fitted face, where it is wider than before
    TopTools_DataMapOfShapeShape image;  //!< of every vertex, edge, face, shell and solid
    //! The mesh of the shape as it was; with more faces where washers were divided from them, the
    //! last ones.
    std::shared_ptr<const ShapeMesh> mesh;
    std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>>
        washers;  //!< the face each was of, its image
};

//! Carries what a mesh did to the shape that it was made of. Faces and edges whose vertices moved
//! as one rigid body keep their surfaces and curves; the others become splines of third degree,
//! which keep the parameters that their points had. A ring of triangles inside a face that moves
//! with a hole becomes a face of its own.
//!
//! \param result  (n, 3) positions of the mesh, in the coordinates of the shape, mm
//! \throws InvalidInput if a face has no mesh, SolverError
CarriedShape carried_shape(const std::shared_ptr<const ShapeMesh>& mesh, const Points& result,
                           const CarryTolerances& tolerances, const Progress& progress);

}  // namespace sheetmorph::cad
