#include "support/scene_file.h"

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "scene/reader.h"

namespace drape::test {

namespace {

class FreshFolder {
public:
    FreshFolder() {
        static std::atomic<int> count{0};
        path_ = std::filesystem::temp_directory_path() / cat("drape_scene_", getpid(), "_", count++);
        std::filesystem::create_directories(path_);
    }
    ~FreshFolder() { std::filesystem::remove_all(path_); }
    FreshFolder(const FreshFolder&) = delete;
    FreshFolder& operator=(const FreshFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace

std::string with_cloth(const std::string& rest) {
    return "schema = 1\n[[cloth]]\npattern = {}\n" + rest;
}

SceneDescription scene_of(const std::string& text, const std::vector<std::string>& overrides) {
    const FreshFolder folder;
    const std::string file = (folder.path() / "scene.toml").string();
    std::ofstream(file, std::ios::binary) << text;
    try {
        return read_scene(file, overrides);
    } catch (const Error& error) {
        const std::string message = error.what(), prefix = folder.path().string() + "/";
        throw Error(message.starts_with(prefix) ? message.substr(prefix.size()) : message, error.code());
    }
}

std::string error_of(const std::string& text, const std::vector<std::string>& overrides) {
    try {
        scene_of(text, overrides);
    } catch (const Error& error) {
        return error.code() == Exit::bad_input ? error.what() : cat("wrong exit code: ", error.what());
    }
    return "";
}

}  // namespace drape::test
