// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/feature.h"

#include <array>

namespace sheetmorph::recognise
{

const char* name_of(FeatureKind kind)
{
    static constexpr std::array<const char*, 13> names = {
        "round hole", "slotted hole", "rectangular hole", "hole", "round edge", "plane", "cylinder",
        "cone",       "sphere",       "flange",           "bead", "emboss",     "bend"};
    return names[static_cast<std::size_t>(kind)];
}

FeatureKind hole_kind(fitting::OutlineKind outline)
{
    static constexpr std::array<FeatureKind, 4> kinds = {
        FeatureKind::round_hole, FeatureKind::slotted_hole, FeatureKind::rectangular_hole,
        FeatureKind::hole};
    return kinds[static_cast<std::size_t>(outline)];
}

FeatureKind raised_kind(double length, double width)
{
    // Length over width. Chosen: a bead stiffens along its length; a shorter one is an emboss.
    // Measured: at 1 the round boss of Features.ABlindHoleGoesIntoTheMaterial... is a bead.
    constexpr double shortest_bead = 2.0;
    return length >= shortest_bead * width ? FeatureKind::bead : FeatureKind::emboss;
}

}  // namespace sheetmorph::recognise
