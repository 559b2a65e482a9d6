// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/reading/step_text.h"

#include <cctype>

namespace sheetmorph::cad
{

namespace
{

bool is_digit(char c)
{
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// Whether the letter at a place is the exponent of a number, as in -1.5e-16, and not part of a
// name.
bool is_exponent(const std::string& text, std::size_t place)
{
    std::size_t begin = place;
    while (begin > 0 && (is_digit(text[begin - 1]) || text[begin - 1] == '.'))
        --begin;
    if (begin == place || !is_digit(text[begin]))
        return false;
    if (begin > 0 && (text[begin - 1] == '-' || text[begin - 1] == '+'))
        --begin;
    const char before = begin > 0 ? text[begin - 1] : ' ';
    if (before != '(' && before != ',' && before != '='
        && std::isspace(static_cast<unsigned char>(before)) == 0)
        return false;
    std::size_t end = place + 1;
    if (end < text.size() && (text[end] == '-' || text[end] == '+'))
        ++end;
    return end < text.size() && is_digit(text[end]);
}

}  // namespace

std::optional<std::string> standard_step_text(const std::string& text)
{
    std::string made;
    static const std::string mark = "\xEF\xBB\xBF";
    std::size_t copied = text.rfind(mark, 0) == 0 ? mark.size() : 0;  // `made` has the text so far
    const auto copy_to = [&](std::size_t place)
    {
        made.append(text, copied, place - copied);
        copied = place;
    };
    for (std::size_t k = 0; k < text.size(); ++k)
    {
        if (text[k] == '/' && k + 1 < text.size() && text[k + 1] == '*')
        {
            const std::size_t end = text.find("*/", k + 2);
            k = end == std::string::npos ? text.size() : end + 1;
        }
        else if (text[k] == '\'')
        {
            for (++k; k < text.size() && text[k] != '\''; ++k)
                if (text[k] == '\n' || text[k] == '\r')
                {
                    copy_to(k);
                    ++copied;
                }
        }
        else if (text[k] == 'e' && is_exponent(text, k))
        {
            copy_to(k);
            made += 'E';
            ++copied;
        }
    }
    if (copied == 0)
        return std::nullopt;
    copy_to(text.size());
    return made;
}

}  // namespace sheetmorph::cad
