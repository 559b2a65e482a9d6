// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/live_drag.h"

#include "sheetmorph/assembly/session/drag_samples.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/freed_memory.h"
#include "sheetmorph/base/threads/stopping.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace sheetmorph::assembly
{

namespace
{

// Frames whose memory is kept for further ones. From the pipeline: one is shown, one is on its way
// to the screen, one is computed.
constexpr std::size_t frames_kept = 3;

// The first frame has all cores, unless it does not come because the user holds the button still.
// From usability (Nielsen 1993): 0.1 s still feels immediate.
constexpr std::chrono::milliseconds longest_wait(100);

constexpr std::chrono::milliseconds between_looks(100);  // from longest_wait

std::string words_of(const std::exception_ptr& failure)
{
    try
    {
        std::rethrow_exception(failure);
    }
    catch (const std::bad_alloc&)
    {
        return "not enough memory";
    }
    catch (const std::exception& error)
    {
        return error.what();
    }
    catch (...)
    {
        return "unknown error";
    }
}

int vertices_of(const Assembly& assembly)
{
    int count = 0;
    for (const Part& part : assembly.parts)
        count += part.mesh.vertex_count();
    return count;
}

}  // namespace

//! Builds responses sheet by sheet on a thread of its own.
class LiveDrag::Background
{
public:
    Background(const PreparedAssembly& prepared, std::set<std::string> dragged, const Pose& start,
               const DragOptions& options)
        : prepared_(prepared), told_(options.progress), responses_(prepared.deformers.size())
    {
        const bool learns = vertices_of(prepared.assembly) >= options.least_to_learn;
        thread_ = std::thread([this, learns, dragged = std::move(dragged), start]
                              { build(learns, dragged, start); });
    }

    ~Background()
    {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            is_stopped_ = true;
        }
        begun_.notify_all();
        thread_.join();
    }

    //! There is nothing more to wait for.
    void begin()
    {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            is_begun_ = true;
        }
        begun_.notify_all();
    }

    Responses ready() const
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        return responses_;
    }

    bool is_done() const
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        return is_done_;
    }

    std::string failure() const
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        return failure_ ? words_of(failure_) : "";
    }

    void wait()
    {
        begin();
        std::unique_lock<std::mutex> lock(mutex_);
        while (!finished_.wait_for(lock, between_looks, [this] { return is_done_; }))
        {
            lock.unlock();
            look_for_stop();
            lock.lock();
        }
        if (failure_)
            std::rethrow_exception(failure_);
    }

private:
    void build(bool learns, const std::set<std::string>& dragged, const Pose& start)
    {
        const Progress progress(
            [this](double fraction, const std::string& task)
            {
                told_.report(fraction, task);
                const std::lock_guard<std::mutex> lock(mutex_);
                return !is_stopped_;
            });
        wait_for_frame();
        std::exception_ptr failure;
        try
        {
            learn(learns, dragged, start, progress);
        }
        catch (const Cancelled&)
        {
            // The drag has ended.
        }
        catch (...)
        {
            failure = std::current_exception();  // frames go on by substitution
        }
        return_freed_memory();
        const std::lock_guard<std::mutex> lock(mutex_);
        failure_ = failure;
        is_done_ = true;
        finished_.notify_all();
    }

    void learn(bool passes, const std::set<std::string>& dragged, const Pose& start,
               const Progress& progress)
    {
        progress.report(0.0, "learning");
        DragSamples samples(prepared_, dragged, start, passes);
        for (const int sheet : prepared_.system.order)
            keep(sheet, samples.learn(sheet, progress));
    }

    void wait_for_frame()
    {
        std::unique_lock<std::mutex> lock(mutex_);
        begun_.wait_for(lock, longest_wait, [this] { return is_begun_ || is_stopped_; });
    }

    void keep(int sheet, std::shared_ptr<const surface::Response> built)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        responses_[at(sheet)] = std::move(built);
    }

    const PreparedAssembly& prepared_;
    const Progress told_;
    mutable std::mutex mutex_;
    std::condition_variable begun_;
    std::condition_variable finished_;
    Responses responses_;
    std::exception_ptr failure_;
    bool is_begun_ = false;
    bool is_stopped_ = false;
    bool is_done_ = false;
    std::thread thread_;
};

LiveDrag::LiveDrag(std::shared_ptr<const PreparedAssembly> prepared, std::set<std::string> handles,
                   const Pose& start, const DragOptions& options)
    : prepared_(std::move(prepared)),
      background_(std::make_unique<Background>(*prepared_, std::move(handles), start, options))
{
}

LiveDrag::~LiveDrag()
{
    frames_.clear();
    background_.reset();
    return_freed_memory();
}

// One that nobody holds, or a new one.
std::shared_ptr<Deformed> LiveDrag::unheld_frame()
{
    const auto unheld = std::find_if(frames_.begin(), frames_.end(),
                                     [](const auto& frame) { return frame.use_count() == 1; });
    if (unheld != frames_.end())
    {
        // What another thread has read of it before it let go was read before.
        std::atomic_thread_fence(std::memory_order_acquire);
        return *unheld;
    }
    if (frames_.size() == frames_kept)
        frames_.erase(frames_.begin());
    frames_.push_back(std::make_shared<Deformed>());
    return frames_.back();
}

std::shared_ptr<const Deformed> LiveDrag::frame(const Pose& pose)
{
    const Pose told = told_pose(*prepared_, pose);
    const std::lock_guard<std::mutex> lock(framing_);
    std::shared_ptr<Deformed> result = unheld_frame();
    answered_ =
        Wave(*prepared_, told, Exactness::live).run_live(background_->ready(), read_, *result);
    background_->begin();
    return result;
}

std::string LiveDrag::failure() const
{
    return background_->failure();
}

void LiveDrag::wait()
{
    background_->wait();
}

bool LiveDrag::is_ready() const
{
    return background_->is_done();
}

std::vector<char> LiveDrag::answered() const
{
    const std::lock_guard<std::mutex> lock(framing_);
    return answered_;
}

}  // namespace sheetmorph::assembly
