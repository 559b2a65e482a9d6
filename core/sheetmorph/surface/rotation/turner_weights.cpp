// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/rotation/turner_weights.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/operators/shared_unknowns.h"
#include "sheetmorph/surface/operators/ties.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

constexpr int none = -1;
constexpr std::size_t together = 48;  // turners whose weights are solved at once

// Which turner a vertex turns wholly with.
std::vector<int> owners(int vertex_count, const std::vector<Turner>& turners)
{
    std::vector<int> owner(at(vertex_count), none);
    for (std::size_t k = 0; k < turners.size(); ++k)
        if (turners[k].turns)
            for (const int vertex : turners[k].vertices)
                owner[at(vertex)] = static_cast<int>(k);
    return owner;
}

bool is_told_by_point(const RotationFieldInput& input, int vertex)
{
    const std::vector<PointConstraint>& points = input.constraints.points;
    return std::any_of(
        points.begin(), points.end(),
        [&](const PointConstraint& point)
        {
            return point.is_turned
                   && (input.mesh.triangles().row(point.triangle).array() == vertex).any();
        });
}

// Vertices between turners and known rotations, in components that have a turner.
Unknowns open_vertices(const RotationFieldInput& input, const std::vector<int>& owner)
{
    const std::vector<int>& label = input.roles.components.label;
    std::vector<char> has_turner(at(input.roles.components.count), 0);
    for (std::size_t i = 0; i < owner.size(); ++i)
        if (owner[i] != none && label[i] >= 0)
            has_turner[at(label[i])] = 1;
    SharedUnknowns unknowns(input.roles);
    for (int i = 0; i < input.mesh.vertex_count(); ++i)
        unknowns.add(input.roles.role[at(i)] == Role::free && owner[at(i)] == none
                     && label[at(i)] >= 0 && has_turner[at(label[at(i)])]
                     && !is_told_by_point(input, i));
    return unknowns.found();
}

double smoothed(double weight)
{
    constexpr double faded = 1e-3;
    const double w = std::clamp((weight - faded) / (1.0 - faded), 0.0, 1.0);
    return w * w * (3.0 - 2.0 * w);
}

// What the own vertices of some turners pull on the open ones (unknowns, count).
Eigen::MatrixXd pull_of_turners(const SparseMatrix& harmonic, const Unknowns& unknowns,
                                const VertexIds* owned, Eigen::Index count)
{
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(unknowns.count, count);
    for (Eigen::Index k = 0; k < count; ++k)
        for (const int vertex : owned[k])
            for (SparseMatrix::InnerIterator entry(harmonic, vertex); entry; ++entry)
                if (const int unknown = unknowns.of_vertex[at(entry.row())];
                    unknown != Unknowns::known)
                    pull(unknown, k) += entry.value();
    return pull;
}

//! The weights that are some, before they are a partition of unity.
struct Shares
{
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd given;  // by vertex: all of them, not yet smoothed

    void add(int vertex, std::size_t turner, double weight)
    {
        given(vertex) += weight;
        if (const double share = smoothed(weight); share > 0.0)
            entries.emplace_back(vertex, static_cast<int>(turner), share);
    }

    // What the field is left with takes part.
    SparseMatrix normalised(Eigen::Index turners) const
    {
        Eigen::VectorXd sums = given.unaryExpr([](double all) { return smoothed(1.0 - all); });
        for (const Eigen::Triplet<double>& entry : entries)
            sums(entry.row()) += entry.value();
        SparseMatrix weights(given.size(), turners);
        weights.setFromTriplets(entries.begin(), entries.end());
        for (Eigen::Index k = 0; k < turners; ++k)
            for (SparseMatrix::InnerIterator entry(weights, k); entry; ++entry)
                entry.valueRef() /= sums(entry.row());
        return weights;
    }
};

// A few turners at a time: most weights are none.
void add_open(const RotationFieldInput& input, const Unknowns& unknowns,
              const std::vector<VertexIds>& owned, Shares& shares)
{
    const SurfaceOperators& operators = input.operators;
    const SparseCholesky factor(unknowns.merged(operators.harmonic), operators.harmonic_tree);
    for (std::size_t first = 0; first < owned.size(); first += together)
    {
        const std::size_t count = std::min(together, owned.size() - first);
        const Eigen::MatrixXd pulled = factor.solve(pull_of_turners(
            *operators.harmonic, unknowns, owned.data() + first, static_cast<Eigen::Index>(count)));
        for (int i = 0; i < input.mesh.vertex_count(); ++i)
            if (const int unknown = unknowns.of_vertex[at(i)]; unknown != Unknowns::known)
                for (std::size_t k = 0; k < count; ++k)
                    shares.add(i, first + k, -pulled(unknown, static_cast<Eigen::Index>(k)));
    }
}

}  // namespace

SparseMatrix turner_weights(const RotationFieldInput& input, const std::vector<Turner>& turners)
{
    const std::vector<int> owner = owners(input.mesh.vertex_count(), turners);
    std::vector<VertexIds> owned(turners.size());
    Shares shares{{}, Eigen::VectorXd::Zero(input.mesh.vertex_count())};
    for (std::size_t i = 0; i < owner.size(); ++i)
        if (owner[i] != none)
        {
            owned[at(owner[i])].push_back(static_cast<int>(i));
            shares.add(static_cast<int>(i), at(owner[i]), 1.0);
        }
    const Unknowns unknowns = open_vertices(input, owner);
    if (!turners.empty() && unknowns.count > 0)
        add_open(input, unknowns, owned, shares);
    SparseMatrix weights = shares.normalised(static_cast<Eigen::Index>(turners.size()));
    if (input.roles.ties.empty())
        return weights;
    return tie_basis(input.mesh.vertex_count(), input.roles.ties) * weights;
}

}  // namespace sheetmorph
