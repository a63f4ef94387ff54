// render and simulate: scene -> simulation -> frames -> pictures, cache, report.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "app/described_scene.h"
#include "app/interrupt.h"
#include "app/leftovers.h"
#include "app/progress.h"
#include "app/replay.h"
#include "app/resume.h"
#include "app/run_caches.h"
#include "app/run_pictures.h"
#include "app/untangle_start.h"
#include "app/verbs.h"
#include "app/verification.h"
#include "app/version.h"
#include "base/plain_line.h"
#include "io/write_file.h"
#include "picture/palette.h"
#include "report/report.h"
#include "scene/builder.h"
#include "scene/predicted_memory.h"
#include "toml/value.h"

namespace drape {

namespace {

namespace fs = std::filesystem;

int threads_of(const RunOptions& options) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    return options.threads > 0 ? options.threads : static_cast<int>(cores);
}

std::vector<Colour> front_colours(const SceneDescription& scene) {
    std::vector<Colour> colours;
    for (size_t c = 0; c < scene.cloths.size(); ++c)
        colours.push_back(scene.cloths[c].colours.front.value_or(cloth_palette(static_cast<int>(c)).front));
    return colours;
}

// One run from scene to report, step by step.
class Run {
public:
    explicit Run(const RunOptions& options);
    Exit go();

private:
    void demand_memory() const;
    DeliveryOptions delivery_options() const;
    void replay(Setup& setup, DeliveryOptions& wanted);
    void compare_with_replayed(const FrameReport& frame);
    void deliver(const FrameReport& frame);
    bool keep_going(double& unsaved);
    void demand_what_was_asked() const;
    void prepare_folder();
    void resume();
    void verify(const FrameReport& frame);
    void verify_pictures(bool all);
    void add_output_stages();
    std::vector<std::string> picture_hashes();
    SolverWork solver_work() const;
    void save_checkpoint();
    void finish(bool complete);

