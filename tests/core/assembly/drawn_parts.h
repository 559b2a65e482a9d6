// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "assembly/frame.h"
#include "shapes.h"
#include "shapes/growing_mesh.h"

namespace sheetmorph::assembly::frames
{

//! A part 180 mm long and some 60 mm wide, with what can be a feature of it.
struct DrawnPart
{
    Part part;
    std::vector<VertexIds> features;
    bool has_flat_holes = false;  //!< the features are round, and can have a size
};

//! The vertices near places in the middle of a mesh along x.
inline std::vector<VertexIds> patches_along(const mesh::TriangleMesh& mesh, double height)
{
    std::vector<VertexIds> found;
    for (const double x : {50.0, 90.0, 130.0})
        found.push_back(shapes::vertices_where(
            mesh, [=](const Vector3& p) { return (p - Vector3(x, 30.0, height)).norm() < 9.0; }));
    return found;
}

inline DrawnPart drawn_sheet(shapes::Draw& draw)
{
    DrawnPart drawn;
    switch (draw.whole(4))
    {
        case 0:  // a tube along x
            drawn.part.mesh =
                shapes::mapped(shapes::cylinder(20, 24, 20.0, 180.0), [](const Vector3& p)
                               { return Vector3(p.z(), 30.0 + p.x(), p.y()); });
            drawn.features = patches_along(drawn.part.mesh, 20.0);
            return drawn;
        case 1:  // any triangles
            drawn.part.mesh = shapes::mapped(
                shapes::jittered_grid(30, 10, 6.0, static_cast<unsigned>(draw.whole(1000))),
                [](const Vector3& p)
                { return Vector3(p.x(), p.y(), 5.0 * std::sin(p.x() / 40.0)); });
            drawn.features = patches_along(drawn.part.mesh, 0.0);
            break;
        default:
            const shapes::PlateWithHoles plate = shapes::plate_with_holes({3, 16, 3, 60.0, 12.0});
            drawn.has_flat_holes = draw.happens(0.6);
            const double height = drawn.has_flat_holes ? 0.0 : 4.0;
            drawn.part.mesh =
                shapes::mapped(plate.mesh, [=](const Vector3& p)
                               { return Vector3(p.x(), p.y(), height * std::sin(p.y() / 20.0)); });
            drawn.features = plate.rims;
    }
    if (draw.happens(0.2))
    {
        drawn.part.mesh = shapes::two_skinned(drawn.part.mesh, 1.0);
        drawn.part.thin = Thin::automatic;
    }
    return drawn;
}

//! A part whose left end is at `corner`.
inline DrawnPart drawn_part(shapes::Draw& draw, const std::string& name, const Vector3& corner)
{
    DrawnPart drawn = drawn_sheet(draw);
    shapes::GrowingMesh mesh(drawn.part.mesh);
    for (int count = draw.happens(0.4) ? 3 : 0; count > 0; --count)
        mesh.add_node(draw);
    for (int count = draw.happens(0.4) ? 3 : 0; count > 0; --count)
        mesh.add_flat_triangle(draw);
    if (draw.happens(0.2))
        mesh.add_island(draw);
    drawn.part.mesh =
        shapes::mapped(mesh.mesh(), [&](const Vector3& p) { return Vector3(corner + p); });
    drawn.part.name = name;
    if (draw.happens(0.3))
    {
        const shapes::Renumbered other =
            shapes::renumbered(drawn.part.mesh, static_cast<unsigned>(draw.whole(1000)));
        drawn.part.mesh = other.mesh;
        for (VertexIds& feature : drawn.features)
            for (int& vertex : feature)
                vertex = other.new_id[static_cast<std::size_t>(vertex)];
    }
    return drawn;
}

}  // namespace sheetmorph::assembly::frames
