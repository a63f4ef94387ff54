#include "app/picture_line.h"

#include <utility>

#include "base/hash.h"
#include "base/timer.h"
#include "io/png.h"
#include "io/write_file.h"

namespace drape {

namespace {

constexpr std::size_t longest_queue = 2;

}  // namespace

PictureLine::PictureLine(DrawnScene scene, std::string folder, int most_threads, TakeInOrder take_in_order)
    : scene_(std::move(scene)),
      folder_(std::move(folder)),
      most_threads_(static_cast<size_t>(most_threads)),
      take_in_order_(std::move(take_in_order)) {
    start_thread();
    try {
        drain();
    } catch (...) {
        threads_.front().join();
        throw;
    }
}

PictureLine::~PictureLine() {
    {
        const std::scoped_lock hold(lock_);
        closed_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void PictureLine::start_thread() {
    const std::scoped_lock hold(lock_);
    threads_.emplace_back([this] { work(); });
    ++busy_;
}

void PictureLine::add(int frame, FrameInput input) {
    const auto has_room = [&] { return failure_ || waiting_.size() < longest_queue; };
    std::unique_lock hold(lock_);
    if (!has_room() && threads_.size() < most_threads_) {
        hold.unlock();
        start_thread();
        hold.lock();
    }
    changed_.wait(hold, has_room);
    if (failure_) std::rethrow_exception(failure_);
    if (turn_ == 0) {
        turn_ = frame;
        first_ = static_cast<size_t>(frame);
    }
    waiting_.push_back({frame, std::move(input)});
    changed_.notify_all();
}

void PictureLine::drain() {
    std::unique_lock hold(lock_);
    changed_.wait(hold, [&] { return failure_ || (waiting_.empty() && busy_ == 0); });
    if (failure_) std::rethrow_exception(failure_);
}

// Ends the picture or renderer in hand and waits for the next job; false when there will be none.
bool PictureLine::take(Job& job) {
    std::unique_lock hold(lock_);
    --busy_;
    changed_.notify_all();
    changed_.wait(hold, [&] { return closed_ || failure_ || !waiting_.empty(); });
    if (waiting_.empty()) return false;
    job = std::move(waiting_.front());
    waiting_.pop_front();
    ++busy_;
    changed_.notify_all();
    return true;
}

PictureTimes PictureLine::make_picture(Renderer& renderer, const Job& job) {
    PictureTimes times;
    const auto timed = [](double& total, auto run) {
        const ThreadCpuScope timer(total);
        return run();
    };
    const Image image = timed(times.render, [&] { return renderer.draw(job.input); });
    const auto png = timed(times.encode, [&] { return encode_png(image); });
    timed(times.write, [&] { write_file(folder_ + frame_name(job.frame), png); });
    note_hash(static_cast<size_t>(job.frame), hash_text(hash_bytes(png.data(), png.size())));
    if (take_in_order_) hand_over(job.frame, image);
    return times;
}

void PictureLine::note_hash(size_t frame, std::string hash) {
    const std::scoped_lock hold(lock_);
    if (hashes_.size() < frame) hashes_.resize(frame);
    hashes_[frame - 1] = std::move(hash);
}

std::vector<std::string> PictureLine::hashes() {
    const std::scoped_lock hold(lock_);
    size_t written = first_ > 0 ? first_ - 1 : 0;
    while (written < hashes_.size() && !hashes_[written].empty()) ++written;
    std::vector<std::string> all = hashes_;
    all.resize(written);
    return all;
}

// Waits for the frames before; a thread that draws one of them waits for none after it.
void PictureLine::hand_over(int frame, const Image& picture) {
    std::unique_lock hold(lock_);
    changed_.wait(hold, [&] { return failure_ || turn_ == frame; });
    if (failure_) return;
    hold.unlock();
    take_in_order_(frame, picture);
    hold.lock();
    turn_ = frame + 1;
    changed_.notify_all();
}

void PictureLine::work() try {
    const auto count = [&](const PictureTimes& times) {
        const std::scoped_lock hold(lock_);
        times_.render += times.render;
        times_.encode += times.encode;
        times_.write += times.write;
    };
    PictureTimes making;
    Renderer renderer = [&] {
        const ThreadCpuScope timer(making.render);
        return make_renderer(scene_);
    }();
    count(making);
    {
        const std::scoped_lock hold(lock_);
        renderer_ = renderer.description();
    }
    Job job;
    while (take(job)) count(make_picture(renderer, job));
} catch (...) {
    const std::scoped_lock hold(lock_);
    if (!failure_) failure_ = std::current_exception();
    waiting_.clear();  // other threads end the pictures in hand, and begin none
    changed_.notify_all();
}

}  // namespace drape
