// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/local_rotations.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/rotations/rotation_batch.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/base/vertex_sets.h"

#include <Eigen/Dense>
#include <algorithm>
#include <iterator>
#include <utility>

namespace sheetmorph::volume
{

namespace
{

// Area of a ring over the sum of its squared edges. Chosen far above the rounding of an area
// (1e-16) and far below a needle with a height of 1e-5 of its length.
constexpr double no_area = 1e-10;

Vector3 arm(const Points& points, int from, int to)
{
    return (points.row(to) - points.row(from)).transpose();
}

// Reverses the triangles of one ring that are oriented against the first ones. Otherwise the
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

// The sides opposite to a vertex, two ends each, joined to chains that are as long as possible.
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

// The two other corners of every triangle around a vertex.
std::vector<int> ring_of(const mesh::PartGeometry& part, int vertex)
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

// Weights with the sum 1; equal weights if none are given.
Eigen::VectorXd shares(const Eigen::VectorXd& weights, Eigen::Index count)
{
    const bool is_weighted = weights.size() == count && weights.sum() > 0.0;
    const Eigen::VectorXd share =
        is_weighted ? weights : Eigen::VectorXd(Eigen::VectorXd::Ones(count));
    return share / share.sum();
}

// Computes the moments of the last ring of a batch.
void set_moments(RingBatch& batch, Matrix3 moments, const Vector3& area)
{
    const auto lane = at(batch.rings - 1);
    const double squares = moments.trace();
    if (area.norm() > no_area * squares)
    {
        const Vector3 normal = area.normalized();
        batch.normal_weight[lane] = 0.5 * squares;
        moments += batch.normal_weight[lane] * normal * normal.transpose();
        for (int axis = 0; axis < 3; ++axis)
            batch.normal[axis][lane] = normal(axis);
    }
    if (!(moments.determinant() > no_area * no_area * squares * squares * squares))
        return;
    const Matrix3 inverse = moments.inverse();
    constexpr int rows[6] = {0, 1, 2, 0, 0, 1}, columns[6] = {0, 1, 2, 1, 2, 2};
    for (int entry = 0; entry < 6; ++entry)
        batch.inverse[entry][lane] = inverse(rows[entry], columns[entry]);
}

}  // namespace

LocalRotationMeter::LocalRotationMeter(const mesh::TriangleMesh& rest, const VertexIds& vertices)
    : LocalRotationMeter(mesh::PartGeometry(rest), vertices)
{
}

LocalRotationMeter::LocalRotationMeter(const mesh::PartGeometry& rest, const VertexIds& vertices)
    : vertex_count_(rest.mesh().vertex_count())
{
    std::vector<int> missing;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(missing),
                 [&](int v) { return v < 0 || v >= vertex_count_; });
    if (!missing.empty())
        throw InvalidInput("vertices that the mesh does not have: " + list_ids(missing));
    for (const int vertex : vertices)
        add_ring(rest.mesh().points(), vertex, ring_of(rest, vertex));
    make_compact(rest.mesh().points());
    needs_references_ = !without_ring().empty();
}

// Returns the batch with room for another ring: the last one, or a new one.
RingBatch& LocalRotationMeter::open_batch(int vertex, std::size_t spokes)
{
    if (count_++ % RingBatch::lanes == 0)
    {
        batches_.emplace_back();
        batches_.back().first = spokes_.size();
        std::fill_n(batches_.back().vertex, RingBatch::lanes, vertex);
    }
    RingBatch& batch = batches_.back();
    const int lane = batch.rings++;
    batch.vertex[lane] = vertex;
    for (; at(batch.count) < spokes; ++batch.count)
    {
        spokes_.emplace_back();
        std::copy_n(batch.vertex, RingBatch::lanes, spokes_.back().other);
    }
    for (std::size_t k = batch.first; k < spokes_.size(); ++k)
        spokes_[k].other[lane] = vertex;
    return batch;
}

// The first and last spoke of a chain have one triangle, the others two.
void LocalRotationMeter::add_ring(const Points& rest, int vertex, std::vector<int> sides)
{
    std::vector<int> ends;
    const std::vector<int> others = chained(same_sided(rest, vertex, std::move(sides)), ends);
    RingBatch& batch = open_batch(vertex, others.size());
    const auto lane = at(batch.rings - 1);
    Matrix3 moments = Matrix3::Zero();
    Vector3 area = Vector3::Zero(), before = Vector3::Zero();
    std::size_t k = 0;
    for (const int end : ends)
        for (const std::size_t first = k; k < at(end); ++k)
        {
            RingSpokes& spoke = spokes_[batch.first + k];
            spoke.other[lane] = others[k];
            spoke.triangles[lane] = k == first || k + 1 == at(end) ? 1 : 2;
            spoke.is_next[lane] = k == first ? 0 : 1;
            const Vector3 edge = arm(rest, vertex, others[k]);
            moments += spoke.triangles[lane] * edge * edge.transpose();
            area += spoke.is_next[lane] * before.cross(edge);
            before = edge;
        }
    set_moments(batch, moments, area);
}