    RunOptions options_;
    WallTimer wall_;
    RunReport report_;
    SceneDescription scene_;
    Checkpoint identity_;  // no more of it than tells one run from another
    SolverWork solved_before_;
    std::vector<std::string> pictures_before_;  // hashes of those of the run that this one goes on from
    std::string out_;
    std::array<int, 2> drawn_{};  // first and last frame to draw
    std::unique_ptr<Delivery> delivery_;
    std::vector<std::string> replayed_hashes_;  // of every frame
    std::optional<Verification> verification_;
    std::optional<RunCaches> caches_;
    std::unique_ptr<RunPictures> pictures_;  // ends before what it draws
};

Run::Run(const RunOptions& options) : options_(options), scene_(described_scene(options)) {
    const int frames = scene_.frames();
    drawn_ = options.frames.value_or(std::array{1, frames});
    if (drawn_[0] < 1 || drawn_[1] < drawn_[0] || drawn_[1] > frames)
        throw Error(cat("--frames ", drawn_[0], ":", drawn_[1], ": the scene has frames 1:", frames));
    out_ = options.out.empty() ? "renders/" + fs::path(options.scene).stem().string() : options.out;
    demand_memory();
    report_.scene = scene_.name;
    report_.version = version;
    {
        const CpuScope timer(report_.times.build);
        Built built = build_scene(scene_);
        report_.times.load = built.load_seconds;
        report_.notes = built.notes;
        DeliveryOptions wanted = delivery_options();
        if (!options.replay.empty()) replay(built.setup, wanted);
        built.setup.stop = interrupted_for_seconds;
        if (options.untangle) untangle_start(built.setup, report_.notes);
        identify(identity_, scene_, built.setup.method, wanted.replay);
        delivery_ = make_delivery(std::move(built.setup), wanted);
    }
    report_.times.build -= report_.times.load;
    const Simulation& simulation = delivery_->simulation();
    if (simulation.lifted() > 0)
        report_.notes.push_back(cat("cloth started within an obstacle's contact thickness: moved out by ",
                                    simulation.lifted(), " m"));
    report_.plan = simulation.plan();
    report_.start = simulation.energies();
    if (!options.verify_hashes.empty()) verification_.emplace(options.verify_hashes, scene_.name, drawn_[1]);
#ifdef DRAPE_WITH_RENDER
    // the room the cloth moves in is judged from its start, wherever a resumed run goes on
    if (options.pictures)
        pictures_ = make_run_pictures(scene_, *delivery_, options, out_, drawn_, threads_of(options));
#endif
    prepare_folder();
    const Points start = delivery_->state().x;
    if (options.resume) resume();  // ends the simulation there was
    if (!options.cache.empty())
        caches_.emplace(options.cache, delivery_->simulation().model(), front_colours(scene_),
                        scene_.frame_rate, drawn_[1], kept_positions_of(out_), start, delivery_->frame());
}

// Told before anything is built, for what is not there is taken from other programs first.
void Run::demand_memory() const {
    RunExtent extent{drawn_[1], options_.estimate || scene_.accuracy.tolerance, 0};
    if (options_.pictures) extent.drawing = std::min(threads_of(options_), 2);
    const double wanted = predicted_memory(scene_, extent), there = free_memory();
    if (wanted > there)
        throw Error(cat(options_.scene, ": needs about ", std::round(wanted / 1e8) / 10, " GB of memory, ",
                        std::round(there / 1e8) / 10, " GB are free (fewer divisions, or --no-estimate)"));
}

DeliveryOptions Run::delivery_options() const {
    DeliveryOptions wanted{.tolerance = scene_.accuracy.tolerance,
                           .estimate = options_.estimate,
                           .threads = threads_of(options_),
                           .frames = drawn_[1]};
    if (scene_.accuracy.budget) wanted.budget = {*scene_.accuracy.budget, [this] { return wall_.seconds(); }};
    return wanted;
}

void Run::replay(Setup& setup, DeliveryOptions& wanted) {
    const Replay earlier = read_replay(options_.replay);
    if (earlier.scene != scene_.name)
        throw Error(cat(options_.replay, ": is of the scene ", in_quotes(earlier.scene), ", not of ",
                        in_quotes(scene_.name)));
    if (earlier.steps.size() < static_cast<size_t>(drawn_[1]))
        throw Error(cat(options_.replay, ": has ", earlier.steps.size(), " frames, this run ", drawn_[1]));
    setup.method = earlier.method;
    setup.because = cat("replayed from ", options_.replay);
    wanted.replay = earlier.steps;
    replayed_hashes_ = earlier.hashes;
}

// A replay repeats the bits; where it does not, the scene or the program is another: that is said once.
void Run::compare_with_replayed(const FrameReport& frame) {
    const auto k = static_cast<size_t>(frame.index) - 1;
    if (k >= replayed_hashes_.size() || frame.hash == replayed_hashes_[k]) return;
    report_.notes.push_back(cat("from frame ", frame.index, " on this is not the run that ", options_.replay,
                                " is of: the scene, the version or the machine differs"));
    replayed_hashes_.clear();
}

void Run::add_output_stages() {
    if (scene_.accuracy.tolerance)
        report_.plan.use("error estimate", "a tolerance: passes with more steps until it is met");
    else if (delivery_->error().passes.size() > 1)
        report_.plan.use("error estimate", "a second pass with some fewer steps");
    else
        report_.plan.leave_out("error estimate", delivery_->error().how);
    if (options_.pictures)
        report_.plan.use("pictures", cat("frames ", drawn_[0], " to ", drawn_[1]));
    else
        report_.plan.leave_out("pictures", "simulate draws none: no GL context is made");
    if (options_.video.empty())
        report_.plan.leave_out("video", "no --video asked");
    else
        report_.plan.use("video", options_.video);
    if (options_.cache.empty())
        report_.plan.leave_out("cache", "no --cache asked");
    else
        report_.plan.use("cache", options_.cache);
}

// A fresh run leaves no checkpoint of an earlier one behind, a fresh run of all frames no frame of a longer
// one.
void Run::prepare_folder() {
    make_folder(out_);
    remove_leftovers(out_);
    if (options_.resume) return;
    forget_checkpoint(out_);
    std::error_code trouble;
    if (options_.frames || !options_.pictures) return;
    for (const auto& entry : fs::directory_iterator(out_, trouble)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("frame_") && name.ends_with(".png")) fs::remove(entry.path(), trouble);
    }
}

