// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/facets/facet_graph.h"

namespace sheetmorph::recognise
{

//! A closed border of a region of triangles: a rim of the mesh or an edge of the shape.
struct RegionLoop
{
    int region = 0;
    VertexIds vertices;          //!< of the merged mesh, in order
    std::vector<int> triangles;  //!< of the region, at the edge from vertex i to the next
    std::vector<int> across;     //!< the triangle beyond that edge; -1 if there is not exactly one
    int free_edges = 0;          //!< number of edges with a single triangle
    //! position of the region relative to the loop: 1 inside it, -1 around it, 0 along the axis
    double inwards = 0.0;
    double area = 0.0;                  //!< enclosed, mm^2
    Vector3 normal = Vector3::UnitZ();  //!< follows the direction of the loop, length 1
    Vector3 center = Vector3::Zero();   //!< mean of its vertices, mm

    bool is_free() const { return free_edges == static_cast<int>(vertices.size()); }
};

//! RegionLoop::inwards beyond which a region lies clearly inside its loop, or clearly around it.
//! From geometry: the sine of the angle between region and axis. Chosen: a collar or a wall that
//! leans by 20 degrees is still a collar.
constexpr double clearly_inwards = 0.35;

//! The loops around all regions, ordered by region and first vertex, without slits of zero area.
//! \param labels  (m) the region of every triangle
std::vector<RegionLoop> region_loops(const FacetGraph& graph, const std::vector<int>& labels);

}  // namespace sheetmorph::recognise
