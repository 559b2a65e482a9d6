// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "assembly/thin_frames.h"

namespace sheetmorph::assembly::frames
{

inline Frame open_chain(ContactType type)
{
    Frame frame = ring(type);
    frame.name = "chain";
    frame.assembly.contacts.pop_back();
    return frame;
}

inline Frame with_modes(Frame frame, Mode mode)
{
    for (std::size_t k = 1; k < frame.assembly.parts.size(); ++k)
        frame.assembly.parts[k].mode = mode;
    frame.name += "_mode" + std::to_string(static_cast<int>(mode));
    return frame;
}

inline Frame single(Mode mode)
{
    Frame frame = with_modes(ring(ContactType::control_mesh), mode);
    frame.assembly.propagation.type = PropagationType::single;
    if (mode == Mode::all)
        frame.assembly.features.resize(3);
    if (mode == Mode::regions)
        for (int part = 1; part < 4; ++part)
            frame.assembly.followers.push_back(side("follower" + std::to_string(part),
                                                    frame.assembly, part,
                                                    [](const Vector3& p) { return p.y() < 15.0; }));
    frame.name = "single_mode" + std::to_string(static_cast<int>(mode));
    return frame;
}

inline Frame small_contacts(ContactType type, bool straight)
{
    Frame frame = open_chain(type);
    frame.name = straight ? "straight" : "one_vertex";
    for (Contact& contact : frame.assembly.contacts)
        for (PartRegion* region : {&contact.a, &contact.b})
            region->vertices.resize(straight ? 4 : 1);
    const double border = 180.0;
    const auto on_border = [=](const Vector3& p) { return std::abs(p.x() - border) < 1e-6; };
    frame.assembly.contacts[0].a = side("a", frame.assembly, 0, on_border);
    if (!straight)
        frame.assembly.contacts[0].a.vertices.resize(1);
    return frame;
}

inline Frame mode_one()
{
    Frame frame = ring(ContactType::control_mesh);
    frame.name = "mode1";
    frame.assembly.contacts.resize(1);
    frame.assembly.parts.resize(2);
    frame.assembly.parts[1].mode = Mode::all;
    frame.assembly.features.resize(3);
    return frame;
}

//! Every propagation, mode and contact type with `neumann`.
inline std::vector<Frame> all_with_neumann()
{
    std::vector<Frame> frames;
    for (const auto type : {ContactType::control_mesh, ContactType::tied, ContactType::rigid})
        for (Frame frame : {open_chain(type), small_contacts(type, false),
                            small_contacts(type, true), ring(type), thin_solids(open_chain(type))})
        {
            frame.name += "_type" + std::to_string(static_cast<int>(type));
            frames.push_back(frame);
        }
    for (const auto type : {ContactType::tied, ContactType::rigid})
        for (Frame frame : {ring(type), small_contacts(type, true), thin_solids(open_chain(type))})
        {
            frame.assembly.propagation.type = PropagationType::whole;
            frame.name += "_whole" + std::to_string(static_cast<int>(type));
            frames.push_back(frame);
        }
    frames.push_back(with_modes(open_chain(ContactType::control_mesh), Mode::boundaries));
    frames.push_back(mode_one());
    for (const Mode mode : {Mode::automatic, Mode::all, Mode::regions, Mode::boundaries})
        frames.push_back(single(mode));
    frames.push_back(thin_solids(single(Mode::boundaries)));
    return frames;
}

//! All of them, and with `natural` those in which known vertices differ.
inline std::vector<Frame> all()
{
    auto frames = all_with_neumann();
    for (Frame frame : {ring(ContactType::control_mesh), ring(ContactType::tied),
                        ring(ContactType::rigid), small_contacts(ContactType::control_mesh, false),
                        small_contacts(ContactType::tied, true), single(Mode::regions)})
    {
        frame.assembly.energy = surface::Energy::natural;
        frames.push_back(frame);
        frames.back().name += "_natural" + std::to_string(frames.size());
    }
    return frames;
}

}  // namespace sheetmorph::assembly::frames
