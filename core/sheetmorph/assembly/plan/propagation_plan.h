// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"

namespace sheetmorph::assembly
{

//! A contact, with the direction of propagation.
struct DirectedContact
{
    int contact = 0;           //!< index into Assembly::contacts
    bool is_reversed = false;  //!< from side b to side a

    const PartRegion& source(const Assembly& assembly) const;
    const PartRegion& target(const Assembly& assembly) const;
};

//! The order in which parts are deformed, and the contacts that constrain each (section 4.2).
//! Breadth-first from the primary part, by name within a level. Every contact with an earlier part
//! constrains a part, so the order is a directed acyclic graph. Two parts with a pair of form
//! features that keep an axis or a distance count as neighbours, like parts in contact.
struct PropagationPlan
{
    std::vector<int> order;  //!< reached parts, the primary first
    std::vector<int> level;  //!< by part: contacts from the primary; -1 if not reached
    std::vector<DirectedContact> contacts;  //!< that propagate motion
    std::vector<DirectedContact> measured;  //!< that are measured: between reached parts
    std::vector<int> unreached;             //!< neither reached nor driven by handles of their own

    //! The contacts that propagate motion into one part, in the order of the assembly.
    std::vector<DirectedContact> into(const Assembly& assembly, int part) const;
};

//! Parts that no contact connects to the primary, but with a handle, a point or a prescribed
//! rotation, start a breadth-first order of their own after it, by name. A single control mesh
//! reaches every part, and contacts are not used.
PropagationPlan plan_propagation(const Assembly& assembly);

}  // namespace sheetmorph::assembly
