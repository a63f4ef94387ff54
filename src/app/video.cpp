// video: sequences of pictures -> panes, captions, order -> ffmpeg.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/interrupt.h"
#include "app/verbs.h"
#include "video/effort.h"
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

std::string size_of(std::uint64_t file) {
    char text[32];
    const double bytes = static_cast<double>(file);
    std::snprintf(text, sizeof text, bytes < 1e6 ? "%.0f kB" : "%.1f MB", bytes / (bytes < 1e6 ? 1e3 : 1e6));
    return text;
}

struct Made {
    int width = 0, height = 0;  // [pixels]
    size_t frames = 0;
    double rate = 0;  // [1/s]
    std::uint64_t bytes = 0;
};

std::unique_ptr<Film> film_of(const VideoRequest& request, const std::vector<Take>& originals, double scale) {
    std::vector<Take> takes = originals;
    for (Take& take : takes)
        if (scale != 1)
            take.width = std::max(
                1,
                static_cast<int>(std::lround(scale * (take.width > 0 ? take.width : take.sequence.width))));
    return request.side_by_side ? side_by_side(std::move(takes), {request.columns, request.difference})
                                : one_after_the_other(std::move(takes));
}

// The video as `effort` has it, for which `rate` is that of its frames; it becomes final where it has at most
// `most` bytes. Nothing if the user interrupts.
std::optional<Made> encode(const VideoRequest& request, const std::vector<Take>& takes, double rate,
                           const Effort& effort, std::optional<std::uint64_t> most) {
    const auto film = film_of(request, takes, effort.scale);
    const double shown_rate = std::min(effort.most_rate, format_of(request.out).most_rate);
    const std::vector<int> order =
        thinned(play_order(film->frames(), request.boomerang, request.loops), rate, shown_rate);
    Image image = film->frame(order[0]);
    const Made made{image.width, image.height, order.size(), std::min(rate, shown_rate), 0};
    Encoder encoder(request.out, {made.width, made.height, made.rate}, effort.quality);
    do
        for (const int k : order) {
            if (interrupted()) return std::nullopt;
            encoder.add(film->frame(k));
        }
    while (encoder.another_pass());
    Made done = made;
    done.bytes = encoder.end();
    if (!most || done.bytes <= *most) encoder.finish();
    return done;
}

}  // namespace

Exit make_video(const VideoRequest& request) {
    format_of(request.out);
    if (!request.side_by_side && (request.difference || request.columns > 0))
        throw Error(cat(request.difference ? "--difference" : "--columns", ": only with --side-by-side"));
    demand_one_each(request.captions, request.sequences.size(), "--caption");
    demand_one_each(request.labels, request.sequences.size(), "--label");
    CommonRate common;
    std::vector<Take> takes;
    for (size_t i = 0; i < request.sequences.size(); ++i) takes.push_back(take_of(request, i, common));
    const double rate = request.fps.value_or(common.rate()) * request.speed;
    if (!(rate >= least_rate && rate <= most_rate))
        throw Error(cat("plays ", rate, " frames a second (--fps times --speed: ", least_rate, " to ",
                        most_rate, ")"));

    catch_interrupts();
    std::optional<std::uint64_t> most;
    if (request.most_megabytes) most = static_cast<std::uint64_t>(1e6 * *request.most_megabytes);
    const Effort unrestrained{1, most_rate, 0, 1};
    size_t tried = 0;
    std::optional<Made> made = encode(request, takes, rate, most ? efforts()[0] : unrestrained, most);
    while (made && most && made->bytes > *most) {
        const size_t next = next_effort(tried, made->bytes, *most);
        if (next == efforts().size())
            throw Error(cat(request.out, ": cannot write: at its smallest it has ", size_of(made->bytes),
                            " (--at-most ", *request.most_megabytes, ", in megabytes)"),
                        Exit::cannot_write);
        made = encode(request, takes, rate, efforts()[tried = next], most);
    }
    if (!made) return Exit::interrupted;
    if (!request.quiet)
        std::printf("%s: %zu frames of %dx%d, %.4g a second, %.4g s, %s\n", request.out.c_str(), made->frames,
                    made->width, made->height, made->rate, static_cast<double>(made->frames) / made->rate,
                    size_of(made->bytes).c_str());
    return Exit::done;
}

}  // namespace drape
