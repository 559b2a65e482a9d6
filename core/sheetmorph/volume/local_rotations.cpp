// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/local_rotations.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/vertex_sets.h"

#include <Eigen/Dense>
#include <algorithm>
#include <iterator>
#include <utility>

namespace sheetmorph
{

namespace
{

// Below this share of its edges' squares, the area of a ring is rounding.
constexpr double no_area = 1e-10;

Vector3 arm(const Points& points, int from, int to)
{
    return (points.row(to) - points.row(from)).transpose();
}

// Calls visit(index, count, is_first) along the chains of a ring: `count` triangles have that edge.
template <class Visit>
void along(const std::vector<int>& ends, const Visit& visit)
{
    int k = 0;
    for (const int end : ends)
        for (const int first = k; k < end; ++k)
            visit(static_cast<std::size_t>(k), k == first || k + 1 == end ? 1.0 : 2.0, k == first);
}

// Triangles of one ring that are oriented against the first ones, turned round: without this the
// normals of a badly oriented mesh would cancel.
std::vector<int> same_sided(const Points& points, int vertex, std::vector<int> others)
{
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k + 1 < others.size(); k += 2)
    {
        const Vector3 area =
            arm(points, vertex, others[k]).cross(arm(points, vertex, others[k + 1]));
        if (area.dot(sum) < 0.0)
            std::swap(others[k], others[k + 1]);
        sum += area.dot(sum) < 0.0 ? Vector3(-area) : area;
    }
    return others;
}

// The sides opposite to a vertex, two ends each, joined end to end as far as they go.
std::vector<int> chained(std::vector<int> sides, std::vector<int>& ends)
{
    std::vector<int> others;
    const auto take = [&](std::size_t k, bool is_first)
    {
        if (is_first)
            others.push_back(sides[k]);
        others.push_back(sides[k + 1]);
        sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(k),
                    sides.begin() + static_cast<std::ptrdiff_t>(k) + 2);
    };
    const auto starting_at = [&](int vertex)
    {
        std::size_t k = 0;
        while (k < sides.size() && sides[k] != vertex)
            k += 2;
        return k;
    };
    const auto is_entered = [&](int vertex)
    {
        std::size_t k = 1;
        while (k < sides.size() && sides[k] != vertex)
            k += 2;
        return k < sides.size();
    };
    while (!sides.empty())
    {
        std::size_t first = 0;
        while (first < sides.size() && is_entered(sides[first]))
            first += 2;
        take(first < sides.size() ? first : 0, true);
        for (std::size_t k; (k = starting_at(others.back())) < sides.size();)
            take(k, false);
        ends.push_back(static_cast<int>(others.size()));
    }
    return others;
}

// The neighbours of a vertex in every triangle around.
std::vector<int> ring_of(const PartGeometry& part, int vertex)
{
    const Triangles& triangles = part.mesh().triangles();
    std::vector<int> others;
    int last = -1;
    for (const int t : part.triangles().at(vertex))
    {
        for (int k = 0; k < 3 && t != last; ++k)
            for (int step = 1; triangles(t, k) == vertex && step < 3; ++step)
                others.push_back(triangles(t, (k + step) % 3));
        last = t;
    }
    return others;
}

// Weights with the sum 1; equal ones where there are none.
Eigen::VectorXd shares(const Eigen::VectorXd& weights, Eigen::Index count)
{
    const bool is_weighted = weights.size() == count && weights.sum() > 0.0;
    const Eigen::VectorXd share =
        is_weighted ? weights : Eigen::VectorXd(Eigen::VectorXd::Ones(count));
    return share / share.sum();
}

}  // namespace

LocalRotationMeter::LocalRotationMeter(const TriangleMesh& rest, const VertexIds& vertices)
    : LocalRotationMeter(PartGeometry(rest), vertices)
{
}

LocalRotationMeter::LocalRotationMeter(const PartGeometry& rest, const VertexIds& vertices)
    : vertex_count_(rest.mesh().vertex_count())
{
    std::vector<int> missing;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(missing),
                 [&](int v) { return v < 0 || v >= vertex_count_; });
    if (!missing.empty())
        throw InvalidInput("vertices that the mesh does not have: " + list_ids(missing));
    const Points& points = rest.mesh().points();
    rings_.reserve(vertices.size());
    for (const int vertex : vertices)
        rings_.push_back(rest_ring(points, vertex, ring_of(rest, vertex)));
    keep_rest(points);
}

