#include "video/piped_program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>

#include "base/assert.h"
#include "base/error.h"

namespace drape {

namespace {

void close_if_open(int& descriptor) {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
}

// Error number of posix_spawnp; the program is in a group of its own, so that Ctrl-C is drape's to handle.
int spawn(std::vector<std::string> words, int reads, int says, pid_t& process) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, reads, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, says, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

// "Unknown encoder" of "[libx264 @ 0x55d0c8] Unknown encoder": where in memory something lay helps nobody.
std::string without_address(const std::string& line) {
    const size_t end = line.find("] ");
    return line.starts_with("[") && end != std::string::npos && line.find(" @ 0x") < end
               ? line.substr(end + 2)
               : line;
}

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

PipedProgram::PipedProgram(const std::vector<std::string>& words) : name_(words.at(0)) {
    // a socket, unlike a pipe, can be written to without a signal where nobody reads any more
    int ends[2] = {-1, -1};
    says_ = memfd_create("says", MFD_CLOEXEC);
    int error = says_ < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0 ? errno : 0;
    if (error == 0) error = spawn(words, ends[0], says_, process_);
    close_if_open(ends[0]);
    to_program_ = ends[1];
    if (error == 0) return;
    close_if_open(to_program_);
    close_if_open(says_);
    throw Error(error == ENOENT ? name_ + " is not installed" : cat(name_, ": ", std::strerror(error)),
                Exit::cannot_write);
}

PipedProgram::~PipedProgram() {
    close_if_open(to_program_);
    close_if_open(says_);
    if (process_ < 0) return;
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
}

bool PipedProgram::write(std::span<const std::uint8_t> bytes) {
    DRAPE_ASSERT(to_program_ >= 0);
    while (!bytes.empty()) {
        const ssize_t done = send(to_program_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) return false;
        bytes = bytes.subspan(static_cast<size_t>(done));
    }
    return true;
}

std::string PipedProgram::finish() {
    DRAPE_ASSERT(process_ >= 0);
    close_if_open(to_program_);
    int status = 0;
    rusage used{};
    while (wait4(process_, &status, 0, &used) < 0 && errno == EINTR) continue;
    process_ = -1;
    cpu_seconds_ = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
    if (WIFSIGNALED(status)) return cat(name_, " was ended by a signal: ", strsignal(WTERMSIG(status)));
    if (WEXITSTATUS(status) == 0) return "";
    const std::string line = complaint();
    return line.empty() ? cat(name_, " ended with exit code ", WEXITSTATUS(status)) : cat(name_, ": ", line);
}

std::string PipedProgram::complaint() const {
    std::string said(static_cast<size_t>(std::max<off_t>(0, lseek(says_, 0, SEEK_END))), '\0');
    const ssize_t got = pread(says_, said.data(), said.size(), 0);
    said.resize(static_cast<size_t>(std::max<ssize_t>(0, got)));
    std::istringstream lines(said);
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (line.find_first_not_of(" \t\r") != std::string::npos && line != "Conversion failed!") last = line;
    return without_address(last);
}

}  // namespace drape
