#include "simulate/checkpoint.h"

#include <cstring>

#include "base/hash.h"

namespace drape {

namespace {

constexpr std::string_view magic = "drape checkpoint 1\n";

template <class Number>
void put(std::string& bytes, const Number& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Number>
bool take(std::string_view& bytes, Number& value) {
    if (bytes.size() < sizeof value) return false;
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
    return true;
}

bool take(std::string_view& bytes, Points& points, std::uint64_t columns) {
    const std::uint64_t size = columns * 3 * sizeof(double);
    if (columns > bytes.size() || bytes.size() < size) return false;
    points.resize(3, static_cast<Eigen::Index>(columns));
    std::memcpy(points.data(), bytes.data(), size);
    bytes.remove_prefix(size);
    return true;
}

}  // namespace

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
    std::string bytes(magic);
    put(bytes, checkpoint.scene_hash);
    put(bytes, checkpoint.frame);
    put(bytes, checkpoint.state.time);
    put(bytes, checkpoint.flow.dissipated);
    put(bytes, checkpoint.flow.driven);
    put(bytes, checkpoint.start_energy);
    put(bytes, static_cast<std::uint64_t>(checkpoint.state.x.cols()));
    for (const Points* points : {&checkpoint.state.x, &checkpoint.state.v})
        bytes.append(reinterpret_cast<const char*>(points->data()),
                     static_cast<size_t>(points->size()) * sizeof(double));
    put(bytes, hash_bytes(bytes.data(), bytes.size()));
    return bytes;
}

std::optional<Checkpoint> read_checkpoint(std::string_view bytes) {
    std::uint64_t columns = 0, hash = 0;
    if (!bytes.starts_with(magic) || bytes.size() < magic.size() + sizeof hash) return std::nullopt;
    const std::string_view signed_part = bytes.substr(0, bytes.size() - sizeof hash);
    std::memcpy(&hash, bytes.data() + signed_part.size(), sizeof hash);
    if (hash != hash_bytes(signed_part.data(), signed_part.size())) return std::nullopt;
    std::string_view rest = signed_part.substr(magic.size());
    Checkpoint checkpoint;
    const bool whole = take(rest, checkpoint.scene_hash) && take(rest, checkpoint.frame) &&
                       take(rest, checkpoint.state.time) && take(rest, checkpoint.flow.dissipated) &&
                       take(rest, checkpoint.flow.driven) && take(rest, checkpoint.start_energy) &&
                       take(rest, columns) && take(rest, checkpoint.state.x, columns) &&
                       take(rest, checkpoint.state.v, columns) && rest.empty();
    if (!whole) return std::nullopt;
    return checkpoint;
}

}  // namespace drape
