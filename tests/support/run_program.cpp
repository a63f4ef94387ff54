#include "support/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "support/temporary_folder.h"

namespace drape::test {

namespace {

struct Limit {
    int resource = -1;  // none
    rlim_t most = 0;
};

// The program as a process of its own, in `folder`, its output in two files.
pid_t start(const std::vector<std::string>& arguments, const std::string& folder, const std::string& out,
            const std::string& err, const Limit& limit = {}) {
    std::vector<const char*> argv{"drape"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    const int to_out = open(out.c_str(), O_WRONLY | O_CREAT, 0600);
    const int to_err = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
    if (to_out < 0 || to_err < 0 || chdir(folder.c_str()) != 0) _exit(126);
    const rlimit most{limit.most, limit.most};
    if (limit.resource >= 0 && setrlimit(static_cast<__rlimit_resource_t>(limit.resource), &most) != 0)
        _exit(126);
    dup2(to_out, STDOUT_FILENO);
    dup2(to_err, STDERR_FILENO);
    execv(DRAPE_PROGRAM, const_cast<char* const*>(argv.data()));
    _exit(127);
}

int exit_code_of(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

int Ran::error_lines() const {
    return static_cast<int>(std::count(err.begin(), err.end(), '\n'));
}

namespace {

Ran run_to_the_end(const std::vector<std::string>& arguments, const std::string& folder, const Limit& limit) {
    const TemporaryFolder streams;
    const std::string out = streams.file("out"), err = streams.file("err");
    const pid_t child = start(arguments, folder, out, err, limit);
    int status = 0;
    waitpid(child, &status, 0);
    return {exit_code_of(status), bytes_of(out), bytes_of(err)};
}

}  // namespace

Ran run_drape(const std::vector<std::string>& arguments, const std::string& folder) {
    return run_to_the_end(arguments, folder, {});
}

Ran run_drape_within(int resource, std::uint64_t most, const std::vector<std::string>& arguments,
                     const std::string& folder) {
    return run_to_the_end(arguments, folder, {resource, most});
}

int interrupted_drape(const std::vector<std::string>& arguments, const std::function<bool()>& sign,
                      int signal) {
    const TemporaryFolder streams;
    const pid_t child = start(arguments, ".", streams.file("out"), streams.file("err"));
    int status = 0;
    while (!sign()) {
        if (waitpid(child, &status, WNOHANG) != 0) return exit_code_of(status);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(child, signal);
    waitpid(child, &status, 0);
    return exit_code_of(status);
}

}  // namespace drape::test
