// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/errors.h"

namespace sheetmorph
{

InvalidInput::InvalidInput(std::string before, std::vector<int> vertices, std::string after)
    : std::invalid_argument(before + list_ids(vertices) + after),
      before_(std::move(before)),
      vertices_(std::move(vertices)),
      after_(std::move(after))
{
}

InvalidInput InvalidInput::in_part(const std::string& part, const std::vector<int>& ids) const
{
    const std::string prefix = "part '" + part + "': ";
    if (vertices_.empty())
        return InvalidInput(prefix + what());
    std::vector<int> numbered = vertices_;
    for (int& vertex : numbered)
        if (static_cast<std::size_t>(vertex) < ids.size())
            vertex = ids[static_cast<std::size_t>(vertex)];
    return InvalidInput(prefix + before_, numbered, after_);
}

std::string list_ids(const std::vector<int>& ids, std::size_t shown)
{
    std::string text;
    for (std::size_t k = 0; k < ids.size() && k < shown; ++k)
        text += (k ? ", " : "") + std::to_string(ids[k]);
    if (ids.size() > shown)
        text += " and " + std::to_string(ids.size() - shown) + " more";
    return text;
}

}  // namespace sheetmorph
