// A file that appears whole or not at all: written under a temporary name beside its target, flushed to the
// disk, renamed. Whatever goes wrong in between, the target is as it was and the temporary is gone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace drape {

class OutputFile {
public:
    // Each member throws Error (Exit::cannot_write) "FILE: cannot write: reason".
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    // Where another program may write the file in place of write().
    const std::string& temporary() const { return temporary_; }
    void write(std::span<const std::uint8_t> bytes);
    // Overwrites what was written at `offset` from the start; the next write() appends as before.
    void patch(std::uint64_t offset, std::span<const std::uint8_t> bytes);
    // Cuts out what was written from `begin` to `end` (offsets from the start).
    void close_gap(std::uint64_t begin, std::uint64_t end);
    // Flushes and closes, still under the temporary name: many may wait closed to be finished together.
    void close();
    // Closes if need be and renames to the target.
    void finish();

private:
    [[noreturn]] void fail(int reason);

    std::string path_, temporary_;
    int descriptor_ = -1;
    bool finished_ = false;
};

}  // namespace drape
