// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/labels.h"

#include "sheetmorph/base/index.h"

#include <algorithm>
#include <set>

namespace sheetmorph::assembly
{

namespace
{

// Of a part that is joined of several, those that have the vertices.
std::vector<Subject> concerned(const Part& part, const std::vector<int>& vertices)
{
    const std::vector<Subject> all = subjects_of("part", part);
    if (part.of.empty() || vertices.empty())
        return all;
    std::set<std::ptrdiff_t> places;
    for (const int vertex : vertices)
        places.insert(std::upper_bound(part.joined.begin(), part.joined.end(), vertex)
                      - part.joined.begin() - 1);
    std::vector<Subject> found;
    for (const std::ptrdiff_t place : places)
        found.push_back(all[static_cast<std::size_t>(place)]);
    return found;
}

}  // namespace

InvalidInput in_part(const InvalidInput& fault, const Part& part)
{
    return fault.in_parts(part.name, concerned(part, fault.fault().what.vertices()), part.ids);
}

SolverError on_part(const SolverError& fault, const Part& part)
{
    return fault.in_parts(part.name, concerned(part, {}));
}

}  // namespace sheetmorph::assembly
