// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/fans.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/index.h"

#include <map>

namespace sheetmorph::mesh
{

namespace
{

int next_corner(int corner)
{
    return corner / 3 * 3 + (corner + 1) % 3;
}

// Joins the corners at both ends of two sides on the same edge.
void join_sides(const LaidFaces& faces, int one, int other, DisjointSets& corners)
{
    const bool opposed = faces.from(one) == faces.to(other);
    corners.join(one, opposed ? next_corner(other) : other);
    corners.join(next_corner(one), opposed ? other : next_corner(other));
}

}  // namespace

Fans fans_of(const LaidFaces& faces, int vertex_count)
{
    const int corner_count = 3 * faces.count();
    DisjointSets sets(corner_count);
    Fans fans;
    fans.around.assign(at(vertex_count), 0);
    fans.is_interior.assign(at(vertex_count), 1);
    for (int side = 0; side < corner_count; ++side)
        if (faces.glued[at(side)] > side)
            join_sides(faces, side, faces.glued[at(side)], sets);
        else if (faces.glued[at(side)] == LaidFaces::open)
            for (const int vertex : {faces.from(side), faces.to(side)})
                fans.is_interior[at(vertex)] = 0;
    for (const std::vector<int>& seam : seams_of(faces))
        for (const int side : seam)
            join_sides(faces, seam.front(), side, sets);
    fans.of_corner.resize(at(corner_count));
    for (int corner = 0; corner < corner_count; ++corner)
    {
        const int root = sets.root(corner);
        if (root == corner)
        {
            fans.of_corner[at(corner)] = static_cast<int>(fans.vertex.size());
            fans.vertex.push_back(faces.from(corner));
            ++fans.around[at(faces.from(corner))];
        }
        fans.of_corner[at(corner)] = fans.of_corner[at(root)];
    }
    for (int vertex = 0; vertex < vertex_count; ++vertex)
        if (fans.around[at(vertex)] != 1)
            fans.is_interior[at(vertex)] = 0;
    return fans;
}

std::vector<std::vector<int>> seams_of(const LaidFaces& faces)
{
    std::map<int, std::vector<int>> sides_on;
    for (int side = 0; side < 3 * faces.count(); ++side)
        if (faces.rim[at(side)] != LaidFaces::open)
            sides_on[faces.rim[at(side)]].push_back(side);
    std::vector<std::vector<int>> seams;
    for (auto& [edge, sides] : sides_on)
        if (sides.size() > 1)
            seams.push_back(std::move(sides));
    return seams;
}

}  // namespace sheetmorph::mesh
