// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/triangle_mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace sheetmorph::cad
{

struct ShapeMesh;
struct CadSource;

enum class SurfaceKind
{
    plane,
    cylinder,
    cone,
    sphere,
    torus,
    other
};

//! The surface under one face of a CAD part, as the file defines it; mm.
struct CadSurface
{
    SurfaceKind kind = SurfaceKind::other;
    Vector3 point = Vector3::Zero();  //!< on a plane, on the axis, a cone's apex, a centre
    Vector3 axis = Vector3::UnitZ();  //!< of length 1; a plane's normal
    double radius = 0.0;              //!< cylinder, sphere, torus (of the circle of centres)
    double minor_radius = 0.0;        //!< torus (of the tube)
    double half_angle = 0.0;          //!< cone: between axis and surface, radians, > 0
    double fit_error = 0.0;           //!< 0 if the file says so, else how well a spline is it
    std::string name = {};            //!< of the face in the file, empty if it has none
    std::string colour = {};          //!< "#rrggbb", the same
};

//! A circle that the file draws as edges of a part.
struct CadCircle
{
    Vector3 centre = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();
    double radius = 0.0;
    VertexIds vertices;  //!< ascending
};

enum class CadFeatureKind
{
    round_hole,
    cylinder,
    plane,
    cone,
    sphere
};

//! Neighbouring faces of a part that are one shape, from their surfaces: exact to rounding. A hole
//! is a hollow cylinder all around, or a circular border inside a sheet without thickness.
struct CadFeature
{
    CadFeatureKind kind = CadFeatureKind::plane;
    Vector3 centre = Vector3::Zero();  //!< hole, cylinder, cone: on the axis, halfway along it
    Vector3 axis = Vector3::UnitZ();   //!< of length 1, largest component > 0; a plane's normal
    double radius = 0.0;               //!< 0 for a plane and a cone, mm
    double half_angle = 0.0;           //!< of a cone, radians
    double length = 0.0;               //!< along the axis, 0 for plane and sphere, mm
    bool is_hollow = false;            //!< curved, and seen from inside
    VertexIds vertices;                //!< of the faces and their borders, ascending
    double residual = 0.0;             //!< largest distance of a vertex from the surface, mm
};

//! One solid, or one shell that belongs to none.
struct CadPart
{
    std::string name;  //!< from the file, made unique
    mesh::TriangleMesh mesh;
    std::vector<int> face_of_triangle;  //!< (m) index into `surfaces`
    std::vector<CadSurface> surfaces;   //!< one a face
    std::vector<CadCircle> circles;
    bool is_closed = false;          //!< every edge has two triangles; they look outwards then
    double deviation = 0.0;          //!< largest distance found between mesh and surfaces, mm
    std::vector<int> skipped_faces;  //!< faces that could not be meshed, ascending
    std::vector<std::string> faults = {};  //!< why its shape is not valid, a few words each
    std::vector<std::string> healed = {};  //!< the same before it was healed
    double healed_within = 0.0;            //!< how far that moved anything, mm
    Convergence convergence = {};  //!< of the face whose meshing took most rounds, or did not end
    std::shared_ptr<const ShapeMesh> known;  //!< shared by instances of one product
};

//! What a CAD file holds, placed as in its assembly; mm.
struct CadModel
{
    std::vector<CadPart> parts;
    double edge = 0.0;                        //!< what was meshed with, see CadMeshing
    double deflection = 0.0;                  //!< the same
    double angle = 0.0;                       //!< the same
    std::shared_ptr<const CadSource> source;  //!< what was read, to be written with other shapes
    int lost_faces = 0;                       //!< faces in the file that no part has: unreadable
    std::vector<std::string> lost_in;         //!< solids of a STEP file that lack some of them
    std::vector<std::string> unread;  //!< entities of a STEP file with values that make no sense:
                                      //!< the number of each, and why
};

}  // namespace sheetmorph::cad
