// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/regions/flags.h"

#include "sheetmorph/base/errors.h"

namespace sheetmorph::mesh
{

Flags flags_of(const std::vector<int>& ids, int count, const std::string& what)
{
    Flags flags(static_cast<std::size_t>(count), 0);
    std::vector<int> bad;
    for (const int id : ids)
        if (id < 0 || id >= count)
            bad.push_back(id);
        else
            flags[id] = 1;
    if (!bad.empty())
        throw InvalidInput(what + " that do not exist: " + list_ids(bad),
                           "the mesh has " + std::to_string(count));
    return flags;
}

std::vector<int> ids_of(const Flags& flags, char value)
{
    std::vector<int> ids;
    for (int id = 0; id < static_cast<int>(flags.size()); ++id)
        if (flags[id] == value)
            ids.push_back(id);
    return ids;
}

}  // namespace sheetmorph::mesh
