#include "app/picture_line.h"

#include <cstdio>
#include <utility>

#include "app/picture_maker.h"
#include "base/timer.h"
#include "io/png.h"
#include "io/write_file.h"

namespace drape {

namespace {

constexpr std::size_t longest_queue = 2;

}  // namespace

PictureLine::PictureLine(const SceneDescription& scene, const Simulation& simulation, std::string folder)
    : folder_(std::move(folder)), thread_([&] { work(scene, simulation); }) {
    try {
        drain();  // until the renderer is made: the scene and the simulation are not the thread's from then
                  // on
    } catch (...) {
        thread_.join();
        throw;
    }
}

PictureLine::~PictureLine() {
    {
        const std::scoped_lock hold(lock_);
        closed_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void PictureLine::add(int frame, FrameInput input) {
    std::unique_lock hold(lock_);
    changed_.wait(hold, [&] { return failure_ || waiting_.size() < longest_queue; });
    if (failure_) std::rethrow_exception(failure_);
    waiting_.push_back({frame, std::move(input)});
    changed_.notify_all();
}

void PictureLine::drain() {
    std::unique_lock hold(lock_);
    changed_.wait(hold, [&] { return failure_ || (waiting_.empty() && !busy_); });
    if (failure_) std::rethrow_exception(failure_);
}

// The next job; false when there will be none.
bool PictureLine::take(Job& job) {
    std::unique_lock hold(lock_);
    busy_ = false;
    changed_.notify_all();
    changed_.wait(hold, [&] { return closed_ || !waiting_.empty(); });
    if (waiting_.empty()) return false;
    job = std::move(waiting_.front());
    waiting_.pop_front();
    busy_ = true;
    changed_.notify_all();
    return true;
}

void PictureLine::work(const SceneDescription& scene, const Simulation& simulation) try {
    const auto timed = [](double& total, auto run) {
        const ThreadCpuScope timer(total);
        return run();
    };
    PictureMaker maker = timed(times_.render, [&] { return PictureMaker(scene, simulation); });
    renderer_ = maker.renderer();
    Job job;
    while (take(job)) {
        const Image image = timed(times_.render, [&] { return maker.draw(job.input); });
        const auto png = timed(times_.encode, [&] { return encode_png(image); });
        char name[32];
        std::snprintf(name, sizeof name, "/frame_%04d.png", job.frame);
        timed(times_.write, [&] { write_file(folder_ + name, png); });
    }
} catch (...) {
    const std::scoped_lock hold(lock_);
    failure_ = std::current_exception();
    changed_.notify_all();
}

}  // namespace drape
