// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/recognise/feature.h"
#include "sheetmorph/recognise/tolerances.h"

namespace sheetmorph::recognise
{

//! A part among others.
struct ContactPart
{
    mesh::TriangleMesh mesh;
    double thickness = 0.0;         //!< of a sheet whose mesh has none, mm; 0 if not known
    std::vector<Feature> features;  //!< of this mesh; holes make bolts, flanges tied contacts
};

//! An element of a finite element model that holds a vertex of one part to one
//! of another.
struct Connection
{
    int part_a, vertex_a;
    int part_b, vertex_b;
    int joint = -1;         //!< of one weld or bolt: its connections have one number; < 0: alone
    bool is_rigid = false;  //!< of a rigid body
};

//! What holds two parts together.
enum class ContactKind
{
    bolt,    //!< two holes on one axis
    weld,    //!< elements that connect both parts
    flange,  //!< a flange on a flange
    face,    //!< surfaces that face each other
    edge,    //!< a free edge on a surface, or on another free edge
};

//! "bolt", "weld", "flange", "face", "edge".
const char* name_of(ContactKind kind);

//! A place where two parts touch, or nearly. Lengths in mm.
struct FoundContact
{
    ContactKind kind = ContactKind::face;
    int part_a = 0;
    int part_b = 0;  //!< > part_a
    VertexIds a;     //!< ascending, of the meshes
    VertexIds b;
    Vector3 center = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();  //!< of a bolt; else the mean normal, length 1
    double distance = 0.0;            //!< median distance of its vertices from the other part
    double size = 0.0;                //!< diagonal of the box around both sides
    int connections = 0;              //!< elements that connect both sides
    bool is_spot = false;             //!< of a weld: a single joint, and nothing around it
};

//! The type of contact proposed: "rigid" for bolts and single welds, "tied" for flanges and seams,
//! which have to bend, else "control mesh".
const char* type_of(const FoundContact& contact);

//! The contacts between all pairs of parts, by part and first vertex. Parts are
//! told apart by a search tree each and a sweep over their boxes: thousands of
//! parts are no trouble. \throws InvalidInput naming a tolerance out of its
//! range; Cancelled
std::vector<FoundContact> find_contacts(const std::vector<ContactPart>& parts,
                                        const std::vector<Connection>& connections = {},
                                        const ContactTolerances& tolerances = {},
                                        const Progress& progress = {});

//! The largest gap, beyond half of both thicknesses, at which parts of this
//! assembly lie on each other, mm: the end of the gaps between facing surfaces
//! that is followed by hardly any up to half as much again.
double proposed_gap(const std::vector<ContactPart>& parts,
                    const ContactTolerances& tolerances = {});

}  // namespace sheetmorph::recognise
