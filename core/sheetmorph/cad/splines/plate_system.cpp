// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/plate_system.h"
#include "sheetmorph/base/errors.h"

namespace sheetmorph::cad
{

namespace
{

constexpr int reach = GridMatrix::reach, across = GridMatrix::across;

}  // namespace

PlateSystem::PlateSystem(int u_count, int v_count)
    : right_(Eigen::MatrixXd::Zero(u_count * v_count, 3))
{
    matrix_.rows = u_count;
    matrix_.columns = v_count;
    matrix_.products.assign(static_cast<std::size_t>(u_count * v_count) * across * across, 0.0);
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
        const int pole = (u.first + i) * matrix_.columns + v.first + j;
        right_.row(pole) += one * value.transpose();
        double* products =
            matrix_.products.data() + static_cast<std::ptrdiff_t>(pole) * across * across;
        for (int k = 0; k < 4; ++k)
            for (int l = 0; l < 4; ++l)
                products[(k - i + reach) * across + l - j + reach] +=
                    one * u.weights[static_cast<std::size_t>(k)]
                    * v.weights[static_cast<std::size_t>(l)];
    }
}

void PlateSystem::add_energy(const Band& u, const Band& v, double weight)
{
    double* products = matrix_.products.data();
    for (const auto& in_u : u)
        for (const auto& in_v : v)
            for (const double one : in_u)
                for (const double other : in_v)
                    *products++ += weight * one * other;
}

void PlateSystem::tie(const std::array<CubicBasis::Row, 2>& low,
                      const std::array<CubicBasis::Row, 2>& high, int direction, double weight)
{
    matrix_.is_tied[static_cast<std::size_t>(direction)] = true;
    std::vector<std::pair<int, double>> entries;
    for (const auto* side : {&low, &high})
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
            {
                const double product = (*side)[0].weights[i] * (*side)[1].weights[j];
                const int pole = ((*side)[0].first + static_cast<int>(i)) * matrix_.columns
                                 + (*side)[1].first + static_cast<int>(j);
                if (product != 0.0)
                    entries.emplace_back(pole, side == &low ? product : -product);
            }
    for (const auto& [row, a] : entries)
        for (const auto& [column, b] : entries)
            if (row >= column)
                matrix_.ties.emplace_back(row, column, weight * a * b);
}

Eigen::MatrixXd PlateSystem::solution() const
{
    constexpr int refinements = 2;  // chosen: they remove the error of a shift
    // Poles that are hardly determined may have no pivot next to well-determined ones. Chosen:
    // shifts from none to 1e-8 of the largest entry, each a thousand times the one before.
    for (const double share : {0.0, 1e-14, 1e-11, 1e-8})
    {
        const GridCholesky factors(matrix_, share * matrix_.largest());
        if (!factors.is_definite())
            continue;
        Eigen::MatrixXd found = factors.solve(right_);
        for (int i = 0; i < refinements; ++i)
            found += factors.solve(right_ - matrix_.times(found));
        return found;
    }
    throw SolverError("a surface cannot be fitted", "mesh the part finer");
}

}  // namespace sheetmorph::cad
