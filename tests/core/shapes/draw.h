// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <random>
#include <vector>

namespace sheetmorph::shapes
{

//! Whatever a test draws at random, the same every time.
class Draw
{
public:
    explicit Draw(unsigned seed) : bits_(seed) {}

    double number(double low, double high)
    {
        return low
               + (high - low) * static_cast<double>(bits_())
                     / static_cast<double>(std::mt19937::max());
    }

    //! 0 to count - 1.
    int whole(int count) { return static_cast<int>(bits_() % static_cast<unsigned>(count)); }

    bool happens(double share) { return number(0.0, 1.0) < share; }

    template <typename Value>
    Value one_of(const std::vector<Value>& values)
    {
        return values[static_cast<std::size_t>(whole(static_cast<int>(values.size())))];
    }

    Vector3 within(double radius)
    {
        Vector3 point;
        do
            for (int c = 0; c < 3; ++c)
                point(c) = number(-1.0, 1.0);
        while (point.squaredNorm() > 1.0);
        return radius * point;
    }

private:
    std::mt19937 bits_;
};

}  // namespace sheetmorph::shapes
