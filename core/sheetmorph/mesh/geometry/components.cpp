// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/components.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/mesh/geometry/operators.h"

#include <algorithm>

namespace sheetmorph::mesh
{

VertexIds Components::vertices(int component) const
{
    VertexIds found;
    for (int i = 0; i < static_cast<int>(label.size()); ++i)
        if (label[static_cast<std::size_t>(i)] == component)
            found.push_back(i);
    return found;
}

Components connected_components(const TriangleMesh& mesh, const std::vector<VertexIds>& joined)
{
    look_for_stop();
    const int vertex_count = mesh.vertex_count();
    DisjointSets sets(vertex_count);
    std::vector<char> used(static_cast<std::size_t>(vertex_count), 0);
    const Points weights = half_cotangents(mesh);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (!weights.row(t).isZero(0.0))
            for (int k = 0; k < 3; ++k)
            {
                used[static_cast<std::size_t>(mesh.triangles()(t, k))] = 1;
                sets.join(mesh.triangles()(t, 0), mesh.triangles()(t, k));
            }
    for (const VertexIds& group : joined)
    {
        const bool is_on_sheet =
            std::any_of(group.begin(), group.end(),
                        [&](int vertex) { return used[static_cast<std::size_t>(vertex)] != 0; });
        for (const int vertex : group)
        {
            sets.join(group.front(), vertex);
            if (is_on_sheet)
                used[static_cast<std::size_t>(vertex)] = 1;
        }
    }

    Components components;
    components.label.assign(static_cast<std::size_t>(vertex_count), Components::unused);
    std::vector<int> number(static_cast<std::size_t>(vertex_count), Components::unused);
    for (int i = 0; i < vertex_count; ++i)
        if (used[static_cast<std::size_t>(i)])
        {
            int& of_root = number[static_cast<std::size_t>(sets.root(i))];
            if (of_root == Components::unused)
                of_root = components.count++;
            components.label[static_cast<std::size_t>(i)] = of_root;
        }
    return components;
}

}  // namespace sheetmorph::mesh
