// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/rotation/turner_weights.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/operators/stitches.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

constexpr int none = -1;

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

// What the field is left with takes part in the partition of unity. Column by column, as they lie.
void smooth_and_renormalise(Eigen::MatrixXd& weights)
{
    Eigen::VectorXd sums = (1.0 - weights.rowwise().sum().array()).unaryExpr(&smoothed);
    for (Eigen::Index k = 0; k < weights.cols(); ++k)
    {
        weights.col(k) = weights.col(k).unaryExpr(&smoothed);
        sums += weights.col(k);
    }
    for (Eigen::Index k = 0; k < weights.cols(); ++k)
        weights.col(k).array() /= sums.array();
}

// What the turners' own vertices pull on the open ones (unknowns, turners).
Eigen::MatrixXd pull_of_turners(const SparseMatrix& harmonic, const Unknowns& unknowns,
                                const std::vector<int>& owner, Eigen::Index turners)
{
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(unknowns.count, turners);
    for (Eigen::Index i = 0; i < harmonic.cols(); ++i)
        if (owner[at(i)] != none)
            for (SparseMatrix::InnerIterator entry(harmonic, i); entry; ++entry)
                if (const int unknown = unknowns.of_vertex[at(entry.row())];
                    unknown != Unknowns::known)
                    pull(unknown, owner[at(i)]) += entry.value();
    return pull;
}

}  // namespace

SparseMatrix turner_weights(const RotationFieldInput& input, const std::vector<Turner>& turners)
{
    const std::vector<int> owner = owners(input.mesh.vertex_count(), turners);
    Eigen::MatrixXd weights =
        Eigen::MatrixXd::Zero(input.mesh.vertex_count(), static_cast<Eigen::Index>(turners.size()));
    for (std::size_t i = 0; i < owner.size(); ++i)
        if (owner[i] != none)
            weights(static_cast<Eigen::Index>(i), owner[i]) = 1.0;
    const Unknowns unknowns = open_vertices(input, owner);
    if (turners.empty() || unknowns.count == 0)
        return weights.sparseView();
    const SurfaceOperators& operators = input.operators;
    const SparseCholesky factor(unknowns.merged(operators.harmonic), operators.harmonic_tree);
    weights -=
        unknowns.basis()
        * factor.solve(pull_of_turners(*operators.harmonic, unknowns, owner, weights.cols()));
    smooth_and_renormalise(weights);
    return weights.sparseView();
}

}  // namespace sheetmorph
