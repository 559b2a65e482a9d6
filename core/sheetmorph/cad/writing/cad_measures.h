// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"
#include "sheetmorph/cad/carry/worst_at.h"

#include <string>
#include <vector>

namespace sheetmorph::cad
{

//! A cylinder of a part that is also a cylinder in the written file.
struct KeptCylinder
{
    int face = 0;
    double before = 0.0, wanted = 0.0, after = 0.0;  //!< radii, mm
};

//! Measures of a carried part in the written file. Faces are counted from 0, lengths are in mm.
struct CadMeasures
{
    std::string name;
    int faces = 0;
    int washers = 0;                  //!< faces divided from others, the last ones
    int kept = 0;                     //!< faces on their old surface
    std::vector<int> fitted_faces;    //!< ascending
    bool is_valid = false;            //!< according to OpenCASCADE's BRepCheck
    bool was_valid = false;           //!< the same for the shape that was read
    std::vector<std::string> faults;  //!< reasons why the shape that was read was invalid
    std::vector<std::string> healed;  //!< reasons why it was invalid before healing
    double healed_within = 0.0;       //!< largest displacement by healing
    std::vector<int> invalid_faces;
    bool is_closed = false;
    bool was_closed = false;
    WorstAt distance;                  //!< from the deformed mesh
    WorstAt gap;                       //!< between an edge and a fitted face, if wider than before
    WorstAt kink;                      //!< degrees, at edges that were smooth
    double edge_tolerance = 0.0;       //!< as written
    double edge_tolerance_read = 0.0;  //!< as read again
    double vertex_tolerance = 0.0;
    std::vector<KeptCylinder> cylinders;
    double volume_before = 0.0;  //!< of a closed body's mesh, mm^3
    double volume_after = 0.0;   //!< of the same triangles, on the faces as read again
    Points points;               //!< (n, 3) of the mesh, on the faces as read again
    std::vector<int> far_faces;  //!< faces that exceed the surface tolerance
};

}  // namespace sheetmorph::cad
