// SPDX-License-Identifier: LGPL-2.1-or-later
#include "answer.h"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace sheetmorph::cad_worker
{

void Answer::separate()
{
    if (!json_.empty() && json_.back() != '[' && json_.back() != '{' && json_.back() != ':')
        json_ += ',';
}

Answer& Answer::open(char bracket)
{
    separate();
    json_ += bracket;
    return *this;
}

Answer& Answer::close(char bracket)
{
    json_ += bracket;
    return *this;
}

Answer& Answer::key(std::string_view name)
{
    value(name);
    json_ += ':';
    return *this;
}

Answer& Answer::value(double number)
{
    separate();
    if (std::isnan(number))
        json_ += "NaN";  // a word that Python's json reads, like Infinity
    else if (std::isinf(number))
        json_ += number > 0.0 ? "Infinity" : "-Infinity";
    else
    {
        char text[32];
        std::snprintf(text, sizeof text, "%.17g", number);
        json_ += text;
        if (std::strpbrk(text, ".e") == nullptr)
            json_ += ".0";  // or Python takes it for an integer
    }
    return *this;
}

Answer& Answer::value(int number)
{
    separate();
    json_ += std::to_string(number);
    return *this;
}

Answer& Answer::value(bool is_true)
{
    separate();
    json_ += is_true ? "true" : "false";
    return *this;
}

Answer& Answer::value(std::string_view text)
{
    separate();
    json_ += '"';
    for (const char letter : text)
    {
        char escaped[8] = {letter, '\0'};
        if (letter == '"' || letter == '\\')
            std::snprintf(escaped, sizeof escaped, "\\%c", letter);
        else if (static_cast<unsigned char>(letter) < 0x20)
            std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned>(letter));
        json_ += escaped;
    }
    json_ += '"';
    return *this;
}

Answer& Answer::null()
{
    separate();
    json_ += "null";
    return *this;
}

Answer& Answer::array(const double* numbers, std::size_t rows, std::size_t columns)
{
    place("f8", {rows, columns});
    data_.append(reinterpret_cast<const char*>(numbers), rows * columns * sizeof(double));
    return *this;
}

Answer& Answer::array(const int* numbers, std::size_t rows, std::size_t columns)
{
    place("i4", {rows, columns});
    data_.append(reinterpret_cast<const char*>(numbers), rows * columns * sizeof(int));
    return *this;
}

Answer& Answer::array(const std::vector<int>& numbers)
{
    place("i4", {numbers.size()});
    data_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(int));
    return *this;
}

Answer& Answer::place(std::string_view type, std::vector<std::size_t> shape)
{
    data_.resize((data_.size() + 7) / 8 * 8, '\0');  // numpy wants its numbers aligned
    open('{').key("at");
    json_ += std::to_string(data_.size());
    key("type").value(type).key("shape").open('[');
    for (const std::size_t one : shape)
    {
        separate();
        json_ += std::to_string(one);
    }
    return close(']').close('}');
}

}  // namespace sheetmorph::cad_worker
