// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/span.h"

#include "sheetmorph/base/index.h"

#include <Eigen/QR>
#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

// Largest entry of a column that the directions leave. From largest_miss of response.cpp, 4e-7:
// interpolation at selected rows may enlarge the error 20 times before it reaches that limit.
constexpr double largest_miss = 2e-8;

// Chosen, not measured: a frame multiplies 600 * 600 entries, estimated at 0.1 ms.
constexpr Eigen::Index most_directions = 600;

// A new pose needs another solve; a further column of a selected pose does not. Such a column is
// preferred if its error is above this share of the largest error. Chosen: a column with a fifth of
// the largest error brings most of what a new one would.
constexpr double worth_taking = 0.2;
constexpr Eigen::Index columns_a_pose = 3;

// The column to select next.
Eigen::Index next_column(const Eigen::RowVectorXd& misses, const std::vector<Eigen::Index>& chosen)
{
    Eigen::Index worst = 0;
    const double least = worth_taking * misses.maxCoeff(&worst);
    for (const Eigen::Index taken : chosen)
    {
        const Eigen::Index first = taken - taken % columns_a_pose;
        for (Eigen::Index k = first; k < std::min(first + columns_a_pose, misses.size()); ++k)
            if (misses(k) > least)
                return k;
    }
    return worst;
}

}  // namespace

Span spanned(Eigen::MatrixXd columns)
{
    Span span;
    Eigen::MatrixXd& directions = span.directions;
    const Eigen::Index most = std::min({columns.rows(), columns.cols(), most_directions});
    directions.resize(columns.rows(), most);
    Eigen::MatrixXd shares(most, columns.cols());
    Eigen::Index count = 0;
    Eigen::RowVectorXd misses;
    const auto look = [&]
    {
        if (columns.size() > 0)
            misses = columns.cwiseAbs().colwise().maxCoeff();
        return misses.size() > 0 ? misses.maxCoeff() : 0.0;
    };
    while ((span.miss = look()) > largest_miss && count < most)
    {
        const Eigen::Index worst = next_column(misses, span.chosen);
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
        span.upper.col(k) = shares.col(span.chosen[at(k)]).head(count);
    return span;
}

std::vector<Eigen::Index> telling_rows(const Eigen::MatrixXd& directions)
{
    std::vector<Eigen::Index> found, left;
    for (Eigen::Index row = 0; row < directions.rows(); ++row)
        left.push_back(row);
    for (int pass = 0; pass < 2 && !left.empty(); ++pass)
    {
        const Eigen::MatrixXd open = directions(left, Eigen::indexing::all).transpose();
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(open);
        const auto& order = factors.colsPermutation().indices();
        const Eigen::Index count = std::min(open.rows(), open.cols());
        std::vector<Eigen::Index> rest;
        for (Eigen::Index k = 0; k < order.size(); ++k)
            (k < count ? found : rest).push_back(left[at(order(k))]);
        left = std::move(rest);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace sheetmorph::surface