// Contacts measure few vertices of a large part: they keep no copy of its points.
void LocalRotationMeter::keep_rest(const Points& rest)
{
    const VertexIds used = reads();
    if (2 * static_cast<Eigen::Index>(used.size()) > rest.rows())
    {
        rest_ = rest;
        return;
    }
    rest_ = rest(used, Eigen::indexing::all);
    const auto row_of = [&](int vertex)
    { return static_cast<int>(std::lower_bound(used.begin(), used.end(), vertex) - used.begin()); };
    for (Ring& ring : rings_)
    {
        ring.rows.push_back(row_of(ring.vertex));
        std::transform(ring.others.begin(), ring.others.end(), std::back_inserter(ring.rows),
                       row_of);
    }
}

LocalRotationMeter::Ring LocalRotationMeter::rest_ring(const Points& rest, int vertex,
                                                       std::vector<int> sides)
{
    Ring ring{vertex, {}, {}, {}, Vector3::Zero(), 0.0, Matrix3::Zero()};
    ring.others = chained(same_sided(rest, vertex, std::move(sides)), ring.ends);
    Matrix3 moments = Matrix3::Zero();
    Vector3 area = Vector3::Zero(), before = Vector3::Zero();
    along(ring.ends,
          [&](std::size_t k, double count, bool is_first)
          {
              const Vector3 edge = arm(rest, vertex, ring.others[k]);
              moments += count * edge * edge.transpose();
              if (!is_first)
                  area += before.cross(edge);
              before = edge;
          });
    const double squares = moments.trace();
    if (area.norm() > no_area * squares)
    {
        ring.normal = area.normalized();
        ring.normal_weight = 0.5 * squares;
        moments += ring.normal_weight * ring.normal * ring.normal.transpose();
    }
    if (moments.determinant() > no_area * no_area * squares * squares * squares)
        ring.inverse_moments = moments.inverse();
    return ring;
}

LocalRotations LocalRotationMeter::measure(const Points& deformed, const Points& references) const
{
    LocalRotations result{matrices(deformed, references), references};
    const auto count = static_cast<Eigen::Index>(rings_.size());
    parallel_ranges(count, microsecond_items,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        for (Eigen::Index k = begin; k < end; ++k)
                        {
                            const Vector3 log = references.row(k).transpose();
                            if (result.matrices[k] != rotation_from_log(log))
                                result.logs.row(k) = log_near(result.matrices[k], log).transpose();
                        }
                    });
    return result;
}

std::vector<Matrix3> LocalRotationMeter::matrices(const Points& deformed,
                                                  const Points& references) const
{
    const auto count = static_cast<Eigen::Index>(rings_.size());
    if (deformed.rows() != vertex_count_ || references.rows() != count)
        throw InvalidInput(
            "measuring rotations needs a position for every vertex of the mesh and a "
            "reference for every measured vertex");
    std::vector<Matrix3> found(rings_.size());
    parallel_ranges(count, microsecond_items,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        for (Eigen::Index k = begin; k < end; ++k)
                            found[k] = ring_rotation(
                                rings_[k], deformed,
                                rotation_from_log(Vector3(references.row(k).transpose())));
                    });
    return found;
}

VertexIds LocalRotationMeter::reads() const
{
    VertexIds vertices;
    for (const Ring& ring : rings_)
    {
        vertices.push_back(ring.vertex);
        vertices.insert(vertices.end(), ring.others.begin(), ring.others.end());
    }
    make_set(vertices);
    return vertices;
}

// The map is reference + (what the reference leaves unexplained), so that nothing left gives the
// reference itself, bit for bit.
Matrix3 LocalRotationMeter::ring_rotation(const Ring& ring, const Points& deformed,
                                          const Matrix3& reference) const
{
    Matrix3 unexplained = Matrix3::Zero();
    Vector3 area = Vector3::Zero(), before = Vector3::Zero();
    along(ring.ends,
          [&](std::size_t k, double count, bool is_first)
          {
              const Vector3 edge = rest_arm(ring, k);
              const Vector3 now = arm(deformed, ring.vertex, ring.others[k]);
              const Vector3 left = count * (now - reference * edge);
              unexplained += left * edge.transpose();
              if (!is_first)
                  area += before.cross(now);
              before = now;
          });
    if (unexplained.isZero(0.0) || ring.inverse_moments.isZero(0.0))
        return reference;
    if (ring.normal_weight > 0.0 && area.norm() > 0.0)
        unexplained += ring.normal_weight * (area.normalized() - reference * ring.normal)
                       * ring.normal.transpose();
    return polar_rotation(reference + unexplained * ring.inverse_moments);
}

