// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/system/sheet.h"

#include "sheetmorph/base/index.h"

#include <algorithm>
#include <set>

namespace sheetmorph::assembly
{

namespace
{

std::ptrdiff_t place_of(const Sheet& sheet, int vertex)
{
    return std::upper_bound(sheet.first.begin(), sheet.first.end(), vertex) - sheet.first.begin()
           - 1;
}

// Whether a pose can move the sheet by this feature.
bool moves(const surface::FormFeature& feature)
{
    return feature.rotation == surface::FeatureRotation::prescribed || feature.is_resizable;
}

}  // namespace

bool Sheet::is_driven() const
{
    const auto is_led = [](const surface::FeatureLink& link) { return link.leader < 0; };
    return !surface.handles.empty() || !surface.points.empty() || !surface.propagated.empty()
           || std::any_of(surface.features.begin(), surface.features.end(), moves)
           || std::any_of(surface.links.begin(), surface.links.end(), is_led);
}

int Sheet::part_of(int vertex) const
{
    return parts[at(place_of(*this, vertex))];
}

std::vector<Subject> Sheet::subjects_of(const VertexIds& vertices) const
{
    if (vertices.empty())
        return of;
    std::set<std::ptrdiff_t> places;
    for (const int vertex : vertices)
        places.insert(place_of(*this, vertex));
    std::vector<Subject> found;
    for (const std::ptrdiff_t place : places)
        found.push_back(of[at(place)]);
    return found;
}

InvalidInput in_sheet(const InvalidInput& fault, const Sheet& sheet)
{
    return fault.in_parts(sheet.name, sheet.subjects_of(fault.fault().what.vertices()), sheet.ids);
}

SolverError on_sheet(const SolverError& fault, const Sheet& sheet)
{
    return fault.in_parts(sheet.name, sheet.of);
}

}  // namespace sheetmorph::assembly
