// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/mesh_estimate.h"

#include "sheetmorph/base/errors.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRepLProp_CLProps.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace sheetmorph::cad
{

namespace
{

// As in repair/remeshing. Measured: a set-up takes 3.2 GiB for a million vertices, that is two
// million triangles, so this limit needs about 5 GiB.
constexpr double most_triangles = 3e6;

// Along an edge, and along either parameter of a face. Chosen: an estimate to a factor of two is
// enough, because the limit is a round number.
constexpr int samples = 4;

// The longest chord that follows a curvature: see CadMeshing.
double chord(double curvature, const CadMeshing& meshing)
{
    const double bend = std::abs(curvature);
    if (!(bend * meshing.edge > 1e-9))
        return meshing.edge;
    return std::min(
        {meshing.edge, std::sqrt(8.0 * meshing.deflection / bend), meshing.angle / bend});
}

// The middle of one of the pieces of a range.
double sample(double low, double high, int k)
{
    return low + (high - low) * (k + 0.5) / samples;
}

}  // namespace

std::string short_number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

MeshEstimate::MeshEstimate(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(shape, TopAbs_EDGE, shapes);
    TopExp::MapShapes(shape, TopAbs_FACE, shapes);
    for (int i = 1; i <= shapes.Extent(); ++i)
        try
        {
            if (shapes(i).ShapeType() == TopAbs_FACE)
                add(TopoDS::Face(shapes(i)));
            else if (!BRep_Tool::Degenerated(TopoDS::Edge(shapes(i))))
                add(TopoDS::Edge(shapes(i)));
        }
        catch (const Standard_Failure&)
        {
            continue;  // what cannot be measured is not meshed either
        }
}

void MeshEstimate::add(const TopoDS_Edge& edge)
{
    const BRepAdaptor_Curve curve(edge);
    const double low = curve.FirstParameter(), high = curve.LastParameter();
    BRepLProp_CLProps local(curve, 2, 1e-9);
    for (int k = 0; k < samples; ++k)
    {
        local.SetParameter(sample(low, high, k));
        const double length = local.D1().Magnitude() * (high - low) / samples;
        if (std::isfinite(length))
            pieces_.push_back({length, local.IsTangentDefined() ? local.Curvature() : 0.0});
    }
}

void MeshEstimate::add(const TopoDS_Face& face)
{
    GProp_GProps all;
    BRepGProp::SurfaceProperties(face, all, 1e-2);
    const double area = std::abs(all.Mass());
    const BRepAdaptor_Surface surface(face, false);
    if (surface.GetType() == GeomAbs_Plane || !std::isfinite(area))
    {
        patches_.push_back({std::isfinite(area) ? area : 0.0, 0.0, 0.0});
        return;
    }
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    BRepLProp_SLProps local(surface, 2, 1e-9);
    for (int k = 0; k < samples * samples; ++k)
    {
        local.SetParameters(sample(u0, u1, k % samples), sample(v0, v1, k / samples));
        const bool is_known = local.IsCurvatureDefined();
        patches_.push_back({area / (samples * samples), is_known ? local.MaxCurvature() : 0.0,
                            is_known ? local.MinCurvature() : 0.0});
    }
}

double MeshEstimate::triangles(const CadMeshing& meshing) const
{
    // Equilateral triangles over every face, and those that grow from the short sides of its border
    // by 0.4 of the way (growth): the integral of 2.31 / (h + 0.4 x)^2 over both sides of the edge.
    // From geometry: an equilateral triangle of side h has the area h^2 / 2.31.
    constexpr double per_square = 2.31, beside_edges = 2.0 * per_square / 0.4;
    double found = 0.0;
    for (const Patch& patch : patches_)
    {
        // Between triangles as long as each curvature allows, and ones as long as both do.
        const double one = chord(patch.first, meshing), other = chord(patch.second, meshing);
        found += per_square * patch.area / std::sqrt(one * other) / std::min(one, other);
    }
    for (const Piece& piece : pieces_)
    {
        const double size = chord(piece.curvature, meshing);
        found += beside_edges * (piece.length / size) * (1.0 - size / meshing.edge);
    }
    return found;
}

void MeshEstimate::check(const CadMeshing& meshing) const
{
    const double needed = triangles(meshing);
    if (!(needed > most_triangles))
        return;
    // What asks for most of them: the edge alone, or what follows the curvature.
    CadMeshing flat = meshing, wanted = meshing;
    flat.deflection = 1e12;
    flat.angle = 1.5;
    const bool is_edge = triangles(flat) > 0.5 * needed;
    CadMeshing sharp = meshing;
    sharp.deflection = 1e12;
    const bool is_angle = !is_edge && triangles(sharp) > 0.5 * needed;
    double& size = is_edge ? wanted.edge : is_angle ? wanted.angle : wanted.deflection;
    // Chosen: the size in the message needs a tenth of the limit, and is found to 10 %.
    constexpr double fit = 0.1 * most_triangles, step = 1.1;
    const double largest = is_angle ? 1.5 : 1e12;
    while (triangles(wanted) > fit && size < largest)
        size *= step;
    const std::string what =
        is_edge    ? "edges of " + short_number(meshing.edge) + " mm"
        : is_angle ? "an angle of " + short_number(meshing.angle * 180.0 / M_PI) + " degrees"
                   : "a deflection of " + short_number(meshing.deflection) + " mm";
    const double unit = std::pow(10.0, std::floor(std::log10(size)));
    const std::string enough = short_number(std::ceil(size / unit) * unit) + " mm";
    throw InvalidInput(what + " would need " + short_number(needed / 1e6)
                           + " million triangles, the limit is "
                           + short_number(most_triangles / 1e6) + " million",
                       is_edge    ? "give a longer edge, about " + enough
                       : is_angle ? "give a larger one"
                                  : "give a larger one, about " + enough);
}

}  // namespace sheetmorph::cad