// Goes on from the folder's checkpoint if it is one of this scene; otherwise from the start, and says so.
void Run::resume() {
    auto found = checkpoint_to_go_on_from(out_, identity_, options_, report_.notes);
    if (!found) return;
    const std::string path = checkpoint_of(out_);
    const auto last = static_cast<int>(found->frames.size());
    if (last > drawn_[1]) throw Error(cat(path, ": is of frame ", last, ", beyond --frames"));
    if (!options_.cache.empty() && !found->keeps_positions)
        throw Error(cat(path,
                        ": is of a run without a --cache, whose positions are gone (leave it out, or remove ",
                        path, " to start fresh)"));
    if (options_.pictures) demand_pictures(out_, *found, drawn_[0]);
    if (!delivery_->restore(found->passes) || delivery_->frame() != last)
        throw Error(path +
                    ": is of a run with another mesh, tolerance, estimate or number of frames (remove it to "
                    "start fresh)");
    report_.start = {0, found->start_energy};
    report_.notes.push_back(cat("resumed after frame ", last));
    report_.frames = std::move(found->frames);
    pictures_before_ = std::move(found->pictures);
    // of a tolerance's passes each counts for itself
    if (!scene_.accuracy.tolerance) solved_before_ = found->solver;
    for (const FrameReport& frame : report_.frames) {
        compare_with_replayed(frame);
        if (verification_) verification_->positions(frame);
    }
}

std::vector<std::string> Run::picture_hashes() {
    std::vector<std::string> all = pictures_before_;
    const std::vector<std::string> drawn = pictures_ ? pictures_->hashes() : std::vector<std::string>();
    for (size_t k = all.size(); k < drawn.size(); ++k) all.push_back(drawn[k]);
    return all;
}

// The first frame that differs is named, though its picture may be written long after it was simulated.
void Run::verify_pictures(bool all) {
    if (!verification_) return;
    if (pictures_ && all) pictures_->drain();
    verification_->pictures(picture_hashes());
}

// Pictures of the frames that a resumed run takes for done are written before.
void Run::save_checkpoint() {
    if (pictures_) pictures_->drain();
    const ThreadCpuScope timer(report_.times.write);
    if (caches_) caches_->flush();
    Checkpoint checkpoint = identity_;
    checkpoint.start_energy = report_.start.total();
    checkpoint.solver = solver_work();
    checkpoint.frames = report_.frames;
    checkpoint.pictures = picture_hashes();
    checkpoint.pictures.resize(report_.frames.size());
    checkpoint.keeps_positions = caches_.has_value();
    checkpoint.passes = delivery_->save();
    write_file(checkpoint_of(out_), checkpoint_bytes(checkpoint));
}

SolverWork Run::solver_work() const {
    const SolverWork now = delivery_->simulation().solver_work();
    return {solved_before_.factorisations + now.factorisations, solved_before_.iterations + now.iterations};
}

void Run::finish(bool complete) {
    if (pictures_) pictures_->finish(complete, report_);
    if (caches_) caches_->finish();
    add_output_stages();
    const Simulation& simulation = delivery_->simulation();
    for (const Cloth& cloth : simulation.model().cloths) report_.vertices += cloth.vertices();
    report_.method = &simulation.method();
    report_.chosen_because = simulation.chosen_because();
    report_.step = simulation.step();
    report_.solver = solver_work();
    report_.pictures = picture_hashes();
    report_.longest_step = simulation.longest_step();
    report_.guaranteed_step = simulation.guaranteed_step();
    report_.error = delivery_->error();
    report_.budget = scene_.accuracy.budget;
    report_.spent_before = delivery_->spent_before();
    report_.end = simulation.energies();
    report_.flow = simulation.flow();
    report_.times.contact = simulation.contact_seconds();
    report_.times.error = report_.error.seconds;
    report_.times.total = process_cpu_seconds() + report_.times.video;
    report_.times.wall = wall_.seconds();
    write_file(out_ + "/report.json", report_json(report_));
    if (complete) forget_checkpoint(out_);
    if (!options_.quiet) {
        for (const std::string& note : report_.notes)
            std::fprintf(stderr, "note: %s\n", plain_line(note).c_str());
        std::fputs(report_summary(report_).c_str(), stdout);
        if (complete && verification_) std::printf("  %s\n", verification_->summary(drawn_[1]).c_str());
        std::printf("  %s\n", out_.c_str());
        if (complete && !options_.video.empty()) std::printf("  %s\n", options_.video.c_str());
    }
}

