// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph
{

//! Two facets that share an edge nobody else uses, oriented alike.
struct FacetJoint
{
    int one, other;
    double bend;    //!< radians between the planes, 0 flat; 0 if one facet is too thin for a plane
    double length;  //!< of the edge, mm
};

//! The facets of a mesh and how they hang together.
struct SolidFacets
{
    std::vector<FacetJoint> joints;
    Points normals;               //!< (m, 3) of length 1, out of the material of closed components
    Points centres;               //!< (m, 3) mm
    Eigen::VectorXd areas;        //!< (m) mm^2
    std::vector<char> is_thin;    //!< (m) too thin to have a plane (thinness.h)
    std::vector<int> component;   //!< (m) connected across joints, from 0
    std::vector<char> is_closed;  //!< by component: no open edge, and oriented alike

    int component_count() const { return static_cast<int>(is_closed.size()); }
    int facet_count() const { return static_cast<int>(is_thin.size()); }
};

//! Where more than two facets meet in an edge, or two of opposite orientation, they are not joined;
//! the components around stay closed if as many facets run along the edge one way as the other.
SolidFacets solid_facets(const TriangleMesh& mesh);

}  // namespace sheetmorph
