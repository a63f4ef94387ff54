#include "support/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "support/temporary_folder.h"

namespace drape::test {

namespace {

// The program as a process of its own, in `folder`, its output in two files.
pid_t start(const std::vector<std::string>& arguments, const std::string& folder, const std::string& out,
            const std::string& err) {
    std::vector<const char*> argv{"drape"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    const int to_out = open(out.c_str(), O_WRONLY | O_CREAT, 0600);
    const int to_err = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
    if (to_out < 0 || to_err < 0 || chdir(folder.c_str()) != 0) _exit(126);
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

Ran run_drape(const std::vector<std::string>& arguments, const std::string& folder) {
    const TemporaryFolder streams;
    const std::string out = streams.file("out"), err = streams.file("err");
    const pid_t child = start(arguments, folder, out, err);
    int status = 0;
    waitpid(child, &status, 0);
    return {exit_code_of(status), bytes_of(out), bytes_of(err)};
}

int interrupted_drape(const std::vector<std::string>& arguments, const std::function<bool()>& sign) {
    const TemporaryFolder streams;
    const pid_t child = start(arguments, ".", streams.file("out"), streams.file("err"));
    int status = 0;
    while (!sign()) {
        if (waitpid(child, &status, WNOHANG) != 0) return exit_code_of(status);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(child, SIGINT);
    waitpid(child, &status, 0);
    return exit_code_of(status);
}

}  // namespace drape::test
