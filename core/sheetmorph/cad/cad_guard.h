// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/errors.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <string>

namespace sheetmorph::cad
{

//! Silences OpenCASCADE's console messages during its lifetime.
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

//! Runs an OpenCASCADE operation silently. Its exceptions become an InvalidInput with the given
//! words around their text.
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
