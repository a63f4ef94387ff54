#include "io/kept_positions.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.h"

namespace drape {

KeptPositions::KeptPositions(const std::string& path, Eigen::Index vertices, int frames)
    : path_(path), vertices_(vertices), counts_(frames > 0) {
    descriptor_ = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC | (frames == 0 ? O_TRUNC : 0), 0666);
    if (descriptor_ < 0) fail(errno);
    const off_t end = static_cast<off_t>(vertices) * 3 * static_cast<off_t>(sizeof(double)) * frames;
    struct stat there {};
    if (fstat(descriptor_, &there) != 0) fail(errno);
    if (!S_ISREG(there.st_mode))
        throw Error(path + ": cannot write: is not a regular file", Exit::cannot_write);
    if (there.st_size < end)
        throw Error(cat(path, ": ", there.st_size, " bytes, but ", frames, " frames need ", end));
    if (ftruncate(descriptor_, end) != 0 || lseek(descriptor_, 0, SEEK_END) < 0) fail(errno);
}

KeptPositions::~KeptPositions() {
    if (descriptor_ < 0) return;
    close(descriptor_);
    if (!counts_) unlink(path_.c_str());
}

Points KeptPositions::read(int frame) const {
    Points positions(3, vertices_);
    auto* to = reinterpret_cast<char*>(positions.data());
    auto left = static_cast<size_t>(positions.size()) * sizeof(double);
    for (auto at = static_cast<off_t>(left) * (frame - 1); left > 0;) {
        const ssize_t got = pread(descriptor_, to, left, at);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0)
            throw Error(cat(path_, ": cannot read: ", got < 0 ? std::strerror(errno) : "ends early"));
        to += got;
        at += got;
        left -= static_cast<size_t>(got);
    }
    return positions;
}

void KeptPositions::add(In positions) {
    const Points whole = positions;
    const auto* from = reinterpret_cast<const char*>(whole.data());
    for (auto left = static_cast<size_t>(whole.size()) * sizeof(double); left > 0;) {
        const ssize_t done = write(descriptor_, from, left);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) fail(errno);
        from += done;
        left -= static_cast<size_t>(done);
    }
}

void KeptPositions::flush() {
    if (fdatasync(descriptor_) != 0) fail(errno);
    counts_ = true;
}

void KeptPositions::fail(int reason) const {
    throw Error(cat(path_, ": cannot write: ", std::strerror(reason)), Exit::cannot_write);
}

}  // namespace drape
