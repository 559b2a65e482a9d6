// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/cad/meshing/face_mesh.h"
#include "sheetmorph/cad/meshing/stoppable.h"

namespace sheetmorph::cad
{

//! The surface under a face.
class FaceSurface
{
public:
    virtual ~FaceSurface() = default;

    //! A point, mm.
    virtual Vector3 point(const Vector2& uv) const = 0;

    //! The two derivatives, mm per parameter; columns.
    virtual Eigen::Matrix<double, 3, 2> tangents(const Vector2& uv) const = 0;

    virtual bool is_plane() const = 0;
};

//! The normal of length 1 with a positive turn from u to v; 0 where the surface has none.
Vector3 surface_normal(const FaceSurface& surface, const Vector2& uv);

//! What refine_face aims at.
struct FaceSizes
{
    double edge = 0.0;        //!< longest edge, mm
    double deflection = 0.0;  //!< largest distance of an edge's middle from the surface, mm
    double angle = 0.0;       //!< largest angle between the normals at its ends, radians
    double growth = 0.4;      //!< how much longer edges may be, for each mm away from the border
    int most_vertices = 500000;
    const StopFlag* stop = nullptr;  //!< may be none
};

//! Fills a face with well shaped triangles: splits long and bent sides, exchanges diagonals until
//! the triangles are Delaunay, removes needless vertices, evens out the rest. Vertices stay on the
//! surface, and no triangle turns over in the parameter plane. (Botsch and Kobbelt, A remeshing
//! approach to multiresolution modeling, 2004, in the parameter plane and with sizes that grow.)
//! \param mesh  its border, which stays, has the sizes wanted there
//! \returns whether its last splits and exchanges ended, before `most_vertices` too
//! \throws Cancelled if the flag is set meanwhile
Convergence refine_face(FaceMesh& mesh, const FaceSurface& surface, const FaceSizes& sizes);

//! The largest distance between side middles, triangle centres and the surface, mm.
double deviation(const FaceMesh& mesh, const FaceSurface& surface);

}  // namespace sheetmorph::cad
