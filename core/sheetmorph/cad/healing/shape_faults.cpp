// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/healing/shape_faults.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListIteratorOfListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <map>
#include <set>

namespace sheetmorph::cad
{

namespace
{

std::string words(BRepCheck_Status status)
{
    static const std::map<BRepCheck_Status, std::string> known = {
        {BRepCheck_InvalidPointOnCurve, "a vertex is off its edge"},
        {BRepCheck_InvalidPointOnCurveOnSurface, "a vertex is off the face"},
        {BRepCheck_InvalidPointOnSurface, "a vertex is off the face"},
        {BRepCheck_No3DCurve, "an edge has no curve"},
        {BRepCheck_Multiple3DCurve, "an edge has several curves"},
        {BRepCheck_Invalid3DCurve, "an edge has no usable curve"},
        {BRepCheck_NoCurveOnSurface, "an edge has no curve on the face"},
        {BRepCheck_InvalidCurveOnSurface, "an edge is off the face"},
        {BRepCheck_InvalidCurveOnClosedSurface, "the seam is off the face"},
        {BRepCheck_InvalidSameParameterFlag, "an edge and its curve on the face do not agree"},
        {BRepCheck_InvalidSameRangeFlag, "an edge and its curve on the face do not agree"},
        {BRepCheck_FreeEdge, "an edge belongs to no other face"},
        {BRepCheck_InvalidMultiConnexity, "an edge has more than two faces"},
        {BRepCheck_InvalidRange, "an edge has no extent"},
        {BRepCheck_EmptyWire, "a border has no edges"},
        {BRepCheck_RedundantEdge, "an edge comes twice in a border"},
        {BRepCheck_SelfIntersectingWire, "its border crosses itself"},
        {BRepCheck_NoSurface, "it has no surface"},
        {BRepCheck_InvalidWire, "its border is broken"},
        {BRepCheck_RedundantWire, "a border comes twice"},
        {BRepCheck_IntersectingWires, "its borders cross"},
        {BRepCheck_InvalidImbricationOfWires, "its borders do not lie within each other"},
        {BRepCheck_EmptyShell, "a shell has no faces"},
        {BRepCheck_RedundantFace, "a face comes twice"},
        {BRepCheck_InvalidImbricationOfShells, "its shells do not lie within each other"},
        {BRepCheck_UnorientableShape, "it has no inside"},
        {BRepCheck_NotClosed, "it is not closed"},
        {BRepCheck_NotConnected, "it is in pieces"},
        {BRepCheck_BadOrientation, "an edge runs the wrong way"},
        {BRepCheck_BadOrientationOfSubshape, "a part of it is turned inside out"},
        {BRepCheck_EnclosedRegion, "it encloses another solid"},
    };
    const auto found = known.find(status);
    return found == known.end() ? "it cannot be checked" : found->second;
}

void add_words(const BRepCheck_ListOfStatus& all, std::set<std::string>& found)
{
    for (BRepCheck_ListIteratorOfListOfStatus it(all); it.More(); it.Next())
        if (it.Value() != BRepCheck_NoError)
            found.insert(words(it.Value()));
}

// Faults of a face, and of its borders, edges and vertices, alone and on the face.
std::set<std::string> faults_of_face(const BRepCheck_Analyzer& analyzer, const TopoDS_Shape& face)
{
    std::set<std::string> found;
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(face, parts);
    for (int i = 1; i <= parts.Extent(); ++i)
    {
        const Handle(BRepCheck_Result) result = analyzer.Result(parts(i));
        if (result.IsNull())
            continue;
        add_words(result->Status(), found);
        for (result->InitContextIterator(); result->MoreShapeInContext();
             result->NextShapeInContext())
            if (parts.Contains(result->ContextualShape()))
                add_words(result->StatusOnShape(), found);
    }
    return found;
}

std::string listed(const std::set<std::string>& all)
{
    std::string text;
    for (const std::string& one : all)
        text += (text.empty() ? "" : ", ") + one;
    return text;
}

}  // namespace

std::vector<std::string> shape_faults(const TopoDS_Shape& shape)
{
    const BRepCheck_Analyzer analyzer(shape);
    if (analyzer.IsValid())
        return {};
    std::vector<std::string> faults;
    TopTools_IndexedMapOfShape faces, groups;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    for (int f = 1; f <= faces.Extent(); ++f)
        if (const auto found = faults_of_face(analyzer, faces(f)); !found.empty())
            faults.push_back("face " + std::to_string(f - 1) + ": " + listed(found));
    for (const TopAbs_ShapeEnum kind : {TopAbs_SHELL, TopAbs_SOLID})
        TopExp::MapShapes(shape, kind, groups);
    std::set<std::string> of_groups;
    for (int i = 1; i <= groups.Extent(); ++i)
        if (const Handle(BRepCheck_Result) result = analyzer.Result(groups(i)); !result.IsNull())
        {
            add_words(result->Status(), of_groups);
            for (result->InitContextIterator(); result->MoreShapeInContext();
                 result->NextShapeInContext())
                add_words(result->StatusOnShape(), of_groups);
        }
    if (!of_groups.empty() || faults.empty())
        faults.push_back(of_groups.empty() ? "BRepCheck does not accept it" : listed(of_groups));
    return faults;
}

}  // namespace sheetmorph::cad
