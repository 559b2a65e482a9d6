// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/recognise/feature.h"
#include "sheetmorph/recognise/tolerances.h"

namespace sheetmorph::recognise
{

//! A part to test for contacts.
struct ContactPart
{
    mesh::TriangleMesh mesh;
    double thickness = 0.0;         //!< of a sheet meshed without thickness, mm; 0 if unknown
    std::vector<Feature> features;  //!< of this mesh; holes give bolts, flanges give tied contacts
};

//! A finite element that connects a vertex of one part to a vertex of another.
struct Connection
{
    int part_a, vertex_a;
    int part_b, vertex_b;
    int joint = -1;         //!< number of the weld or bolt it belongs to; < 0: a joint of its own
    bool is_rigid = false;  //!< part of a rigid body
};

//! How two parts are connected.
enum class ContactKind
{
    bolt,    //!< two coaxial holes
    weld,    //!< elements that connect both parts
    flange,  //!< a flange on a flange
    face,    //!< surfaces that face each other
    edge,    //!< a free edge on a surface or on another free edge
};

//! "bolt", "weld", "flange", "face" or "edge".
const char* name_of(ContactKind kind);

//! A region where two parts touch or nearly touch. Lengths in mm.
struct FoundContact
{
    ContactKind kind = ContactKind::face;
    int part_a = 0;
    int part_b = 0;  //!< > part_a
    VertexIds a;     //!< vertices of the meshes, ascending
    VertexIds b;
    Vector3 center = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();  //!< of a bolt: the axis of its first hole
    double distance = 0.0;  //!< median distance from the other part; of a bolt: between rims
    double size = 0.0;      //!< diagonal of the bounding box of both sides
    int connections = 0;    //!< elements that connect both sides
    bool is_spot = false;   //!< of a weld: a rigid body or a single joint
};

//! The proposed type of contact: "rigid" for bolts and single welds, "tied" for flanges and seams,
//! because they must be able to bend, and "control mesh" for all others.
const char* type_of(const FoundContact& contact);

//! Finds the contacts between all pairs of parts. A sweep over bounding boxes and one AABB tree per
//! part keep the search fast for thousands of parts.
//! \returns contacts ordered by pair of parts
//! \throws InvalidInput naming a tolerance that is out of range
//! \throws Cancelled on request
std::vector<FoundContact> find_contacts(const std::vector<ContactPart>& parts,
                                        const std::vector<Connection>& connections = {},
                                        const ContactTolerances& tolerances = {},
                                        const Progress& progress = {});

//! Proposes the largest gap of a contact, beyond half of both thicknesses, mm. Small gaps form
//! a cluster: almost no facing surfaces have gaps from its end to 1.5 times that gap. The proposal
//! is 1.2 times the gap at the end of the cluster.
double proposed_gap(const std::vector<ContactPart>& parts,
                    const ContactTolerances& tolerances = {});

}  // namespace sheetmorph::recognise
