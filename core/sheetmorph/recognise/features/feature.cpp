// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/feature.h"

#include <array>

namespace sheetmorph
{

const char* name_of(FeatureKind kind)
{
    static constexpr std::array<const char*, 13> names = {
        "round hole", "slotted hole", "rectangular hole", "hole", "round edge", "plane", "cylinder",
        "cone",       "sphere",       "flange",           "bead", "emboss",     "bend"};
    return names[static_cast<std::size_t>(kind)];
}

}  // namespace sheetmorph
