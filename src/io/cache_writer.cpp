#include "io/cache_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/assert.h"
#include "base/error.h"
#include "io/bytes.h"
#include "io/endings.h"
#include "io/glb_writer.h"
#include "io/output_file.h"
#include "io/write_mesh.h"

namespace drape {

namespace {

template <std::endian Order>
std::vector<std::uint8_t> floats_of(In points) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(static_cast<size_t>(points.size()) * sizeof(float));
    for (Eigen::Index i = 0; i < points.cols(); ++i)
        for (const double coordinate : points.col(i)) put<Order>(bytes, static_cast<float>(coordinate));
    return bytes;
}

// PC2, little endian: "POINTCACHE2\0", int32 version 1, int32 points, float start, float rate, int32 samples,
// then the samples. Start and rate count frames.
class Pc2Writer : public CacheWriter {
public:
    Pc2Writer(const std::string& path, const Mesh& mesh, int samples)
        : mesh_(mesh), promised_(samples), file_(path) {
        constexpr std::string_view magic("POINTCACHE2\0", 12);
        std::vector<std::uint8_t> header(magic.begin(), magic.end());
        put<std::endian::little>(header, std::int32_t{1});
        put<std::endian::little>(header, static_cast<std::int32_t>(mesh.file_vertex.size()));
        put<std::endian::little>(header, 0.0F);
        put<std::endian::little>(header, 1.0F);
        put<std::endian::little>(header, static_cast<std::int32_t>(samples));
        file_.write(header);
    }
    void add(In positions) override {
        DRAPE_ASSERT(added_ < promised_);
        file_.write(floats_of<std::endian::little>(in_file_order(mesh_, positions)));
        ++added_;
    }
    void finish() override {
        std::vector<std::uint8_t> count;
        put<std::endian::little>(count, static_cast<std::int32_t>(added_));
        file_.patch(samples_at, count);
        file_.finish();
    }

private:
    static constexpr std::uint64_t samples_at = 28;  // where the header counts them
    Mesh mesh_;
    int promised_, added_ = 0;
    OutputFile file_;
};

// MDD, big endian: int32 samples, int32 points, float time of each sample [s], then the samples.
class MddWriter : public CacheWriter {
public:
    MddWriter(const std::string& path, const Mesh& mesh, double frame_rate, int samples)
        : mesh_(mesh), frame_rate_(frame_rate), promised_(samples), file_(path) {
        file_.write(header(samples));
    }
    void add(In positions) override {
        DRAPE_ASSERT(added_ < promised_);
        file_.write(floats_of<std::endian::big>(in_file_order(mesh_, positions)));
        ++added_;
    }
    void finish() override {
        // the samples of a run cut short begin earlier, behind a shorter list of times
        if (added_ < promised_) {
            const std::vector<std::uint8_t> shorter = header(added_);
            file_.close_gap(shorter.size(), header(promised_).size());
            file_.patch(0, shorter);
        }
        file_.finish();
    }

private:
    std::vector<std::uint8_t> header(int samples) const {
        std::vector<std::uint8_t> bytes;
        put<std::endian::big>(bytes, static_cast<std::int32_t>(samples));
        put<std::endian::big>(bytes, static_cast<std::int32_t>(mesh_.file_vertex.size()));
        for (int k = 0; k < samples; ++k) put<std::endian::big>(bytes, static_cast<float>(k / frame_rate_));
        return bytes;
    }

    Mesh mesh_;
    double frame_rate_;
    int promised_, added_ = 0;
    OutputFile file_;
};

// A mesh file per sample, all renamed together at the end.
class MeshSequence : public CacheWriter {
public:
    MeshSequence(const std::string& path, const Mesh& mesh, int samples)
        : path_(path), mesh_(mesh), digits_(std::max<size_t>(4, std::to_string(samples - 1).size())) {
        // an unwritable place is found out now, not after the first frame
        OutputFile probe(numbered(0));
    }
    void add(In positions) override {
        const std::string text = mesh_file(path_, mesh_, positions);
        auto file = std::make_unique<OutputFile>(numbered(files_.size()));
        file->write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
        file->close();
        files_.push_back(std::move(file));
    }
    void finish() override {
        for (const auto& file : files_) file->finish();
    }

private:
    std::string numbered(size_t index) const {
        std::string number = std::to_string(index);
        number.insert(0, digits_ - std::min(digits_, number.size()), '0');
        const std::filesystem::path path(path_);
        const std::string name = path.stem().string() + "_" + number + path.extension().string();
        return (path.parent_path() / name).string();
    }

    std::string path_;
    Mesh mesh_;
    size_t digits_;
    std::vector<std::unique_ptr<OutputFile>> files_;
};

std::unique_ptr<CacheWriter> make_pc2(const std::string& path, const Mesh& mesh, double, int samples,
                                      const Colour&) {
    return std::make_unique<Pc2Writer>(path, mesh, samples);
}
std::unique_ptr<CacheWriter> make_mdd(const std::string& path, const Mesh& mesh, double frame_rate,
                                      int samples, const Colour&) {
    return std::make_unique<MddWriter>(path, mesh, frame_rate, samples);
}
std::unique_ptr<CacheWriter> make_sequence(const std::string& path, const Mesh& mesh, double, int samples,
                                           const Colour&) {
    return std::make_unique<MeshSequence>(path, mesh, samples);
}

// Every cache drape writes. A new one: its class and its row here; the tests loop over the table.
constexpr std::array kinds{
    CacheKind{".pc2", "point cache 2, one file", make_pc2},
    CacheKind{".mdd", "motion designer data, one file, times in seconds", make_mdd},
    CacheKind{".obj", "a numbered OBJ per sample", make_sequence},
    CacheKind{".ply", "a numbered binary PLY per sample", make_sequence},
    CacheKind{".glb", "glTF binary with mesh, UVs and a morph target per frame", make_glb_writer},
};

}  // namespace

std::span<const CacheKind> cache_kinds() {
    return kinds;
}

std::unique_ptr<CacheWriter> make_cache_writer(const std::string& path, const Mesh& mesh, double frame_rate,
                                               int samples, const Colour& colour) {
    DRAPE_ASSERT(samples > 0 && frame_rate > 0);
    const std::string ending = ending_of(path);
    std::string known;
    for (const CacheKind& kind : kinds) {
        if (kind.ending == ending) return kind.make(path, mesh, frame_rate, samples, colour);
        known += cat(known.empty() ? "" : ", ", kind.ending);
    }
    throw Error(cat(path, ": unknown cache ending \"", ending, "\" (known: ", known, ")"));
}

}  // namespace drape
