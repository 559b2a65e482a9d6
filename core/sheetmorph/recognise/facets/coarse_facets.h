// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/facets/facet_graph.h"

#include <optional>
#include <vector>

namespace sheetmorph::recognise
{

//! A drawn part whose facets were cut into many small triangles, with few large ones in their
//! place: the same surface, so that what is recognised does not depend on how fine a mesh is.
//! A facet is all triangles that lie in one plane side by side. Vertices inside facets, and on
//! straight edges between two, are taken out while the triangles stay smaller than the facet is
//! wide and than a share of the part; corners, bent edges and borders keep theirs.
class CoarseFacets
{
public:
    //! \returns nothing where that would not leave far fewer triangles
    static std::optional<CoarseFacets> of(const FacetGraph& fine);

    //! The coarse part.
    const FacetGraph& graph() const { return graph_; }

    //! The triangles of the fine part, ascending, of the facets that lie for the most part in
    //! these triangles of the coarse one.
    std::vector<int> fine_triangles(const std::vector<int>& coarse) const;

private:
    CoarseFacets(const mesh::TriangleMesh& mesh, std::vector<int> facet_of_coarse,
                 std::vector<int> facet_of_fine);

    FacetGraph graph_;
    std::vector<int> facet_of_coarse_;  // of every triangle
    std::vector<double> area_;          // of every facet in the coarse part, mm^2
    std::vector<int> starts_;           // of the fine triangles of each facet, and the end
    std::vector<int> fine_;
};

}  // namespace sheetmorph::recognise
