// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdio>
#include <mutex>
#include <string>
#include <vector>

namespace sheetmorph::cad_worker
{

//! Connects this process with the one that started it. Both count bytes in 8 bytes of this machine.
//!
//! A request is the number of its fields, then the length and the bytes of each field. An answer is
//! the length of its JSON text, the length of its data, the text, and the data.
class Pipe
{
public:
    //! Takes stdin and stdout; whatever OpenCASCADE prints from now on goes to stderr.
    Pipe();

    //! Waits for the next request.
    //! \returns its fields; none when nobody will ask any more
    std::vector<std::string> next_request();

    //! Sends an answer. Ends this process if nobody reads it.
    void send(const std::string& json, const std::string& data = {});

private:
    bool read(void* there, std::size_t size);
    void write(const void* bytes, std::size_t size);

    std::FILE* out_;
    std::mutex sending_;
};

}  // namespace sheetmorph::cad_worker
