// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/splines/cubic_basis.h"

#include <Eigen/SparseCore>

namespace sheetmorph
{

//! The normal equations of a least squares fit by tensor products of two cubic bases.
class PlateSystem
{
public:
    PlateSystem(int u_count, int v_count);

    //! Asks for a value (3) of the sum of poles with these weights; `weight` is squared already.
    void add(const CubicBasis::Row& u, const CubicBasis::Row& v, const Vector3& value,
             double weight);

    //! Asks that such a sum is the same in two places that have few poles in common.
    void tie(const std::array<CubicBasis::Row, 2>& one, const std::array<CubicBasis::Row, 2>& other,
             double weight);

    //! The poles (u count * v count, 3), v fastest.
    Eigen::MatrixXd solution() const;

private:
    //! Products of a pole with those up to 3 beside it each way.
    static constexpr int reach = 7;

    int u_count_, v_count_;
    std::vector<double> products_;
    std::vector<Eigen::Triplet<double>> others_;
    Eigen::MatrixXd right_;
};

}  // namespace sheetmorph
