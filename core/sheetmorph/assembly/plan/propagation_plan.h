// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"

namespace sheetmorph::assembly
{

//! One contact with the direction in which it passes the motion on.
struct DirectedContact
{
    int contact = 0;           //!< index into Assembly::contacts
    bool is_reversed = false;  //!< from side b to side a

    const PartRegion& source(const Assembly& assembly) const;
    const PartRegion& target(const Assembly& assembly) const;
};

//! In which order parts are deformed, and which contacts decide each (section 4.2).
//! Breadth-first from the primary part, ties inside a level by part name; a part is constrained by
//! every contact with an earlier part, so that the order is a directed acyclic graph. Two parts
//! with a pair of form features that keep an axis or a distance are neighbours like those in
//! contact.
struct PropagationPlan
{
    std::vector<int> order;  //!< parts that are reached, the primary first
    std::vector<int> level;  //!< by part: contacts from the primary; -1 if not reached
    std::vector<DirectedContact> contacts;  //!< that pass motion on
    std::vector<DirectedContact> measured;  //!< whose fidelity is told: between reached parts
    std::vector<int> unreached;  //!< parts that neither the primary nor a driver of their own moves

    //! The contacts that pass motion into one part, in the assembly's order.
    std::vector<DirectedContact> into(const Assembly& assembly, int part) const;
};

//! Parts that no contact joins to the primary but that have a handle, a point or a prescribed
//! rotation of their own start a breadth-first order of their own after it, by name.
//! With a single control mesh every part is reached, and contacts are not used.
PropagationPlan plan_propagation(const Assembly& assembly);

}  // namespace sheetmorph::assembly
