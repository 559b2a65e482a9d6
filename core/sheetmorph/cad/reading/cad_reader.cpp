// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/reading/cad_reader.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/cad_guard.h"
#include "sheetmorph/cad/meshing/edge_discretisation.h"
#include "sheetmorph/cad/meshing/mesh_estimate.h"
#include "sheetmorph/cad/meshing/occt_surface.h"
#include "sheetmorph/cad/meshing/part_mesher.h"
#include "sheetmorph/cad/meshing/stoppable.h"
#include "sheetmorph/cad/reading/cad_shapes.h"

#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Eigen/Geometry>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>

namespace sheetmorph::cad
{

namespace
{

constexpr const char* unreadable = "it cannot be read";
constexpr const char* repair = "repair it in the CAD system and export it again";

void check(const CadMeshing& meshing)
{
    for (const double length : {meshing.edge, meshing.deflection})
        // Chosen: a length of a million kilometres is a mistake. Angles: up to just below a right
        // angle.
        if (!(length >= 0.0) || length > 1e12)
            throw InvalidInput("a length of the meshing is out of range", "give 0 to 1e12 mm");
    if (!(meshing.angle >= 0.01 && meshing.angle <= 1.5))
        throw InvalidInput("the angle of the meshing is out of range", "give 0.6 to 85 degrees");
}

// Rounds to two digits, short enough to repeat in a recipe.
double rounded(double length)
{
    const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
    return std::round(length / unit) * unit;
}

CadMeshing with_defaults(CadMeshing meshing, const std::vector<NamedShape>& shapes)
{
    Bnd_Box box;
    for (const NamedShape& one : shapes)
        BRepBndLib::Add(one.shape, box, false);
    const double size = box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
    if (!(size > 0.0) || !std::isfinite(size))
        throw InvalidInput("its shapes have no extent", "check what was exported");
    // Defaults. Chosen: a square part gets 20,000 triangles. From geometry: a chord e of an arc
    // deviates by e^2 / 8 r, so an edge turns by 0.16 radians (9 degrees) at a fiftieth of its
    // length.
    constexpr double edges_along_the_diagonal = 100.0, edge_over_deflection = 50.0;
    if (meshing.edge == 0.0)
        meshing.edge = rounded(size / edges_along_the_diagonal);
    if (meshing.deflection == 0.0)
        meshing.deflection = rounded(meshing.edge / edge_over_deflection);
    // Relative to the size. From files with seven digits: a smaller deflection follows their
    // rounding.
    constexpr double smallest = 1e-7;
    if (meshing.deflection < smallest * size)
        throw InvalidInput("a deflection of " + short_number(meshing.deflection)
                               + " mm is too small for what is in the file",
                           "give " + short_number(1.1 * smallest * size) + " mm or more");
    return meshing;
}

// Places the surfaces or circles of a part.
struct Placement
{
    Matrix3 turn;
    Vector3 shift;
    double scale;

    explicit Placement(const gp_Trsf& motion) : scale(std::abs(motion.ScaleFactor()))
    {
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                turn(r, c) = motion.Value(r + 1, c + 1);
        shift = to_vector(motion.TranslationPart());
    }