// What is due after a frame of work: a checkpoint, or the end because the user asked for it.
bool Run::keep_going(double& unsaved) {
    if (interrupted() && delivery_->frame() < drawn_[1]) {
        save_checkpoint();
        return false;
    }
    if (unsaved >= options_.checkpoint_every) {
        save_checkpoint();
        unsaved = 0;
    }
    return true;
}

void Run::deliver(const FrameReport& frame) {
    if (!frame.trouble.empty()) {
        save_checkpoint();
        finish(false);
        throw Error(cat(options_.scene, ": frame ", frame.index, ": ", frame.trouble), Exit::went_wrong);
    }
    report_.times.simulate += frame.cpu_seconds;
    report_.frames.push_back(frame);
    compare_with_replayed(frame);
    verify(frame);
    if (pictures_) pictures_->add(frame.index, *delivery_);
    if (caches_) caches_->add(delivery_->state().x);
}

void Run::verify(const FrameReport& frame) {
    if (!verification_) return;
    verify_pictures(false);
    try {
        verification_->positions(frame);
    } catch (const Error&) {
        verify_pictures(true);  // of the frames before
        throw;
    }
}

void Run::demand_what_was_asked() const {
    const ErrorAccount& error = report_.error;
    if (error.reached == false)
        throw Error(cat(options_.scene, ": the tolerance of ", *error.asked,
                        " m was not reached: refining stopped helping (--strict)"),
                    Exit::went_wrong);
    if (!error.met())
        throw Error(
            cat(options_.scene, ": the tolerance of ", *error.asked,
                " m lies below the predictability floor from t = ", error.floor_from, " s on (--strict)"),
            Exit::went_wrong);
    if (!report_.budget_kept())
        throw Error(cat(options_.scene, ": took ", report_.spent(), " s of a budget of ", *report_.budget,
                        " s: its shortest way takes longer (--strict)"),
                    Exit::went_wrong);
}

Exit Run::go() {
    double unsaved = 0;  // CPU seconds since the last checkpoint
    {
        Progress progress(delivery_->frame() + 1, drawn_[1], options_.quiet);
        while (delivery_->frame() < drawn_[1]) {
            const double before = process_cpu_seconds();
            if (const std::optional<FrameReport> frame = delivery_->advance()) {
                deliver(*frame);
                progress.frame_done(*frame);
            } else {
                progress.pass_frame_done(delivery_->progress());
            }
            unsaved += process_cpu_seconds() - before;
            if (!keep_going(unsaved)) {
                finish(false);
                return Exit::interrupted;
            }
        }
    }
    verify_pictures(true);
    finish(true);
    if (options_.strict) demand_what_was_asked();
    return Exit::done;
}

}  // namespace

Exit run_scene(const RunOptions& options) {
#ifndef DRAPE_WITH_RENDER
    if (options.pictures)
        throw Error(
            "this drape was built without a renderer (use `drape simulate`, or build with DRAPE_RENDER=ON)");
#endif
    // before a folder tells others that the run has begun
    catch_interrupts();
    // Mesa's rasteriser draws on the thread that asks it to, whose CPU time is then what the pictures cost;
    // where they lag behind the simulation, several threads draw one each
    setenv("LP_NUM_THREADS", "0", 1);
    return Run(options).go();
}

}  // namespace drape
