// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/spline_curve.h"

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <algorithm>

namespace sheetmorph::cad
{

namespace
{

// Lagrange's polynomial through all points.
Vector3 polynomial(const std::vector<double>& parameters, const Points& points, double t)
{
    Vector3 found = Vector3::Zero();
    for (std::size_t i = 0; i < parameters.size(); ++i)
    {
        double weight = 1.0;
        for (std::size_t j = 0; j < parameters.size(); ++j)
            if (j != i)
                weight *= (t - parameters[j]) / (parameters[i] - parameters[j]);
        found += weight * points.row(static_cast<Eigen::Index>(i)).transpose();
    }
    return found;
}

Points values_at(const PointAt& curve, const std::vector<double>& places)
{
    Points values(static_cast<Eigen::Index>(places.size()), 3);
    for (std::size_t i = 0; i < places.size(); ++i)
        values.row(static_cast<Eigen::Index>(i)) = curve(places[i]).transpose();
    return values;
}

SplineCurve through_places_of(const CubicBasis& basis, const PointAt& curve)
{
    const std::vector<double> places = basis.greville();
    return {basis, basis.through(places, values_at(curve, places))};
}

Vector3 sum(const Eigen::MatrixXd& poles, const CubicBasis::Row& row)
{
    Vector3 found = Vector3::Zero();
    for (int k = 0; k < 4; ++k)
        found += row.weights[static_cast<std::size_t>(k)] * poles.row(row.first + k).transpose();
    return found;
}

}  // namespace

Vector3 SplineCurve::at(double t) const
{
    return sum(poles, basis.row(t));
}

Vector3 SplineCurve::derivative(double t) const
{
    return sum(poles, basis.row(t, 1));
}

Handle(Geom_BSplineCurve) SplineCurve::curve() const
{
    TColgp_Array1OfPnt points(1, basis.count());
    for (int i = 0; i < basis.count(); ++i)
        points.SetValue(i + 1, gp_Pnt(poles(i, 0), poles(i, 1), poles(i, 2)));
    const std::vector<double>& ends = basis.ends();
    TColStd_Array1OfReal knots(1, static_cast<int>(ends.size()));
    TColStd_Array1OfInteger times(1, knots.Length());
    for (int i = 1; i <= knots.Length(); ++i)
    {
        const double end = ends[static_cast<std::size_t>(i - 1)];
        knots.SetValue(i, end);
        const auto& all = basis.knots();
        times.SetValue(i, static_cast<int>(std::count(all.begin(), all.end(), end)));
    }
    return new Geom_BSplineCurve(points, knots, times, 3);
}

SplineCurve curve_through(const std::vector<double>& parameters, const Points& points,
                          bool is_closed)
{
    const auto count = static_cast<int>(parameters.size());
    if (count < 4)
        return through_places_of(CubicBasis(parameters.front(), parameters.back()),
                                 [&](double t) { return polynomial(parameters, points, t); });
    std::vector<double> all = parameters;
    Points values = points;
    if (const int more = std::min(4, count - 1); is_closed)
    {
        const double period = parameters.back() - parameters.front();
        values.resize(count + 2 * more, 3);
        values.middleRows(more, count) = points;
        values.topRows(more) = points.middleRows(count - 1 - more, more);
        values.bottomRows(more) = points.middleRows(1, more);
        for (int k = 1; k <= more; ++k)
        {
            all.insert(all.begin(), parameters[static_cast<std::size_t>(count - 1 - k)] - period);
            all.push_back(parameters[static_cast<std::size_t>(k)] + period);
        }
    }
    std::vector<CubicBasis::Break> inner;
    for (std::size_t i = 2; i + 2 < all.size(); ++i)
        inner.push_back({all[i], 1});
    const CubicBasis basis(all.front(), all.back(), inner);
    return {basis, basis.through(all, values)};
}

SplineCurve curve_near(const PointAt& curve, const CubicBasis& start, double tolerance)
{
    // Chosen: nine halvings give 512 spans from one. An edge of a file has fewer than 400.
    constexpr int most_rounds = 9, most_spans = 400;
    SplineCurve found = through_places_of(start, curve);
    for (int round = 0; round < most_rounds && found.basis.span_count() < most_spans; ++round)
    {
        std::vector<bool> is_off;
        const std::vector<double>& ends = found.basis.ends();
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        {
            double worst = 0.0;
            for (const double share : {0.11, 0.31, 0.5, 0.69, 0.89})
            {
                const double t = ends[i] + share * (ends[i + 1] - ends[i]);
                worst = std::max(worst, (found.at(t) - curve(t)).norm());
            }
            is_off.push_back(worst > tolerance);
        }
        if (std::find(is_off.begin(), is_off.end(), true) == is_off.end())
            break;
        found = through_places_of(found.basis.halved(is_off), curve);
    }
    return found;
}

}  // namespace sheetmorph::cad
