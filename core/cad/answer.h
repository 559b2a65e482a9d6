// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sheetmorph::cad_worker
{

//! Writes JSON, one call after the other. Arrays of numbers go into the data beside it; the JSON
//! says where: {"at": byte, "type": "f8" or "i4", "shape": [rows, columns]}.
class Answer
{
public:
    Answer& open(char bracket);
    Answer& close(char bracket);
    Answer& key(std::string_view name);

    Answer& value(double number);
    Answer& value(int number);
    Answer& value(bool is_true);
    Answer& value(std::string_view text);
    Answer& value(const char* text) { return value(std::string_view(text)); }
    Answer& null();

    //! A list of values.
    template <typename Value>
    Answer& list(const std::vector<Value>& values)
    {
        open('[');
        for (const Value& one : values)
            value(one);
        return close(']');
    }

    //! An array whose rows lie one after the other.
    Answer& array(const double* numbers, std::size_t rows, std::size_t columns);
    Answer& array(const int* numbers, std::size_t rows, std::size_t columns);
    Answer& array(const std::vector<int>& numbers);

    //! Adds bytes to the data that the JSON does not mention.
    void add_data(const std::string& bytes) { data_ += bytes; }

    const std::string& json() const { return json_; }
    const std::string& data() const { return data_; }

private:
    void separate();
    Answer& place(std::string_view type, std::vector<std::size_t> shape);

    std::string json_;
    std::string data_;
};

}  // namespace sheetmorph::cad_worker
