// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/text.h"
#include "sheetmorph/base/types.h"

#include <string>

namespace sheetmorph::assembly
{

//! Vertices of one part: a fixed region, a follower, or one side of a contact.
struct PartRegion
{
    std::string name;
    int part = 0;
    VertexIds vertices;
    std::vector<Subject> of = {};  //!< the entries that it was made of; empty: itself
};

//! How a contact passes the motion on.
enum class ContactType
{
    control_mesh,  //!< the paper's: a local control mesh around both sides
    tied,  //!< every vertex keeps its place relative to the nearest triangle of the other side
    rigid  //!< both sides move as one rigid body: the gap is exact
};

//! Where two parts are welded or bolted (section 4.2).
struct Contact
{
    std::string name;
    ContactType type = ContactType::control_mesh;
    PartRegion a;
    PartRegion b;
};

//! How parts are answered together.
enum class PropagationType
{
    local,   //!< one after the other, along the contacts (section 4.2)
    single,  //!< one control mesh around everything (section 4.1)
    whole    //!< all at once: contacts are constraints of one system (system/system.h)
};

//! How the motion of the primary reaches the other parts.
struct Propagation
{
    PropagationType type = PropagationType::local;
    int levels = 3;            //!< of Catmull-Clark subdivision of the control meshes
    double smoothness = 0.05;  //!< c of (3.3)
};

}  // namespace sheetmorph::assembly
