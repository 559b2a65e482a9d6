// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/facets/facet_graph.h"

#include <optional>
#include <vector>

namespace sheetmorph::recognise
{

//! A coarser copy of a drawn part whose facets consist of many small triangles. It describes the
//! same surface, so that recognition does not depend on the fineness of the mesh.
//! A facet is a connected set of coplanar triangles. Coarsening removes vertices inside facets and
//! on straight edges between two facets. It limits the edge length by the facet's width and by a
//! share of the part's size. Corners, bent edges and borders keep their vertices.
class CoarseFacets
{
public:
    //! \returns nothing if coarsening would not reduce the number of triangles enough
    static std::optional<CoarseFacets> of(const FacetGraph& fine);

    //! The coarse part.
    const FacetGraph& graph() const { return graph_; }

    //! The triangles of the fine part (ascending) whose facets lie mostly in these coarse
    //! triangles.
    std::vector<int> fine_triangles(const std::vector<int>& coarse) const;

private:
    CoarseFacets(const mesh::TriangleMesh& mesh, std::vector<int> facet_of_coarse,
                 std::vector<int> facet_of_fine);

    FacetGraph graph_;
    std::vector<int> facet_of_coarse_;  // by triangle
    std::vector<double> area_;          // by facet, mm^2 in the coarse part
    std::vector<int> starts_;           // by facet: its first entry in fine_, and the end
    std::vector<int> fine_;
};

}  // namespace sheetmorph::recognise
