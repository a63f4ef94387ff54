// gallery: scenes and comparisons -> runs and looping pictures, each by another drape -> a page of them.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/child.h"
#include "app/demo_scenes.h"
#include "app/interrupt.h"
#include "app/verbs.h"
#include "app/version.h"
#include "base/hash.h"
#include "base/names.h"
#include "base/shell_word.h"
#include "gallery/catalogue.h"
#include "gallery/page.h"
#include "io/png.h"
#include "io/read_file.h"
#include "io/write_file.h"
#include "report/report.h"
#include "scene/reader.h"
#include "scene/scene_text.h"
#include "video/film.h"

namespace drape {

namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

constexpr int quick_frames = 15;
constexpr const char* most_megabytes = "1.5";  // of a looping picture
constexpr std::uint64_t largest_mesh = std::uint64_t{4} << 30;

std::string command_of(const Words& words) {
    std::string command = "drape";
    for (const std::string& word : words) command += cat(" ", shell_word(word));
    return command;
}

// A piece on its way to its pictures. Paths are from the page's folder.
class Work {
public:
    Work(Piece piece, const GalleryRequest& request, std::string out);

    // False where the user interrupts.
    bool go();
    bool is_up_to_date() const;
    const Piece& piece() const { return piece_; }
    ShownPiece shown() const;
    // Why there is no picture; "" if there is.
    const std::string& trouble() const { return trouble_; }

private:
    std::string in_page(const std::string& path) const { return out_ + "/" + path; }
    std::string run_folder(size_t pane) const;
    std::string key_file() const { return in_page("runs/" + piece_.name + ".key"); }
    Words render_words(size_t pane, const SceneDescription& scene) const;
    Words video_words() const;
    void find_key(const std::vector<SceneDescription>& scenes);
    bool run(const Words& words);
    void write_poster() const;
    void drop_frames() const;

