// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::numerics
{

//! Tall columns Phi (n, k), k growing, in little memory: rows near each other of smooth columns are
//! nearly blends of a few fields, so every patch of rows keeps only those and how the columns blend
//! them. Patches are cut in space, so nothing depends on how rows are numbered.
class ResponseFields
{
public:
    using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

    //! Rows of one patch: Phi = fields * shares.
    struct Patch
    {
        Eigen::MatrixXf fields;  //!< (rows, f), nearly orthonormal columns
        Eigen::MatrixXd shares;  //!< (f, k)
    };

    ResponseFields() = default;

    //! Without columns.
    //! \param places   (n, 3) where the rows are
    //! \param columns  about how many there will be: many are worth larger patches
    explicit ResponseFields(const Points& places, Eigen::Index columns = 0);

    //! Further columns from (n, j). Rows of zeros stay zeros.
    //! \param tolerances  (j) by how much an entry may miss; relative rounding of 1e-7 comes on top
    void append(const Eigen::MatrixXd& columns, const Eigen::VectorXd& tolerances);

    //! Phi c, (n, 3).
    Points times(const Coefficients& coefficients) const;

    //! (1, k) one row of Phi.
    Eigen::RowVectorXd row(Eigen::Index row) const;

    Eigen::Index rows() const { return static_cast<Eigen::Index>(order_.size()); }
    Eigen::Index columns() const { return tolerances_.size(); }

    //! Ascending.
    VertexIds rows_of(std::size_t patch) const;
    Eigen::Index rows_a_patch() const { return rows_a_patch_; }
    const std::vector<Patch>& patches() const { return patches_; }
    const Eigen::VectorXd& tolerances() const { return tolerances_; }

    //! Of memory.
    double bytes() const;

private:
    VertexIds order_;  // the rows, a patch after the other
    VertexIds place_;  // of every row in the order
    Eigen::Index rows_a_patch_ = 1;
    Eigen::VectorXd tolerances_;
    std::vector<Patch> patches_;
};

}  // namespace sheetmorph::numerics
