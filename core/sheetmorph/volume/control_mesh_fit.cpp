// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/control_mesh_fit.h"

#include "sheetmorph/base/errors.h"

#include <utility>

namespace sheetmorph::volume
{

using numerics::Weights;

namespace
{

Weights weighted_rows(const Weights& sample_weights, const Eigen::VectorXd& areas)
{
    if (sample_weights.rows() == 0 || areas.size() != sample_weights.rows())
        throw InvalidInput("fitting a control mesh needs at least one sample, and one area each");
    if (!(areas.minCoeff() >= 0.0) || !(areas.sum() > 0.0))
        throw InvalidInput(
            "the areas of the samples of a control mesh must not be negative, and at "
            "least one must be positive");
    return (areas / areas.mean()).asDiagonal() * sample_weights;
}

Weights normal_matrix(const Weights& sample_weights, const Weights& weighted,
                      const Eigen::SparseMatrix<double>& laplacian, double smoothness)
{
    if (laplacian.rows() != sample_weights.cols() || laplacian.cols() != sample_weights.cols())
        throw InvalidInput("the weights of the samples belong to another control mesh");
    if (!(smoothness > 0.0))
        throw InvalidInput("the smoothness of a control mesh must be positive",
                           "the default is 0.05");
    const double share =
        static_cast<double>(sample_weights.rows()) / static_cast<double>(sample_weights.cols());
    const Eigen::SparseMatrix<double> square = laplacian.transpose() * laplacian;
    Weights matrix = Weights::Zero(square.rows(), square.cols());
    for (Eigen::Index column = 0; column < square.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(square, column); entry; ++entry)
            matrix(entry.row(), column) = smoothness * share * entry.value();
    const Weights left = weighted.transpose(), right = sample_weights.transpose();
    numerics::add_lower_product(left, right, 1.0, matrix);
    return matrix;
}

numerics::DenseCholesky factor_of(Weights matrix)
{
    try
    {
        return numerics::DenseCholesky(std::move(matrix));
    }
    catch (const SolverError&)
    {
        throw InvalidInput(
            "the source points do not determine the control mesh around them: they lie too close "
            "together or too far outside it, or the smoothness is too small");
    }
}

}  // namespace

ControlMeshFit::ControlMeshFit(const Weights& sample_weights, const Eigen::VectorXd& areas,
                               const Eigen::SparseMatrix<double>& laplacian, double smoothness)
    : weighted_(weighted_rows(sample_weights, areas)),
      factor_(factor_of(normal_matrix(sample_weights, weighted_, laplacian, smoothness)))
{
}

Points ControlMeshFit::displacements(const Points& sample_displacements) const
{
    return factor_.solve(Points(weighted_.transpose() * sample_displacements));
}

}  // namespace sheetmorph::volume
