// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/refinement.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/vertex_sets.h"

namespace sheetmorph
{

namespace
{

constexpr int most_rounds = 400;
constexpr double settled = 1e-7;  // of the size: a round that changes less is the last
constexpr double stretch_against_bending = 100.0;

// The vertices of triangles: nodes of none must not change how strong stretching is.
VertexIds corners_of(const TriangleMesh& mesh)
{
    VertexIds corners(mesh.triangles().data(), mesh.triangles().data() + mesh.triangles().size());
    make_set(corners);
    return corners;
}

// Weights of rows count areas; unweighted rows (`paper`) one each.
double per_area(const RotationFieldInput& input, std::size_t vertices)
{
    return input.constraints.energy == Energy::paper
               ? static_cast<double>(vertices) / input.operators.vertex_areas.sum()
               : 1.0;
}

}  // namespace

Refinement::Refinement(const RotationFieldInput& input, const QuadraticProblem& problem)
    : mesh_(input.mesh), operators_(input.operators)
{
    const VertexIds corners = corners_of(input.mesh);
    const Points used = input.mesh.points()(corners, Eigen::indexing::all);
    size_ = (used.colwise().maxCoeff() - used.colwise().minCoeff()).norm();
    const double strength =
        stretch_against_bending / (size_ * size_) * per_area(input, corners.size());
    const SparseMatrix& stiffness = *input.operators.harmonic;
    for (Eigen::Index column = 0; column < stiffness.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(stiffness, column); entry; ++entry)
            if (entry.row() < column && entry.value() < 0.0)
                edges_.push_back({static_cast<int>(entry.row()), static_cast<int>(column),
                                  -strength * entry.value()});
    const Eigen::Index rows = problem.rows.rows();
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index column = 0; column < problem.rows.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(problem.rows, column); entry; ++entry)
            entries.emplace_back(entry.row(), entry.col(), entry.value());
    QuadraticProblem stretched = problem;
    stretched.stiffness = nullptr;
    stretched.weights.conservativeResize(rows + static_cast<Eigen::Index>(edges_.size()));
    for (std::size_t k = 0; k < edges_.size(); ++k)
    {
        const Eigen::Index row = rows + static_cast<Eigen::Index>(k);
        entries.emplace_back(row, edges_[k].a, 1.0);
        entries.emplace_back(row, edges_[k].b, -1.0);
        stretched.weights(row) = edges_[k].weight;
    }
    stretched.rows.resize(stretched.weights.size(), problem.rows.cols());
    stretched.rows.setFromTriplets(entries.begin(), entries.end());
    minimiser_ = std::make_unique<ConstrainedMinimiser>(std::move(stretched));
}

std::vector<Matrix3> Refinement::fitted_changes(const Points& positions) const
{
    std::vector<Matrix3> fits(at(mesh_.vertex_count()), Matrix3::Zero());
    for (const Edge& edge : edges_)
    {
        const Vector3 now = (positions.row(edge.a) - positions.row(edge.b)).transpose();
        const Vector3 rest = (mesh_.points().row(edge.a) - mesh_.points().row(edge.b)).transpose();
        const Matrix3 fit = 0.5 * edge.weight * now * rest.transpose();
        fits[at(edge.a)] += fit;
        fits[at(edge.b)] += fit;
    }
    const Eigen::MatrixXd rows = operators_.rows * positions;
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
        fits[at(operators_.row_vertices[at(row)])] +=
            operators_.weights(row) * rows.row(row).transpose() * operators_.rest_rows.row(row);
    for (Matrix3& fit : fits)
        if (!fit.isZero(0.0))
            fit = nearest_rotation(fit) - Matrix3::Identity();
    return fits;
}

// What the rows of bending and stretch gain by rotations, as displacements ask for it.
Eigen::MatrixXd Refinement::turned(const std::vector<Matrix3>& changes) const
{
    const Eigen::Index rows = operators_.rest_rows.rows();
    Eigen::MatrixXd wanted(rows + static_cast<Eigen::Index>(edges_.size()), 3);
    wanted.topRows(rows) = turned_rows(operators_, changes);
    for (std::size_t k = 0; k < edges_.size(); ++k)
    {
        const Edge& edge = edges_[k];
        const Matrix3 mean = 0.5 * (changes[at(edge.a)] + changes[at(edge.b)]);
        const Vector3 rest = (mesh_.points().row(edge.a) - mesh_.points().row(edge.b)).transpose();
        wanted.row(rows + static_cast<Eigen::Index>(k)) = (mean * rest).transpose();
    }
    return wanted;
}

Convergence Refinement::refine(const ConstrainedMinimiser::Targets& asked, Eigen::MatrixXd& u) const
{
    ConstrainedMinimiser::Targets problem = asked;
    Convergence found{"refined rotations", false, 0, 0.0};
    for (; found.rounds < most_rounds && !found.is_converged; ++found.rounds)
    {
        problem.rows = turned(fitted_changes(mesh_.points() + u));
        Eigen::MatrixXd next = minimiser_->solve(problem, 1);
        found.miss = (next - u).rowwise().norm().maxCoeff();
        found.is_converged = found.miss <= settled * size_;
        u = std::move(next);
    }
    return found;
}

}  // namespace sheetmorph
