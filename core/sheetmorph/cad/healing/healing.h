// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_source.h"

#include <TopTools_DataMapOfShapeShape.hxx>

namespace sheetmorph::cad
{

//! Heals the products of a document whose bodies fail OpenCASCADE's BRepCheck, if all faces survive
//! and nothing moves by more than 0.01 mm.
class Healing
{
public:
    //! \param source  with collected bodies; collect them again if is_any()
    explicit Healing(CadSource& source);

    bool is_any() const { return !before_.IsEmpty(); }

    //! Originals of faces and solids, by their healed form; all without placements.
    const TopTools_DataMapOfShapeShape& before() const { return before_; }

    //! Records for every body its faults before and after healing.
    void note(std::vector<NamedShape>& bodies) const;

private:
    void heal_product(CadDocument& document, const TDF_Label& product);

    std::vector<std::vector<std::string>> faults_;  // one per body
    std::vector<int> products_;         // one per body: index of the healed product, or -1
    std::vector<TopoDS_Shape> bodies_;  // without placements
    std::vector<double> within_;        // one per healed product, mm
    TopTools_DataMapOfShapeShape before_;
};

}  // namespace sheetmorph::cad
