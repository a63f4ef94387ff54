#include "io/glb_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string_view>

#include "base/assert.h"
#include "base/error.h"
#include "io/bytes.h"
#include "io/glb_layout.h"
#include "io/output_file.h"
#include "mesh/normals.h"

namespace drape {

namespace {

constexpr auto little = std::endian::little;
constexpr std::uint64_t file_header = 12, chunk_header = 8, most_bytes = 0xffffffff;

using Floats = Eigen::Matrix3Xf;

std::vector<std::uint8_t> bytes_of(const Eigen::Ref<const Eigen::MatrixXf>& numbers) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(static_cast<size_t>(numbers.size()) * sizeof(float));
    for (Eigen::Index i = 0; i < numbers.cols(); ++i)
        for (const float number : numbers.col(i)) put<little>(bytes, number);
    return bytes;
}

// The drawn vertices in the order of the file's vertices that stand for them.
std::vector<int> vertices_in_file_order(const Mesh& mesh) {
    std::vector<size_t> first(static_cast<size_t>(mesh.vertices()), mesh.file_vertex.size());
    for (size_t i = mesh.file_vertex.size(); i-- > 0;)
        if (mesh.file_vertex[i] >= 0) first[static_cast<size_t>(mesh.file_vertex[i])] = i;
    std::vector<int> order(mesh.drawn.vertex.size());
    std::iota(order.begin(), order.end(), 0);
    const auto place = [&](int drawn) {
        return first[static_cast<size_t>(mesh.drawn.vertex[static_cast<size_t>(drawn)])];
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return place(a) < place(b); });
    return order;
}

GlbBounds bounds_of(const Floats& points) {
    return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()};
}

std::uint64_t in_fours(std::uint64_t size) {
    return (size + 3) / 4 * 4;
}

class GlbWriter : public CacheWriter {
public:
    GlbWriter(const std::string& path, const Mesh& mesh, double frame_rate, int samples, const Colour& colour)
        : path_(path),
          mesh_(mesh),
          frame_rate_(frame_rate),
          order_(vertices_in_file_order(mesh)),
          layout_{.name = std::filesystem::path(path).stem().string(),
                  .colour = colour,
                  .vertices = order_.size(),
                  .triangles = static_cast<std::uint64_t>(mesh.triangles()),
                  .samples = static_cast<std::uint64_t>(samples),
                  .has_uv = mesh.drawn.uv.cols() > 0},
          json_room_(longest_json()),
          file_(path) {
        file_.write(std::vector<std::uint8_t>(file_header + chunk_header + json_room_ + chunk_header));
        write_corners();
        if (layout_.has_uv) write_uv();
    }

    void add(In positions) override {
        DRAPE_ASSERT(bounds_.size() < layout_.samples);
        const Points normals = vertex_normals(positions, mesh_.faces);
        if (bounds_.empty()) {
            positions_ = spread(positions).cast<float>();
            normals_ = spread(normals).cast<float>();
            write_sample(positions_, normals_);
        } else {
            write_sample((spread(positions) - positions_.cast<double>()).cast<float>(),
                         (spread(normals) - normals_.cast<double>()).cast<float>());
        }
    }

    void finish() override {
        layout_.samples = bounds_.size();
        if (layout_.samples > 1) write_animation();
        const std::string json = glb_json(layout_, bounds_, time_of(layout_.samples - 1));
        DRAPE_ASSERT(json.size() <= json_room_);
        std::vector<std::uint8_t> head;
        head.reserve(file_header + chunk_header + json_room_ + chunk_header);
        const auto put_word = [&](std::uint64_t word) {
            put<little>(head, static_cast<std::uint32_t>(word));
        };
        const auto put_letters = [&](std::string_view letters) {
            head.insert(head.end(), letters.begin(), letters.end());
        };
        put_letters("glTF");
        put_word(2);
        put_word(file_header + chunk_header + json_room_ + chunk_header + layout_.bytes());
        put_word(json_room_);
        put_letters("JSON");
        put_letters(json);
        head.resize(file_header + chunk_header + json_room_, ' ');
        put_word(layout_.bytes());
        put_letters(std::string_view("BIN\0", 4));
        file_.patch(0, head);
        file_.finish();
    }

private:
    // The JSON stands before what it tells of: it gets as much room as its longest numbers need, spaces fill
    // the rest.
    std::uint64_t longest_json() const {
        const auto samples = static_cast<double>(layout_.samples);
        demand_at_most_4_gib(24 * samples * static_cast<double>(layout_.vertices) +
                             4 * samples * (samples - 1));
        const Eigen::Vector3f longest = Eigen::Vector3f::Constant(-std::numeric_limits<float>::min());
        const std::vector<GlbBounds> bounds(layout_.samples, GlbBounds{longest, longest});
        const std::uint64_t room = in_fours(glb_json(layout_, bounds, longest[0]).size());
        demand_at_most_4_gib(static_cast<double>(file_header + 2 * chunk_header + room + layout_.bytes()));
        return room;
    }

