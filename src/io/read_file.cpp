#include "io/read_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace drape {

void check_readable(const std::string& path, std::uint64_t largest) {
    namespace fs = std::filesystem;
    std::error_code trouble;
    const fs::file_status status = fs::status(path, trouble);
    if (status.type() == fs::file_type::not_found) throw Error(cat(path, ": no such file"));
    if (trouble) throw Error(cat(path, ": cannot read: ", trouble.message()));
    if (fs::is_directory(status)) throw Error(cat(path, ": is a folder, not a file"));
    if (!fs::is_regular_file(status)) throw Error(cat(path, ": is not a regular file"));
    const std::uintmax_t size = fs::file_size(path, trouble);
    if (trouble) throw Error(cat(path, ": cannot read: ", trouble.message()));
    if (size > largest) throw Error(cat(path, ": ", size, " bytes is too large (at most ", largest, ")"));
    if (size == 0) throw Error(cat(path, ": is empty"));
    if (!std::ifstream(path, std::ios::binary))
        throw Error(cat(path, ": cannot read: ", std::strerror(errno)));
}

std::string read_file(const std::string& path, std::uint64_t largest) {
    check_readable(path, largest);
    std::ifstream file(path, std::ios::binary);
    std::string bytes(static_cast<size_t>(std::filesystem::file_size(path)), '\0');
    if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        throw Error(cat(path, ": cannot read: ", std::strerror(errno)));
    return bytes;
}

}  // namespace drape
