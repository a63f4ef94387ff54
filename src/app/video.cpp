// video: sequences of pictures -> panes, captions, order -> ffmpeg.
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/interrupt.h"
#include "app/verbs.h"
#include "video/encoder.h"
#include "video/film.h"
#include "video/timeline.h"

namespace drape {

namespace {

namespace fs = std::filesystem;

constexpr double least_rate = 0.01, most_rate = 1e5;  // [1/s]

// "drop" of "renders/drop/"
std::string name_of(const std::string& folder) {
    const fs::path path = fs::absolute(folder).lexically_normal();
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

// The words of a flag that is given not at all, once for all sequences, or once for each.
void demand_one_each(const std::vector<std::string>& words, size_t sequences, const char* flag) {
    if (words.size() > 1 && words.size() != sequences)
        throw Error(cat(flag, ": given ", words.size(), " times for ", sequences,
                        " sequences (once for all, or once for each)"));
}

const std::string& word_of(const std::vector<std::string>& words, size_t sequence) {
    return words.size() == 1 ? words[0] : words[sequence];
}

// Frames a second of the sequences whose reports tell it; all must tell the same, or one would play too fast.
class CommonRate {
public:
    void add(const std::string& folder, double rate) {
        if (!from_.empty() && std::abs(rate / rate_ - 1) > 1e-6)
            throw Error(cat(folder, ": is of ", rate, " frames a second, ", from_, " of ", rate_,
                            " (--fps says how many are shown)"));
        rate_ = rate;
        from_ = folder;
    }
    double rate() const { return rate_; }

private:
    double rate_ = 30;
    std::string from_;
};

Take take_of(const VideoRequest& request, size_t i, CommonRate& rate) {
    const std::string& folder = request.sequences[i];
    Take take{find_sequence(folder), {}, "", request.width};
    const bool reported_caption = request.caption && request.captions.empty();
    const std::string report = (fs::path(folder) / "report.json").string();
    if ((reported_caption || !request.fps) && fs::exists(report)) {
        const ReportedRun run = read_reported_run(report);
        if (reported_caption) take.captions = run.captions;
        if (!request.fps && run.frame_rate > 0) rate.add(folder, run.frame_rate);
    }
    if (request.caption && !request.captions.empty())
        take.captions.common.title = word_of(request.captions, i);
    if (!request.labels.empty())
        take.label = word_of(request.labels, i);
    else if (request.side_by_side)
        take.label = name_of(folder);
    return take;
}

std::string size_of(const std::string& file) {
    char text[32];
    const double bytes = static_cast<double>(fs::file_size(file));
    std::snprintf(text, sizeof text, bytes < 1e6 ? "%.0f kB" : "%.1f MB", bytes / (bytes < 1e6 ? 1e3 : 1e6));
    return text;
}

}  // namespace

Exit make_video(const VideoRequest& request) {
    const VideoFormat& format = format_of(request.out);
    if (!request.side_by_side && (request.difference || request.columns > 0))
        throw Error(cat(request.difference ? "--difference" : "--columns", ": only with --side-by-side"));
    demand_one_each(request.captions, request.sequences.size(), "--caption");
    demand_one_each(request.labels, request.sequences.size(), "--label");
    CommonRate common;
    std::vector<Take> takes;
    for (size_t i = 0; i < request.sequences.size(); ++i) takes.push_back(take_of(request, i, common));
    double rate = request.fps.value_or(common.rate()) * request.speed;
    if (!(rate >= least_rate && rate <= most_rate))
        throw Error(cat("plays ", rate, " frames a second (--fps times --speed: ", least_rate, " to ",
                        most_rate, ")"));
    const auto film = request.side_by_side
                          ? side_by_side(std::move(takes), {request.columns, request.difference})
                          : one_after_the_other(std::move(takes));
    const std::vector<int> order =
        thinned(play_order(film->frames(), request.boomerang, request.loops), rate, format.most_rate);
    rate = std::min(rate, format.most_rate);

    catch_interrupts();
    Image image = film->frame(order[0]);
    const Canvas canvas{image.width, image.height, rate};
    Encoder encoder(request.out, canvas);
    do
        for (const int k : order) {
            if (interrupted()) return Exit::interrupted;
            encoder.add(film->frame(k));
        }
    while (encoder.another_pass());
    encoder.finish();
    if (!request.quiet)
        std::printf("%s: %zu frames of %dx%d, %.4g a second, %.4g s, %s\n", request.out.c_str(), order.size(),
                    canvas.width, canvas.height, rate, static_cast<double>(order.size()) / rate,
                    size_of(request.out).c_str());
    return Exit::done;
}

}  // namespace drape
