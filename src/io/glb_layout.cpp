#include "io/glb_layout.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/assert.h"

namespace drape {

namespace {

using Json = nlohmann::ordered_json;

// numbers of the glTF 2.0 specification
constexpr int unsigned_int = 5125, real = 5126, vertex_buffer = 34962, index_buffer = 34963;

// Views of the buffer one behind the other, each with its accessor.
class Views {
public:
    // `target` 0: neither vertices nor indices. Returns the accessor's index.
    size_t add(std::uint64_t bytes, int target, int component, std::uint64_t count, const char* type) {
        Json view{{"buffer", 0}, {"byteOffset", end_}, {"byteLength", bytes}};
        if (target > 0) view["target"] = target;
        views.push_back(std::move(view));
        accessors.push_back({{"bufferView", views.size() - 1},
                             {"componentType", component},
                             {"count", count},
                             {"type", type}});
        end_ += bytes;
        return accessors.size() - 1;
    }
    void bound(size_t accessor, Json least, Json most) {
        accessors[accessor]["min"] = std::move(least);
        accessors[accessor]["max"] = std::move(most);
    }
    std::uint64_t end() const { return end_; }

    Json views = Json::array(), accessors = Json::array();

private:
    std::uint64_t end_ = 0;
};

// As doubles, so that they read back as the very numbers.
Json exact(const Eigen::Vector3f& v) {
    return Json::array({static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
}

Json attributes_of_sample(Views& views, const GlbLayout& layout, const GlbBounds& bounds) {
    const auto vectors = [&] {
        return views.add(layout.vector_bytes(), vertex_buffer, real, layout.vertices, "VEC3");
    };
    Json attributes;
    attributes["POSITION"] = vectors();
    views.bound(attributes["POSITION"].get<size_t>(), exact(bounds.least), exact(bounds.most));
    attributes["NORMAL"] = vectors();
    return attributes;
}

double linear(float encoded) {
    const double c = static_cast<double>(encoded);
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Json material_of(const GlbLayout& layout) {
    const Colour& c = layout.colour;
    return {{"name", layout.name},
            {"doubleSided", true},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", Json::array({linear(c[0]), linear(c[1]), linear(c[2]), 1.0})},
              {"metallicFactor", 0.0},
              {"roughnessFactor", 0.9}}}};
}

}  // namespace

std::string glb_json(const GlbLayout& layout, const std::vector<GlbBounds>& bounds, float last_time) {
    DRAPE_ASSERT(layout.samples > 0 && bounds.size() == layout.samples);
    Views views;
    Json primitive{{"attributes", Json::object()}, {"indices", nullptr}, {"material", 0}, {"mode", 4}};
    primitive["indices"] =
        views.add(layout.corner_bytes(), index_buffer, unsigned_int, 3 * layout.triangles, "SCALAR");
    const size_t uv =
        layout.has_uv ? views.add(layout.uv_bytes(), vertex_buffer, real, layout.vertices, "VEC2") : 0;
    primitive["attributes"] = attributes_of_sample(views, layout, bounds[0]);
    if (layout.has_uv) primitive["attributes"]["TEXCOORD_0"] = uv;
    for (size_t k = 1; k < layout.samples; ++k)
        primitive["targets"].push_back(attributes_of_sample(views, layout, bounds[k]));

    const auto list_of = [](Json item) { return Json::array({std::move(item)}); };
    Json json;
    json["asset"] = {{"version", "2.0"}, {"generator", "drape"}};
    json["scene"] = 0;
    json["scenes"] = list_of({{"nodes", list_of(0)}});
    json["nodes"] = list_of({{"name", layout.name}, {"mesh", 0}});
    json["meshes"] = list_of({{"name", layout.name}, {"primitives", list_of(std::move(primitive))}});
    json["materials"] = list_of(material_of(layout));
    if (layout.samples > 1) {
        const size_t times = views.add(layout.time_bytes(), 0, real, layout.samples, "SCALAR");
        views.bound(times, list_of(0.0), list_of(static_cast<double>(last_time)));
        const size_t weights =
            views.add(layout.weight_bytes(), 0, real, layout.samples * layout.targets(), "SCALAR");
        const Json sampler{{"input", times}, {"interpolation", "LINEAR"}, {"output", weights}};
        const Json channel{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
        json["animations"] =
            list_of({{"name", layout.name}, {"samplers", list_of(sampler)}, {"channels", list_of(channel)}});
    }
    DRAPE_ASSERT(views.end() == layout.bytes());
    json["accessors"] = std::move(views.accessors);
    json["bufferViews"] = std::move(views.views);
    json["buffers"] = list_of({{"byteLength", layout.bytes()}});
    // a file's name may hold bytes that are no UTF-8
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace drape
