// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/surfaces/surface_fit.h"

#include <algorithm>

namespace sheetmorph::recognise
{

namespace
{

// The corners of every stride-th triangle.
Points corners_of(const FacetGraph& graph, const std::vector<int>& triangles, std::size_t stride)
{
    Points corners(3 * ((triangles.size() + stride - 1) / stride), 3);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < triangles.size(); i += stride)
        for (int k = 0; k < 3; ++k)
            corners.row(row++) = graph.point(graph.mesh().triangles()(triangles[i], k)).transpose();
    return corners;
}

}  // namespace

fitting::FacetSample sample_of(const FacetGraph& graph, const std::vector<int>& triangles)
{
    const auto count = static_cast<Eigen::Index>(triangles.size());
    fitting::FacetSample sample{corners_of(graph, triangles, 1), Points(count, 3), Points(count, 3),
                                Eigen::VectorXd(count)};
    for (Eigen::Index i = 0; i < count; ++i)
    {
        const int triangle = triangles[static_cast<std::size_t>(i)];
        sample.normals.row(i) = graph.normal(triangle).transpose();
        sample.centroids.row(i) = graph.centroid(triangle).transpose();
        sample.areas(i) = graph.area(triangle);
    }
    return sample;
}

Points some_corners(const FacetGraph& graph, const std::vector<int>& triangles)
{
    // Chosen: 750 corners determine the six unknowns of a cone; more only take longer.
    constexpr std::size_t most = 250;
    return corners_of(graph, triangles, 1 + triangles.size() / most);
}

double misfit_of(const FacetGraph& graph, const std::vector<int>& triangles,
                 const fitting::Surface& surface)
{
    return fitting::misfit_of(corners_of(graph, triangles, 1), surface);
}

}  // namespace sheetmorph::recognise
