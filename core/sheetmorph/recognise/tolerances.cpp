// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/tolerances.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/limits.h"

#include <string>

namespace sheetmorph::recognise
{

namespace
{

// Chosen: beyond a right angle, an edge of a box would no longer be an edge.
constexpr double right_angle = 90.0 * degree;

struct Range
{
    const char* name;
    double value;
    double least;
    double most;
};

void require(const Range& range)
{
    if (!(range.value >= range.least && range.value <= range.most))
        throw InvalidInput(
            std::string("the tolerance ") + range.name + " is " + std::to_string(range.value),
            "give a number from " + std::to_string(range.least) + " to "
                + std::to_string(range.most));
}

}  // namespace

void FeatureTolerances::check() const
{
    require({"crease_angle", crease_angle, 0.01, right_angle});
    require({"smooth_angle", smooth_angle, 0.01, right_angle});
    require({"plane_angle", plane_angle, 1e-6, 0.8});
    require({"roundness", roundness, 1e-9, 0.3});
    require({"surface", surface, 1e-9, 0.3});
    require({"smallest_area", smallest_area, 0.0, 1.0});
    require({"scatter", scatter, -1.0, 1e12});
    require({"weld", weld, 0.0, 0.01});
    require({"fewest_rim_vertices", static_cast<double>(fewest_rim_vertices), 3.0, 1e6});
    require({"washer_rings", static_cast<double>(washer_rings), 0.0, 20.0});
    require({"smallest_radius", smallest_radius, 0.0, largest_number});
    require({"largest_radius", largest_radius, smallest_radius, largest_number});
}

void ContactTolerances::check() const
{
    require({"gap", gap, -1.0, 1e12});
    require({"facing_angle", facing_angle, 0.0, right_angle});
    require({"coaxial", coaxial, 0.0, 10.0});
    require({"bolt_ratio", bolt_ratio, 1.0, 100.0});
    require({"smallest", static_cast<double>(smallest), 1.0, 1e6});
}

}  // namespace sheetmorph::recognise
