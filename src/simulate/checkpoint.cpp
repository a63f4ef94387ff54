#include "simulate/checkpoint.h"

#include "base/hash.h"
#include "simulate/archive.h"

namespace drape {

namespace {

constexpr std::string_view magic = "drape checkpoint 2\n";

}  // namespace

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
    ByteWriter body;
    body.put(checkpoint.scene_hash);
    body.put(checkpoint.start_energy);
    body.put(checkpoint.passes);
    std::string bytes = std::string(magic) + std::move(body).bytes();
    const std::uint64_t hash = hash_bytes(bytes.data(), bytes.size());
    return bytes.append(reinterpret_cast<const char*>(&hash), sizeof hash);
}

std::optional<Checkpoint> read_checkpoint(std::string_view bytes) {
    std::uint64_t hash = 0;
    if (!bytes.starts_with(magic) || bytes.size() < magic.size() + sizeof hash) return std::nullopt;
    const std::string_view signed_part = bytes.substr(0, bytes.size() - sizeof hash);
    std::memcpy(&hash, bytes.data() + signed_part.size(), sizeof hash);
    if (hash != hash_bytes(signed_part.data(), signed_part.size())) return std::nullopt;
    ByteReader rest(signed_part.substr(magic.size()));
    Checkpoint checkpoint;
    checkpoint.scene_hash = rest.take<std::uint64_t>();
    checkpoint.start_energy = rest.take<double>();
    checkpoint.passes = rest.take_text();
    if (!rest.at_end()) return std::nullopt;
    return checkpoint;
}

}  // namespace drape
