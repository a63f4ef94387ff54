// The position caches of a run, one for each cloth, which a run that goes on from its checkpoint makes whole.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/colour.h"
#include "cloth/model.h"
#include "io/cache_writer.h"
#include "io/kept_positions.h"

namespace drape {

class RunCaches {
public:
    // `path` as --cache has it, `colours` of every cloth. `kept` is a file for the positions of frames that
    // are not in a finished cache yet; of an earlier run it holds the first `done` frames, which come after
    // the `start`.
    RunCaches(const std::string& path, const Model& model, const std::vector<Colour>& colours,
              double frame_rate, int frames, const std::string& kept, const Points& start, int done);

    void add(const Points& positions);  // of the next frame
    void flush();                       // a checkpoint may count what was added
    void finish();

private:
    void add_to_writers(const Points& positions);

    struct Part {
        Eigen::Index first, vertices;  // of the cloth in the model
        std::unique_ptr<CacheWriter> writer;
    };
    std::vector<Part> parts_;
    KeptPositions kept_;
};

}  // namespace drape
