// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>

namespace sheetmorph
{

//! Reports how far a long computation is, and lets the user cancel it. A default-constructed
//! Progress reports to nobody.
class Progress
{
public:
    //! Receives a fraction in [0, 1] and the current task; returns false to cancel.
    using Callback = std::function<bool(double fraction, const std::string& task)>;

    Progress() = default;
    explicit Progress(Callback callback) : callback_(std::move(callback)) {}

    //! \throws Cancelled if the callback returns false
    void report(double fraction, const std::string& task) const;

    //! The progress of a sub-task, which covers the range from `begin` to `end` of this one.
    Progress part(double begin, double end) const;

private:
    Callback callback_;
    double begin_ = 0.0;
    double end_ = 1.0;
};

}  // namespace sheetmorph
