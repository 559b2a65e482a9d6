// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/carry/shape_carrier.h"

#include <BRep_Builder.hxx>

namespace sheetmorph::cad
{

//! Rebuilds a shape on the surfaces, curves and points of a ShapeCarrier. Shared parts stay shared,
//! no part has a location of its own, and parameters stay.
class ShapeBuilder
{
public:
    explicit ShapeBuilder(const ShapeCarrier& carrier) : carrier_(carrier) {}

    //! The new form of a part of the carrier's shape, or of the whole, with the same orientation.
    TopoDS_Shape built(const TopoDS_Shape& part);

    //! All built parts, by their originals.
    const TopTools_DataMapOfShapeShape& images() const { return images_; }

private:
    TopoDS_Shape made(const TopoDS_Shape& part);
    TopoDS_Shape made_vertex(const TopoDS_Shape& part) const;
    TopoDS_Shape made_edge(const TopoDS_Shape& part);
    TopoDS_Shape made_face(const TopoDS_Shape& part);
    TopoDS_Shape made_group(const TopoDS_Shape& part);
    void add_parts(TopoDS_Shape& whole, const TopoDS_Shape& before);
    void add_parameters(const TopoDS_Face& face, const CarriedFace& carried);
    Handle(Geom2d_Curve) written_curve(const TopoDS_Edge& edge, const TopoDS_Face& face) const;

    const ShapeCarrier& carrier_;
    BRep_Builder builder_;
    TopTools_DataMapOfShapeShape images_;
};

}  // namespace sheetmorph::cad
