// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

namespace sheetmorph::cad
{

//! While it lives, memory that is reached for in vain (damaged files make OpenCASCADE follow null
//! pointers and endless circles; it may be our own fault, too) raises an OSD_Signal where
//! OCC_CATCH_SIGNALS stands in the same thread, instead of ending the process. Any number may live,
//! in any threads; afterwards signals are handled as before. What the user sends (Ctrl+C) stays
//! with who handles it.
class CaughtSignals
{
public:
    CaughtSignals();
    ~CaughtSignals();
    CaughtSignals(const CaughtSignals&) = delete;
    CaughtSignals& operator=(const CaughtSignals&) = delete;

private:
    class OwnStack;  // a stack that overflowed has no room for who handles that

    std::unique_ptr<OwnStack> stack_;
};

}  // namespace sheetmorph::cad
