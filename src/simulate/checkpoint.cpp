#include "simulate/checkpoint.h"

#include "base/hash.h"
#include "simulate/frame_bytes.h"

namespace drape {

namespace {

constexpr std::string_view magic = "drape checkpoint 3\n";

}  // namespace

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
    ByteWriter body;
    body.put(checkpoint.scene);
    body.put(checkpoint.steps);
    body.put(checkpoint.start_energy);
    body.put(checkpoint.solver.factorisations);
    body.put(checkpoint.solver.iterations);
    put_frames(body, checkpoint.frames);
    for (const std::string& picture : checkpoint.pictures) body.put(picture);
    body.put(checkpoint.keeps_positions);
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
    checkpoint.scene = rest.take_text();
    checkpoint.steps = rest.take_text();
    checkpoint.start_energy = rest.take<double>();
    checkpoint.solver.factorisations = rest.take<long>();
    checkpoint.solver.iterations = rest.take<long>();
    checkpoint.frames = take_frames(rest);
    for (size_t k = 0; k < checkpoint.frames.size() && rest.ok(); ++k)
        checkpoint.pictures.push_back(rest.take_text());
    checkpoint.keeps_positions = rest.take<bool>();
    checkpoint.passes = rest.take_text();
    if (!rest.at_end()) return std::nullopt;
    return checkpoint;
}

}  // namespace drape
