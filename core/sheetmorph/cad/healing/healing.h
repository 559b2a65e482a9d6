// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_source.h"

#include <TopTools_DataMapOfShapeShape.hxx>

namespace sheetmorph::cad
{

//! Heals the products of a document whose bodies OpenCASCADE's BRepCheck does not accept, where
//! that leaves all faces and moves nothing by more than a hundredth of a millimetre.
class Healing
{
public:
    //! \param source  whose bodies were collected; they must be collected anew if is_any()
    explicit Healing(CadSource& source);

    bool is_any() const { return !before_.IsEmpty(); }

    //! What faces and solids were, by what they are; all without placements.
    const TopTools_DataMapOfShapeShape& before() const { return before_; }

    //! Says of every body what was wrong with it, and what still is.
    void note(std::vector<NamedShape>& bodies) const;

private:
    void heal_product(CadDocument& document, const TDF_Label& product);

    std::vector<std::vector<std::string>> faults_;  // one a body
    std::vector<int> products_;         // one a body: the index of what healed it, or -1
    std::vector<TopoDS_Shape> bodies_;  // without placements
    std::vector<double> within_;        // one a healed product, mm
    TopTools_DataMapOfShapeShape before_;
};

}  // namespace sheetmorph::cad
