// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/text.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

std::string count_of(const std::vector<int>& vertices)
{
    return std::to_string(vertices.size()) + (vertices.size() == 1 ? " vertex" : " vertices");
}

}  // namespace

Text::Text(const std::string& text)
{
    if (!text.empty())
        pieces_.push_back({text, {}, {}, text});
}

Text Text::about(const std::string& kind, const std::string& name)
{
    return about(kind + " '" + name + "'", {{kind, name}});
}

Text Text::about(const std::string& shown, const std::vector<Subject>& subjects)
{
    Text text(shown);
    text.subjects_ = subjects;
    return text;
}

Text Text::listed(const std::string& before, const std::vector<int>& vertices)
{
    Text text;
    text.pieces_.push_back({before, vertices, {}, count_of(vertices)});
    return text;
}

Text Text::counted(const std::vector<int>& vertices)
{
    Text text;
    text.pieces_.push_back({count_of(vertices) + " (", vertices, ")", count_of(vertices)});
    return text;
}

Text Text::shortened(const std::string& full, const std::string& brief)
{
    Text text(full);
    text.pieces_.front().brief = brief;
    return text;
}

Text& Text::operator+=(const Text& more)
{
    const Text added = more;  // `more` may be this object
    pieces_.insert(pieces_.end(), added.pieces_.begin(), added.pieces_.end());
    for (const Subject& subject : added.subjects_)
        if (std::find(subjects_.begin(), subjects_.end(), subject) == subjects_.end())
            subjects_.push_back(subject);
    return *this;
}

std::string Text::full(const std::vector<int>& ids) const
{
    std::string text;
    for (const Piece& piece : pieces_)
    {
        std::vector<int> numbered = piece.vertices;
        for (int& vertex : numbered)
            if (static_cast<std::size_t>(vertex) < ids.size())
                vertex = ids[static_cast<std::size_t>(vertex)];
        text += piece.before + list_ids(numbered) + piece.after;
    }
    return text;
}

std::string Text::brief() const
{
    std::string text;
    for (const Piece& piece : pieces_)
        text += piece.brief;
    return text;
}

std::vector<int> Text::vertices() const
{
    std::vector<int> found;
    for (const Piece& piece : pieces_)
        found.insert(found.end(), piece.vertices.begin(), piece.vertices.end());
    return found;
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
