// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/splines/cubic_basis.h"
#include "sheetmorph/cad/splines/grid_cholesky.h"

namespace sheetmorph::cad
{

//! The normal equations of a least squares fit by tensor products of two cubic bases.
class PlateSystem
{
public:
    PlateSystem(int u_count, int v_count);

    //! Adds an equation: the sum of poles with these weights has a value (3). `weight` is squared
    //! already.
    void add(const CubicBasis::Row& u, const CubicBasis::Row& v, const Vector3& value,
             double weight);

    //! Adds an equation: such a sum is equal at both ends of u (direction 0) or v (1).
    void tie(const std::array<CubicBasis::Row, 2>& low, const std::array<CubicBasis::Row, 2>& high,
             int direction, double weight);

    //! One row per spline of a basis: its products with those up to 3 before and after it.
    using Band = std::vector<std::array<double, GridMatrix::across>>;

    //! Adds the product of a quadratic form of u and one of v to the energy.
    void add_energy(const Band& u, const Band& v, double weight);

    //! The poles (u count * v count, 3), v fastest.
    Eigen::MatrixXd solution() const;

private:
    GridMatrix matrix_;
    Eigen::MatrixXd right_;
};

}  // namespace sheetmorph::cad
