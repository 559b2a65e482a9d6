// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/patches.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/mesh/geometry/areas.h"
#include "sheetmorph/mesh/geometry/thinness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace sheetmorph::repair
{

namespace
{

// Distance from the plane of a group, relative to the mesh size. From STL, whose single precision
// rounds to 6e-8; a distance combines three coordinates.
constexpr double flatness = 2e-7;

// Cosine between the normals inside a group, 2.6 degrees. Chosen: small facets of a plane have
// normals that rounding turns by degrees; the distance decides for large ones.
constexpr double same_direction = 0.999;

// Groups of coplanar triangles, each grown from its largest triangle, whose plane is the most
// accurate.
class PlaneFlood
{
public:
    PlaneFlood(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table)
        : mesh_(mesh),
          table_(table),
          tolerance_(flatness * mesh.size()),
          plane_(static_cast<std::size_t>(mesh.triangle_count()), -1)
    {
    }

    std::vector<int> groups()
    {
        std::vector<double> area(plane_.size());
        for (int t = 0; t < mesh_.triangle_count(); ++t)
            area[t] = mesh::doubled_area(mesh_, t).norm();
        std::vector<int> order(plane_.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return area[a] > area[b]; });
        for (const int seed : order)
            if (plane_[seed] < 0)
                grow(seed, count_++);
        return plane_;
    }

private:
    void grow(int seed, int group)
    {
        const Vector3 normal = mesh::doubled_area(mesh_, seed).normalized();
        const Vector3 origin = mesh_.points().row(mesh_.triangles()(seed, 0));
        std::vector<int> front{seed};
        plane_[seed] = group;
        for (std::size_t next = 0; next < front.size(); ++next)
            for (int k = 0; k < 3; ++k)
            {
                const int edge = table_.edge_of(front[next], k);
                if (edge < 0 || table_.uses(edge).count() != 2)
                    continue;
                for (const mesh::EdgeUse& use : table_.uses(edge))
                    if (plane_[use.triangle] < 0 && is_on_plane(use.triangle, normal, origin))
                    {
                        plane_[use.triangle] = group;
                        front.push_back(use.triangle);
                    }
            }
    }

    bool is_on_plane(int triangle, const Vector3& normal, const Vector3& origin) const
    {
        for (int k = 0; k < 3; ++k)
        {
            const Vector3 corner = mesh_.points().row(mesh_.triangles()(triangle, k));
            if (std::abs((corner - origin).dot(normal)) > tolerance_)
                return false;
        }
        return mesh::is_thin(mesh_.points(), mesh_.triangles(), triangle)
               || mesh::doubled_area(mesh_, triangle).normalized().dot(normal) > same_direction;
    }

    const mesh::TriangleMesh& mesh_;
    const mesh::EdgeTable& table_;
    double tolerance_;
    std::vector<int> plane_;
    int count_ = 0;
};

// Whether each group is wide. The width is twice its area divided by the length of its border.
std::vector<char> wide_groups(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                              const std::vector<int>& plane, double least_width)
{
    const int count = plane.empty() ? 0 : *std::max_element(plane.begin(), plane.end()) + 1;
    std::vector<double> area(count, 0.0), border(count, 0.0);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        area[plane[t]] += 0.5 * mesh::doubled_area(mesh, t).norm();
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const mesh::EdgeUses uses = table.uses(edge);
        const mesh::EdgeUse& first = *uses.begin();
        const double length = (mesh.points().row(first.to) - mesh.points().row(first.from)).norm();
        const bool is_inner =
            uses.count() == 2 && plane[first.triangle] == plane[(uses.begin() + 1)->triangle];
        for (const mesh::EdgeUse& use : uses)
            border[plane[use.triangle]] += is_inner ? 0.0 : length;
    }
    std::vector<char> is_wide(count);
    for (int group = 0; group < count; ++group)
        is_wide[group] = 2.0 * area[group] > least_width * border[group];
    return is_wide;
}

// Patches are connected regions between ridges, numbered by their first triangle.
void number_patches(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                    const std::vector<char>& is_wide, Patches& found)
{
    DisjointSets sets(mesh.triangle_count());
    for (int edge = 0; edge < table.count(); ++edge)
        if (!found.is_ridge[edge])
            sets.join(table.uses(edge).begin()->triangle, (table.uses(edge).begin() + 1)->triangle);
    found.patch.assign(static_cast<std::size_t>(mesh.triangle_count()), -1);
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const int root = sets.root(t);
        if (root == t)
        {
            found.patch[t] = static_cast<int>(found.is_flat.size());
            found.is_flat.push_back(is_wide[found.plane[t]]);
        }
        found.patch[t] = found.patch[root];
    }
}

}  // namespace

Patches find_patches(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                     const PatchOptions& options)
{
    Patches found;
    found.plane = PlaneFlood(mesh, table).groups();
    const std::vector<char> is_wide = wide_groups(mesh, table, found.plane, options.least_width);
    found.is_ridge.assign(static_cast<std::size_t>(table.count()), 1);
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const mesh::EdgeUses uses = table.uses(edge);
        if (uses.count() != 2)
            continue;
        const mesh::EdgeUse& one = *uses.begin();
        const mesh::EdgeUse& two = *(uses.begin() + 1);
        const int a = found.plane[one.triangle], b = found.plane[two.triangle];
        found.is_ridge[edge] =
            a != b
            && (is_wide[a] || is_wide[b]
                || mesh::bend_angle(mesh.points(), one, two) > options.crease_angle);
    }
    number_patches(mesh, table, is_wide, found);
    return found;
}

}  // namespace sheetmorph::repair
