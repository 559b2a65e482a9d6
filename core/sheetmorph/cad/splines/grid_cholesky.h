// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

namespace sheetmorph::cad
{

//! A symmetric matrix over the places of a grid, each with those up to 3 beside it each way.
struct GridMatrix
{
    static constexpr int reach = 3, across = 2 * reach + 1;

    int rows = 0, columns = 0;     //!< a place's number is row * columns + column
    std::vector<double> products;  //!< across * across a place, by the other's row, then column
    //! Others, lower triangle: among the first and last `border` rows (0) or columns (1).
    std::vector<Eigen::Triplet<double>> ties;
    std::array<bool, 2> is_tied = {};
    static constexpr int border = 4;

    Eigen::MatrixXd times(const Eigen::MatrixXd& values) const;
    double largest() const;  //!< on the diagonal
};

//! Cholesky's factors of such a matrix, by nested dissection: the grid is halved by strips that
//! come after what lies beside them, and all is done to dense blocks.
class GridCholesky
{
public:
    //! \param shift  added to the diagonal
    GridCholesky(const GridMatrix& matrix, double shift);

    //! Whether the matrix is positive definite; there is no solution else.
    bool is_definite() const { return is_definite_; }

    //! \param right  (places, k)
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

private:
    struct Rectangle
    {
        int row, column, rows, columns;
    };

    //! Places that are eliminated together, then those of later blocks beside them.
    struct Block
    {
        std::vector<int> places;
        Eigen::Index own = 0;
        Eigen::MatrixXd factor;  //!< (places, own)
    };

    //! What eliminating a block changes among the places beside it, lower triangle.
    struct Change
    {
        std::vector<int> places;
        Eigen::MatrixXd matrix;
    };

    Rectangle without_border() const;
    void add_places(std::vector<int>& places, const Rectangle& area, const Rectangle& but) const;
    Change eliminate(const Rectangle& area);
    Change eliminate(Block block, const std::vector<Change>& before, bool has_ties);
    void add_products(Eigen::MatrixXd& front, const Block& block) const;
    void add_ties(Eigen::MatrixXd& front) const;
    void add_change(Eigen::MatrixXd& front, const Change& change) const;

    const GridMatrix& matrix_;
    double shift_;
    bool is_definite_ = true;
    std::vector<Block> blocks_;  // in the order of elimination
    std::vector<int> local_;     // of a place in the block at hand; -1 if it is not there
};

}  // namespace sheetmorph::cad
