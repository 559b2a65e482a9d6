// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/facet_graph.h"
#include "sheetmorph/recognise/feature.h"

#include <optional>

namespace sheetmorph
{

//! A plane, cylinder, cone or sphere in space.
struct Surface
{
    FeatureKind kind = FeatureKind::plane;
    Vector3 point = Vector3::Zero();  //!< on the plane or axis, apex, center, mm
    Vector3 axis = Vector3::UnitZ();  //!< normal or axis, length 1; of a cone away
                                      //!< from its apex
    double radius = 0.0;              //!< of cylinder and sphere, mm
    double angle = 0.0;               //!< of a cone, between axis and surface, radians

    //! Distance of a point from it, mm.
    double distance(const Vector3& place) const;

    //! Its normal at a place, length 1, to either side.
    Vector3 normal(const Vector3& place) const;

    //! What residuals are compared with: the radius at a place, mm.
    double radius_at(const Vector3& place) const;
};

//! The least-squares surface of one kind through triangles; nothing where their
//! normals are not those of that kind.
std::optional<Surface> fit_surface(const FacetGraph& graph, const std::vector<int>& triangles,
                                   FeatureKind kind);

}  // namespace sheetmorph
