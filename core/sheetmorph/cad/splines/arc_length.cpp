// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/arc_length.h"
#include "sheetmorph/cad/splines/surface_breaks.h"

#include <algorithm>
#include <array>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace sheetmorph::cad
{

namespace
{

// Places and weights of the Gauss rule with five places, from Abramowitz and Stegun, table 25.4.
constexpr std::array<double, 5> places = {0.0, -0.5384693101056831, 0.5384693101056831,
                                          -0.9061798459386640, 0.9061798459386640};
constexpr std::array<double, 5> weights = {0.5688888888888889, 0.4786286704993665,
                                           0.4786286704993665, 0.2369268850561891,
                                           0.2369268850561891};

}  // namespace

ArcLength::ArcLength(const Handle(Geom_Curve) & curve, double low, double high)
    : curve_(curve), ends_{low}, lengths_{0.0}
{
    // Pieces of a span. Chosen: five places of Gauss integrate polynomials of degree 9, so eight
    // pieces leave 8^-10 of the error of one.
    constexpr int cuts = 8;
    std::vector<double> breaks;
    for (const CubicBasis::Break& one : curve_breaks(curve, low, high))
        breaks.push_back(one.at);
    breaks.push_back(high);
    for (const double end : breaks)
    {
        const double start = ends_.back();
        for (int cut = 1; cut <= cuts; ++cut)
        {
            const double t = start + cut * (end - start) / cuts;
            lengths_.push_back(lengths_.back() + between(ends_.back(), t));
            ends_.push_back(t);
        }
    }
}

double ArcLength::at(double t) const
{
    const auto above = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, t);
    const auto piece = static_cast<std::size_t>(above - ends_.begin()) - 1;
    return lengths_[piece] + between(ends_[piece], t);
}

double ArcLength::between(double low, double high) const
{
    const double half = 0.5 * (high - low);
    double sum = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
        gp_Pnt here;
        gp_Vec along;
        curve_->D1(low + half * (1.0 + places[k]), here, along);
        sum += weights[k] * along.Magnitude();
    }
    return half * sum;
}

}  // namespace sheetmorph::cad
