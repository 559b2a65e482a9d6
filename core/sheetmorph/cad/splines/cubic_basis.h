// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace sheetmorph::cad
{

//! The cubic B-splines of a clamped knot vector.
class CubicBasis
{
public:
    //! A place where two spans meet. Its multiplicity is 1 for two continuous derivatives, 2 for
    //! one, 3 for a kink.
    struct Break
    {
        double at = 0.0;
        int times = 1;
    };

    //! The splines that are not 0 at a parameter: `first` and the three after it.
    struct Row
    {
        int first = 0;
        std::array<double, 4> weights = {};
    };

    //! \param inner  ascending, between low and high
    CubicBasis(double low, double high, const std::vector<Break>& inner = {});

    int count() const { return static_cast<int>(knots_.size()) - 4; }
    double low() const { return knots_.front(); }
    double high() const { return knots_.back(); }
    const std::vector<double>& knots() const { return knots_; }

    //! The ends of all spans, ascending.
    const std::vector<double>& ends() const { return ends_; }
    int span_count() const { return static_cast<int>(ends_.size()) - 1; }

    //! The span of a parameter; outside the range, the first or the last.
    int span_of(double t) const;

    //! Values, first or second derivatives at a parameter; outside the range, of the polynomials at
    //! its ends.
    Row row(double t, int derivative = 0) const;

    //! Places at which a spline of this basis is interpolated: averages of three knots (Greville).
    std::vector<double> greville() const;

    //! The coefficients (count, k) of the splines through values (count, k) at ascending places, as
    //! many as there are splines.
    Eigen::MatrixXd through(const std::vector<double>& places, const Eigen::MatrixXd& values) const;

    //! The basis with some of its spans halved.
    CubicBasis halved(const std::vector<bool>& spans) const;

private:
    std::vector<double> knots_, ends_;
};

}  // namespace sheetmorph::cad
