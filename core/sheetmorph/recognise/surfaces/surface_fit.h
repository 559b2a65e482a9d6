// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/facets/facet_graph.h"
#include "sheetmorph/recognise/feature.h"

#include <cmath>
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

    //! Distance of a point from it, mm; offset: to which side, along the normal.
    double distance(const Vector3& place) const { return std::abs(offset(place)); }
    double offset(const Vector3& place) const;

    //! Its normal at a place, length 1, to either side.
    Vector3 normal(const Vector3& place) const;

    //! What residuals are compared with: the radius at a place, mm.
    double radius_at(const Vector3& place) const;
};

//! A surface of one kind through triangles, from their normals and corners; nothing where their
//! normals are not those of that kind.
std::optional<Surface> fit_surface(const FacetGraph& graph, const std::vector<int>& triangles,
                                   FeatureKind kind);

//! The surface with the least squared distances from the corners of the triangles (Levenberg and
//! Marquardt): exact where they were drawn on one. A start that nothing betters is returned.
Surface refined(const FacetGraph& graph, const std::vector<int>& triangles, const Surface& start);

//! The largest distance of a corner of the triangles over the radius there.
double misfit_of(const FacetGraph& graph, const std::vector<int>& triangles,
                 const Surface& surface);

}  // namespace sheetmorph
