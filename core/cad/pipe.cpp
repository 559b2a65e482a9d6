// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipe.h"

#include <cstdint>
#include <cstdlib>
#include <unistd.h>

namespace sheetmorph::cad_worker
{

Pipe::Pipe() : out_(fdopen(dup(STDOUT_FILENO), "wb"))
{
    if (out_ == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        std::_Exit(1);
}

std::vector<std::string> Pipe::next_request()
{
    std::uint64_t count = 0;
    if (!read(&count, sizeof count))
        return {};
    std::vector<std::string> fields(count);
    for (std::string& field : fields)
    {
        std::uint64_t length = 0;
        if (!read(&length, sizeof length))
            return {};
        field.resize(length);
        if (!read(field.data(), length))
            return {};
    }
    return fields;
}

void Pipe::send(const std::string& json, const std::string& data)
{
    const std::uint64_t lengths[] = {json.size(), data.size()};
    const std::lock_guard lock(sending_);
    write(lengths, sizeof lengths);
    write(json.data(), json.size());
    write(data.data(), data.size());
    if (std::fflush(out_) != 0)
        std::_Exit(1);
}

bool Pipe::read(void* there, std::size_t size)
{
    return std::fread(there, 1, size, stdin) == size;
}

void Pipe::write(const void* bytes, std::size_t size)
{
    if (std::fwrite(bytes, 1, size, out_) != size)
        std::_Exit(1);
}

}  // namespace sheetmorph::cad_worker
