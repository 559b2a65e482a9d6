// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/span.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

// Columns x -> exp(t x): smooth, so that a few tell all.
Eigen::MatrixXd exponentials(int count)
{
    Eigen::MatrixXd columns(60, count);
    for (Eigen::Index row = 0; row < columns.rows(); ++row)
        for (Eigen::Index k = 0; k < count; ++k)
            columns(row, k) = std::exp(static_cast<double>(row * k) / 60.0 / count);
    return columns;
}

TEST(Span, FewColumnsBlendToAllOfThem)
{
    const Eigen::MatrixXd columns = exponentials(80);
    const Span span = spanned(columns);
    EXPECT_LT(span.chosen.size(), 14U);
    const Eigen::MatrixXd& q = span.directions;
    EXPECT_LT((q * (q.transpose() * columns) - columns).cwiseAbs().maxCoeff(), 2e-8);
    EXPECT_LT((q.transpose() * q - Eigen::MatrixXd::Identity(q.cols(), q.cols())).norm(), 1e-12);
}

TEST(Span, TellsHowItsDirectionsComeFromTheChosenColumns)
{
    const Eigen::MatrixXd columns = exponentials(40);
    const Span span = spanned(columns);
    for (std::size_t k = 0; k < span.chosen.size(); ++k)
    {
        const auto column = static_cast<Eigen::Index>(k);
        EXPECT_LT((span.directions * span.upper.col(column) - columns.col(span.chosen[k])).norm(),
                  1e-10);
        EXPECT_GT(span.upper(column, column), 0.0);
    }
    EXPECT_GE(span.reach(0), span.upper(0, 0));
}

TEST(Span, OfNothingIsEmpty)
{
    EXPECT_TRUE(spanned(Eigen::MatrixXd::Zero(5, 3)).chosen.empty());
}

}  // namespace
}  // namespace sheetmorph::surface
