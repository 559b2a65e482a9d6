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

//! The surface of one face of a CAD part, as the file defines it; mm.
struct CadSurface
{
    SurfaceKind kind = SurfaceKind::other;
    Vector3 point = Vector3::Zero();  //!< point of a plane or on an axis, apex, or centre
    Vector3 axis = Vector3::UnitZ();  //!< length 1; the normal of a plane
    double radius = 0.0;              //!< cylinder, sphere, torus (circle of centres)
    double minor_radius = 0.0;        //!< torus (tube)
    double half_angle = 0.0;          //!< cone: between axis and surface, radians, > 0
    double fit_error = 0.0;           //!< deviation of a spline; 0 if exact in the file
    std::string name = {};            //!< of the face in the file; empty if it has none
    std::string colour = {};          //!< "#rrggbb"; empty if it has none
};

//! A circle that a part's edges form in the file.
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

//! Neighbouring faces of a part that form one shape, from their surfaces; exact to rounding. A hole
//! is a complete hollow cylinder, or a circular border inside a sheet without thickness.
struct CadFeature
{
    CadFeatureKind kind = CadFeatureKind::plane;
    Vector3 centre = Vector3::Zero();  //!< hole, cylinder, cone: on the axis, halfway along it
    Vector3 axis = Vector3::UnitZ();   //!< of length 1, largest component > 0; a plane's normal
    double radius = 0.0;               //!< 0 for a plane and a cone, mm
    double half_angle = 0.0;           //!< of a cone, radians
    double length = 0.0;               //!< along the axis, 0 for plane and sphere, mm
    bool is_hollow = false;            //!< curved, with the material outside
    VertexIds vertices;                //!< of the faces and their borders, ascending
    double residual = 0.0;             //!< largest distance of a vertex from the surface, mm
};

//! A solid, or a shell outside of solids.
struct CadPart
{
    std::string name;  //!< from the file, made unique
    mesh::TriangleMesh mesh;
    std::vector<int> face_of_triangle;  //!< (m) index into `surfaces`
    std::vector<CadSurface> surfaces;   //!< one per face
    std::vector<CadCircle> circles;
    bool is_closed = false;                //!< every edge has two triangles, which face outwards
    double deviation = 0.0;                //!< largest distance between mesh and surfaces, mm
    std::vector<int> skipped_faces;        //!< faces that were not meshed, ascending
    std::vector<std::string> faults = {};  //!< reasons why its shape is invalid, a few words each
    std::vector<std::string> healed = {};  //!< the same, before healing
    double healed_within = 0.0;            //!< largest displacement by healing, mm
    Convergence convergence = {};          //!< of the face whose meshing took most rounds or failed
    std::shared_ptr<const ShapeMesh> known;  //!< instances of one product share it
};

//! The contents of a CAD file, placed as in its assembly; mm.
struct CadModel
{
    std::vector<CadPart> parts;
    double edge = 0.0;                        //!< used sizes, see CadMeshing
    double deflection = 0.0;                  //!< used
    double angle = 0.0;                       //!< used
    std::shared_ptr<const CadSource> source;  //!< what was read, to write it with other shapes
    int lost_faces = 0;                       //!< faces of the file that OpenCASCADE could not read
    std::vector<std::string> lost_in;         //!< solids that lack some of these faces
    std::vector<std::string> unread;          //!< entities of a STEP file with impossible values:
                                              //!< number and reason
};

}  // namespace sheetmorph::cad