    Piece piece_;
    const GalleryRequest& request_;
    std::string out_, title_, key_, trouble_;
    std::vector<Words> renders_;
    Words video_;
};

Work::Work(Piece piece, const GalleryRequest& request, std::string out)
    : piece_(std::move(piece)), request_(request), out_(std::move(out)), title_(piece_.title) {
    std::vector<SceneDescription> scenes;
    for (size_t i = 0; i < piece_.panes.size(); ++i) {
        scenes.push_back(in_context(
            piece_.place.text, [&] { return read_scene(scene_path(piece_.scene), piece_.panes[i].set); }));
        renders_.push_back(render_words(i, scenes.back()));
    }
    if (title_.empty()) title_ = scenes[0].name;
    video_ = video_words();
    find_key(scenes);
}

std::string Work::run_folder(size_t pane) const {
    const std::string folder = "runs/" + piece_.name;
    return piece_.panes.size() == 1 ? folder : cat(folder, "/", pane + 1);
}

Words Work::render_words(size_t pane, const SceneDescription& scene) const {
    const int part = request_.quick ? 2 : 1;
    const bool is_file = fs::path(piece_.scene).is_absolute();
    Words words{"render", is_file ? fs::path(piece_.scene).lexically_relative(out_).string() : piece_.scene};
    for (const std::string& set : piece_.panes[pane].set) words.insert(words.end(), {"--set", set});
    if (request_.quick)
        words.insert(words.end(), {"--frames", cat("1:", std::min(quick_frames, scene.frames()))});
    words.insert(words.end(), {"--size", cat(piece_.size[0] / part, "x", piece_.size[1] / part), "--out",
                               run_folder(pane)});
    return words;
}

Words Work::video_words() const {
    Words words{"video"};
    for (size_t i = 0; i < piece_.panes.size(); ++i) words.push_back(run_folder(i));
    if (piece_.panes.size() > 1) {
        words.push_back("--side-by-side");
        for (const Pane& pane : piece_.panes) words.insert(words.end(), {"--label", pane.label});
        if (piece_.columns > 0) words.insert(words.end(), {"--columns", cat(piece_.columns)});
    }
    words.insert(words.end(), {"--no-caption", "--at-most", most_megabytes, "--out", piece_.name + ".webp"});
    return words;
}

// What the pictures depend on: version, commands, scenes with all that their files say, meshes.
void Work::find_key(const std::vector<SceneDescription>& scenes) {
    std::uint64_t hash = hash_seed;
    const auto add = [&](const std::string& text) { hash = hash_bytes(text.data(), text.size() + 1, hash); };
    add(std::string(version));
    add(cat("poster ", piece_.poster.value_or(0)));
    for (const Words& words : renders_) add(command_of(words));
    add(command_of(video_));
    for (const SceneDescription& scene : scenes) {
        add(scene_text(scene));
        for (const ClothDescription& cloth : scene.cloths)
            for (const std::string& mesh : {cloth.mesh, cloth.start.mesh})
                if (!mesh.empty()) add(read_file(scene.path_to(mesh), largest_mesh));
    }
    key_ = hash_text(hash);
}

bool Work::is_up_to_date() const {
    for (const char* ending : {".webp", ".png"})
        if (!fs::exists(in_page(piece_.name + ending))) return false;
    for (size_t i = 0; i < piece_.panes.size(); ++i)
        if (!fs::exists(in_page(run_folder(i) + "/report.json"))) return false;
    return fs::exists(key_file()) && read_file(key_file(), 1 << 10) == key_;
}

bool Work::go() {
    std::error_code none;
    fs::remove(key_file(), none);
    try {
        for (Words words : renders_) {
            if (request_.threads > 0) words.insert(words.end(), {"--threads", cat(request_.threads)});
            if (!run(words)) return !interrupted();
        }
        write_poster();
        if (!run(video_)) return !interrupted();
        drop_frames();
        write_file(key_file(), key_);
    } catch (const Error& error) {
        trouble_ = error.what();
    }
    return true;
}

bool Work::run(const Words& words) {
    Words all = words;
    all.push_back("--quiet");
    const ChildEnd end = run_child(all, out_);
    if (end.code == Exit::done) return true;
    trouble_ = end.complaint.empty() ? cat(command_of(words), ": exit code ", static_cast<int>(end.code))
                                     : end.complaint;
    return false;
}

void Work::write_poster() const {
    std::vector<Take> takes;
    for (size_t i = 0; i < piece_.panes.size(); ++i) {
        Take& take = takes.emplace_back();
        take.sequence = find_sequence(in_page(run_folder(i)));
        take.label = piece_.panes[i].label;
    }
    const auto film = takes.size() > 1 ? side_by_side(std::move(takes), {piece_.columns, false})
                                       : one_after_the_other(std::move(takes));
    const int frame = std::min(piece_.poster.value_or(film->frames()), film->frames()) - 1;
    write_file(in_page(piece_.name + ".png"), encode_png(film->frame(frame)));
}

// The page has no use for them, and the commands make them again.
void Work::drop_frames() const {
    for (size_t i = 0; i < piece_.panes.size(); ++i)
        for (const std::string& file : find_sequence(in_page(run_folder(i))).files) fs::remove(file);
}

ShownPiece Work::shown() const {
    ShownPiece shown;
    shown.name = piece_.name;
    shown.title = title_;
    shown.says = piece_.says;
    shown.has_panes = piece_.panes.size() > 1;
    shown.trouble = trouble_;
    for (const Words& words : renders_) shown.commands.push_back(command_of(words));
    shown.commands.push_back(command_of(video_));
    if (!trouble_.empty()) return shown;
    shown.loop = piece_.name + ".webp";
    shown.poster = piece_.name + ".png";
    const auto [width, height] = read_png_size(in_page(shown.poster));
    shown.width = width;
    shown.height = height;
    shown.bytes = fs::file_size(in_page(shown.loop));
    for (size_t i = 0; i < piece_.panes.size(); ++i)
        shown.runs.push_back({piece_.panes[i].label, read_cost(in_page(run_folder(i) + "/report.json"))});
    return shown;
}

std::string default_catalogue() {
    const std::vector<DemoScene> scenes = demo_scenes();
    if (scenes.empty()) throw Error("gallery: drape's own scenes are not beside the program (name a FILE)");
    return (fs::path(scenes[0].path).parent_path().parent_path() / "gallery/gallery.toml").string();
}

bool is_chosen(const Piece& piece, const std::vector<std::string>& only) {
    return only.empty() || std::find(only.begin(), only.end(), piece.name) != only.end();
}

void say(const GalleryRequest& request, const std::string& line) {
    if (!request.quiet) std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

Exit make_gallery(const GalleryRequest& request) {
    const Catalogue catalogue = read_catalogue(request.file.empty() ? default_catalogue() : request.file);
#ifndef DRAPE_WITH_RENDER
    throw Error("this drape was built without a renderer (build with DRAPE_RENDER=ON)");
#endif
    const std::string out =
        fs::absolute(request.out.empty() ? "renders/gallery_page" : request.out).lexically_normal().string();
    for (const std::string& name : request.only) find_named(catalogue.pieces, "piece", name);
    // every scene is read before the first is run
    std::vector<Work> works;
    for (const Piece& piece : catalogue.pieces) works.emplace_back(piece, request, out);
    catch_interrupts();
    make_folder(out + "/runs");
    GalleryPage page{.title = catalogue.title,
                     .made_by = cat("drape ", version),
                     .machine = processor_name(),
                     .pieces = {}};
    std::string failed;
    for (Work& work : works) {
        const std::string& name = work.piece().name;
        const bool chosen = is_chosen(work.piece(), request.only);
        if (work.is_up_to_date()) {
            if (chosen) say(request, name + ": is as it was");
        } else if (!chosen) {
            continue;  // the page shows what there is
        } else {
            say(request, name + " ...");
            if (!work.go()) return Exit::interrupted;
        }
        page.pieces.push_back(work.shown());
        if (work.trouble().empty()) continue;
        failed += cat(failed.empty() ? "" : ", ", name);
        say(request, name + ": not made: " + work.trouble());
    }
    write_file(out + "/index.html", gallery_page(page));
    if (!request.quiet) std::printf("%s/index.html\n", out.c_str());
    if (!failed.empty())
        throw Error(cat("gallery: not made: ", failed, " (", out, "/index.html says why)"), Exit::went_wrong);
    return Exit::done;
}

}  // namespace drape