Vector3 LocalRotationMeter::rest_arm(const Ring& ring, std::size_t k) const
{
    return ring.rows.empty() ? arm(rest_, ring.vertex, ring.others[k])
                             : arm(rest_, ring.rows.front(), ring.rows[k + 1]);
}

Points LocalRotationMeter::spins(const Points& deformed, const LocalRotations& measured,
                                 const Points& rates, const Points& reference_spins) const
{
    Points found = reference_spins;
    for (std::size_t k = 0; k < rings_.size(); ++k)
        if (!rings_[k].inverse_moments.isZero(0.0))
            found.row(static_cast<Eigen::Index>(k)) =
                ring_spin(rings_[k], deformed, measured.matrices[k], rates).transpose();
    return found;
}

// The map of a ring is (sum of its edges' images + that of its normal) times what its moments are
// at rest; the reference it is told about drops out.
Vector3 LocalRotationMeter::ring_spin(const Ring& ring, const Points& deformed,
                                      const Matrix3& rotation, const Points& rates) const
{
    Matrix3 images = Matrix3::Zero(), change = Matrix3::Zero();
    Vector3 area = Vector3::Zero(), before = area, area_rate = area, rate_before = area;
    along(ring.ends,
          [&](std::size_t k, double count, bool is_first)
          {
              const Vector3 edge = rest_arm(ring, k);
              const Vector3 now = arm(deformed, ring.vertex, ring.others[k]);
              const Vector3 rate = arm(rates, ring.vertex, ring.others[k]);
              images += count * now * edge.transpose();
              change += count * rate * edge.transpose();
              if (!is_first)
              {
                  area += before.cross(now);
                  area_rate += rate_before.cross(now) + before.cross(rate);
              }
              before = now;
              rate_before = rate;
          });
    if (ring.normal_weight > 0.0 && area.norm() > 0.0)
    {
        const Vector3 normal = area.normalized();
        const Vector3 tilting = (area_rate - normal * normal.dot(area_rate)) / area.norm();
        images += ring.normal_weight * normal * ring.normal.transpose();
        change += ring.normal_weight * tilting * ring.normal.transpose();
    }
    return spin_of_polar(rotation, images * ring.inverse_moments, change * ring.inverse_moments);
}

RigidMotion mean_motion(const Points& rest, const Points& deformed, const LocalRotations& turned,
                        const Eigen::VectorXd& weights)
{
    const Eigen::Index count = rest.rows();
    if (count == 0 || deformed.rows() != count || turned.logs.rows() != count
        || static_cast<Eigen::Index>(turned.matrices.size()) != count
        || (weights.size() != 0 && weights.size() != count))
        throw InvalidInput(
            "the motion of a region needs as many positions, rotations and weights "
            "as it has vertices, and at least one");
    const Eigen::VectorXd share = shares(weights, count);
    const Vector3 log = (share.transpose() * turned.logs).transpose();
    Vector3 tilt = Vector3::Zero();
    for (Eigen::Index k = 0; k < count; ++k)
        tilt += share(k) * tilt_beyond(turned.matrices[k], turned.logs.row(k).transpose());
    RigidMotion motion;
    motion.rotation_log =
        tilt.isZero(0.0) ? log : nearest_branch(log_from_rotation(tilted_rotation(log, tilt)), log);
    motion.pivot = (share.transpose() * rest).transpose();
    motion.translation = (share.transpose() * (deformed - rest)).transpose();
    return motion;
}

MotionRate mean_motion_rate(const RigidMotion& mean, const Points& rates, const Points& log_rates,
                            const Eigen::VectorXd& weights)
{
    const Eigen::VectorXd share = shares(weights, rates.rows());
    MotionRate rate;
    rate.shift = (share.transpose() * rates).transpose();
    rate.log = (share.transpose() * log_rates).transpose();
    rate.spin = spin_of_log(mean.rotation_log, rate.log);
    return rate;
}

}  // namespace sheetmorph
