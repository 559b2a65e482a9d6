// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/progress.h"

#include "sheetmorph/base/errors.h"

namespace sheetmorph
{

void Progress::report(double fraction, const std::string& task) const
{
    if (callback_ && !callback_(begin_ + fraction * (end_ - begin_), task))
        throw Cancelled();
}

Progress Progress::part(double begin, double end) const
{
    Progress stretch(*this);
    stretch.begin_ = begin_ + begin * (end_ - begin_);
    stretch.end_ = begin_ + end * (end_ - begin_);
    return stretch;
}

}  // namespace sheetmorph
