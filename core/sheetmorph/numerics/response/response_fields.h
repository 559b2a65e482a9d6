// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::numerics
{

//! Tall columns Phi (n, k), with growing k, in little memory. On rows near each other, smooth
//! columns are nearly combinations of a few fields. So every patch of rows stores only those fields
//! and the coefficients of the columns. Patches are cut in space, so nothing depends on the
//! numbering of the rows.
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

    //! Has no columns yet.
    //! \param places   (n, 3) positions of the rows
    //! \param columns  expected number of columns; many justify larger patches
    explicit ResponseFields(const Points& places, Eigen::Index columns = 0);

    //! Appends columns (n, j). Rows of zeros stay zeros.
    //! \param tolerances  (j) largest error of an entry; relative rounding of 1e-7 adds to it
    void append(const Eigen::MatrixXd& columns, const Eigen::VectorXd& tolerances);

    //! Phi c, (n, 3).
    Points times(const Coefficients& coefficients) const;

    //! (1, k) one row of Phi.
    Eigen::RowVectorXd row(Eigen::Index row) const;

    Eigen::Index rows() const { return static_cast<Eigen::Index>(order_.size()); }
    Eigen::Index columns() const { return tolerances_.size(); }

    //! The rows of a patch, ascending.
    VertexIds rows_of(std::size_t patch) const;
    Eigen::Index rows_a_patch() const { return rows_a_patch_; }
    const std::vector<Patch>& patches() const { return patches_; }
    const Eigen::VectorXd& tolerances() const { return tolerances_; }

    //! Memory in bytes.
    double bytes() const;

private:
    VertexIds order_;  // rows, patch after patch
    VertexIds place_;  // position of every row in the order
    Eigen::Index rows_a_patch_ = 1;
    Eigen::VectorXd tolerances_;
    std::vector<Patch> patches_;
};

}  // namespace sheetmorph::numerics
