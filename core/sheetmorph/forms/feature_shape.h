// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <optional>
#include <string>

namespace sheetmorph::forms
{

//! The form of a feature whose size can be set: how its vertices follow the size.
//! The feature at rest with size s is
//!   p_hat_i + (s - size) growth_i + rounding_i ;
//! its rim is then an exact circle (slot, cylinder) of that size, whatever noise the import has.
struct FeatureShape
{
    enum class Kind
    {
        hole,     //!< size: diameter of the rim
        slot,     //!< size: overall length
        cylinder  //!< size: radius
    };

    Kind kind = Kind::hole;
    double size = 0.0;  //!< at rest, mm
    Vector3 centre = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();   //!< of the hole or cylinder, normal of the slot
    Vector3 along = Vector3::UnitX();  //!< of a slot
    double smallest = 0.0;             //!< what a size must exceed, mm: the width of a slot
    Points growth;                     //!< (k, 3), no unit, by vertex of the feature
    Points rounding;                   //!< (k, 3) mm
    std::vector<int> rim;              //!< rows that lie on the circle (slot, cylinder)

    std::string measure() const;  //!< "diameter", "length" or "radius"

    //! The feature's vertices at rest with a size, (k, 3) mm. \param rest  the same without one
    Points resized(const Points& rest, double wanted) const;

    //! How far its rim is, at most, from the exact circle (slot, cylinder) of a size, mm.
    //! \param placed  (k, 3) mm, the feature's vertices, moved back to rest as one rigid body
    double outline_error(const Points& placed, double wanted) const;
};

//! What a feature's vertices are, if they are anything whose size can be set: a rim (boundary loop
//! or closed loop in the surface) or a slot, with or without rings of washer, which keep their
//! width; the same through both skins of a thin solid, with its wall; a cylinder or a part of one.
//! \param vertices  in any order; rows of the answer are in this order
//! \param scatter   of a measured mesh, scatter_of(), mm: its rims are allowed to be as uneven
std::optional<FeatureShape> feature_shape(const mesh::TriangleMesh& mesh, const VertexIds& vertices,
                                          double scatter = 0.0);

}  // namespace sheetmorph::forms
