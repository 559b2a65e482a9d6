// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/operators/ties.h"
#include "sheetmorph/surface/operators/unknowns.h"

namespace sheetmorph::surface
{

//! A sheet with groups of vertices. Other vertices are unknown, or belong to no group and have no
//! weight.
struct WeightedSheet
{
    const numerics::SparseMatrix& harmonic;  //!< K (n, n)
    const Unknowns& unknowns;
    const numerics::SparseCholesky& factor;  //!< of K merged by the unknowns
};

//! Options of the weights.
struct WeightCount
{
    double faded = 0.0;    //!< weights up to this value become 0; a weight of 1 stays 1
    double least = 0.0;    //!< smaller weights are not stored
    bool has_rest = true;  //!< the remainder to 1 belongs to another source
};

//! Weights of groups at every vertex. A harmonic weight w is 1 on its group and 0 on all others.
//! Smoothstep 3 w^2 - 2 w^3 is applied, and the sum is normalised. Only weights above
//! WeightCount::least are stored, so a vertex only has the weights of nearby groups.
class SmoothWeights
{
public:
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    //! Without groups.
    explicit SmoothWeights(Eigen::Index vertices) : by_vertex_(vertices, 0) {}

    //! Weights are within [0, 1]. Their sum at a vertex is 1, or less if WeightCount::has_rest.
    //! \param groups  disjoint sets of vertices
    SmoothWeights(const WeightedSheet& sheet, const std::vector<VertexIds>& groups,
                  const WeightCount& count);

    //! Interpolates the weights of tied vertices from the corners of their triangles.
    void fill_tied(const std::vector<Tie>& ties);

    Eigen::Index vertices() const { return by_vertex_.rows(); }
    Eigen::Index groups() const { return by_vertex_.cols(); }
    bool is_empty() const { return by_vertex_.nonZeros() == 0; }

    //! The weights of a vertex, by ascending group: col() and value().
    Matrix::InnerIterator at_vertex(Eigen::Index vertex) const { return {by_vertex_, vertex}; }

    double sum(Eigen::Index vertex) const;

    //! (n, 3) weights * values.
    //! \param values  (groups, 3)
    Points times(const Points& values) const;

private:
    Matrix by_vertex_;  // (n, groups)
};

//! (unknowns, count): right-hand sides for groups with the value 1.
Eigen::MatrixXd pull_of(const WeightedSheet& sheet, const VertexIds* groups, Eigen::Index count);

}  // namespace sheetmorph::surface
