// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

namespace sheetmorph::cad
{

//! A symmetric matrix over the places of a grid. Each place is coupled with those up to 3 away in
//! each direction.
struct GridMatrix
{
    //! From cubic splines: each overlaps the three before and after it.
    static constexpr int reach = 3, across = 2 * reach + 1;

    int rows = 0, columns = 0;     //!< the number of a place is row * columns + column
    std::vector<double> products;  //!< across * across per place, by the other's row, then column
    //! Couplings among the first and last `border` rows (0) or columns (1); lower triangle.
    std::vector<Eigen::Triplet<double>> ties;
    std::array<bool, 2> is_tied = {};
    static constexpr int border = 4;  //!< from cubic splines: those at an end

    Eigen::MatrixXd times(const Eigen::MatrixXd& values) const;
    double largest() const;  //!< on the diagonal
};

//! Cholesky factors of such a matrix by nested dissection. Strips halve the grid and come after the
//! parts on both sides. All work is on dense blocks.
class GridCholesky
{
public:
    //! \param shift  added to the diagonal
    GridCholesky(const GridMatrix& matrix, double shift);

    //! Whether the matrix is positive definite. Otherwise there is no solution.
    bool is_definite() const { return is_definite_; }

    //! \param right  (places, k)
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

private:
    struct Rectangle
    {
        int row, column, rows, columns;
    };

    //! Places that are eliminated together, then the adjacent places of later blocks.
    struct Block
    {
        std::vector<int> places;
        Eigen::Index own = 0;
        Eigen::MatrixXd factor;  //!< (places, own)
    };

    //! Changes among the adjacent places when a block is eliminated, lower triangle.
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
    std::vector<int> local_;     // of a place in the current block; -1 if it is not in it
};

}  // namespace sheetmorph::cad
