// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/body_list.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>

namespace sheetmorph
{

namespace
{

// Faces that lie side by side as shells with common edges.
std::vector<TopoDS_Shape> sewn(const std::vector<TopoDS_Shape>& faces)
{
    Bnd_Box box;
    for (const TopoDS_Shape& face : faces)
        BRepBndLib::Add(face, box, false);
    const double size = box.IsVoid() ? 1.0 : std::sqrt(box.SquareExtent());
    BRepBuilderAPI_Sewing sewing(std::clamp(1e-5 * size, 1e-4, 0.05));
    for (const TopoDS_Shape& face : faces)
        sewing.Add(face);
    sewing.Perform();
    const TopoDS_Shape& result = sewing.SewedShape();
    std::vector<TopoDS_Shape> shells;
    for (TopExp_Explorer it(result, TopAbs_SHELL); it.More(); it.Next())
        shells.push_back(it.Current());
    for (TopExp_Explorer it(result, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next())
    {
        TopoDS_Shell shell;
        BRep_Builder builder;
        builder.MakeShell(shell);
        builder.Add(shell, it.Current());
        shells.push_back(shell);
    }
    return shells;
}

std::vector<TopoDS_Shape> bodies_in(const TopoDS_Shape& shape)
{
    std::vector<TopoDS_Shape> bodies, faces;
    for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next())
        bodies.push_back(it.Current());
    for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
        bodies.push_back(it.Current());
    for (TopExp_Explorer it(shape, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next())
        faces.push_back(it.Current());
    if (!faces.empty())
        for (const TopoDS_Shape& shell : sewn(faces))
            bodies.push_back(shell);
    return bodies;
}

}  // namespace

void BodyList::add(const TopoDS_Shape& shape, const std::string& name, const BodyName& body_name)
{
    const std::vector<TopoDS_Shape> found = bodies_in(shape);
    for (std::size_t k = 0; k < found.size(); ++k)
    {
        std::string full = name;
        if (found.size() > 1)
        {
            const std::string own = body_name ? body_name(found[k]) : "";
            full += (full.empty() ? "" : ".") + (own.empty() ? std::to_string(k + 1) : own);
        }
        else if (full.empty() && body_name)
            full = body_name(found[k]);
        bodies_.push_back({unique(full.empty() ? "part" : full), found[k], {}});
    }
}

std::string BodyList::unique(const std::string& name)
{
    std::string found = name;
    for (int number = 2; !used_.insert(found).second; ++number)
        found = name + " " + std::to_string(number);
    return found;
}

}  // namespace sheetmorph
