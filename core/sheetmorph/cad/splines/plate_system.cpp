// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/plate_system.h"
#include "sheetmorph/base/errors.h"

#include <Eigen/SparseCholesky>

namespace sheetmorph
{

PlateSystem::PlateSystem(int u_count, int v_count)
    : u_count_(u_count),
      v_count_(v_count),
      products_(
          static_cast<std::size_t>(u_count) * static_cast<std::size_t>(v_count) * reach * reach,
          0.0),
      right_(Eigen::MatrixXd::Zero(u_count * v_count, 3))
{
}

void PlateSystem::add(const CubicBasis::Row& u, const CubicBasis::Row& v, const Vector3& value,
                      double weight)
{
    for (int a = 0; a < 16; ++a)
    {
        const int i = a / 4, j = a % 4;
        const double one = weight * u.weights[static_cast<std::size_t>(i)]
                           * v.weights[static_cast<std::size_t>(j)];
        if (one == 0.0)
            continue;
        const int pole = (u.first + i) * v_count_ + v.first + j;
        right_.row(pole) += one * value.transpose();
        double* products = products_.data() + static_cast<std::ptrdiff_t>(pole) * reach * reach;
        for (int k = 0; k < 4; ++k)
            for (int l = 0; l < 4; ++l)
                products[(k - i + 3) * reach + l - j + 3] +=
                    one * u.weights[static_cast<std::size_t>(k)]
                    * v.weights[static_cast<std::size_t>(l)];
    }
}

void PlateSystem::tie(const std::array<CubicBasis::Row, 2>& one,
                      const std::array<CubicBasis::Row, 2>& other, double weight)
{
    std::vector<std::pair<int, double>> entries;
    for (const auto* side : {&one, &other})
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
            {
                const double product = (*side)[0].weights[i] * (*side)[1].weights[j];
                const int pole = ((*side)[0].first + static_cast<int>(i)) * v_count_
                                 + (*side)[1].first + static_cast<int>(j);
                if (product != 0.0)
                    entries.emplace_back(pole, side == &one ? product : -product);
            }
    for (const auto& [row, a] : entries)
        for (const auto& [column, b] : entries)
            if (row >= column)
                others_.emplace_back(row, column, weight * a * b);
}

Eigen::MatrixXd PlateSystem::solution() const
{
    std::vector<Eigen::Triplet<double>> entries = others_;
    for (int pole = 0; pole < u_count_ * v_count_; ++pole)
        for (int k = 0; k < reach; ++k)
            for (int l = 0; l < reach; ++l)
            {
                const int other = pole + (k - 3) * v_count_ + l - 3;
                const double product =
                    products_[static_cast<std::size_t>((pole * reach + k) * reach + l)];
                if (product != 0.0 && other <= pole)
                    entries.emplace_back(pole, other, product);
            }
    Eigen::SparseMatrix<double> matrix(u_count_ * v_count_, u_count_ * v_count_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const double largest = Eigen::VectorXd(matrix.diagonal()).maxCoeff();
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver;
    // What is hardly known at all may have no pivot left beside what is known well.
    for (const double share : {0.0, 1e-14, 1e-11, 1e-8})
    {
        solver.setShift(share * largest);
        solver.compute(matrix);
        if (solver.info() == Eigen::Success)
            break;
    }
    if (solver.info() != Eigen::Success)
        throw SolverError("a surface cannot be fitted; mesh the part finer");
    constexpr int refinements = 2;
    Eigen::MatrixXd found = solver.solve(right_);
    for (int i = 0; i < refinements; ++i)
        found += solver.solve(right_ - matrix.selfadjointView<Eigen::Lower>() * found);
    return found;
}

}  // namespace sheetmorph