    void demand_at_most_4_gib(double bytes) const {
        if (bytes > static_cast<double>(most_bytes))
            throw Error(cat(path_, ": ", layout_.samples, " samples of ", layout_.vertices, " vertices need ",
                            bytes / 1e9,
                            " GB, and a glTF binary holds 4.29 (take .pc2 or .mdd, or fewer frames)"));
    }

    Points spread(In simulated) const {
        Points points(3, static_cast<Eigen::Index>(order_.size()));
        for (size_t i = 0; i < order_.size(); ++i)
            points.col(static_cast<Eigen::Index>(i)) =
                simulated.col(mesh_.drawn.vertex[static_cast<size_t>(order_[i])]);
        return points;
    }

    void write_corners() {
        std::vector<std::uint32_t> place(order_.size());
        for (size_t i = 0; i < order_.size(); ++i)
            place[static_cast<size_t>(order_[i])] = static_cast<std::uint32_t>(i);
        std::vector<std::uint8_t> bytes;
        bytes.reserve(layout_.corner_bytes());
        for (int f = 0; f < mesh_.triangles(); ++f)
            for (const int corner : mesh_.drawn.faces.col(f))
                put<little>(bytes, place[static_cast<size_t>(corner)]);
        file_.write(bytes);
    }

    // v of a glTF runs down
    void write_uv() {
        Eigen::Matrix2Xf uv(2, static_cast<Eigen::Index>(order_.size()));
        for (Eigen::Index i = 0; i < uv.cols(); ++i) {
            const auto from = mesh_.drawn.uv.col(order_[static_cast<size_t>(i)]);
            uv.col(i) << from[0], 1 - from[1];
        }
        file_.write(bytes_of(uv));
    }

    void write_sample(const Floats& positions, const Floats& normals) {
        bounds_.push_back(bounds_of(positions));
        if (!bounds_.back().least.allFinite() || !bounds_.back().most.allFinite())
            throw Error(cat(path_, ": sample ", bounds_.size() - 1, " lies beyond a float's 3.4e38 m"),
                        Exit::went_wrong);
        file_.write(bytes_of(positions));
        file_.write(bytes_of(normals));
    }

    float time_of(size_t sample) const {
        return static_cast<float>(static_cast<double>(sample) / frame_rate_);
    }

    // At the time of sample k the weight of target k - 1 is 1, and in between two share it.
    void write_animation() {
        std::vector<std::uint8_t> times;
        for (size_t k = 0; k < layout_.samples; ++k) put<little>(times, time_of(k));
        file_.write(times);
        Eigen::VectorXf weights = Eigen::VectorXf::Zero(static_cast<Eigen::Index>(layout_.targets()));
        for (Eigen::Index k = 0; k <= weights.size(); ++k) {
            if (k > 0) weights[k - 1] = 1;
            file_.write(bytes_of(weights));
            if (k > 0) weights[k - 1] = 0;
        }
    }

    std::string path_;
    Mesh mesh_;
    double frame_rate_;
    std::vector<int> order_;  // drawn vertices, as they are written
    GlbLayout layout_;
    std::uint64_t json_room_;
    OutputFile file_;
    Floats positions_, normals_;  // of sample 0, as written
    std::vector<GlbBounds> bounds_;
};

}  // namespace

std::unique_ptr<CacheWriter> make_glb_writer(const std::string& path, const Mesh& mesh, double frame_rate,
                                             int samples, const Colour& colour) {
    return std::make_unique<GlbWriter>(path, mesh, frame_rate, samples, colour);
}

}  // namespace drape
