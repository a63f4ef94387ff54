#include "io/png_chunks.h"

#include <libdeflate.h>

#include <algorithm>
#include <cstdint>

#include "base/error.h"
#include "io/bytes.h"

namespace drape {

namespace {

constexpr size_t signature_bytes = 8, number_bytes = 4, type_bytes = 4;
constexpr size_t least_chunk = number_bytes + type_bytes + number_bytes;  // length, type, checksum

struct Chunk {
    std::string_view type, data;
};

// Takes the chunk that `rest` begins with off it.
Chunk next_chunk(const std::string& path, std::string_view& rest) {
    if (rest.size() < least_chunk) throw Error(cat(path, ": the picture is cut off: no IEND chunk"));
    const auto length = number_at<std::uint32_t>(rest.data(), std::endian::big);
    const Chunk chunk{rest.substr(number_bytes, type_bytes), rest.substr(number_bytes + type_bytes, length)};
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (!std::all_of(chunk.type.begin(), chunk.type.end(), is_letter))
        throw Error(cat(path, ": is damaged: a chunk's type is not four letters"));
    if (length > rest.size() - least_chunk)
        throw Error(cat(path, ": the picture is cut off within its ", chunk.type, " chunk"));
    const std::uint32_t sum = libdeflate_crc32(0, chunk.type.data(), type_bytes + length);
    if (sum != number_at<std::uint32_t>(chunk.data.data() + length, std::endian::big))
        throw Error(cat(path, ": is damaged: its ", chunk.type, " chunk has another checksum"));
    rest.remove_prefix(least_chunk + length);
    return chunk;
}

bool must_be_understood(std::string_view type) {
    return type.front() >= 'A' && type.front() <= 'Z';
}

void add_chunk(std::string& png, const Chunk& chunk) {
    std::vector<std::uint8_t> length;
    put<std::endian::big>(length, static_cast<std::uint32_t>(chunk.data.size()));
    png.append(length.begin(), length.end()).append(chunk.type).append(chunk.data).append(number_bytes, '\0');
}

}  // namespace

std::string plain_png(const std::string& path, std::string_view bytes) {
    std::string plain(bytes.substr(0, signature_bytes)), data;
    std::string_view rest = bytes.substr(std::min(signature_bytes, bytes.size()));
    for (Chunk chunk = next_chunk(path, rest); chunk.type != "IEND"; chunk = next_chunk(path, rest)) {
        if (chunk.type == "IDAT") {
            data += chunk.data;
        } else if (chunk.type == "PLTE") {
            constexpr size_t colour = 3, most = 256 * colour;
            if (chunk.data.empty() || chunk.data.size() > most || chunk.data.size() % colour != 0)
                throw Error(cat(path, ": is damaged: its palette has ", chunk.data.size(),
                                " bytes (allowed: 3 a colour, 1 to 256 colours)"));
            std::string palette(chunk.data);
            palette.resize(most);
            add_chunk(plain, {chunk.type, palette});
        } else if (chunk.type == "IHDR" || chunk.type == "tRNS") {
            add_chunk(plain, chunk);
        } else if (must_be_understood(chunk.type)) {
            throw Error(cat(path, ": has a chunk ", chunk.type,
                            ", which no PNG reader may skip and drape does not know"));
        }
    }
    if (data.empty()) throw Error(cat(path, ": the picture has no data: no IDAT chunk"));
    add_chunk(plain, {"IDAT", data});
    add_chunk(plain, {"IEND", ""});
    return plain;
}

}  // namespace drape
