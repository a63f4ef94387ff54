// A program that runs beside drape and is fed through its standard input. No shell is in between.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace drape {

class PipedProgram {
public:
    // Starts words[0], looked for along PATH, with the other words as its arguments. Throws Error
    // (Exit::cannot_write) where it is not installed.
    explicit PipedProgram(const std::vector<std::string>& words);
    ~PipedProgram();  // ends the program if it still runs
    PipedProgram(const PipedProgram&) = delete;
    PipedProgram& operator=(const PipedProgram&) = delete;

    // Waits while the program is busy. False if it ended or reads no further: finish() tells why.
    bool write(std::span<const std::uint8_t> bytes);
    // Tells the program that this is all and waits for its end. "" if it succeeded, else the last line of its
    // complaint.
    std::string finish();
    // Of the program, once it has ended [s].
    double cpu_seconds() const { return cpu_seconds_; }

private:
    std::string complaint() const;

    std::string name_;
    int to_program_ = -1, says_ = -1;  // descriptors
    pid_t process_ = -1;
    double cpu_seconds_ = 0;
};

}  // namespace drape
