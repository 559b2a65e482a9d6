// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace sheetmorph::cad
{

//! How finely CAD parts are meshed. The edges of a curved face follow its curvature, flat faces
//! are filled with triangles that grow from the edges around them.
struct CadMeshing
{
    double edge =
        0.0;  //!< longest edge aimed at, mm; 0: 1/100 of the diagonal of what is in the file
    double deflection = 0.0;  //!< how far an edge may be from the surface, mm; 0: edge / 50
    double angle = 0.35;      //!< how far the surface may turn along an edge, radians, below pi / 2
};

}  // namespace sheetmorph::cad
