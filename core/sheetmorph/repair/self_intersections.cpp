// SPDX-License-Identifier: LGPL-2.1-or-later
// Of CGAL only its kernel, which is LGPL: exact predicates.
#include "sheetmorph/repair/self_intersections.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/search/picking.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>

namespace sheetmorph
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 place(const TriangleMesh& mesh, int vertex)
{
    return {mesh.points()(vertex, 0), mesh.points()(vertex, 1), mesh.points()(vertex, 2)};
}

bool has_area(const TriangleMesh& mesh, int t)
{
    return !CGAL::collinear(place(mesh, mesh.triangles()(t, 0)),
                            place(mesh, mesh.triangles()(t, 1)),
                            place(mesh, mesh.triangles()(t, 2)));
}

// Two triangles with area, turned so that the corners they share come first.
class Pair
{
public:
    Pair(const TriangleMesh& mesh, int one, int other)
    {
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                if (mesh.triangles()(one, k) == mesh.triangles()(other, j))
                {
                    put(one_, shared_, k);
                    put(other_, shared_, j);
                    ++shared_;
                }
        for (int k = 0; k < 3; ++k)
        {
            p_[k] = place(mesh, mesh.triangles()(one, one_[k]));
            q_[k] = place(mesh, mesh.triangles()(other, other_[k]));
        }
    }

    bool meet_elsewhere() const
    {
        if (shared_ == 0)
            return CGAL::do_intersect(triangle(p_), triangle(q_));
        if (shared_ == 1)
            return CGAL::do_intersect(Kernel::Segment_3(p_[1], p_[2]), triangle(q_))
                   || CGAL::do_intersect(Kernel::Segment_3(q_[1], q_[2]), triangle(p_));
        // Over one side they meet elsewhere only where one lies folded onto the other.
        return shared_ == 3
               || (CGAL::coplanar(p_[0], p_[1], p_[2], q_[2])
                   && CGAL::coplanar_orientation(p_[0], p_[1], p_[2], q_[2]) == CGAL::POSITIVE);
    }

private:
    using Places = std::array<Kernel::Point_3, 3>;
    using Order = std::array<int, 3>;

    static void put(Order& order, int where, int k)
    {
        std::swap(order[where], *std::find(order.begin(), order.end(), k));
    }
    static Kernel::Triangle_3 triangle(const Places& places)
    {
        return {places[0], places[1], places[2]};
    }

    Order one_{0, 1, 2}, other_{0, 1, 2};
    int shared_ = 0;
    Places p_, q_;
};

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh)
{
    std::vector<char> counts;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        counts.push_back(has_area(mesh, t));
    return PickingTree(mesh).pairs_where(
        [&](int one, int other) {
            return counts[at(one)] && counts[at(other)] && Pair(mesh, one, other).meet_elsewhere();
        });
}

}  // namespace sheetmorph
