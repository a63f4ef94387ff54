#include "io/isolated.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>

#include "base/error.h"

namespace drape {

namespace {

// the first byte of what comes back
constexpr char is_result = 'r', is_error = 'e', is_out_of_memory = 'm';

void limit(int what, rlim_t most) {
    rlimit now{};
    getrlimit(static_cast<__rlimit_resource_t>(what), &now);
    const rlimit lower{std::min(most, now.rlim_max), std::min(most, now.rlim_max)};
    setrlimit(what, &lower);
}

// What the parent has allocated already counts as the child's. [bytes]
std::uint64_t inherited_memory() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
    statm >> size >> resident >> shared >> text >> library >> data;
    return data * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::string answer_of(const std::function<std::string()>& work) {
    try {
        return is_result + work();
    } catch (const Error& error) {
        return is_error + std::string(error.what());
    } catch (const std::bad_alloc&) {
        return {is_out_of_memory};
    } catch (const std::exception& error) {
        return is_error + std::string(error.what());
    }
}

[[noreturn]] void be_the_child(const Limits& limits, const std::function<std::string()>& work,
                               int to_parent) {
    // the parent's handlers and its terminal are not for us
    for (const int signal : {SIGINT, SIGTERM, SIGSEGV, SIGABRT, SIGBUS, SIGFPE}) std::signal(signal, SIG_DFL);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_DATA, inherited_memory() + limits.memory);
    limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu));

    const std::string answer = answer_of(work);
    for (std::string_view rest = answer; !rest.empty();) {
        const ssize_t done = write(to_parent, rest.data(), rest.size());
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) _exit(1);
        rest.remove_prefix(static_cast<size_t>(done));
    }
    _exit(0);
}

std::string read_all(int from_child) {
    std::string answer, chunk(1 << 16, '\0');
    for (;;) {
        const ssize_t got = read(from_child, chunk.data(), chunk.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return answer;
        answer.append(chunk, 0, static_cast<size_t>(got));
    }
}

}  // namespace

std::string run_isolated(const Limits& limits, const std::function<std::string()>& work) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Error(cat("cannot start a process: ", std::strerror(errno)));
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        be_the_child(limits, work, ends[1]);
    }
    close(ends[1]);
    std::string answer = child > 0 ? read_all(ends[0]) : "";
    close(ends[0]);
    if (child < 0) throw Error(cat("cannot start a process: ", std::strerror(errno)));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;

    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
        throw Error(cat("needs more than ", limits.cpu, " s"));
    const bool whole = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !answer.empty();
    if (!whole) throw Error("crashes the reader");
    if (answer[0] == is_out_of_memory)
        throw Error(cat("needs more than ", limits.memory >> 20, " MB of memory"));
    if (answer[0] == is_error) throw Error(answer.substr(1));
    answer.erase(0, 1);
    return answer;
}

}  // namespace drape
