// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/picking.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/limits.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/mesh/search/triangle_queries.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

namespace sheetmorph::mesh
{

namespace
{

constexpr int triangles_per_leaf = 4;  // chosen, not measured: 2 to 8 are usual in box trees
constexpr int leaves_at_once = 64;     // chosen, not measured: fewest leaves for a thread
constexpr int most_levels = 32;        // from int: no mesh has 2^32 leaves
constexpr double far_away = std::numeric_limits<double>::infinity();

// The lowest 21 bits of a number, two zeros between each.
std::uint64_t spread_bits(std::uint64_t bits)
{
    bits &= 0x1fffff;
    bits = (bits | bits << 32) & 0x1f00000000ffff;
    bits = (bits | bits << 16) & 0x1f0000ff0000ff;
    bits = (bits | bits << 8) & 0x100f00f00f00f00f;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
    return (bits | bits << 2) & 0x1249249249249249;
}

// A ray's nearest hit so far.
struct RayQuery
{
    TriangleRay ray;
    Hit best;

    template <typename Box>
    double distance_of(const Box& box) const
    {
        return ray.entry(box.low, box.high);
    }

    void try_triangle(int triangle, const std::array<Vector3, 3>& corners)
    {
        Hit hit;
        if (!ray.meets(corners, hit))
            return;
        hit.triangle = triangle;
        if (std::pair(hit.distance, hit.triangle) < std::pair(best.distance, best.triangle))
            best = hit;
    }
};

template <typename Box>
double distance_to_box(const Vector3& point, const Box& box)
{
    const Vector3 nearest = point.cwiseMax(box.low).cwiseMin(box.high);
    // Rounding must not hide the box that holds the nearest place.
    return (1.0 - 1e-14) * (nearest - point).norm();
}

// The place nearest to a point; best: so far.
struct PointQuery
{
    Vector3 point;
    Hit best;

    template <typename Box>
    double distance_of(const Box& box) const
    {
        return distance_to_box(point, box);
    }

