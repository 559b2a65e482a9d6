// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/regions/crease_loops.h"

#include <array>

namespace sheetmorph::mesh
{

namespace
{

constexpr int none = -1;

// The two neighbours of every vertex along creases; `none` if it does not have exactly two.
std::vector<std::array<int, 2>> crease_neighbours(const TriangleMesh& mesh, const EdgeTable& table,
                                                  double angle)
{
    std::vector<std::array<int, 2>> next(static_cast<std::size_t>(mesh.vertex_count()),
                                         {none, none});
    std::vector<int> count(next.size(), 0);
    for (int edge = 0; edge < table.count(); ++edge)
    {
        if (!is_crease(mesh, table, edge, angle))
            continue;
        const EdgeUse& use = *table.uses(edge).begin();
        for (const auto& [here, there] : {std::array{use.from, use.to}, {use.to, use.from}})
        {
            if (count[here] < 2)
                next[here][count[here]] = there;
            ++count[here];
        }
    }
    for (std::size_t i = 0; i < next.size(); ++i)
        if (count[i] != 2)
            next[i] = {none, none};
    return next;
}

}  // namespace

bool is_crease(const TriangleMesh& mesh, const EdgeTable& table, int edge, double angle)
{
    const EdgeUses uses = table.uses(edge);
    return uses.count() != 2
           || bend_angle(mesh.points(), *uses.begin(), *(uses.begin() + 1)) >= angle;
}

std::vector<VertexIds> crease_loops(const TriangleMesh& mesh, const EdgeTable& table, double angle)
{
    const auto next = crease_neighbours(mesh, table, angle);
    std::vector<char> is_seen(next.size(), 0);
    std::vector<VertexIds> loops;
    for (int start = 0; start < mesh.vertex_count(); ++start)
    {
        VertexIds path;
        int before = none;
        for (int here = start; here != none && !is_seen[here];)
        {
            is_seen[here] = 1;
            path.push_back(here);
            const int ahead = next[here][0] == before ? next[here][1] : next[here][0];
            before = here;
            here = ahead;
        }
        // The path is a loop if its last step leads back to the start; otherwise it ran into a
        // junction.
        if (path.size() > 2 && (next[path.back()][0] == start || next[path.back()][1] == start))
            loops.push_back(path);
    }
    return loops;
}

}  // namespace sheetmorph::mesh
