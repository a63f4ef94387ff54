#include "io/write_file.h"

#include <filesystem>

#include "base/error.h"
#include "io/output_file.h"

namespace drape {

void write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.finish();
}

void write_file(const std::string& path, std::string_view text) {
    write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void make_folder(const std::string& path) {
    std::error_code trouble;
    std::filesystem::create_directories(path, trouble);
    if (!trouble && !std::filesystem::is_directory(path, trouble) && !trouble)
        trouble = std::make_error_code(std::errc::not_a_directory);
    if (trouble) throw Error(cat(path, ": cannot make the folder: ", trouble.message()), Exit::cannot_write);
}

}  // namespace drape
