#include "app/child.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <sstream>
#include <thread>

#include "app/interrupt.h"

namespace drape {

namespace {

constexpr std::string_view own_name = "drape: ";

// The child is in a group of its own, so that Ctrl-C is ours to hand on.
pid_t spawn(std::vector<std::string> words, const std::string& folder, int says) {
    words.insert(words.begin(), "drape");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, says, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    pid_t child = -1;
    const int error = posix_spawn(&child, "/proc/self/exe", &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw Error(cat("cannot start another drape: ", std::strerror(error)), Exit::went_wrong);
    return child;
}

int status_of(pid_t child) {
    bool told = false;
    for (;;) {
        int status = 0;
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child) return status;
        if (interrupted() && !told) told = kill(child, SIGTERM) == 0;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

std::string last_line(int says) {
    std::string said(static_cast<size_t>(std::max<off_t>(0, lseek(says, 0, SEEK_END))), '\0');
    const ssize_t got = pread(says, said.data(), said.size(), 0);
    said.resize(static_cast<size_t>(std::max<ssize_t>(0, got)));
    std::istringstream lines(said);
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) last = line;
    return last.starts_with(own_name) ? last.substr(own_name.size()) : last;
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& arguments, const std::string& folder) {
    const int says = memfd_create("says", MFD_CLOEXEC);
    if (says < 0) throw Error(cat("cannot start another drape: ", std::strerror(errno)), Exit::went_wrong);
    ChildEnd end;
    try {
        const int status = status_of(spawn(arguments, folder, says));
        end.complaint = last_line(says);
        if (WIFSIGNALED(status)) {
            end.code = Exit::went_wrong;
            end.complaint = cat("was ended by a signal: ", strsignal(WTERMSIG(status)));
        } else {
            end.code = static_cast<Exit>(WEXITSTATUS(status));
        }
    } catch (...) {
        ::close(says);
        throw;
    }
    ::close(says);
    return end;
}

}  // namespace drape
