// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/facets/facet_graph.h"

namespace sheetmorph::recognise
{

//! One look from a facet straight into the material.
struct InwardProbe
{
    int facet;
    int opposite;     //!< the facet of the same component that ends the look; -1 if there is none
    double distance;  //!< to it, mm
    double area;      //!< of the facet that this look stands for, mm^2
    bool is_facing;   //!< whether the opposite facet looks the other way, to 45 degrees
};

//! Looks from points spread over every facet with a plane of every closed component: one a facet,
//! up to 64 where a facet is large, since CAD tessellations have a few huge facets on every flat.
std::vector<InwardProbe> inward_probes(const mesh::TriangleMesh& mesh, const FacetGraph& graph);

}  // namespace sheetmorph::recognise
