// compare, video, gallery, mesh, list.
#include <limits>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/declare_verbs.h"
#include "app/flag_values.h"
#include "app/verbs.h"
#include "base/names.h"
#include "compare/metrics.h"

namespace drape {

Action declare_compare(CLI::App& verb) {
    auto asked = std::make_shared<CompareRequest>();
    verb.add_option("RESULT", asked->result,
                    "a picture, a cache (.pc2, .mdd, .glb), or a folder of frames and caches")
        ->required();
    verb.add_option("REFERENCE", asked->reference, "what it should be like, of the same kind")->required();
    const struct {
        std::string key, type, says;
    } common[] = {
        {"share", "SHARE", "share of a picture's pixels that may be over 8 levels off (default 2e-5)"},
        {"mean", "LEVELS", "mean difference a picture may have (default 2e-3)"},
        {"rms", "M", "how far a cache's sample may be off, in metres (default 1e-6)"}};
    for (const auto& limit : common)
        verb.add_option_function<std::string>(
                "--" + limit.key,
                [asked, key = limit.key](const std::string& value) {
                    asked->limits.push_back(key + "=" + value);
                },
                limit.says)
            ->type_name(limit.type);
    verb.add_option("--limit", asked->limits,
                    cat("a limit by its key (", joined(metric_keys()), "); may be given again"))
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb.add_option("--ignore", asked->ignore, "a rectangle of pixels not to look at; may be given again")
        ->type_name("X,Y,W,H")
        ->allow_extra_args(false);
    verb.add_flag("--perceptual", asked->perceptual, "SSIM and FLIP of pictures that differ as well");
    verb.add_flag("--hausdorff", asked->hausdorff, "Hausdorff's distance of caches that differ as well");
    verb.add_option("--json", asked->json, "write what was found to this file")->type_name("FILE");
    verb.add_option("--html", asked->html, "the same as a page with the pictures, which needs no other file")
        ->type_name("FILE");
    verb.add_flag("--accept", asked->accept, "make the results the references where they differ");
    verb.add_option("--junit", asked->junit, "the same as JUnit XML, for continuous integration")
        ->type_name("FILE");
    verb.add_flag("--quiet", asked->quiet, "print nothing but errors");
    return [asked] { return compare_results(*asked); };
}

Action declare_video(CLI::App& verb) {
    auto asked = std::make_shared<VideoRequest>();
    verb.add_option("SEQUENCE", asked->sequences,
                    "a folder of numbered PNG pictures; several are shown one after the other")
        ->required();
    verb.add_option("-o,--out", asked->out, "the file to write: .mp4 .webm .webp .gif")
        ->type_name("FILE")
        ->required();
    verb.add_option_function<std::string>(
            "--fps",
            [asked](const std::string& text) {
                asked->fps = positive_number(text, "--fps", "frames a second over 0");
            },
            "frames a second at normal speed (default: as report.json says, else 30)")
        ->type_name("N");
    verb.add_option_function<std::string>(
            "--speed",
            [asked](const std::string& text) {
                asked->speed = positive_number(text, "--speed", "how many times as fast, over 0");
            },
            "so many times as fast (0.25: slow motion)")
        ->type_name("X");
    verb.add_flag("--boomerang", asked->boomerang, "there and back");
    verb.add_option("--loop", asked->loops, "write it so many times")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    verb.add_option("--caption", asked->captions,
                    "written into the frames; again for each sequence (default: what report.json says)")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    verb.add_flag("!--no-caption", asked->caption, "leave the frames without a caption");
    verb.add_option("--width", asked->width, "resize each picture to so many pixels across")
        ->type_name("N")
        ->check(CLI::Range(1, 16384));
    verb.add_option_function<std::string>(
            "--at-most",
            [asked](const std::string& text) {
                asked->most_megabytes = positive_number(text, "--at-most", "megabytes over 0");
            },
            "give up frames, quality and size until the file has at most so many megabytes")
        ->type_name("MB");
    verb.add_flag("--side-by-side", asked->side_by_side, "a pane for each sequence, playing together");
    verb.add_option("--label", asked->labels,
                    "in the upper corner; again for each sequence (default: of a pane its folder's name)")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    verb.add_option("--columns", asked->columns, "panes in a row (default: all)")
        ->type_name("N")
        ->check(CLI::Range(1, 100));
    verb.add_flag("--difference", asked->difference, "one more pane: what two sequences differ in, times 16");
    verb.add_flag("--quiet", asked->quiet, "print nothing but errors");
    return [asked] { return make_video(*asked); };
}

Action declare_gallery(CLI::App& verb) {
    auto asked = std::make_shared<GalleryRequest>();
    verb.add_option("FILE", asked->file,
                    "what to show, a TOML file (default: every demo scene and comparisons)");
    verb.add_option("--out", asked->out, "folder of the page (default: renders/gallery_page)")
        ->type_name("DIR");
    verb.add_option("--only", asked->only, "make only this piece; may be given again")
        ->type_name("NAME")
        ->allow_extra_args(false);
    verb.add_flag("--quick", asked->quick, "the first 15 frames of each, small");
    verb.add_option("--threads", asked->threads, "how many threads (default: one per core)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    verb.add_flag("--quiet", asked->quiet, "print nothing but errors");
    return [asked] { return make_gallery(*asked); };
}

Action declare_mesh(CLI::App& verb) {
    auto wanted = std::make_shared<PatternOptions>();
    verb.add_option("PATTERN", wanted->pattern, "drape list patterns")->required();
    verb.add_option("-o,--output", wanted->file, "the file to write, .obj or .ply")
        ->type_name("FILE")
        ->required();
    verb.add_option("--size", wanted->size, "of the sheet in metres (default 1 1)")->type_name("WIDTH DEPTH");
    verb.add_option("--divisions", wanted->divisions, "quads along the two sides (default 32 32)")
        ->type_name("COLUMNS ROWS");
    verb.add_option("--seed", wanted->seed, "of patterns that throw dice (default 1)")
        ->type_name("N")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()));
    verb.add_option("--over", wanted->over, "what it covers: rectangle, disc, annulus or outline")
        ->type_name("KIND");
    verb.add_option("--hole", wanted->hole, "inner diameter of an annulus in metres")->type_name("M");
    verb.add_option("--outline", wanted->outline, "corners, as a scene has them: \"[[0,0],[1,0],[0,1]]\"")
        ->type_name("CORNERS");
    verb.add_option("--finer", wanted->finer, "where `adaptive` is finer: \"{ points = [[0,0]] }\"")
        ->type_name("TABLE");
    verb.add_option("--remesh", wanted->remesh,
                    "fill this mesh's outline anew, with edges as long as its own but for --divisions")
        ->type_name("MESH");
    return [wanted] { return write_pattern(*wanted); };
}

Action declare_list(CLI::App& verb) {
    auto kind = std::make_shared<std::string>();
    verb.add_option("KIND", *kind,
                    "scenes, fabrics, methods, obstacles, patterns, membranes or lab (default: all)");
    return [kind] { return list_kinds(*kind); };
}

}  // namespace drape
