// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/healing/healing.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/cad/healing/shape_faults.h"
#include "sheetmorph/cad/label_attributes.h"

#include <BRep_Tool.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>

namespace sheetmorph::cad
{

namespace
{

// mm: how far healing may move a surface. Chosen: the default tolerance of writing
// (CarryTolerances::surface), so that a healed shape is as exact as a written one.
constexpr double farthest = 0.01;

TopoDS_Shape unplaced(const TopoDS_Shape& shape)
{
    return shape.Located(TopLoc_Location());
}

TopTools_IndexedMapOfShape parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind)
{
    TopTools_IndexedMapOfShape found;
    TopExp::MapShapes(shape, kind, found);
    return found;
}

bool has_as_many(const TopoDS_Shape& one, const TopoDS_Shape& other)
{
    for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE})
        if (parts_of(one, kind).Extent() != parts_of(other, kind).Extent())
            return false;
    return true;
}

// The largest displacement of a vertex, or the new tolerance of an edge or vertex, mm.
double change(const TopoDS_Shape& before, const TopoDS_Shape& after,
              const Handle(BRepTools_ReShape) & context)
{
    double worst = 0.0;
    const auto edges = parts_of(after, TopAbs_EDGE), vertices = parts_of(after, TopAbs_VERTEX);
    for (int i = 1; i <= edges.Extent(); ++i)
        worst = std::max(worst, BRep_Tool::Tolerance(TopoDS::Edge(edges(i))));
    for (int i = 1; i <= vertices.Extent(); ++i)
        worst = std::max(worst, BRep_Tool::Tolerance(TopoDS::Vertex(vertices(i))));
    const auto old = parts_of(before, TopAbs_VERTEX);
    for (int i = 1; i <= old.Extent(); ++i)
        if (const TopoDS_Shape now = context->Apply(old(i));
            !now.IsNull() && now.ShapeType() == TopAbs_VERTEX)
            worst = std::max(worst, BRep_Tool::Pnt(TopoDS::Vertex(old(i)))
                                        .Distance(BRep_Tool::Pnt(TopoDS::Vertex(now))));
    return worst;
}

}  // namespace

Healing::Healing(CadSource& source)
{
    for (const NamedShape& body : source.bodies)
        bodies_.push_back(unplaced(body.shape));
    faults_.resize(bodies_.size());
    products_.assign(bodies_.size(), -1);
    parallel_items(static_cast<Eigen::Index>(bodies_.size()),
                   [&](Eigen::Index k)
                   {
                       const auto i = static_cast<std::size_t>(k);
                       faults_[i] = shape_faults(bodies_[i]);
                   });
    if (std::all_of(faults_.begin(), faults_.end(), [](const auto& one) { return one.empty(); }))
        return;
    TDF_LabelSequence labels;
    source.document.shapes()->GetShapes(labels);
    for (int i = 1; i <= labels.Length(); ++i)
        if (XCAFDoc_ShapeTool::IsSimpleShape(labels.Value(i)))
            heal_product(source.document, labels.Value(i));
    if (is_any())
        source.document.shapes()->UpdateAssemblies();
}

void Healing::heal_product(CadDocument& document, const TDF_Label& product)
{
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, parts);
    TopTools_IndexedMapOfShape known;
    for (int i = 1; i <= parts.Extent(); ++i)
        known.Add(unplaced(parts(i)));
    std::vector<std::size_t> broken;
    for (std::size_t k = 0; k < bodies_.size(); ++k)
        if (!faults_[k].empty() && known.Contains(bodies_[k]))
            broken.push_back(k);
    if (broken.empty())
        return;
    ShapeFix_Shape fix(shape);
    fix.SetMaxTolerance(farthest);
    fix.Perform();
    const TopoDS_Shape healed = fix.Shape();
    if (healed.IsNull() || !has_as_many(shape, healed) || !shape_faults(healed).empty())
        return;
    const double within = change(shape, healed, fix.Context());
    if (!(within <= farthest))
        return;
    PartImages images;
    for (int i = 1; i <= parts.Extent(); ++i)
        if (const TopoDS_Shape now = fix.Context()->Apply(parts(i));
            !now.IsNull() && !now.IsSame(parts(i)) && now.ShapeType() == parts(i).ShapeType())
        {
            images.one.Bind(parts(i), now);
            before_.Bind(unplaced(now), unplaced(parts(i)));
        }
    document.shapes()->SetShape(product, healed);
    copy_parts(product, product, images, document.shapes());
    for (const std::size_t k : broken)
        products_[k] = static_cast<int>(within_.size());
    within_.push_back(within);
}

void Healing::note(std::vector<NamedShape>& bodies) const
{
    for (std::size_t k = 0; k < std::min(bodies.size(), faults_.size()); ++k)
        if (products_[k] < 0)
            bodies[k].faults = faults_[k];
        else
        {
            bodies[k].healed = faults_[k];
            bodies[k].healed_within = within_[static_cast<std::size_t>(products_[k])];
        }
}

}  // namespace sheetmorph::cad
