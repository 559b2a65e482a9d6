// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "pipe.h"

#include <condition_variable>
#include <string>
#include <thread>

namespace sheetmorph::cad_worker
{

//! Sends the progress of a request ten times a second, even while OpenCASCADE reports none. So the
//! other process can stop this one at any moment, and this one ends when nobody reads any more.
class Heartbeat
{
public:
    explicit Heartbeat(Pipe& pipe);
    ~Heartbeat();
    Heartbeat(const Heartbeat&) = delete;
    Heartbeat& operator=(const Heartbeat&) = delete;

    //! Sends it at once.
    void report(double fraction, const std::string& task);

private:
    void beat();

    Pipe& pipe_;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool is_ended_ = false;
    std::string last_;
    std::thread thread_;
};

}  // namespace sheetmorph::cad_worker
