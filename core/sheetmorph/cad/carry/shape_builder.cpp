// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/shape_builder.h"
#include "sheetmorph/cad/splines/parameter_curve.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>

namespace sheetmorph::cad
{

TopoDS_Shape ShapeBuilder::built(const TopoDS_Shape& part)
{
    if (!images_.IsBound(part))
    {
        TopoDS_Shape image = made(part.Oriented(TopAbs_FORWARD));
        image.Closed(part.Closed());
        images_.Bind(part, image);
    }
    return images_.Find(part).Oriented(part.Orientation());
}

TopoDS_Shape ShapeBuilder::made(const TopoDS_Shape& part)
{
    switch (part.ShapeType())
    {
        case TopAbs_VERTEX:
            return made_vertex(part);
        case TopAbs_EDGE:
            return made_edge(part);
        case TopAbs_FACE:
            return made_face(part);
        default:
            return made_group(part);
    }
}

TopoDS_Shape ShapeBuilder::made_vertex(const TopoDS_Shape& part) const
{
    const int index = carrier_.mesh().vertices.FindIndex(part);
    const CarriedVertex& carried = carrier_.vertices()[static_cast<std::size_t>(index - 1)];
    TopoDS_Vertex vertex;
    builder_.MakeVertex(vertex, gp_Pnt(carried.point(0), carried.point(1), carried.point(2)),
                        carried.tolerance);
    return vertex;
}

TopoDS_Shape ShapeBuilder::made_edge(const TopoDS_Shape& part)
{
    const int index = carrier_.mesh().edges.FindIndex(part);
    const CarriedEdge& carried = carrier_.edges()[static_cast<std::size_t>(index - 1)];
    TopoDS_Edge edge;
    if (carried.is_degenerated)
    {
        builder_.MakeEdge(edge);
        builder_.Degenerated(edge, true);
        builder_.UpdateEdge(edge, carried.tolerance);
    }
    else
        builder_.MakeEdge(edge, carried.curve, carried.tolerance);
    add_parts(edge, part);
    if (!carried.is_degenerated)
        builder_.Range(edge, carried.low, carried.high);
    return edge;
}

TopoDS_Shape ShapeBuilder::made_face(const TopoDS_Shape& part)
{
    const int index = carrier_.mesh().faces.FindIndex(part);
    const CarriedFace& carried = carrier_.faces()[static_cast<std::size_t>(index - 1)];
    TopoDS_Face face;
    builder_.MakeFace(face, carried.surface,
                      carried.spline ? 1e-7 : BRep_Tool::Tolerance(carried.face));
    builder_.NaturalRestriction(face, BRep_Tool::NaturalRestriction(carried.face));
    add_parts(face, part);
    add_parameters(face, carried);
    return face;
}

Handle(Geom2d_Curve) ShapeBuilder::written_curve(const TopoDS_Edge& edge,
                                                 const TopoDS_Face& face) const
{
    const int index = carrier_.mesh().edges.FindIndex(edge) - 1;
    const int number = carrier_.mesh().faces.FindIndex(face) - 1;
    const std::vector<EdgeOnFace>& uses = carrier_.edges()[static_cast<std::size_t>(index)].uses;
    return std::find_if(uses.begin(), uses.end(),
                        [&](const EdgeOnFace& use) { return use.face == number; })
        ->written;
}

// The curves of the edges in the parameters of a face stay, or are recomputed beneath the edges.
void ShapeBuilder::add_parameters(const TopoDS_Face& face, const CarriedFace& carried)
{
    const TopoDS_Face before = TopoDS::Face(carried.face.Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer it(before, TopAbs_EDGE); it.More(); it.Next())
    {
        const TopoDS_Edge old = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
        const TopoDS_Edge edge = TopoDS::Edge(built(old));
        double low = 0.0, high = 0.0;
        Standard_Boolean is_stored = false;
        const Handle(Geom2d_Curve) curve =
            BRep_Tool::CurveOnSurface(old, before, low, high, &is_stored);
        // A plane needs no such curve. A face that stays a plane keeps its stored one.
        if (curve.IsNull() || (!is_stored && !carried.spline))
            continue;
        const double tolerance = BRep_Tool::Tolerance(edge);
        const auto ended = [&](const Handle(Geom2d_Curve) & one)
        { return carried.spline ? spline_in_parameters(one, low, high) : one; };
        if (BRep_Tool::IsClosed(old, before))
            builder_.UpdateEdge(
                edge, ended(curve),
                ended(BRep_Tool::CurveOnSurface(TopoDS::Edge(old.Reversed()), before, low, high)),
                face, tolerance);
        else
            builder_.UpdateEdge(edge, carried.spline ? written_curve(old, before) : curve, face,
                                tolerance);
        builder_.Range(edge, face, low, high);
    }
}

TopoDS_Shape ShapeBuilder::made_group(const TopoDS_Shape& part)
{
    TopoDS_Shape group = part.EmptyCopied();
    group.Location(TopLoc_Location());
    add_parts(group, part);
    return group;
}

void ShapeBuilder::add_parts(TopoDS_Shape& whole, const TopoDS_Shape& before)
{
    for (TopoDS_Iterator it(before, false, true); it.More(); it.Next())
        builder_.Add(whole, built(it.Value()));
}

}  // namespace sheetmorph::cad
