// Pictures of every demo scene are those that were accepted, and the gate that says so tells changes from
// noise.
#include "references/references.h"

#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "compare/cache_difference.h"
#include "compare/compare.h"
#include "compare/metrics.h"
#include "io/png.h"
#include "io/write_file.h"
#include "references/changes.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Json = nlohmann::json;

namespace {

std::string reference_of(const std::string& name) {
    return reference_folder() + "/" + name;
}

// How a picture stands to a reference by the limits beside it.
Compared held(const Image& picture, const std::string& name) {
    const TemporaryFolder folder;
    const std::string file = folder.file(name);
    write_file(file, encode_png(picture));
    return compare(file, reference_of(name), {}).files.front();
}

std::string told(const Compared& compared) {
    if (!compared.picture) return "nothing";
    return cat(compared.picture->share_over * width * height, " pixels, ", compared.picture->mean_levels,
               " levels");
}

std::vector<std::string> reference_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(reference_folder()))
        if (entry.path().extension() == ".png") names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
    ~Variable() { unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
};

}  // namespace

TEST_CASE("every demo scene has references, and a record of what made them", "[references]") {
    std::vector<std::string> scenes, named;
    for (const auto& entry : std::filesystem::directory_iterator(DRAPE_SOURCE_DIR "/assets/scenes"))
        if (entry.path().extension() == ".toml") scenes.push_back(entry.path().stem().string());
    std::sort(scenes.begin(), scenes.end());
    for (const Reference& reference : references()) named.push_back(reference.scene);
    CHECK(named == scenes);
    const Json made = Json::parse(bytes_of(reference_of("made.json")));
    const std::vector<std::string> names = reference_names();
    CHECK(names.size() == 2 * scenes.size());
    CHECK(made.size() == names.size());
    std::uintmax_t bytes = 0;
    for (const std::string& name : names) {
        CAPTURE(name);
        REQUIRE(made.contains(name));
        for (const char* key : {"command", "version", "renderer", "processor", "cpu_level"})
            CHECK_FALSE(made[name][key].get<std::string>().empty());
        bytes += std::filesystem::file_size(reference_of(name));
    }
    CHECK(bytes < 1500000);
}

TEST_CASE("demo scenes look as accepted, and changes of each are told from that", "[references]") {
    for (const Reference& reference : references()) {
        visit_moments(reference, [](const Moment& moment) {
            const Compared same = held(picture_of(moment), moment.name);
            INFO(moment.name << ": " << same.why
                             << "\nif this is meant: ninja -C build/checked references, and look at them");
            CHECK(same.passed());
            for (const Change& change : changes()) {
                const Compared other = held(change.of(moment), moment.name);
                INFO(change.name << ": " << told(other));
                CHECK_FALSE(other.passed());
            }
            // which pictures of this size do not show, but positions do
            for (const Points& cloth : moment.input.cloth)
                CHECK(cache_difference({{cloth}, {}}, {{bumped(cloth)}, {}}).rms_m > *metric_of("rms").usual);
        });
    }
}

TEST_CASE("every two references are told apart", "[references]") {
    const std::vector<std::string> names = reference_names();
    for (const std::string& one : names) {
        for (const std::string& other : names) {
            CAPTURE(one, other);
            CHECK(compare(reference_of(one), reference_of(other), {}).passed() == (one == other));
        }
    }
}

TEST_CASE("the program draws the references whatever the machine's vectors are", "[references]") {
    const Reference& reference = references().front();
    const auto check = [&](const char* name, const char* value) {
        const Variable machine(name, value);
        const TemporaryFolder folder;
        std::vector<std::string> arguments = arguments_of(reference);
        arguments.insert(arguments.end(), {"--quiet", "--out", folder.path()});
        const Ran ran = run_drape(arguments);
        CAPTURE(name, value, ran.err);
        REQUIRE(ran.exit_code == 0);
        for (const int frame : {1, 2}) {
            const Compared compared =
                compare(folder.file(cat("frame_000", frame, ".png")),
                        reference_of(cat("frame_", reference.scene, "_", frame, ".png")), {})
                    .files.front();
            CAPTURE(frame, compared.why);
            CHECK(compared.passed());
        }
    };
    check("LP_NATIVE_VECTOR_WIDTH", "128");
    check("LP_NATIVE_VECTOR_WIDTH", "256");
    check("LP_NATIVE_VECTOR_WIDTH", "512");
    check("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1");  // and no fused multiply-add
}