    Vector3 point(const Vector3& p) const { return turn * p + shift; }
    Vector3 direction(const Vector3& d) const { return (turn * d).normalized(); }
};

CadPart placed(CadPart part, const gp_Trsf& motion)
{
    if (motion.Form() == gp_Identity)
        return part;
    const Placement there(motion);
    Points points =
        (part.mesh.points() * there.turn.transpose()).rowwise() + there.shift.transpose();
    Triangles triangles = part.mesh.triangles();
    if (there.turn.determinant() < 0)
        triangles.col(1).swap(triangles.col(2));
    part.mesh = mesh::TriangleMesh(std::move(points), std::move(triangles));
    part.deviation *= there.scale;
    for (CadSurface& surface : part.surfaces)
    {
        surface.point = there.point(surface.point);
        surface.axis = there.direction(surface.axis);
        for (double* length : {&surface.radius, &surface.minor_radius, &surface.fit_error})
            *length *= there.scale;
    }
    for (CadCircle& circle : part.circles)
    {
        circle.centre = there.point(circle.centre);
        circle.axis = there.direction(circle.axis);
        circle.radius *= there.scale;
    }
    return part;
}

void name(CadPart& part, const NamedShape& shape)
{
    part.name = shape.name;
    part.faults = shape.faults;
    part.healed = shape.healed;
    part.healed_within = shape.healed_within;
    for (std::size_t f = 0; f < std::min(shape.faces.size(), part.surfaces.size()); ++f)
    {
        part.surfaces[f].name = shape.faces[f].name;
        part.surfaces[f].colour = shape.faces[f].colour;
    }
}

TopoDS_Shape unplaced(const TopoDS_Shape& shape)
{
    return shape.Located(TopLoc_Location());
}

// Meshes every shape.
std::vector<CadPart> mesh_all(const TopTools_IndexedMapOfShape& shapes, const CadMeshing& meshing,
                              const Progress& progress)
{
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (int i = 1; i <= shapes.Extent(); ++i)
        builder.Add(all, shapes(i));
    progress.report(0.0, "triangulating");
    MeshEstimate(all).check(meshing);
    const auto in_thread = [&](double fraction, const char* task, const auto& work)
    {
        const auto in_silence = [&](const StopFlag& flag)
        { return guarded(unreadable, repair, [&] { return work(flag); }); };
        return stoppable(progress, fraction, task, in_silence);
    };
    in_thread(0.0, "triangulating",
              [&](const StopFlag& flag) { triangulate(all, meshing, &flag); });
    std::vector<CadPart> made;
    for (int i = 1; i <= shapes.Extent(); ++i)
    {
        const double fraction = 0.4 + 0.6 * (i - 1) / shapes.Extent();
        progress.report(fraction, "meshing");
        made.push_back(in_thread(fraction, "meshing",
                                 [&](const StopFlag& flag)
                                 { return mesh_part(shapes(i), meshing, &flag); }));
    }
    return made;
}

CadModel meshed(const std::shared_ptr<CadSource>& source, const CadMeshing& wanted,
                const Progress& progress)
{
    const std::vector<NamedShape>& shapes = source->bodies;
    if (shapes.empty())
        throw InvalidInput("it holds no solid and no surface", "export solids or surfaces");
    const CadMeshing meshing = with_defaults(wanted, shapes);
    TopTools_IndexedMapOfShape originals;  // a part with several instances is meshed once
    for (const NamedShape& one : shapes)
        originals.Add(unplaced(one.shape));
    const std::vector<CadPart> made = mesh_all(originals, meshing, progress);
    CadModel model{{},     meshing.edge,       meshing.deflection, meshing.angle,
                   source, source->lost_faces, source->lost_in,    source->unread};
    for (const NamedShape& one : shapes)
    {
        const int index = originals.FindIndex(unplaced(one.shape));
        model.parts.push_back(placed(made[static_cast<std::size_t>(index - 1)],
                                     one.shape.Location().Transformation()));
        name(model.parts.back(), one);
    }
    if (std::none_of(model.parts.begin(), model.parts.end(),
                     [](const CadPart& part) { return part.mesh.triangle_count() > 0; }))
        throw InvalidInput("none of its faces can be meshed", "repair them in the CAD system");
    return model;
}

}  // namespace

CadModel read_cad(const std::string& path, const CadMeshing& meshing, const Progress& progress)
{
    check(meshing);
    return guarded(unreadable, repair,
                   [&]
                   {
                       progress.report(0.0, "reading");
                       const std::shared_ptr<CadSource> source = source_of_file(path);
                       return meshed(source, meshing, progress.part(0.4, 1.0));
                   });
}

CadModel read_brep(const std::string& text, const std::string& name, const CadMeshing& meshing,
                   const Progress& progress)
{
    check(meshing);
    return guarded(unreadable, repair,
                   [&] { return meshed(source_of_brep_text(text, name), meshing, progress); });
}

}  // namespace sheetmorph::cad
