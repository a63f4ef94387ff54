#include "io/write_file.h"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <functional>

#include "base/error.h"
#include "io/output_file.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;

namespace {

Exit code_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.code();
    }
    return Exit::done;
}

}  // namespace

TEST_CASE("a file is written whole and replaces the one before, and nothing else is left", "[io]") {
    const TemporaryFolder folder;
    write_file(folder.file("a.txt"), std::string_view("first"));
    write_file(folder.file("a.txt"), std::string_view("second, longer"));
    write_file(folder.file("a.txt"), std::string_view(""));
    CHECK(bytes_of(folder.file("a.txt")).empty());
    write_file(folder.file("a.txt"), std::string_view("third"));
    CHECK(bytes_of(folder.file("a.txt")) == "third");
    CHECK(folder.files() == 1);
}

TEST_CASE("a file that is not finished leaves the old one and nothing beside it", "[io]") {
    const TemporaryFolder folder;
    write_file(folder.file("a.txt"), std::string_view("old"));
    {
        OutputFile file(folder.file("a.txt"));
        file.write(std::vector<std::uint8_t>(100000, 1));
        CHECK(bytes_of(folder.file("a.txt")) == "old");
    }
    CHECK(bytes_of(folder.file("a.txt")) == "old");
    CHECK(folder.files() == 1);
}

TEST_CASE("a place that cannot be written to is one line and exit code 3", "[io]") {
    const TemporaryFolder folder;
    const std::string nowhere = folder.file("no/such/folder/a.txt");
    const auto write = [](const std::string& path) {
        return [path] { write_file(path, std::string_view("x")); };
    };
    CHECK(code_of(write(nowhere)) == Exit::cannot_write);
    CHECK(error_of(write(nowhere)) == nowhere + ": cannot write: No such file or directory");
    CHECK(error_of(write(folder.path())) == folder.path() + ": cannot write: is a folder");
    CHECK(code_of(write("/proc/drape/a.txt")) == Exit::cannot_write);
    CHECK(code_of(write("/dev/null")) == Exit::cannot_write);
    CHECK(folder.files() == 0);
}

TEST_CASE("a folder that vanishes while a file is written to it is an error, not a file", "[io]") {
    const TemporaryFolder folder;
    make_folder(folder.file("deep/er"));
    OutputFile file(folder.file("deep/er/a.txt"));
    file.write(std::vector<std::uint8_t>(10, 1));
    std::filesystem::remove_all(folder.file("deep"));
    CHECK(code_of([&] { file.finish(); }) == Exit::cannot_write);
    CHECK(folder.files() == 0);
}

TEST_CASE("a file too large for where it goes is one line and leaves nothing behind", "[io]") {
    // a limit on file sizes stands in for a full disk: both fail in the middle of write()
    const TemporaryFolder folder;
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = error_of([&] { write_file(folder.file("a.txt"), std::string(5000, 'x')); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    CHECK(message == folder.file("a.txt") + ": cannot write: File too large");
    CHECK(folder.files() == 0);
}

TEST_CASE("a folder cannot be made below a file", "[io]") {
    const TemporaryFolder folder;
    const std::string file = folder.file("a.txt", "x");
    CHECK(code_of([&] { make_folder(file + "/below"); }) == Exit::cannot_write);
    CHECK(code_of([&] { make_folder(file); }) == Exit::cannot_write);
}

TEST_CASE("folders are made with their parents, and made again without complaint", "[io]") {
    const TemporaryFolder folder;
    make_folder(folder.file("a/b/c"));
    make_folder(folder.file("a/b/c"));
    CHECK(std::filesystem::is_directory(folder.file("a/b/c")));
}

TEST_CASE("what was written can be patched and cut before the file is finished", "[io]") {
    const TemporaryFolder folder;
    const auto put = [](std::string_view text) {
        return std::vector<std::uint8_t>(text.begin(), text.end());
    };
    OutputFile file(folder.file("a.txt"));
    file.write(put("0123456789"));
    file.patch(1, put("AB"));
    file.close_gap(3, 7);
    file.write(put("!"));
    file.finish();
    CHECK(bytes_of(folder.file("a.txt")) == "0AB789!");
}
