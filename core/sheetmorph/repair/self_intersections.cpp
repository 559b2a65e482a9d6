// SPDX-License-Identifier: LGPL-2.1-or-later
// Only CGAL's kernel (LGPL) is used, for exact predicates.
#include "sheetmorph/repair/self_intersections.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/search/picking.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <limits>

namespace sheetmorph::repair
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Vector3 corner(const mesh::TriangleMesh& mesh, int t, int k)
{
    return mesh.points().row(mesh.triangles()(t, k));
}

Kernel::Point_3 exact(const Vector3& place)
{
    return {place.x(), place.y(), place.z()};
}

bool has_area(const mesh::TriangleMesh& mesh, int t)
{
    return !CGAL::collinear(exact(corner(mesh, t, 0)), exact(corner(mesh, t, 1)),
                            exact(corner(mesh, t, 2)));
}

// Two triangles with area, permuted so that their shared corners come first.
class Pair
{
public:
    Pair(const mesh::TriangleMesh& mesh, int one, int other)
    {
        Order p{0, 1, 2}, q{0, 1, 2};
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                if (mesh.triangles()(one, k) == mesh.triangles()(other, j))
                {
                    put(p, shared_, k);
                    put(q, shared_, j);
                    ++shared_;
                }
        for (int k = 0; k < 3; ++k)
        {
            p_[at(k)] = corner(mesh, one, p[at(k)]);
            q_[at(k)] = corner(mesh, other, q[at(k)]);
        }
    }

    bool meet_elsewhere() const
    {
        return shared_ == 3 || (!has_clear_plane_between() && meet_exactly());
    }

private:
    using Places = std::array<Vector3, 3>;
    using Order = std::array<int, 3>;

    static Kernel::Triangle_3 triangle(const std::array<Kernel::Point_3, 3>& places)
    {
        return {places[0], places[1], places[2]};
    }

    static void put(Order& order, int where, int k)
    {
        std::swap(order[at(where)], *std::find(order.begin(), order.end(), k));
    }

    // Whether a plane through the shared corners, or between the triangles, separates them by more
    // than rounding. This filter avoids exact predicates for most pairs; they are slow on flat
    // sheets.
    bool has_clear_plane_between() const
    {
        // Relative. From rounding: some products of coordinates, 1e-15. Chosen a thousand times
        // larger, because exact predicates decide the rest.
        constexpr double rounding = 1e-12;
        const Vector3& origin = p_[0];
        const auto ahead = [&](const Places& places)
        {
            Vector3 sum = Vector3::Zero();
            for (int k = shared_; k < 3; ++k)
                sum += places[at(k)] - origin;
            return shared_ == 1 ? Vector3(sum.normalized()) : sum;
        };
        Vector3 normal = ahead(p_) - ahead(q_);
        if (shared_ == 2)
        {
            const Vector3 side = (p_[1] - origin).normalized();
            normal -= normal.dot(side) * side;
        }
        normal.normalize();
        double above = std::numeric_limits<double>::infinity(),
               below = -std::numeric_limits<double>::infinity(), size = 0.0;
        for (int k = shared_; k < 3; ++k)
        {
            above = std::min(above, normal.dot(p_[at(k)] - origin));
            below = std::max(below, normal.dot(q_[at(k)] - origin));
        }
        for (int k = 0; k < 3; ++k)
            size =
                std::max({size, p_[at(k)].cwiseAbs().maxCoeff(), q_[at(k)].cwiseAbs().maxCoeff()});
        const double room = rounding * size;
        return shared_ == 0 ? above - below > room : above > room && below < -room;
    }

    bool meet_exactly() const
    {
        const std::array p{exact(p_[0]), exact(p_[1]), exact(p_[2])};
        const std::array q{exact(q_[0]), exact(q_[1]), exact(q_[2])};
        if (shared_ == 0)
            return CGAL::do_intersect(triangle(p), triangle(q));
        if (shared_ == 1)
            return CGAL::do_intersect(Kernel::Segment_3(p[1], p[2]), triangle(q))
                   || CGAL::do_intersect(Kernel::Segment_3(q[1], q[2]), triangle(p));
        // Triangles that share a side meet elsewhere only if they are coplanar and overlap.
        return CGAL::coplanar(p[0], p[1], p[2], q[2])
               && CGAL::coplanar_orientation(p[0], p[1], p[2], q[2]) == CGAL::POSITIVE;
    }

    int shared_ = 0;
    Places p_, q_;
};

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const mesh::TriangleMesh& mesh)
{
    std::vector<char> counts;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        counts.push_back(has_area(mesh, t));
    return mesh::PickingTree(mesh).pairs_where(
        [&](int one, int other) {
            return counts[at(one)] && counts[at(other)] && Pair(mesh, one, other).meet_elsewhere();
        });
}

}  // namespace sheetmorph::repair
