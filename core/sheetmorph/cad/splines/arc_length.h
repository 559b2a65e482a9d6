// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_Curve.hxx>
#include <vector>

namespace sheetmorph::cad
{

//! Arc length of a curve from its start, mm, as a function of its parameter.
class ArcLength
{
public:
    ArcLength(const Handle(Geom_Curve) & curve, double low, double high);

    double at(double t) const;
    double whole() const { return lengths_.back(); }

private:
    double between(double low, double high) const;

    Handle(Geom_Curve) curve_;
    std::vector<double> ends_, lengths_;  // of pieces: parameters and arc lengths
};

}  // namespace sheetmorph::cad
