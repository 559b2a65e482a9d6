// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <optional>
#include <string>

namespace sheetmorph::forms
{

//! How the vertices of a feature follow its size.
//! At size s, the feature at rest is
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
    double smallest = 0.0;             //!< lower limit of the size, mm: the width of a slot
    Points growth;                     //!< (k, 3), no unit, by vertex of the feature
    Points rounding;                   //!< (k, 3) mm
    std::vector<int> rim;              //!< rows on the circle (slot, cylinder)

    std::string measure() const;  //!< "diameter", "length" or "radius"

    //! The feature's vertices at rest with a given size, (k, 3) mm.
    //! \param rest  the vertices at rest, (k, 3) mm
    Points resized(const Points& rest, double wanted) const;

    //! The largest distance of the rim from the exact circle (slot, cylinder) of a size, mm.
    //! \param placed  (k, 3) mm, the feature's vertices after removing its rigid body motion
    double outline_error(const Points& placed, double wanted) const;
};

//! Recognises a feature whose size can be set, else returns nothing. Such a feature is a rim (a
//! border or a closed loop in the surface) or a slot, with or without rings of washer that keep
//! their width. It may run through both skins of a thin solid, with its wall. It may also be a
//! cylinder or a part of one.
//! \param vertices  in any order; rows of the result are in this order
//! \param scatter   scatter_of() a measured mesh, mm; rims may be uneven to this extent
std::optional<FeatureShape> feature_shape(const mesh::TriangleMesh& mesh, const VertexIds& vertices,
                                          double scatter = 0.0);

}  // namespace sheetmorph::forms
