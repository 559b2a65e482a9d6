// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/cubic_basis.h"

#include <Eigen/SparseLU>
#include <algorithm>

namespace sheetmorph::cad
{

namespace
{

constexpr int degree = 3;  // chosen: the lowest degree with continuous curvature

using Table = std::array<std::array<double, 4>, 4>;

// Piegl and Tiller, The NURBS Book, algorithm A2.2, with the differences of knots stored below the
// diagonal.
Table table_of(const std::vector<double>& knots, std::size_t span, double t)
{
    Table table{};
    std::array<double, 4> left{}, right{};
    table[0][0] = 1.0;
    for (std::size_t j = 1; j <= degree; ++j)
    {
        left[j] = t - knots[span + 1 - j];
        right[j] = knots[span + j] - t;
        double saved = 0.0;
        for (std::size_t r = 0; r < j; ++r)
        {
            table[j][r] = right[r + 1] + left[j - r];
            const double part = table[r][j - 1] / table[j][r];
            table[r][j] = saved + right[r + 1] * part;
            saved = left[j - r] * part;
        }
        table[j][j] = saved;
    }
    return table;
}

// The k-th derivative of the r-th spline (the same book, algorithm A2.3).
double derivative_of(const Table& table, int r, int order)
{
    std::array<std::array<double, 4>, 2> a{};
    a[0][0] = 1.0;
    std::size_t now = 0, next = 1;
    double found = 0.0;
    for (int k = 1; k <= order; ++k)
    {
        found = 0.0;
        const int rk = r - k, pk = degree - k;
        const auto at = [&](int row, int column)
        { return table[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]; };
        if (r >= k)
        {
            a[next][0] = a[now][0] / at(pk + 1, rk);
            found = a[next][0] * at(rk, pk);
        }
        const int from = rk >= -1 ? 1 : -rk, to = r - 1 <= pk ? k - 1 : degree - r;
        for (int j = from; j <= to; ++j)
        {
            const auto i = static_cast<std::size_t>(j);
            a[next][i] = (a[now][i] - a[now][i - 1]) / at(pk + 1, rk + j);
            found += a[next][i] * at(rk + j, pk);
        }
        if (r <= pk)
        {
            const auto i = static_cast<std::size_t>(k);
            a[next][i] = -a[now][i - 1] / at(pk + 1, r);
            found += a[next][i] * at(r, pk);
        }
        std::swap(now, next);
    }
    return found;
}

}  // namespace

CubicBasis::CubicBasis(double low, double high, const std::vector<Break>& inner)
    : knots_(4, low), ends_{low}
{
    for (const Break& one : inner)
    {
        knots_.insert(knots_.end(), static_cast<std::size_t>(one.times), one.at);
        ends_.push_back(one.at);
    }
    knots_.insert(knots_.end(), 4, high);
    ends_.push_back(high);
}

int CubicBasis::span_of(double t) const
{
    const auto above = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, t);
    return static_cast<int>(above - ends_.begin()) - 1;
}

CubicBasis::Row CubicBasis::row(double t, int derivative) const
{
    const auto above = std::upper_bound(knots_.begin() + 4, knots_.end() - 4, t);
    const auto span = static_cast<std::size_t>(above - knots_.begin()) - 1;
    const Table table = table_of(knots_, span, t);
    Row found;
    found.first = static_cast<int>(span) - degree;
    for (std::size_t r = 0; r <= degree; ++r)
        found.weights[r] = table[r][degree];
    if (derivative == 0)
        return found;
    const double factor = derivative == 1 ? degree : degree * (degree - 1);
    for (int r = 0; r <= degree; ++r)
        found.weights[static_cast<std::size_t>(r)] = factor * derivative_of(table, r, derivative);
    return found;
}

std::vector<double> CubicBasis::greville() const
{
    std::vector<double> places;
    for (std::size_t i = 0; i + 4 < knots_.size(); ++i)
        places.push_back((knots_[i + 1] + knots_[i + 2] + knots_[i + 3]) / 3.0);
    places.front() = low();
    places.back() = high();
    return places;
}

Eigen::MatrixXd CubicBasis::through(const std::vector<double>& places,
                                    const Eigen::MatrixXd& values) const
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const Row here = row(places[i]);
        for (int k = 0; k < 4; ++k)
            entries.emplace_back(static_cast<int>(i), here.first + k,
                                 here.weights[static_cast<std::size_t>(k)]);
    }
    Eigen::SparseMatrix<double> matrix(count(), count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
    return solver.solve(values);
}

CubicBasis CubicBasis::halved(const std::vector<bool>& spans) const
{
    std::vector<Break> inner;
    for (std::size_t i = 0; i + 1 < ends_.size(); ++i)
    {
        if (i > 0)
            inner.push_back(
                {ends_[i], static_cast<int>(std::count(knots_.begin(), knots_.end(), ends_[i]))});
        if (spans[i])
            inner.push_back({0.5 * (ends_[i] + ends_[i + 1]), 1});
    }
    return {low(), high(), inner};
}

}  // namespace sheetmorph::cad
