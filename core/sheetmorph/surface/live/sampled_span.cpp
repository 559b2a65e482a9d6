// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/sampled_span.h"

namespace sheetmorph
{

namespace
{

constexpr double largest_miss = 1e-8;
constexpr Eigen::Index most_directions = 192;

}  // namespace

SampledSpan spanned(Eigen::MatrixXd columns)
{
    SampledSpan span;
    Eigen::MatrixXd& directions = span.directions;
    const Eigen::Index most = std::min({columns.rows(), columns.cols(), most_directions});
    directions.resize(columns.rows(), most);
    Eigen::MatrixXd shares(most, columns.cols());
    Eigen::Index count = 0, worst = 0;
    while (count < most && columns.cwiseAbs().colwise().maxCoeff().maxCoeff(&worst) > largest_miss)
    {
        Eigen::VectorXd direction = columns.col(worst);
        const auto earlier = directions.leftCols(count);
        direction -= earlier * (earlier.transpose() * direction).eval();
        direction.normalize();
        const Eigen::RowVectorXd share = direction.transpose() * columns;
        columns.noalias() -= direction * share;
        directions.col(count) = direction;
        shares.row(count++) = share;
        span.chosen.push_back(worst);
    }
    directions.conservativeResize(Eigen::NoChange, count);
    span.reach = shares.topRows(count).cwiseAbs().rowwise().maxCoeff();
    span.upper.resize(count, count);
    for (Eigen::Index k = 0; k < count; ++k)
        span.upper.col(k) = shares.col(span.chosen[static_cast<std::size_t>(k)]).head(count);
    return span;
}

}  // namespace sheetmorph
