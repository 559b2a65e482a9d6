// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/frontal_cholesky.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "numerics/cholesky/cholmod_oracle.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::numerics
{
namespace
{

constexpr int side = 70;

// A bilaplacian of a square grid, singular where nothing is known, and its tree.
struct Sheet
{
    std::shared_ptr<const SparseMatrix> whole;
    std::shared_ptr<const SeparatorTree> tree;
};

Sheet sheet()
{
    constexpr int count = side * side;
    std::vector<Eigen::Triplet<double>> entries;
    Points places(count, 3);
    for (int i = 0; i < count; ++i)
    {
        places.row(i) << i % side, i / side, 0.0;
        for (const int other : {i % side + 1 < side ? i + 1 : i, i + side})
            if (other != i && other < count)
                for (const auto& [a, b] : {std::pair(i, other), std::pair(other, i)})
                {
                    entries.emplace_back(a, b, -1.0);
                    entries.emplace_back(a, a, 1.0);
                }
    }
    SparseMatrix laplacian(count, count);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    Sheet made;
    made.whole = std::make_shared<const SparseMatrix>(laplacian * laplacian);
    made.tree = std::make_shared<const SeparatorTree>(nested_dissection(*made.whole, places));
    return made;
}

// Some rows known, some sets of rows merged, all others unknowns.
MergedMatrix merged(const Sheet& given, const std::vector<int>& known,
                    const std::vector<std::vector<int>>& sets)
{
    MergedMatrix matrix{given.whole, std::vector<int>(side * side, 0), 0};
    for (const int row : known)
        matrix.unknown_of[static_cast<std::size_t>(row)] = -1;
    for (const std::vector<int>& set : sets)
    {
        for (const int row : set)
            matrix.unknown_of[static_cast<std::size_t>(row)] = -2 - matrix.count;
        ++matrix.count;
    }
    for (int& unknown : matrix.unknown_of)
        unknown = unknown == 0 ? matrix.count++ : (unknown < -1 ? -2 - unknown : -1);
    return matrix;
}

std::vector<int> block(int column, int row, int wide)
{
    std::vector<int> rows;
    for (int y = row; y < row + wide; ++y)
        for (int x = column; x < column + wide; ++x)
            rows.push_back(y * side + x);
    return rows;
}

FrontList factorised(const FrontPattern& pattern, const FrontList* earlier = nullptr)
{
    FrontList fronts = new_fronts(pattern, earlier);
    factorise_fronts(pattern, *pattern.elimination().matrix().whole, fronts);
    return fronts;
}

double miss(const SparseCholesky& factor, const MergedMatrix& matrix)
{
    const Eigen::MatrixXd wanted = Eigen::MatrixXd::Random(matrix.count, 5);
    return (factor.solve(written_out(matrix) * wanted) - wanted).cwiseAbs().maxCoeff();
}

TEST(FrontalCholesky, SolvesWhateverRowsAreKnownOrMerged)
{
    const Sheet given = sheet();
    for (const auto& sets : std::vector<std::vector<std::vector<int>>>{
             {}, {block(30, 30, 3)}, {block(5, 5, 4), {0, side * side - 1, 2500}}})
    {
        const MergedMatrix matrix = merged(given, block(60, 60, 5), sets);
        const SparseCholesky factor(matrix, given.tree);
        EXPECT_EQ(factor.size(), matrix.count);
        EXPECT_LT(miss(factor, matrix), 1e-7);
    }
}

TEST(FrontalCholesky, TakesOverWhatAnEditLeavesAsItWas)
{
    const Sheet given = sheet();
    const std::vector<int> held = block(60, 60, 5);
    const FrontPattern before({merged(given, held, {block(30, 30, 3)}), given.tree});
    const FrontList first = factorised(before);
    const Elimination after(merged(given, held, {block(30, 30, 3), block(8, 50, 2)}), given.tree);
    const FrontList edited = factorised(FrontPattern(after, &before), &first);
    const FrontList fresh = factorised(FrontPattern(after));
    int shared = 0;
    for (std::size_t k = 0; k < edited.fronts.size(); ++k)
    {
        shared += edited.fronts[k] == first.fronts[k] ? 1 : 0;
        ASSERT_EQ(edited.fronts[k]->rows(), fresh.fronts[k]->rows());
        const Weights difference = edited.fronts[k]->panel() - fresh.fronts[k]->panel();
        for (Eigen::Index row = 0; row < difference.rows(); ++row)
            for (Eigen::Index column = 0; column <= row && column < difference.cols(); ++column)
                ASSERT_NEAR(difference(row, column), 0.0, 1e-10);
    }
    EXPECT_GT(shared, 0.9 * static_cast<double>(edited.fronts.size()));
    EXPECT_LT(shared, static_cast<int>(edited.fronts.size()));
}

TEST(FrontalCholesky, FollowsAnyRowOfEdits)
{
    const Sheet given = sheet();
    std::mt19937 random(7);
    const auto place = [&] { return static_cast<int>(random() % (side - 6)); };
    std::vector<int> held = block(60, 60, 5);
    std::vector<std::vector<int>> sets;
    std::unique_ptr<SparseCholesky> last;
    for (int edit = 0; edit < 12; ++edit)
    {
        if (edit % 3 == 0)
            held = block(60, 60, 1 + static_cast<int>(random() % 8));
        else if (sets.size() > 2)
            sets.erase(sets.begin());
        else
            sets.push_back(block(place() % 50, place() % 50, 3));
        const MergedMatrix matrix = merged(given, held, sets);
        auto next = std::make_unique<SparseCholesky>(matrix, given.tree, last.get());
        EXPECT_LT(miss(*next, matrix), 1e-6);
        last = std::move(next);
    }
}

// The same pattern, other values.
MergedMatrix scaled_at_random(const MergedMatrix& matrix, std::mt19937& random)
{
    std::uniform_real_distribution<double> number(0.5, 2.0);
    const Eigen::VectorXd scales =
        Eigen::VectorXd::NullaryExpr(matrix.whole->rows(), [&] { return number(random); });
    MergedMatrix scaled = matrix;
    scaled.whole = std::make_shared<const SparseMatrix>(scales.asDiagonal() * *matrix.whole
                                                        * scales.asDiagonal());
    return scaled;
}

TEST(FrontalCholesky, FactorisesOneMatrixAfterTheOtherAlongOnePattern)
{
    const Sheet given = sheet();
    const MergedMatrix matrix = merged(given, block(60, 60, 5), {block(30, 30, 3)});
    SparseCholesky factor(std::make_shared<const FrontPattern>(Elimination(matrix, given.tree)));
    std::mt19937 random(11);
    SparseMatrix indefinite = *matrix.whole;
    indefinite.diagonal().array() -= 1.0;
    for (int k = 0; k < 5; ++k)
    {
        const MergedMatrix next = scaled_at_random(matrix, random);
        factor.factorise(*next.whole);
        EXPECT_LT(miss(factor, next), 1e-6);
        EXPECT_THROW(factor.factorise(indefinite), SolverError);
    }
}

TEST(FrontalCholesky, AnotherFactorKeepsTheFrontsItShares)
{
    const Sheet given = sheet();
    const std::vector<int> held = block(60, 60, 5);
    const MergedMatrix first_matrix = merged(given, held, {block(30, 30, 3)});
    const MergedMatrix edited_matrix = merged(given, held, {});
    std::mt19937 random(12);
    SparseCholesky first(first_matrix, given.tree);
    SparseCholesky edited(edited_matrix, given.tree, &first);
    const MergedMatrix next = scaled_at_random(first_matrix, random);
    first.factorise(*next.whole);
    EXPECT_LT(miss(first, next), 1e-6);
    EXPECT_LT(miss(edited, edited_matrix), 1e-6);
    const MergedMatrix last = scaled_at_random(edited_matrix, random);
    edited.factorise(*last.whole);
    EXPECT_LT(miss(edited, last), 1e-6);
    EXPECT_LT(miss(first, next), 1e-6);
}

TEST(FrontalCholesky, RefusesAMatrixThatIsNotPositiveDefinite)
{
    const Sheet given = sheet();
    SparseMatrix shifted = *given.whole;
    shifted.diagonal().array() -= 1.0;
    const Sheet bad{std::make_shared<const SparseMatrix>(shifted), given.tree};
    EXPECT_THROW(SparseCholesky(merged(bad, {}, {}), bad.tree), SolverError);
}

TEST(FrontalCholesky, TakesAMatrixWithMoreEntriesThanItsTreeKnows)
{
    const Sheet given = sheet();
    const SparseMatrix identity = []
    {
        SparseMatrix one(side * side, side * side);
        one.setIdentity();
        return one;
    }();
    SparseMatrix more = *given.whole + 4.0 * identity;
    more.coeffRef(3, side * side - 4) = more.coeffRef(side * side - 4, 3) = 1.0;
    const Sheet coupled{std::make_shared<const SparseMatrix>(more), given.tree};
    const MergedMatrix matrix = merged(coupled, {}, {});
    EXPECT_LT(miss(SparseCholesky(matrix, given.tree), matrix), 1e-9);
}

// One look for every front at least, in the rows as in the values, and one for every cut.
TEST(FrontalCholesky, LooksForAStopAtEveryFront)
{
    const ThreadCount alone(1);
    int looks = 0;
    const StopSignal signal([&] { ++looks; }, std::chrono::milliseconds(0));
    const auto counted = [&looks](const auto& work)
    {
        looks = 0;
        work();
        return looks;
    };
    Sheet given;
    const int cuts = counted([&] { given = sheet(); });
    const int nodes = given.tree->size();
    EXPECT_GE(2 * cuts, nodes);
    const FrontPattern pattern({merged(given, block(60, 60, 5), {}), given.tree});
    EXPECT_GE(counted([&] { FrontPattern(pattern.elimination()); }), nodes);
    EXPECT_GE(counted([&] { factorised(pattern); }), nodes);
}

// A front with many columns takes long by itself: a look at every block of them.
TEST(FrontalCholesky, LooksForAStopInTheBlocksOfOneFront)
{
    const ThreadCount alone(1);
    constexpr Eigen::Index size = 600;
    Weights matrix = Weights::Identity(size, size);
    int looks = 0;
    const StopSignal signal([&] { ++looks; }, std::chrono::milliseconds(0));
    EXPECT_NO_THROW(DenseCholesky{matrix});
    EXPECT_GE(looks, size / 48);
}

// Wherever it is stopped, the same factor gives the same bits afterwards.
TEST(FrontalCholesky, EndsAtAnyLookAndFactorisesAsBeforeThen)
{
    const Sheet given = sheet();
    const MergedMatrix matrix = merged(given, block(60, 60, 5), {});
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(matrix.count, 3);
    SparseCholesky factor(matrix, given.tree);
    const Eigen::MatrixXd wanted = factor.solve(right);
    for (int after = 1; after < 1000; after = 3 * after / 2 + 1)
    {
        int looks = 0;
        {
            const StopSignal signal(
                [&]
                {
                    if (++looks == after)
                        throw Cancelled();
                },
                std::chrono::milliseconds(0));
            const ThreadCount alone(1);
            EXPECT_THROW(factor.factorise(*given.whole), Cancelled);
            EXPECT_EQ(looks, after);
        }
        factor.factorise(*given.whole);
        EXPECT_EQ(factor.solve(right), wanted);
    }
}

}  // namespace
}  // namespace sheetmorph::numerics
