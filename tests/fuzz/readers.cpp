#include "fuzz/readers.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/error.h"
#include "base/hash.h"
#include "io/bytes.h"
#include "io/cache_reader.h"
#include "io/check_ply.h"
#include "io/obj_text.h"
#include "io/png.h"
#include "scene/builder.h"
#include "scene/read_parts.h"
#include "scene/reader.h"
#include "scene/scene_text.h"
#include "simulate/checkpoint.h"
#include "simulate/delivery.h"
#include "support/glb_bytes.h"

namespace drape::test {

namespace {

void demand(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "read, but wrong: %s\n", what);
    std::abort();
}

// An Error is an answer, if it is one line.
template <class Read>
void answered(Read read) {
    try {
        read();
    } catch (const Error& error) {
        demand(std::string_view(error.what()).find('\n') == std::string_view::npos, "a message of two lines");
    }
}

// What a scene is printed as is the same scene.
void read_a_scene(std::string_view bytes) {
    answered([&] {
        const std::string text = scene_text(read_scene_text(bytes, "fuzzed.toml"));
        demand(scene_text(read_scene_text(text, "fuzzed.toml")) == text, "a scene printed is another scene");
    });
}

// As the value of `motion`, looked at before, between and after its keys.
void read_keyframes(std::string_view bytes) {
    answered([&] {
        const Value root = parse_toml("motion = " + std::string(bytes), "fuzzed.toml");
        const RigidMotion motion(read_motion(root.items.front()));
        for (int k = -1; k <= 9; ++k) {
            const MovingPose at = motion.at(motion.end_time() * k / 8);
            demand(at.pose.translation.allFinite() && at.pose.rotation.allFinite(), "a pose is not finite");
            demand(at.linear.allFinite() && at.angular.allFinite(), "a speed is not finite");
        }
        demand(motion.top_speed(1) >= 0, "the top speed is no number");
    });
}

void read_an_obj(std::string_view bytes) {
    answered([&] {
        const ObjText obj = read_obj("fuzzed.obj", bytes);
        demand(obj.vertices.cols() > 0 && obj.vertices.allFinite(), "vertices are not finite");
        // what assimp gets is as plain as it says
        const ObjText again = read_obj("plain.obj", obj.plain);
        demand(again.vertices.cols() == obj.vertices.cols(), "a vertex is lost");
    });
}

void read_a_ply(std::string_view bytes) {
    answered([&] { check_ply("fuzzed.ply", bytes); });
}

void read_a_cache(const char* name, std::string_view bytes) {
    answered([&] {
        const Cache cache = read_cache_bytes(name, bytes);
        demand(cache.samples.size() == cache.times.size(), "samples without a time");
        for (const Points& sample : cache.samples)
            demand(sample.cols() == cache.samples[0].cols(), "samples of several sizes");
    });
}

void read_a_pc2(std::string_view bytes) {
    read_a_cache("fuzzed.pc2", bytes);
}

void read_an_mdd(std::string_view bytes) {
    read_a_cache("fuzzed.mdd", bytes);
}

// As it is, then as the JSON up to a zero and the bytes that its numbers are in: no fuzzer finds the sizes
// before them.
void read_a_glb(std::string_view bytes) {
    read_a_cache("fuzzed.glb", bytes);
    const size_t end = std::min(bytes.find('\0'), bytes.size());
    const std::string_view json = bytes.substr(0, end),
                           binary = bytes.substr(std::min(end + 1, bytes.size()));
    read_a_cache("fuzzed.glb", glb_bytes(json, binary));
}

// The PNG with the checksums that its chunks should have, as far as they lie within it.
std::string with_checksums(std::string png) {
    constexpr size_t signature = 8, number = 4, type = 4;
    for (size_t at = signature; at + number + type + number <= png.size();) {
        const size_t length = number_at<std::uint32_t>(&png[at], std::endian::big);
        if (length > png.size() - at - number - type - number) break;
        at += number;
        std::vector<std::uint8_t> sum;
        put<std::endian::big>(sum, libdeflate_crc32(0, &png[at], type + length));
        at += type + length;
        std::copy(sum.begin(), sum.end(), png.begin() + static_cast<std::ptrdiff_t>(at));
        at += number;
    }
    return png;
}

// First as it is, then with the right checksums, which a fuzzer does not find.
void read_a_png(std::string_view bytes) {
    for (const std::string& png : {std::string(bytes), with_checksums(std::string(bytes))})
        answered([&] {
            const Image image = decode_png("fuzzed.png", png);
            demand(image.width > 0 && image.height > 0, "a picture without pixels");
        });
}

Setup small_setup() {
    const std::string text =
        "schema = 1\n[scene]\nduration = 0.2\nframe_rate = 10\n[[cloth]]\n"
        "pattern = { name = \"alternating\", divisions = [1, 1] }\nfabric = \"cotton\"\n";
    return build_scene(read_scene_text(text, "small.toml")).setup;
}

// First as it is, then as the passes of a checkpoint whose hash is right, in both kinds of run.
void read_a_checkpoint(std::string_view bytes) {
    answered([&] { static_cast<void>(read_checkpoint(bytes)); });
    Checkpoint checkpoint;
    checkpoint.passes = bytes;
    const auto whole = read_checkpoint(checkpoint_bytes(checkpoint));
    demand(whole && whole->passes == bytes, "a checkpoint reads back as another");
    static const std::unique_ptr<Delivery> streamed = make_delivery(small_setup(), {.frames = 2});
    static const std::unique_ptr<Delivery> controlled =
        make_delivery(small_setup(), {.tolerance = 1e-3, .frames = 2});
    for (Delivery* run : {streamed.get(), controlled.get()}) {
        answered([&] {
            if (!run->restore(bytes)) return;
            demand(run->frame() >= 0 && run->frame() <= 2, "a frame beyond the last");
            demand(run->state().x.allFinite(), "a state that is not finite");
        });
    }
}

constexpr std::array readers{
    FuzzedReader{"scene", read_a_scene},
    FuzzedReader{"keyframes", read_keyframes},
    FuzzedReader{"obj", read_an_obj},
    FuzzedReader{"ply", read_a_ply},
    FuzzedReader{"pc2", read_a_pc2},
    FuzzedReader{"mdd", read_an_mdd},
    FuzzedReader{"glb", read_a_glb},
    FuzzedReader{"png", read_a_png},
    FuzzedReader{"checkpoint", read_a_checkpoint},
};

}  // namespace

std::span<const FuzzedReader> fuzzed_readers() {
    return readers;
}

}  // namespace drape::test
