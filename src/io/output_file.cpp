#include "io/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include "base/assert.h"
#include "base/error.h"

namespace drape {

namespace {

// no other thread, and no other process on this machine, writes under the same name
std::string temporary_name(const std::string& path) {
    static std::atomic<unsigned> count{0};
    return cat(path, ".part", getpid(), "-", count++);
}

[[noreturn]] void cannot_write(const std::string& path, const std::string& reason) {
    throw Error(cat(path, ": cannot write: ", reason), Exit::cannot_write);
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), temporary_(temporary_name(path)) {
    // renaming over a device or a folder would replace it, or fail only after all the work
    struct stat there {};
    if (stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode))
        cannot_write(path, S_ISDIR(there.st_mode) ? "is a folder" : "is not a regular file");
    descriptor_ = open(temporary_.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
    if (descriptor_ < 0) cannot_write(path, std::strerror(errno));
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!finished_) unlink(temporary_.c_str());
}

void OutputFile::write(std::span<const std::uint8_t> bytes) {
    DRAPE_ASSERT(descriptor_ >= 0);
    while (!bytes.empty()) {
        const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) fail(errno);
        bytes = bytes.subspan(static_cast<size_t>(done));
    }
}

void OutputFile::patch(std::uint64_t offset, std::span<const std::uint8_t> bytes) {
    DRAPE_ASSERT(descriptor_ >= 0);
    while (!bytes.empty()) {
        const ssize_t done = pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) fail(errno);
        bytes = bytes.subspan(static_cast<size_t>(done));
        offset += static_cast<std::uint64_t>(done);
    }
}

void OutputFile::close_gap(std::uint64_t begin, std::uint64_t end) {
    DRAPE_ASSERT(descriptor_ >= 0 && begin <= end);
    std::vector<std::uint8_t> chunk(1 << 20);
    for (;;) {
        const ssize_t got = pread(descriptor_, chunk.data(), chunk.size(), static_cast<off_t>(end));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(errno);
        if (got == 0) break;
        patch(begin, std::span(chunk.data(), static_cast<size_t>(got)));
        begin += static_cast<std::uint64_t>(got);
        end += static_cast<std::uint64_t>(got);
    }
    if (ftruncate(descriptor_, static_cast<off_t>(begin)) != 0) fail(errno);
    if (lseek(descriptor_, 0, SEEK_END) < 0) fail(errno);
}

void OutputFile::close() {
    DRAPE_ASSERT(descriptor_ >= 0);
    if (fsync(descriptor_) != 0) fail(errno);
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail(errno);
}

void OutputFile::finish() {
    if (descriptor_ >= 0) close();
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
    finished_ = true;
}

void OutputFile::fail(int reason) {
    cannot_write(path_, std::strerror(reason));
}

}  // namespace drape
