// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rotation.h"
#include "assembly/frame.h"
#include "shapes.h"

#include <algorithm>

namespace sheetmorph::assembly::frames
{

template <typename Condition>
PartRegion side(const std::string& name, const Assembly& assembly, int part, Condition condition)
{
    const mesh::TriangleMesh& mesh = assembly.parts[static_cast<std::size_t>(part)].mesh;
    return {name, part, shapes::vertices_where(mesh, condition)};
}

inline RigidMotion motion(const Vector3& shift, const Vector3& axis, double degrees,
                          const Vector3& pivot)
{
    return {shift, rotation_log(axis, degrees * shapes::pi / 180.0), pivot};
}

// A plate of three cells with a round hole each, slightly bent, its corner at `corner`.
inline void add_plate(Assembly& assembly, const std::string& name, const Vector3& corner,
                      bool with_features)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes({3, 16, 3, 60.0, 12.0});
    const auto place = [&](const Vector3& p)
    { return Vector3(corner + p + Vector3(0.0, 0.0, 4.0 * std::sin(p.y() / 20.0))); };
    const auto part = static_cast<int>(assembly.parts.size());
    assembly.parts.push_back({name, shapes::mapped(plate.mesh, place), {}, Mode::automatic});
    for (std::size_t k = 0; with_features && k < plate.rims.size(); ++k)
        assembly.features.push_back({name + " hole" + std::to_string(k),
                                     part,
                                     plate.rims[k],
                                     surface::FeatureRotation::interpolated,
                                     {},
                                     {},
                                     false});
}

// Both sides reach 30 mm: over the border of a cell and through the middle of a hole.
inline void add_contact(Assembly& assembly, int a, int b, double from)
{
    const double to = from + 30.0;
    const auto between = [=](const Vector3& p) { return p.x() > from - 1e-6 && p.x() < to + 1e-6; };
    Contact contact;
    contact.name = assembly.parts[static_cast<std::size_t>(a)].name + " - "
                   + assembly.parts[static_cast<std::size_t>(b)].name;
    contact.a = side("a", assembly, a, between);
    contact.b = side("b", assembly, b, between);
    assembly.contacts.push_back(contact);
}

// Two rigid welds hold the third plate: each has to have vertices of its own there.
inline void part_rigid_welds(Assembly& assembly)
{
    const auto own = [&](PartRegion& region, double from, double to)
    {
        const Points& points = assembly.parts[2].mesh.points();
        const auto outside = [&](int v) { return points(v, 1) < from || points(v, 1) > to; };
        region.vertices.erase(
            std::remove_if(region.vertices.begin(), region.vertices.end(), outside),
            region.vertices.end());
    };
    own(assembly.contacts[1].b, 0.0, 25.0);
    own(assembly.contacts[3].b, 35.0, 60.0);
}

//! Three plates one after the other and a fourth that closes the ring over the first and the third:
//! the left end of the first is held, a strip in its middle is the handle.
inline Frame ring(ContactType type)
{
    Frame frame{"ring", {}, {}};
    Assembly& assembly = frame.assembly;
    add_plate(assembly, "first", {0.0, 0.0, 0.0}, true);
    add_plate(assembly, "second", {150.0, 0.0, 1.5}, true);
    add_plate(assembly, "third", {300.0, 0.0, 3.0}, false);
    add_plate(assembly, "fourth", {150.0, 0.0, -1.5}, true);
    add_contact(assembly, 0, 1, 150.0);
    add_contact(assembly, 1, 2, 300.0);
    add_contact(assembly, 0, 3, 150.0);
    add_contact(assembly, 3, 2, 300.0);
    for (Contact& contact : assembly.contacts)
        contact.type = type;
    if (type == ContactType::rigid)
        part_rigid_welds(assembly);
    assembly.fixed = {side("root", assembly, 0, [](const Vector3& p) { return p.x() < 1e-6; })};
    const PartRegion tip =
        side("tip", assembly, 0, [](const Vector3& p) { return p.x() > 180.0 - 1e-6; });
    assembly.handles = {{tip.name, tip.part, tip.vertices}};
    frame.pose.handles["tip"] = motion({-3.0, 2.0, 20.0}, {0.1, 1.0, 0.2}, 25.0, {180, 30, 0});
    return frame;
}

}  // namespace sheetmorph::assembly::frames
