// SPDX-License-Identifier: LGPL-2.1-or-later
//! sheetmorph-cad: reads, meshes, carries and writes CAD files for the program that started it.
//! OpenCASCADE runs here alone, so its faults end this process and no other.

#include "heartbeat.h"
#include "pipe.h"
#include "requests.h"

#include "sheetmorph/base/errors.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <new>

namespace sheetmorph::cad_worker
{

namespace
{

//! `kind` is the name of the error in sheetmorph._core.
template <typename Error>
Answer fault_answer(const char* kind, const Error& raised)
{
    const Fault& fault = raised.fault();
    Answer answer;
    answer.open('{').key("error").value(kind).key("message").value(raised.what());
    answer.key("what").value(fault.what.full(fault.ids)).key("brief").value(fault.what.brief());
    answer.key("todo").value(fault.todo).close('}');
    return answer;
}

Answer answered(Requests& requests, const std::vector<std::string>& request, Pipe& pipe)
{
    Heartbeat heartbeat(pipe);
    const Progress progress(
        [&](double fraction, const std::string& task)
        {
            heartbeat.report(fraction, task);
            return true;
        });
    try
    {
        return requests.answer(request, progress);
    }
    catch (const InvalidInput& raised)
    {
        return fault_answer("InvalidInput", raised);
    }
    catch (const SolverError& raised)
    {
        return fault_answer("SolverError", raised);
    }
    catch (const std::bad_alloc&)
    {
        return fault_answer("InvalidInput",
                            InvalidInput("there is not enough memory", "give a longer edge"));
    }
    catch (const std::exception& raised)
    {
        return fault_answer("SolverError", SolverError(std::string(raised.what())));
    }
}

void work()
{
    std::signal(SIGINT, SIG_IGN);  // Ctrl+C is for who started this process
    // Where memory runs out, Linux ends this process and not the one that waits for it.
    std::ofstream("/proc/self/oom_score_adj") << 1000;
    Pipe pipe;
    Requests requests;
    for (auto request = pipe.next_request(); !request.empty(); request = pipe.next_request())
    {
        const Answer answer = answered(requests, request, pipe);
        pipe.send(answer.json(), answer.data());
    }
    std::_Exit(0);  // what the model holds goes with the process
}

}  // namespace

}  // namespace sheetmorph::cad_worker

int main(int count, char** arguments)
{
    if (count == 2 && std::strcmp(arguments[1], "--version") == 0)
    {
        std::cout << "sheetmorph-cad " SHEETMORPH_VERSION "\n";
        return 0;
    }
    sheetmorph::cad_worker::work();
    return 0;
}
