// Position caches: every frame's vertices, in the mesh file's vertex order, for other programs.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/colour.h"
#include "mesh/mesh.h"

namespace drape {

// Sample 0 is the start, sample k the state at frame k; a run of F frames writes F + 1 samples.
class CacheWriter {
public:
    virtual ~CacheWriter() = default;
    virtual void add(In positions) = 0;  // 3 x V, simulated vertices; written in file order
    // Makes the file(s) final; without it nothing is left behind. Fewer samples than promised are fine (a run
    // that ended early): the header says how many there are.
    virtual void finish() = 0;
};

struct CacheKind {
    std::string_view ending;  // ".pc2"
    std::string_view summary;
    std::unique_ptr<CacheWriter> (*make)(const std::string& path, const Mesh&, double frame_rate, int samples,
                                         const Colour&);
};

std::span<const CacheKind> cache_kinds();

inline constexpr Colour undyed{0.8F, 0.8F, 0.8F};

// The file's ending chooses: .pc2 (one file, start 0, rate 1), .mdd (one file, times in seconds),
// .obj and .ply (a numbered file per sample, NAME_0000.obj ...), .glb (one file with mesh, UVs and `colour`).
// One writer per cloth. Throws Error for another ending or an unwritable place.
std::unique_ptr<CacheWriter> make_cache_writer(const std::string& path, const Mesh& mesh, double frame_rate,
                                               int samples, const Colour& colour = undyed);

}  // namespace drape
