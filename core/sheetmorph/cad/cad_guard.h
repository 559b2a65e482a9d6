// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Debian's OpenCASCADE is built so: it turns signals into exceptions where it is asked to.
#ifndef OCC_CONVERT_SIGNALS
#define OCC_CONVERT_SIGNALS
#endif

#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/caught_signals.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <OSD_Signal.hxx>
#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>
#include <string>

namespace sheetmorph::cad
{

//! While it lives, OpenCASCADE does not tell the console what it does; nobody asked.
class Silence
{
public:
    Silence() : kept_(Message::DefaultMessenger()->Printers())
    {
        Message::DefaultMessenger()->ChangePrinters().Clear();
    }
    ~Silence() { Message::DefaultMessenger()->ChangePrinters() = kept_; }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

private:
    Message_SequenceOfPrinters kept_;
};

//! Does work of OpenCASCADE in silence; what it throws becomes an InvalidInput with these words
//! around its own. So does memory that is reached for in vain, which may be our own fault as well
//! as OpenCASCADE's, and says so: what was held then is lost.
template <typename Work>
auto guarded(const std::string& what, const std::string& todo, Work&& work)
{
    const Silence silence;
    const CaughtSignals caught;
    try
    {
        OCC_CATCH_SIGNALS
        return work();
    }
    catch (const Standard_Failure& failure)
    {
        const char* text = failure.GetMessageString();
        const bool is_signal = failure.DynamicType()->SubType(STANDARD_TYPE(OSD_Signal));
        throw InvalidInput(what + " (" + (text && *text ? text : failure.DynamicType()->Name())
                           + (is_signal ? ": a fault of OpenCASCADE or of SheetMorph" : "") + "); "
                           + todo);
    }
}

}  // namespace sheetmorph::cad
