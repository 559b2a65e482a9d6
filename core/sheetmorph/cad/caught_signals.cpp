// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/caught_signals.h"

#include <array>
#include <csignal>
#include <mutex>
#include <vector>

#include <OSD.hxx>

namespace sheetmorph::cad
{

namespace
{

constexpr std::size_t enough = 256 * 1024;                      // bytes; OSD makes texts there
constexpr std::array all = {SIGFPE, SIGILL,  SIGBUS,  SIGSEGV,  // faults of a program
                            SIGHUP, SIGINT,  SIGQUIT, SIGPIPE,  // OSD takes some of these too
                            SIGSYS, SIGTERM, SIGALRM};

bool is_a_fault(int signal)
{
    return signal == SIGFPE || signal == SIGILL || signal == SIGBUS || signal == SIGSEGV;
}

//! What the process does with signals: changed by the first user and put back by the last.
class Actions
{
public:
    void take()
    {
        const std::lock_guard lock(mutex_);
        if (users_++ > 0)
            return;
        for (std::size_t k = 0; k < all.size(); ++k)
            sigaction(all[k], nullptr, &before_[k]);
        OSD::SetSignal(OSD_SignalMode_Set, false);
        for (std::size_t k = 0; k < all.size(); ++k)
            if (!is_a_fault(all[k]))
                sigaction(all[k], &before_[k], nullptr);
            else
                on_own_stack(all[k]);
    }

    void give_back()
    {
        const std::lock_guard lock(mutex_);
        if (--users_ == 0)
            for (std::size_t k = 0; k < all.size(); ++k)
                sigaction(all[k], &before_[k], nullptr);
    }

private:
    static void on_own_stack(int signal)
    {
        struct sigaction now = {};
        sigaction(signal, nullptr, &now);
        now.sa_flags |= SA_ONSTACK;
        sigaction(signal, &now, nullptr);
    }

    std::mutex mutex_;
    int users_ = 0;
    std::array<struct sigaction, all.size()> before_ = {};
};

Actions& actions()
{
    static Actions only;
    return only;
}

}  // namespace

class CaughtSignals::OwnStack
{
public:
    OwnStack() : room_(enough)
    {
        stack_t now = {};
        now.ss_sp = room_.data();
        now.ss_size = room_.size();
        sigaltstack(&now, &before_);
    }
    ~OwnStack() { sigaltstack(&before_, nullptr); }
    OwnStack(const OwnStack&) = delete;
    OwnStack& operator=(const OwnStack&) = delete;

private:
    std::vector<char> room_;
    stack_t before_ = {};
};

CaughtSignals::CaughtSignals() : stack_(std::make_unique<OwnStack>())
{
    actions().take();
}

CaughtSignals::~CaughtSignals()
{
    actions().give_back();
}

}  // namespace sheetmorph::cad
