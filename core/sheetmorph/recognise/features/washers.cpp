// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/washers.h"

#include <set>

namespace sheetmorph::recognise
{

std::vector<VertexIds> WasherGrower::rings(const VertexIds& vertices, int count) const
{
    std::set<int> known(vertices.begin(), vertices.end());
    std::vector<VertexIds> rings;
    VertexIds last = vertices;
    for (int ring = 0; ring < count; ++ring)
    {
        std::set<int> grown;
        for (const int vertex : last)
            for (const int t : triangles_.at(vertex))
                for (int c = 0; c < 3; ++c)
                {
                    const int corner = graph_.mesh().triangles()(t, c);
                    if (known.insert(corner).second)
                        grown.insert(corner);
                }
        last.assign(grown.begin(), grown.end());
        rings.push_back(last);
    }
    return rings;
}

}  // namespace sheetmorph::recognise
