// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/facets/facet_graph.h"

namespace sheetmorph::recognise
{

//! A ray from a facet straight into the material.
struct InwardProbe
{
    int facet;
    int opposite;     //!< the first facet of the same component that the ray hits; -1: none
    double distance;  //!< length of the ray, mm
    double area;      //!< share of the facet's area that this ray represents, mm^2
    bool is_facing;   //!< whether the hit facet faces the opposite way, within 45 degrees
};

//! Casts rays from points spread over every non-degenerate facet of every closed component. A facet
//! gets one ray, a large facet up to 64, because CAD tessellations cover each flat with a few huge
//! facets.
std::vector<InwardProbe> inward_probes(const mesh::TriangleMesh& mesh, const FacetGraph& graph);

}  // namespace sheetmorph::recognise
