#include "app/leftovers.h"

#include <csignal>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <string_view>

namespace drape {

namespace {

namespace fs = std::filesystem;

// "NAME.part123-4" of a process 123 that is no more
bool is_leftover(std::string_view name) {
    constexpr std::string_view mark = ".part";
    const size_t at = name.rfind(mark);
    if (at == name.npos) return false;
    const std::string_view tail = name.substr(at + mark.size());
    pid_t process = 0;
    unsigned count = 0;
    const char* const end = tail.data() + tail.size();
    const auto [dash, first] = std::from_chars(tail.data(), end, process);
    if (first != std::errc() || process <= 0 || dash == end || *dash != '-') return false;
    const auto [last, second] = std::from_chars(dash + 1, end, count);
    return second == std::errc() && last == end && kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace

void remove_leftovers(const std::string& folder, const std::string& prefix) {
    std::error_code trouble;
    for (const auto& entry : fs::directory_iterator(folder, trouble)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(prefix) && is_leftover(name)) fs::remove(entry.path(), trouble);
    }
}

}  // namespace drape
