#include "app/run_pictures.h"

#include <filesystem>

#include "app/frame_video.h"
#include "app/leftovers.h"
#include "app/picture_line.h"
#include "app/picture_maker.h"
#include "io/write_file.h"

namespace drape {

namespace {

class PicturesAndVideo final : public RunPictures {
public:
    PicturesAndVideo(const SceneDescription& scene, const Delivery& delivery, const RunOptions& options,
                     const std::string& out, const std::array<int, 2>& drawn, int threads)
        : overlay_(scene.look.overlay), first_(drawn[0]) {
        PictureLine::TakeInOrder take_in_order;
        if (!options.video.empty()) {
            begin_video(options.video, out, drawn,
                        {scene.look.size[0], scene.look.size[1], scene.frame_rate});
            take_in_order = [this](int frame, const Image& picture) { video_->add(frame, picture); };
        }
        line_ = std::make_unique<PictureLine>(drawn_scene(scene, delivery.simulation()), out, threads,
                                              take_in_order);
    }

    void add(int frame, const Delivery& delivery) override {
        if (frame < first_) return;
        line_->add(frame,
                   frame_input(overlay_, delivery.simulation(), delivery.state(), delivery.vertex_error()));
    }

    void drain() override { line_->drain(); }

    std::vector<std::string> hashes() override { return line_->hashes(); }

    void finish(bool complete, RunReport& report) override {
        line_->drain();
        report.times.render = line_->times().render;
        report.times.encode = line_->times().encode;
        report.times.write += line_->times().write;
        report.renderer = line_->renderer();
        if (!video_ || !complete) return;
        video_->finish();
        report.times.video = video_->cpu_seconds();
    }

private:
    void begin_video(const std::string& path, const std::string& out, const std::array<int, 2>& drawn,
                     const Canvas& canvas) {
        const std::filesystem::path file(path);
        if (file.has_parent_path()) make_folder(file.parent_path().string());
        remove_leftovers(file.has_parent_path() ? file.parent_path().string() : ".",
                         file.filename().string());
        video_ = std::make_unique<FrameVideo>(path, out, drawn[0], drawn[1], canvas);
    }

    std::string overlay_;
    int first_;
    std::unique_ptr<FrameVideo> video_;
    std::unique_ptr<PictureLine> line_;  // ends before what it draws, and what it hands on to
};

}  // namespace

std::unique_ptr<RunPictures> make_run_pictures(const SceneDescription& scene, const Delivery& delivery,
                                               const RunOptions& options, const std::string& out,
                                               const std::array<int, 2>& drawn, int threads) {
    return std::make_unique<PicturesAndVideo>(scene, delivery, options, out, drawn, threads);
}

}  // namespace drape
