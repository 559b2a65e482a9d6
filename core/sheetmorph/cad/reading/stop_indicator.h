// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/threads/stopping.h"

#include <Message_ProgressIndicator.hxx>

namespace sheetmorph::cad
{

//! Cancels an OpenCASCADE call that takes a progress range. Its result is then incomplete. Call
//! look_for_stop() afterwards, which throws.
class StopIndicator : public Message_ProgressIndicator
{
protected:
    Standard_Boolean UserBreak() override
    {
        try
        {
            look_for_stop();
            return Standard_False;
        }
        catch (...)
        {
            return Standard_True;  // the signal keeps the exception
        }
    }
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {}
};

}  // namespace sheetmorph::cad
