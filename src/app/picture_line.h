// Pictures drawn, encoded and written on threads of their own while the simulation goes on. The queue between
// the two is short: memory stays bounded, and whichever is slower sets the pace. One thread draws; where the
// queue fills up, others come to its help, each with a renderer of its own and a whole picture at a time.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/frame_name.h"
#include "app/picture_maker.h"

namespace drape {

// CPU seconds of the drawing threads.
struct PictureTimes {
    double render = 0, encode = 0, write = 0;
};

class PictureLine {
public:
    using TakeInOrder = std::function<void(int frame, const Image& picture)>;

    // Pictures go to `folder`, drawn by `most_threads` at most, and one at a time, in the order of their
    // frames, to `take_in_order` if there is one. Throws what making the renderer throws.
    PictureLine(DrawnScene scene, std::string folder, int most_threads, TakeInOrder take_in_order = {});
    ~PictureLine();  // what was added is written first
    PictureLine(const PictureLine&) = delete;
    PictureLine& operator=(const PictureLine&) = delete;

    // Waits while the queue is full. Throws the error that a picture before this one met. Frames follow each
    // other without a gap.
    void add(int frame, FrameInput input);
    // Waits until all is written, or throws the error met; from then on times() is up to date.
    void drain();
    // Of the files' bytes: those of frame 1, 2, ... up to the first that is not written yet, "" before the
    // first added.
    std::vector<std::string> hashes();
    const PictureTimes& times() const { return times_; }
    const std::string& renderer() const { return renderer_; }

private:
    struct Job {
        int frame;
        FrameInput input;
    };

    void start_thread();
    void work();
    bool take(Job& job);
    PictureTimes make_picture(Renderer& renderer, const Job& job);
    void note_hash(size_t frame, std::string hash);
    void hand_over(int frame, const Image& picture);

    const DrawnScene scene_;
    const std::string folder_;
    const size_t most_threads_;
    const TakeInOrder take_in_order_;
    int turn_ = 0;  // the frame that is to be taken next; 0: none was added
    std::string renderer_;
    PictureTimes times_;
    std::vector<std::string> hashes_;  // of frame 1, 2, ...
    size_t first_ = 0;                 // frame added; 0: none was
    std::mutex lock_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    int busy_ = 0;  // threads making a renderer or a picture
    bool closed_ = false;
    std::exception_ptr failure_;
    std::vector<std::thread> threads_;  // each makes, uses and ends its renderer, whose context belongs to it
};

}  // namespace drape
