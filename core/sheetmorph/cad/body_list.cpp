// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/body_list.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>

namespace sheetmorph::cad
{

namespace
{

// Records for each face which face of the shell replaces it.
void note_sewn(NamedShape& shell, const std::vector<TopoDS_Shape>& faces,
               const BRepBuilderAPI_Sewing& sewing)
{
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(shell.shape, TopAbs_FACE, own);
    for (const TopoDS_Shape& face : faces)
        if (const TopoDS_Shape& made = sewing.Modified(face); own.Contains(made))
            shell.sewn.emplace_back(face, made);
}

// Sews faces that touch to shells with common edges.
std::vector<NamedShape> sewn(const std::vector<TopoDS_Shape>& faces)
{
    Bnd_Box box;
    for (const TopoDS_Shape& face : faces)
        BRepBndLib::Add(face, box, false);
    const double size = box.IsVoid() ? 1.0 : std::sqrt(box.SquareExtent());
    // mm. Chosen: gaps of 1e-5 of the size are exports of surfaces; a gap of 0.05 mm is a fault.
    BRepBuilderAPI_Sewing sewing(std::clamp(1e-5 * size, 1e-4, 0.05));
    for (const TopoDS_Shape& face : faces)
        sewing.Add(face);
    sewing.Perform();
    const TopoDS_Shape& result = sewing.SewedShape();
    std::vector<NamedShape> shells;
    const auto add = [&](const TopoDS_Shape& shape)
    {
        shells.emplace_back();
        shells.back().shape = shape;
        note_sewn(shells.back(), faces, sewing);
    };
    for (TopExp_Explorer it(result, TopAbs_SHELL); it.More(); it.Next())
        add(it.Current());
    for (TopExp_Explorer it(result, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next())
    {
        TopoDS_Shell shell;
        BRep_Builder builder;
        builder.MakeShell(shell);
        builder.Add(shell, it.Current());
        add(shell);
    }
    return shells;
}

std::vector<NamedShape> bodies_in(const TopoDS_Shape& shape)
{
    std::vector<NamedShape> bodies;
    std::vector<TopoDS_Shape> faces;
    const auto add = [&](const TopoDS_Shape& body)
    {
        bodies.emplace_back();
        bodies.back().shape = body;
    };
    for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next())
        add(it.Current());
    for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
        add(it.Current());
    for (TopExp_Explorer it(shape, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next())
        faces.push_back(it.Current());
    if (!faces.empty())
        for (const NamedShape& shell : sewn(faces))
            bodies.push_back(shell);
    return bodies;
}

}  // namespace

void BodyList::add(const TopoDS_Shape& shape, const TopLoc_Location& placement,
                   const std::string& name, const BodyName& body_name)
{
    std::vector<NamedShape> found = bodies_in(shape.Moved(placement));
    for (std::size_t k = 0; k < found.size(); ++k)
    {
        std::string full = name;
        found[k].own_name = body_name ? body_name(found[k].shape) : "";
        if (found.size() > 1)
        {
            const std::string& own = found[k].own_name;
            full += (full.empty() ? "" : ".") + (own.empty() ? std::to_string(k + 1) : own);
        }
        else if (full.empty())
            full = found[k].own_name;
        found[k].name = unique(full.empty() ? "part" : full);
        found[k].placement = placement;
        found[k].product = products_;
        bodies_.push_back(std::move(found[k]));
    }
    ++products_;
}

std::string BodyList::unique(const std::string& name)
{
    std::string found = name;
    for (int number = 2; !used_.insert(found).second; ++number)
        found = name + " " + std::to_string(number);
    return found;
}

}  // namespace sheetmorph::cad
