// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/errors.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
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
//! around its own.
template <typename Work>
auto guarded(const std::string& what, const std::string& todo, Work&& work)
{
    const Silence silence;
    try
    {
        return work();
    }
    catch (const Standard_Failure& failure)
    {
        const char* text = failure.GetMessageString();
        throw InvalidInput(what + " (" + (text && *text ? text : failure.DynamicType()->Name())
                           + "); " + todo);
    }
}

}  // namespace sheetmorph::cad
