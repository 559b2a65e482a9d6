// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/body_list.h"
#include "sheetmorph/cad/carry/carried_shape.h"
#include "sheetmorph/cad/writing/cad_measures.h"

#include <Geom_Surface.hxx>

namespace sheetmorph::cad
{

//! Compares a body that was read from a written file with its intended form.
class BodyMeasurer
{
public:
    //! \param mesh  of the shape as it was read
    //! \param body  as placed in the assembly of the file
    BodyMeasurer(const ShapeMesh& mesh, const CarriedShape& carried, const NamedShape& body);

    //! \param result     (n, 3) of the mesh, in the coordinates of the assembly, mm
    //! \param tolerance  faces that deviate by more are reported, mm
    CadMeasures measures(const Points& result, double tolerance) const;

private:
    Points measure_distances(CadMeasures& found, const Points& result, double tolerance) const;
    void measure_kinks(CadMeasures& found) const;
    void measure_cylinders(CadMeasures& found) const;
    void check_shape(CadMeasures& found) const;
    const TopoDS_Shape& image_of(int face) const;
    TopoDS_Shape read_face(int face) const;

    const ShapeMesh& before_;
    const ShapeMesh& mesh_;  // with washers as separate faces
    const CarriedShape& carried_;
    TopoDS_Shape body_;
    bool is_valid_;
    TopTools_IndexedMapOfShape made_, read_;  // faces
};

}  // namespace sheetmorph::cad
