// Draws the references and accepts what differs from those that lie there; what is within the limits is left
// alone, with the record of what made it.
#include <cstdio>
#include <filesystem>
#include <map>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/shell_word.h"
#include "compare/accept.h"
#include "io/png.h"
#include "io/write_file.h"
#include "references/references.h"
#include "report/report.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Json = nlohmann::ordered_json;

namespace {

// The widest vectors that base/wide.h may pick here.
const char* cpu_level() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512f")) return "avx512f";
    if (__builtin_cpu_supports("avx2")) return "avx2";
#endif
    return "default";
}

std::string command_of(const Reference& reference) {
    std::string command = "drape";
    for (const std::string& argument : arguments_of(reference)) command += cat(" ", shell_word(argument));
    return command;
}

}  // namespace

int main() try {
    const TemporaryFolder drawn;
    std::map<std::string, Json> made;
    for (const Reference& reference : references()) {
        std::printf("%s\n", reference.scene.c_str());
        visit_moments(reference, [&](const Moment& moment) {
            std::string renderer;
            write_file(drawn.file(moment.name), encode_png(picture_of(moment, &renderer)));
            made[moment.name] = {{"command", command_of(reference)},
                                 {"version", DRAPE_VERSION},
                                 {"renderer", renderer},
                                 {"processor", processor_name()},
                                 {"cpu_level", cpu_level()}};
        });
    }
    const std::string folder = reference_folder(), record = folder + "/made.json";
    const Comparison comparison = compare(drawn.path(), folder, {});
    accept(comparison, drawn.path(), folder);
    const Json before = std::filesystem::exists(record) ? Json::parse(bytes_of(record)) : Json::object();
    Json after = Json::object();
    for (const Compared& file : comparison.files) {
        if (file.verdict == Verdict::missing) continue;
        const bool kept = file.passed() && before.contains(file.name);
        after[file.name] = kept ? before[file.name] : made[file.name];
        if (!file.passed()) std::printf("%s: %s\n", file.name.c_str(), file.why.c_str());
    }
    write_file(record, after.dump(1) + "\n");
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