    void try_triangle(int triangle, const std::array<Vector3, 3>& corners)
    {
        Hit hit = nearest_on_triangle(point, corners);
        hit.triangle = triangle;
        if (std::pair(hit.distance, hit.triangle) < std::pair(best.distance, best.triangle))
            best = hit;
    }
};

void require_finite(const Vector3& point)
{
    if (!are_numbers(point))
        throw InvalidInput("the point has coordinates that are not finite numbers");
}

Hit nothing_yet()
{
    Hit hit;
    hit.triangle = std::numeric_limits<int>::max();
    hit.distance = far_away;
    return hit;
}

}  // namespace

PickingTree::PickingTree(const TriangleMesh& mesh)
    : points_(mesh.points()), triangles_(mesh.triangles())
{
    if (mesh.triangle_count() == 0)
        return;
    for (leaf_count_ = 1; leaf_count_ * triangles_per_leaf < mesh.triangle_count();)
        leaf_count_ *= 2;
    look_for_stop();
    order_triangles();
    fit_boxes();
}

Vector3 PickingTree::corner(int triangle, int k) const
{
    return points_.row(triangles_(triangle, k)).transpose();
}

// Along a Morton curve through the centroids, so that neighbours in the order are near each other.
void PickingTree::order_triangles()
{
    const Vector3 low = points_.colwise().minCoeff();
    const Vector3 extent = points_.colwise().maxCoeff().transpose() - low;
    // 2^21 - 1: three numbers of 21 bits fit into one of 64.
    const double scale = 2097151.0 / std::max(extent.maxCoeff(), 1e-300);
    std::vector<std::pair<std::uint64_t, int>> keys(triangles_.rows());
    for (int t = 0; t < triangles_.rows(); ++t)
    {
        const Vector3 cell =
            ((corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0 - low).cwiseMax(0.0) * scale;
        std::uint64_t key = 0;
        for (int c = 0; c < 3; ++c)
            key |= spread_bits(static_cast<std::uint64_t>(std::min(cell(c), 2097151.0))) << c;
        keys[t] = {key, t};
    }
    std::sort(keys.begin(), keys.end());
    order_.resize(keys.size());
    for (std::size_t k = 0; k < keys.size(); ++k)
        order_[k] = keys[k].second;
}

int PickingTree::first_of_leaf(int leaf) const
{
    return static_cast<int>(static_cast<std::int64_t>(leaf) * triangles_.rows() / leaf_count_);
}

PickingTree::Box PickingTree::box_of(int triangle) const
{
    const Vector3 a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

PickingTree::Box PickingTree::box_of_leaf(int leaf) const
{
    Box box{Vector3::Constant(far_away), Vector3::Constant(-far_away)};
    for (int k = first_of_leaf(leaf); k < first_of_leaf(leaf + 1); ++k)
    {
        const Box own = box_of(order_[k]);
        box = {box.low.cwiseMin(own.low), box.high.cwiseMax(own.high)};
    }
    return box;
}

void PickingTree::fit_boxes()
{
    boxes_.resize(2 * static_cast<std::size_t>(leaf_count_));
    for (int leaf = 0; leaf < leaf_count_; ++leaf)
        boxes_[leaf_count_ + leaf] = box_of_leaf(leaf);
    for (int i = leaf_count_ - 1; i >= 1; --i)
        boxes_[i] = {boxes_[2 * i].low.cwiseMin(boxes_[2 * i + 1].low),
                     boxes_[2 * i].high.cwiseMax(boxes_[2 * i + 1].high)};
}

void PickingTree::refit(const Points& points)
{
    if (points.rows() != points_.rows())
        throw InvalidInput("the new shape has " + std::to_string(points.rows())
                           + " points, the picking tree was built for "
                           + std::to_string(points_.rows()));
    points_ = TriangleMesh(points, triangles_).points();  // checks them
    if (leaf_count_ > 0)
        fit_boxes();
}

// Walks the tree, the nearer child first; what is farther than the best find is not entered.
template <typename Query>
void PickingTree::visit(Query& query) const
{
    std::array<std::pair<int, double>, most_levels> waiting;
    int count = 0;
    if (leaf_count_ > 0)
        waiting[count++] = {1, query.distance_of(boxes_[1])};
    while (count > 0)
    {
        auto [node, distance] = waiting[--count];
        while (distance <= query.best.distance && node < leaf_count_)
        {
            std::pair near(2 * node, query.distance_of(boxes_[2 * node]));
            std::pair far(2 * node + 1, query.distance_of(boxes_[2 * node + 1]));
            if (far.second < near.second)
                std::swap(near, far);
            if (far.second < far_away)
                waiting[count++] = far;
            std::tie(node, distance) = near;
        }
        if (!(distance <= query.best.distance) || distance == far_away)
            continue;
        const int leaf = node - leaf_count_;
        for (int k = first_of_leaf(leaf); k < first_of_leaf(leaf + 1); ++k)
            query.try_triangle(order_[k],
                               {corner(order_[k], 0), corner(order_[k], 1), corner(order_[k], 2)});
    }
}

std::optional<Hit> PickingTree::nearest_hit(const Vector3& origin, const Vector3& direction) const
{
    const double reach = leaf_count_ == 0 ? 0.0
                                          : std::max(boxes_[1].low.cwiseAbs().maxCoeff(),
                                                     boxes_[1].high.cwiseAbs().maxCoeff());
    RayQuery query{checked_ray(origin, direction, reach), nothing_yet()};
    if (leaf_count_ == 0)
        return std::nullopt;
    visit(query);
    return query.best.distance < far_away ? std::optional<Hit>(query.best) : std::nullopt;
}

std::vector<int> PickingTree::triangles_between(const Planes& planes) const
{
    std::vector<int> found;
    if (leaf_count_ > 0)
        collect(1, planes, found);
    return found;
}

void PickingTree::collect(int node, const Planes& planes, std::vector<int>& found) const
{
    bool is_inside = true;
    for (int k = 0; k < planes.rows(); ++k)
    {
        const auto normal = planes.row(k).head<3>().transpose();
        const Vector3 low = normal.cwiseProduct(boxes_[node].low);
        const Vector3 high = normal.cwiseProduct(boxes_[node].high);
        if (low.cwiseMax(high).sum() + planes(k, 3) < 0.0)
            return;
        is_inside = is_inside && low.cwiseMin(high).sum() + planes(k, 3) >= 0.0;
    }
    if (!is_inside && node < leaf_count_)
    {
        collect(2 * node, planes, found);
        return collect(2 * node + 1, planes, found);
    }
    int first = node, last = node;  // of the leaves below
    for (; first < leaf_count_; last = 2 * last + 1)
        first *= 2;
    found.insert(found.end(), order_.begin() + first_of_leaf(first - leaf_count_),
                 order_.begin() + first_of_leaf(last + 1 - leaf_count_));
}

// The leaves whose boxes meet the one of a leaf, itself and those behind it in the order.
template <typename Visit>
void PickingTree::visit_leaves_meeting(int leaf, const Visit& visit) const
{
    const int own = leaf_count_ + leaf;
    visit(leaf);
    for (int above = own; above > 1; above /= 2)
    {
        if (above % 2 == 1)
            continue;
        std::array<int, most_levels> waiting{above + 1};
        for (int count = 1; count > 0;)
        {
            const int node = waiting[--count];
            if (!boxes_[own].meets(boxes_[node]))
                continue;
            if (node >= leaf_count_)
            {
                visit(node - leaf_count_);
                continue;
            }
            waiting[count++] = 2 * node;
            waiting[count++] = 2 * node + 1;
        }
    }
}

std::vector<std::pair<int, int>> PickingTree::pairs_where(
    const std::function<bool(int one, int other)>& is_wanted) const
{
    std::vector<Box> boxes(order_.size());  // in the order of the leaves
    for (std::size_t k = 0; k < boxes.size(); ++k)
        boxes[k] = box_of(order_[k]);
    std::vector<std::pair<int, int>> found;
    std::mutex one_at_a_time;
    const auto pairs_of_leaf = [&](int leaf, std::vector<std::pair<int, int>>& pairs)
    {
        visit_leaves_meeting(
            leaf,
            [&](int other)
            {
                for (int k = first_of_leaf(leaf); k < first_of_leaf(leaf + 1); ++k)
                    for (int j = std::max(k + 1, first_of_leaf(other));
                         j < first_of_leaf(other + 1); ++j)
                    {
                        const auto pair = std::minmax({order_[k], order_[j]});
                        if (boxes[k].meets(boxes[j]) && is_wanted(pair.first, pair.second))
                            pairs.push_back(pair);
                    }
            });
    };
    parallel_ranges(leaf_count_, leaves_at_once,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        std::vector<std::pair<int, int>> pairs;
                        for (Eigen::Index leaf = begin; leaf < end; ++leaf)
                            pairs_of_leaf(static_cast<int>(leaf), pairs);
                        const std::lock_guard guard(one_at_a_time);
                        found.insert(found.end(), pairs.begin(), pairs.end());
                    });
    std::sort(found.begin(), found.end());
    return found;
}

std::optional<Hit> PickingTree::nearest_point(const Vector3& point, double reach) const
{
    require_finite(point);
    PointQuery query{point, nothing_yet()};
    query.best.distance = reach;
    visit(query);
    const bool is_found = query.best.triangle < std::numeric_limits<int>::max();
    return is_found ? std::optional<Hit>(query.best) : std::nullopt;
}

}  // namespace sheetmorph::mesh