// A contact measures few vertices of a large part, so rings refer to the vertices they read.
void LocalRotationMeter::make_compact(const Points& rest)
{
    for (const RingBatch& batch : batches_)
        reads_.insert(reads_.end(), batch.vertex, batch.vertex + RingBatch::lanes);
    for (const RingSpokes& spoke : spokes_)
        reads_.insert(reads_.end(), spoke.other, spoke.other + RingBatch::lanes);
    make_set(reads_);
    rest_ = rest(reads_, Eigen::indexing::all);
    std::vector<int> row(at(vertex_count_), 0);
    for (std::size_t k = 0; k < reads_.size(); ++k)
        row[at(reads_[k])] = static_cast<int>(k);
    for (RingBatch& batch : batches_)
        for (int& vertex : batch.vertex)
            vertex = row[at(vertex)];
    for (RingSpokes& spoke : spokes_)
        for (int& other : spoke.other)
            other = row[at(other)];
}

bool LocalRotationMeter::tells(std::size_t ring) const
{
    const RingBatch& batch = batches_[ring / RingBatch::lanes];
    return batch.inverse[0][ring % RingBatch::lanes] > 0.0;
}

Points LocalRotationMeter::of_reads(const Points& points) const
{
    return points(reads_, Eigen::indexing::all);
}

void LocalRotationMeter::require_rows(const Points& deformed, const Points& references,
                                      std::size_t wanted) const
{
    if (deformed.rows() != vertex_count_ || at(references.rows()) < wanted)
        throw InvalidInput(
            "measuring rotations needs a position for every vertex of the mesh and a "
            "reference for every measured vertex");
}

LocalRotations LocalRotationMeter::measure(const Points& deformed, const Points& references) const
{
    require_rows(deformed, references, count_);
    const std::vector<Matrix3> before = rotations_from_logs(references);
    LocalRotations result{before, references, Points(0, 3)};
    turn(deformed, result.matrices);
    NearLogs found = logs_near(result.matrices, references);
    for (std::size_t k = 0; k < count_; ++k)
        if (const auto row = static_cast<Eigen::Index>(k); result.matrices[k] != before[k])
            result.logs.row(row) = found.logs.row(row);
        else if (found.tilts.rows() != 0)
            found.tilts.row(row).setZero();
    result.tilts = std::move(found.tilts);
    return result;
}

std::vector<Matrix3> LocalRotationMeter::matrices(const Points& deformed,
                                                  const Points& references) const
{
    require_rows(deformed, references, needs_references_ ? count_ : 0);
    std::vector<Matrix3> found(count_, Matrix3::Identity());
    for (std::size_t k = 0; k < count_ && needs_references_; ++k)
        if (!tells(k))
            found[k] = rotation_from_log(
                Vector3(references.row(static_cast<Eigen::Index>(k)).transpose()));
    turn(deformed, found);
    return found;
}

VertexIds LocalRotationMeter::without_ring() const
{
    VertexIds vertices;
    for (std::size_t k = 0; k < count_; ++k)
        if (!tells(k))
            vertices.push_back(
                reads_[at(batches_[k / RingBatch::lanes].vertex[k % RingBatch::lanes])]);
    return vertices;
}

// Replaces every reference that its ring does not explain by the rotation of the ring.
void LocalRotationMeter::turn(const Points& deformed, std::vector<Matrix3>& references) const
{
    const bool is_whole = static_cast<Eigen::Index>(reads_.size()) == deformed.rows();
    const Points some = is_whole ? Points() : of_reads(deformed);
    const Points& now = is_whole ? deformed : some;
    const auto turn_some = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (std::size_t k = at(begin); k < at(end); ++k)
            turn_rings(batches_[k], spokes_, {rest_, now},
                       references.data() + k * RingBatch::lanes);
    };
    parallel_ranges(static_cast<Eigen::Index>(batches_.size()), microsecond_items, turn_some);
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
    const Vector3 tilt = turned.tilts.rows() == 0
                             ? Vector3(Vector3::Zero())
                             : Vector3((share.transpose() * turned.tilts).transpose());
    RigidMotion motion;
    motion.rotation_log =
        tilt.isZero(0.0) ? log : nearest_branch(log_from_rotation(tilted_rotation(log, tilt)), log);
    motion.pivot = (share.transpose() * rest).transpose();
    motion.translation = (share.transpose() * (deformed - rest)).transpose();
    return motion;
}

}  // namespace sheetmorph::volume
