// Pictures drawn, encoded and written on a thread of their own while the simulation goes on. The queue
// between the two is short: memory stays bounded, and whichever is slower sets the pace.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "render/picture.h"
#include "scene/description.h"
#include "simulate/simulation.h"

namespace drape {

// CPU seconds of the drawing thread.
struct PictureTimes {
    double render = 0, encode = 0, write = 0;
};

class PictureLine {
public:
    // Pictures go to `folder`. Throws what making the renderer throws.
    PictureLine(const SceneDescription& scene, const Simulation& simulation, std::string folder);
    ~PictureLine();  // what was added is written first
    PictureLine(const PictureLine&) = delete;
    PictureLine& operator=(const PictureLine&) = delete;

    // Waits while the queue is full. Throws the error that a picture before this one met.
    void add(int frame, FrameInput input);
    // Waits until all is written, or throws the error met; from then on times() is up to date.
    void drain();
    const PictureTimes& times() const { return times_; }
    const std::string& renderer() const { return renderer_; }

private:
    struct Job {
        int frame;
        FrameInput input;
    };

    void work(const SceneDescription& scene, const Simulation& simulation);
    bool take(Job& job);

    std::string folder_, renderer_;
    PictureTimes times_;
    std::mutex lock_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    bool busy_ = true, closed_ = false;  // busy from the start: the renderer is being made
    std::exception_ptr failure_;
    std::thread thread_;  // makes, uses and ends the renderer, whose context belongs to one thread
};

}  // namespace drape
