#include "app/run_caches.h"

#include <filesystem>

#include "app/leftovers.h"
#include "base/error.h"
#include "io/write_file.h"

namespace drape {

RunCaches::RunCaches(const std::string& path, const Model& model, const std::vector<Colour>& colours,
                     double frame_rate, int frames, const std::string& kept, const Points& start, int done)
    : kept_(kept, start.cols(), done) {
    const std::filesystem::path cache(path);
    if (cache.has_parent_path()) make_folder(cache.parent_path().string());
    remove_leftovers(cache.has_parent_path() ? cache.parent_path().string() : ".", cache.stem().string());
    for (size_t c = 0; c < model.cloths.size(); ++c) {
        const Cloth& cloth = model.cloths[c];
        std::filesystem::path file = cache;
        if (model.cloths.size() > 1)
            file.replace_filename(cat(cache.stem().string(), "_cloth", c + 1, cache.extension().string()));
        parts_.push_back({cloth.first, cloth.vertices(),
                          make_cache_writer(file.string(), cloth.mesh, frame_rate, frames + 1, colours[c])});
    }
    add_to_writers(start);
    for (int frame = 1; frame <= done; ++frame) add_to_writers(kept_.read(frame));
}

void RunCaches::add(const Points& positions) {
    kept_.add(positions);
    add_to_writers(positions);
}

void RunCaches::flush() {
    kept_.flush();
}

void RunCaches::finish() {
    for (const Part& part : parts_) part.writer->finish();
}

void RunCaches::add_to_writers(const Points& positions) {
    for (const Part& part : parts_) part.writer->add(positions.middleCols(part.first, part.vertices));
}

}  // namespace drape
