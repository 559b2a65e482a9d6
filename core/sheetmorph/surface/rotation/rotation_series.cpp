// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/rotation/rotation_series.h"

#include "sheetmorph/base/rotation.h"

#include <Eigen/QR>
#include <cmath>

namespace sheetmorph
{

namespace
{

// Chebyshev nodes in [0, 1], the ends included.
Eigen::VectorXd nodes(int count)
{
    return Eigen::VectorXd::NullaryExpr(
        count, [count](Eigen::Index k) { return 0.5 - 0.5 * std::cos(M_PI * k / (count - 1)); });
}

// Where the weights can lie: an interval; for two, a triangle if they are
// blends, else a box.
Eigen::MatrixXd sample_weights(const Eigen::MatrixXd& weights, const Eigen::RowVectorXd& lowest,
                               const Eigen::RowVectorXd& highest)
{
    const Eigen::RowVectorXd extent = highest - lowest;
    if (weights.cols() == 1)
        return (nodes(33) * extent).rowwise() + lowest;
    const bool is_blend = lowest.minCoeff() >= 0.0 && weights.rowwise().sum().maxCoeff() < 1.0001;
    const Eigen::VectorXd along = nodes(15);
    Eigen::MatrixXd samples(along.size() * along.size(), 2);
    for (Eigen::Index k = 0; k < samples.rows(); ++k)
    {
        const double x = along(k / along.size()), y = along(k % along.size());
        samples.row(k) << x, is_blend ? (1.0 - x) * y : y;
    }
    return (samples * extent.asDiagonal()).rowwise() + lowest;
}

}  // namespace

RotationSeries::RotationSeries(const Eigen::MatrixXd& weights, int degree)
    : degree_(degree),
      lowest_(weights.colwise().minCoeff().cwiseMin(0.0)),
      highest_(weights.colwise().maxCoeff().cwiseMax(1.0))
{
    samples_ = sample_weights(weights, lowest_, highest_);
    const Eigen::MatrixXd raw = raw_values(samples_);
    const Eigen::HouseholderQR<Eigen::MatrixXd> factors(raw);
    const Eigen::MatrixXd upper =
        factors.matrixQR().topRows(raw.cols()).triangularView<Eigen::Upper>();
    transform_ = upper.triangularView<Eigen::Upper>().solve(
        std::sqrt(static_cast<double>(raw.rows()))
        * Eigen::MatrixXd::Identity(raw.cols(), raw.cols()));
    at_samples_ = raw * transform_;
}

// Products of Chebyshev polynomials up to the degree, each less its value at w
// = 0.
Eigen::MatrixXd RotationSeries::raw_values(const Eigen::MatrixXd& weights) const
{
    const Eigen::Index handles = weights.cols();
    std::vector<Eigen::MatrixXd> single;
    for (Eigen::Index s = 0; s < handles; ++s)
    {
        // The last row is at w = 0.
        Eigen::VectorXd x(weights.rows() + 1);
        x << weights.col(s), 0.0;
        x = (2.0 * x.array() - lowest_(s) - highest_(s)) / (highest_(s) - lowest_(s));
        Eigen::MatrixXd chebyshev(x.size(), degree_ + 1);
        chebyshev.col(0).setOnes();
        chebyshev.col(1) = x;
        for (int k = 2; k <= degree_; ++k)
            chebyshev.col(k) = 2.0 * x.cwiseProduct(chebyshev.col(k - 1)) - chebyshev.col(k - 2);
        single.push_back(std::move(chebyshev));
    }
    std::vector<Eigen::VectorXd> products;
    for (int total = 1; total <= degree_; ++total)
        for (int a = total; a >= (handles == 1 ? total : 0); --a)
            products.push_back(handles == 1
                                   ? Eigen::VectorXd(single[0].col(a))
                                   : single[0].col(a).cwiseProduct(single[1].col(total - a)));
    Eigen::MatrixXd values(weights.rows(), static_cast<Eigen::Index>(products.size()));
    for (std::size_t k = 0; k < products.size(); ++k)
        values.col(static_cast<Eigen::Index>(k)) =
            products[k].head(weights.rows()).array() - products[k](weights.rows());
    return values;
}

Eigen::MatrixXd RotationSeries::values(const Eigen::MatrixXd& weights) const
{
    return raw_values(weights) * transform_;
}

Eigen::VectorXd RotationSeries::reach() const
{
    constexpr double least = 1e-3;
    const Vector3 axes[] = {Vector3::UnitX(), Vector3::UnitY(), Vector3(1.0, 1.0, 1.0) / sqrt(3.0)};
    Eigen::VectorXd largest = Eigen::VectorXd::Constant(count(), least);
    const auto add = [&](const std::vector<Vector3>& logs)
    {
        const std::vector<Matrix3> matrices = fit(logs).matrices;
        for (std::size_t k = 0; k < matrices.size(); ++k)
            largest(static_cast<Eigen::Index>(k)) =
                std::max(largest(static_cast<Eigen::Index>(k)), matrices[k].cwiseAbs().maxCoeff());
    };
    for (double angle = 0.5; angle < 3.1; angle += 0.5)
        for (const Vector3& axis : axes)
        {
            if (lowest_.size() == 1)
                add({angle * axis});
            else
                for (const double other : {-3.0, -1.5, 0.0, 1.5, 3.0})
                    add({angle * Vector3::UnitZ(), other * axis});
        }
    return largest;
}

RotationSeries::Fit RotationSeries::fit(const std::vector<Vector3>& logs) const
{
    Eigen::MatrixXd turned(samples_.rows(), 9);
    for (Eigen::Index k = 0; k < samples_.rows(); ++k)
    {
        Vector3 log = Vector3::Zero();
        for (std::size_t s = 0; s < logs.size(); ++s)
            log += samples_(k, static_cast<Eigen::Index>(s)) * logs[s];
        const Matrix3 change = rotation_from_log(log) - Matrix3::Identity();
        turned.row(k) = Eigen::Map<const Eigen::RowVectorXd>(change.data(), 9);
    }
    const Eigen::MatrixXd coefficients =
        at_samples_.transpose() * turned / static_cast<double>(samples_.rows());
    Fit fit{{}, (at_samples_ * coefficients - turned).cwiseAbs().maxCoeff()};
    for (Eigen::Index k = 0; k < coefficients.rows(); ++k)
    {
        const Eigen::RowVectorXd entries = coefficients.row(k);
        fit.matrices.emplace_back(Eigen::Map<const Matrix3>(entries.data()));
    }
    return fit;
}

}  // namespace sheetmorph
