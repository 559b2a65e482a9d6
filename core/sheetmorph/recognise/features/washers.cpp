// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/washers.h"

#include <set>

namespace sheetmorph
{

WasherGrower::WasherGrower(const FacetGraph& graph)
    : graph_(graph), starts_(static_cast<std::size_t>(graph.mesh().vertex_count()) + 1, 0)
{
    const Triangles& corners = graph.mesh().triangles();
    for (Eigen::Index k = 0; k < corners.size(); ++k)
        ++starts_[corners.data()[k] + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i)
        starts_[i] += starts_[i - 1];
    std::vector<int> next = starts_;
    triangles_.resize(static_cast<std::size_t>(corners.size()));
    for (Eigen::Index k = 0; k < corners.size(); ++k)
        triangles_[next[corners.data()[k]]++] = static_cast<int>(k / 3);
}

std::vector<VertexIds> WasherGrower::rings(const VertexIds& vertices, int count) const
{
    std::set<int> known(vertices.begin(), vertices.end());
    std::vector<VertexIds> rings;
    VertexIds last = vertices;
    for (int ring = 0; ring < count; ++ring)
    {
        std::set<int> grown;
        for (const int vertex : last)
            for (int k = starts_[vertex]; k < starts_[vertex + 1]; ++k)
                for (int c = 0; c < 3; ++c)
                {
                    const int corner = graph_.mesh().triangles()(triangles_[k], c);
                    if (known.insert(corner).second)
                        grown.insert(corner);
                }
        last.assign(grown.begin(), grown.end());
        rings.push_back(last);
    }
    return rings;
}

}  // namespace sheetmorph
