// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/carried_shape.h"
#include "sheetmorph/cad/carry/shape_builder.h"
#include "sheetmorph/cad/carry/washers.h"

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

namespace sheetmorph::cad
{

namespace
{

// Between faces that keep their surfaces, edges keep their continuity.
void keep_continuity(const ShapeCarrier& carrier, ShapeBuilder& builder)
{
    const BRep_Builder change;
    for (const CarriedEdge& edge : carrier.edges())
    {
        if (edge.uses.size() != 2 || edge.is_degenerated)
            continue;
        const CarriedFace& one = carrier.faces()[static_cast<std::size_t>(edge.uses[0].face)];
        const CarriedFace& other = carrier.faces()[static_cast<std::size_t>(edge.uses[1].face)];
        if (one.spline || other.spline
            || !BRep_Tool::HasContinuity(edge.edge, one.face, other.face))
            continue;
        change.Continuity(TopoDS::Edge(builder.built(edge.edge)),
                          TopoDS::Face(builder.built(one.face)),
                          TopoDS::Face(builder.built(other.face)),
                          BRep_Tool::Continuity(edge.edge, one.face, other.face));
    }
}

WasheredMesh with_washers(const ShapeMesh& mesh, const Points& result,
                          const CarryTolerances& tolerances)
{
    // Relative to the tolerance of edges. Chosen: where the divided washer meets its neighbours,
    // the division uses a twentieth of what may be off.
    constexpr double of_edge = 0.05;
    const double rigid = rigid_tolerance(mesh);
    return divide_along_washers(mesh, result, face_motions(mesh, result, rigid),
                                {rigid, of_edge * tolerances.edge});
}

}  // namespace

CarriedShape carried_shape(const std::shared_ptr<const ShapeMesh>& mesh, const Points& result,
                           const CarryTolerances& tolerances, const Progress& progress)
{
    const WasheredMesh divided = with_washers(*mesh, result, tolerances);
    CarriedShape carried;
    carried.mesh = divided.mesh ? divided.mesh : mesh;
    ShapeCarrier carrier(*carried.mesh, result, tolerances);
    carrier.run(progress);
    ShapeBuilder builder(carrier);
    carried.shape = builder.built(carried.mesh->shape);
    keep_continuity(carrier, builder);
    for (const CarriedFace& face : carrier.faces())
    {
        carried.is_kept.push_back(face.motion.has_value());
        carried.scale.push_back(face.motion ? face.motion->scale : 1.0);
    }
    carried.gap = carrier.gap();
    for (const auto& [whole, washer] : divided.washers)
        carried.washers.emplace_back(whole, builder.built(washer));
    carried.image = builder.images();
    for (TopTools_DataMapOfShapeShape::Iterator it(divided.replaced); it.More(); it.Next())
        carried.image.Bind(it.Key(), carried.image.Find(it.Value()));
    return carried;
}

}  // namespace sheetmorph::cad
