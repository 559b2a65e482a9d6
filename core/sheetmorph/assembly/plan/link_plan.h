// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/plan/propagation_plan.h"

namespace sheetmorph::assembly
{

//! Vertices of one part that a link decides.
struct LinkTarget
{
    int part = 0;
    VertexIds vertices;
    std::vector<double> weights = {};  //!< beside other links that want them; empty: 1 each
};

//! Source vertices that decide target vertices through a control mesh or a tie.
struct PlannedLink
{
    std::string name;
    int contact = -1;  //!< index into Assembly::contacts; -1 for the single control mesh
    ContactType type = ContactType::control_mesh;
    int source_part = 0;
    VertexIds source;
    std::vector<LinkTarget> targets;  //!< their rows follow each other
    VertexIds enclosed;               //!< further vertices of targets[0].part inside the box
};

//! What a stack of rigid contacts does to one part: all of them are one rigid body, which moves
//! with the part of the stack that is deformed first.
struct RigidWeld
{
    std::string name;           //!< of its contacts on the part it moves
    std::vector<int> contacts;  //!< all of the stack
    std::vector<Subject> of;    //!< its contacts on the part it moves
    int source_part = 0;
    VertexIds source;
    int target_part = 0;
    VertexIds target;
    bool is_held = false;  //!< a fixed region holds the stack, on whichever part: it stays
};

//! Control mesh and tied links with the vertices each part's mode gives them (section 4.1).
//! \throws InvalidInput: mode 1 where features or several contacts forbid it, a mode 3 that finds
//! no vertex, a part in mode 2 of a single control mesh without followers
//! \returns links by name, so that the order of the contacts does not matter; none where all parts
//! are solved at once
std::vector<PlannedLink> plan_links(const Assembly& assembly, const PropagationPlan& plan,
                                    const ControlBoxes& boxes);

//! What a link decides, its targets one after the other, mm.
Points target_points(const Assembly& assembly, const PlannedLink& link);

//! The box of a link's control mesh: around everything for the single one, else around both sides
//! of the contact and what the link decides.
volume::OrientedBox box_of_link(const Assembly& assembly, const PlannedLink& link,
                                const ControlBoxes& boxes);

//! Rigid contacts that touch one body of a part are one stack, across all parts: a bolt through
//! three layers, a loop of welds.
std::vector<RigidWeld> plan_welds(const Assembly& assembly, const PropagationPlan& plan);

}  // namespace sheetmorph::assembly
