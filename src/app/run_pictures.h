// The pictures of a run, and the video made of them.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/options.h"
#include "report/report.h"
#include "scene/description.h"
#include "simulate/delivery.h"

namespace drape {

class RunPictures {
public:
    virtual ~RunPictures() = default;
    virtual void add(int frame, const Delivery& delivery) = 0;
    // Waits until all that was added is written, or throws the error met.
    virtual void drain() = 0;
    // As PictureLine has them.
    virtual std::vector<std::string> hashes() = 0;
    // Writes what is left, and the video of a run that is complete; tells the report what it took.
    virtual void finish(bool complete, RunReport& report) = 0;
};

// Of frames drawn[0] to drawn[1], in the folder `out`, by `threads` at most. The room that the camera sees is
// judged from where the delivery stands. A program without renderer has none.
std::unique_ptr<RunPictures> make_run_pictures(const SceneDescription& scene, const Delivery& delivery,
                                               const RunOptions& options, const std::string& out,
                                               const std::array<int, 2>& drawn, int threads);

}  // namespace drape
