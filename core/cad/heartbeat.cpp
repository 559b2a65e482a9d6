// SPDX-License-Identifier: LGPL-2.1-or-later
#include "heartbeat.h"
#include "answer.h"

#include <chrono>

namespace sheetmorph::cad_worker
{

namespace
{

std::string progress(double fraction, const std::string& task)
{
    Answer answer;
    answer.open('{').key("progress").open('[').value(fraction).value(task).close(']').close('}');
    return answer.json();
}

}  // namespace

Heartbeat::Heartbeat(Pipe& pipe)
    : pipe_(pipe), last_(progress(0.0, "starting")), thread_([this] { beat(); })
{
}

Heartbeat::~Heartbeat()
{
    {
        const std::lock_guard lock(mutex_);
        is_ended_ = true;
    }
    ended_.notify_one();
    thread_.join();
}

void Heartbeat::report(double fraction, const std::string& task)
{
    const std::lock_guard lock(mutex_);
    last_ = progress(fraction, task);
    pipe_.send(last_);
}

void Heartbeat::beat()
{
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, std::chrono::milliseconds(100), [this] { return is_ended_; }))
        pipe_.send(last_);
}

}  // namespace sheetmorph::cad_worker
