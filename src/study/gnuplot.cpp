#include "study/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "io/write_file.h"

namespace drape {

namespace {

namespace fs = std::filesystem;

constexpr const char* version_file = "version";

// A folder beside the results that is gone at the end, whatever happens.
class WorkFolder {
public:
    explicit WorkFolder(const std::string& beside) : path_(fs::path(beside) / cat("plots.part", getpid())) {
        make_folder(path_.string());
    }
    ~WorkFolder() {
        std::error_code none;
        fs::remove_all(path_, none);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::string first_line(const fs::path& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        if (line.find_first_not_of(" \t\r^") != std::string::npos) return line;
    return "";
}

// Exit code of gnuplot run in `folder`, or -1 with the reason in `trouble`.
int spawn(const fs::path& folder, std::string& trouble) {
    std::string print = cat("set print '", version_file, "'; print GPVAL_VERSION, 'patchlevel', ",
                            "GPVAL_PATCHLEVEL; set print");
    std::array<std::string, 4> words{"gnuplot", "-e", print, "../plots.gp"};
    std::array<char*, 5> arguments{words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                                   nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "says", O_CREAT | O_WRONLY | O_TRUNC, 0666);
    pid_t child = 0;
    const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        trouble = error == ENOENT ? "gnuplot is not installed" : cat("gnuplot: ", std::strerror(error));
        return -1;
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

GnuplotRun run_gnuplot(const std::string& folder) {
    GnuplotRun run;
    const WorkFolder work(folder);
    const int code = spawn(work.path(), run.trouble);
    if (!run.trouble.empty()) return run;
    run.version = first_line(work.path() / version_file);
    if (code != 0) {
        const std::string says = first_line(work.path() / "says");
        run.trouble = says.empty() ? cat("gnuplot ended with exit code ", code) : cat("gnuplot: ", says);
        return run;
    }
    for (const auto& entry : fs::directory_iterator(work.path())) {
        const fs::path ending = entry.path().extension();
        if (ending != ".svg" && ending != ".png") continue;
        std::error_code error;
        fs::rename(entry.path(), fs::path(folder) / entry.path().filename(), error);
        if (error) run.trouble = cat(entry.path().filename().string(), ": cannot write: ", error.message());
    }
    return run;
}

}  // namespace drape
