#include "support/run_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "support/temporary_folder.h"

namespace drape::test {

int Ran::error_lines() const {
    return static_cast<int>(std::count(err.begin(), err.end(), '\n'));
}

Ran run_drape(const std::vector<std::string>& arguments, const std::string& folder) {
    const TemporaryFolder streams;
    const std::string out = streams.file("out"), err = streams.file("err");
    std::vector<const char*> argv{"drape"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    argv.push_back(nullptr);

    const pid_t child = fork();
    if (child == 0) {
        const int to_out = open(out.c_str(), O_WRONLY | O_CREAT, 0600);
        const int to_err = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
        if (to_out < 0 || to_err < 0 || chdir(folder.c_str()) != 0) _exit(126);
        dup2(to_out, STDOUT_FILENO);
        dup2(to_err, STDERR_FILENO);
        execv(DRAPE_PROGRAM, const_cast<char* const*>(argv.data()));
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), bytes_of(out), bytes_of(err)};
}

}  // namespace drape::test
