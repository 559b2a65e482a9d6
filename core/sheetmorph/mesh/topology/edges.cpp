// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/edges.h"

#include "sheetmorph/base/threads/stopping.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace sheetmorph::mesh
{

namespace
{

int low(const EdgeUse& use)
{
    return std::min(use.from, use.to);
}

int high(const EdgeUse& use)
{
    return std::max(use.from, use.to);
}

// Sorts duplicate triangles next to each other, so that the second is detected.
bool is_before(const EdgeUse& a, const EdgeUse& b)
{
    return std::tuple(high(a), a.opposite, a.triangle)
           < std::tuple(high(b), b.opposite, b.triangle);
}

bool is_same_edge(const EdgeUse& a, const EdgeUse& b)
{
    return low(a) == low(b) && high(a) == high(b);
}

bool repeats_a_vertex(const Eigen::RowVector3i& t)
{
    return t(0) == t(1) || t(1) == t(2) || t(2) == t(0);
}

}  // namespace

EdgeTable::EdgeTable(const TriangleMesh& mesh)
{
    look_for_stop();
    sort_uses(mesh);
    look_for_stop();
    drop_doubled_triangles(mesh);
    number_edges(mesh);
}

// One bucket per smaller vertex, then a sort of the few uses in each bucket.
void EdgeTable::sort_uses(const TriangleMesh& mesh)
{
    const Triangles& triangles = mesh.triangles();
    std::vector<EdgeUse> all;
    all.reserve(3 * static_cast<std::size_t>(triangles.rows()));
    std::vector<int> place(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
    for (int t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3 && !repeats_a_vertex(triangles.row(t)); ++k)
        {
            const int from = triangles(t, k);
            const int to = triangles(t, (k + 1) % 3);
            all.push_back({t, from, to, triangles(t, (k + 2) % 3)});
            ++place[std::min(from, to) + 1];
        }
    for (int i = 0; i < mesh.vertex_count(); ++i)
        place[i + 1] += place[i];
    std::vector<int> next = place;
    uses_.resize(all.size());
    for (const EdgeUse& use : all)
        uses_[next[low(use)]++] = use;
    for (int i = 0; i < mesh.vertex_count(); ++i)
        std::sort(uses_.begin() + place[i], uses_.begin() + place[i + 1], is_before);
}

void EdgeTable::drop_doubled_triangles(const TriangleMesh& mesh)
{
    std::vector<char> is_doubled(static_cast<std::size_t>(mesh.triangle_count()), 0);
    for (std::size_t k = 1; k < uses_.size(); ++k)
        if (is_same_edge(uses_[k - 1], uses_[k]) && uses_[k - 1].opposite == uses_[k].opposite)
            is_doubled[uses_[k].triangle] = 1;
    const auto is_dropped = [&](const EdgeUse& use) { return is_doubled[use.triangle] != 0; };
    uses_.erase(std::remove_if(uses_.begin(), uses_.end(), is_dropped), uses_.end());
}

void EdgeTable::number_edges(const TriangleMesh& mesh)
{
    edge_of_side_.assign(3 * static_cast<std::size_t>(mesh.triangle_count()), -1);
    for (std::size_t k = 0; k < uses_.size(); ++k)
    {
        if (k == 0 || !is_same_edge(uses_[k - 1], uses_[k]))
            starts_.push_back(static_cast<int>(k));
        const EdgeUse& use = uses_[k];
        for (int side = 0; side < 3; ++side)
            if (mesh.triangles()(use.triangle, side) == use.from)
                edge_of_side_[3 * use.triangle + side] = static_cast<int>(starts_.size()) - 1;
    }
    starts_.push_back(static_cast<int>(uses_.size()));
}

EdgeUses EdgeTable::uses(int edge) const
{
    return {uses_.data() + starts_[edge], uses_.data() + starts_[edge + 1]};
}

double bend_angle(const Points& points, const EdgeUse& one, const EdgeUse& other)
{
    const Vector3 start = points.row(one.from);
    const Vector3 along = (points.row(one.to).transpose() - start).normalized();
    const Vector3 to_one = points.row(one.opposite).transpose() - start;
    const Vector3 to_other = points.row(other.opposite).transpose() - start;
    const Vector3 across_one = to_one - along * along.dot(to_one);
    const Vector3 across_other = along * along.dot(to_other) - to_other;
    return std::atan2(across_one.cross(across_other).norm(), across_one.dot(across_other));
}

}  // namespace sheetmorph::mesh
