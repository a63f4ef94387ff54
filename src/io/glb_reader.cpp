#include "io/glb_reader.h"

#include <bit>
#include <cstdint>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/bytes.h"

namespace drape {

namespace {

using Json = nlohmann::json;

constexpr auto little = std::endian::little;
constexpr size_t file_header = 12, chunk_header = 8;
constexpr int real = 5126;

std::uint32_t word_at(std::string_view bytes, size_t at) {
    return number_at<std::uint32_t>(bytes.data() + at, little);
}

// The chunk at `at`, whose type is `type`: four letters, or three and a zero.
std::string_view chunk_at(std::string_view bytes, size_t at, std::string_view type) {
    if (bytes.size() < at + chunk_header) throw Error(cat("has no ", type.data(), " chunk"));
    const size_t size = word_at(bytes, at), begin = at + chunk_header;
    if (bytes.substr(at + 4, 4) != type || size > bytes.size() - begin)
        throw Error(cat("has no whole ", type.data(), " chunk"));
    return bytes.substr(begin, size);
}

size_t whole(const Json& number) {
    if (!number.is_number_unsigned())
        throw Error(cat("has a ", number.type_name(), " where a whole number from 0 on is due"));
    return number.get<size_t>();
}

size_t offset_in(const Json& object, size_t bytes) {
    const size_t offset = object.contains("byteOffset") ? whole(object["byteOffset"]) : 0;
    if (offset > bytes) throw Error(cat("an accessor reaches beyond its ", bytes, " bytes"));
    return offset;
}

// Tightly packed floats, `rows` of them an element.
Eigen::MatrixXf floats_of(const Json& json, std::string_view binary, const Json& index, const char* type,
                          int rows) {
    const Json& accessor = json.at("accessors").at(whole(index));
    const Json& view = json.at("bufferViews").at(whole(accessor.at("bufferView")));
    const size_t count = whole(accessor.at("count")), element = sizeof(float) * static_cast<size_t>(rows);
    if (accessor.at("componentType") != real || accessor.at("type") != type || accessor.contains("sparse") ||
        (view.contains("byteStride") && view["byteStride"] != element))
        throw Error(cat("holds its positions in another way than as packed ", type, " of floats"));
    binary.remove_prefix(offset_in(view, binary.size()));
    binary.remove_prefix(offset_in(accessor, binary.size()));
    if (count > binary.size() / element)
        throw Error(cat("an accessor reaches beyond its ", binary.size(), " bytes"));
    Eigen::MatrixXf numbers(rows, static_cast<Eigen::Index>(count));
    for (Eigen::Index i = 0; i < numbers.size(); ++i)
        numbers.data()[i] = number_at<float>(binary.data() + sizeof(float) * static_cast<size_t>(i), little);
    return numbers;
}

Points points_of(const Json& json, std::string_view binary, const Json& attributes) {
    return floats_of(json, binary, attributes.at("POSITION"), "VEC3", 3).cast<double>();
}

Cache cache_of(const Json& json, std::string_view binary) {
    const Json& primitive = json.at("meshes").at(0).at("primitives").at(0);
    Cache cache;
    cache.samples.push_back(points_of(json, binary, primitive.at("attributes")));
    cache.times.push_back(0);
    if (!primitive.contains("targets")) return cache;
    // or many targets of the same bytes would take memory without end
    const auto samples = primitive["targets"].size() + 1,
               vertices = static_cast<size_t>(cache.samples[0].cols());
    if (vertices > 0 && samples > binary.size() / (3 * sizeof(float)) / vertices)
        throw Error(cat("has more morph targets than its ", binary.size(), " bytes can hold"));
    for (const Json& target : primitive.at("targets")) {
        const Points displacements = points_of(json, binary, target);
        if (displacements.cols() != cache.samples[0].cols())
            throw Error("has morph targets of another number of vertices than its mesh");
        cache.samples.push_back(cache.samples[0] + displacements);
    }
    const Json& times = json.at("animations").at(0).at("samplers").at(0).at("input");
    const Eigen::MatrixXf each = floats_of(json, binary, times, "SCALAR", 1);
    if (static_cast<size_t>(each.size()) != cache.samples.size())
        throw Error(cat("has ", cache.samples.size() - 1, " morph targets and ", each.size(),
                        " times (drape writes one more time than targets)"));
    cache.times.assign(each.data(), each.data() + each.size());
    return cache;
}

}  // namespace

Cache read_glb(const std::string& path, std::string_view bytes) {
    return in_context(path, [&] {
        if (bytes.size() < file_header || bytes.compare(0, 4, "glTF") != 0)
            throw Error("is not a glTF binary (does not begin with glTF)");
        if (word_at(bytes, 4) != 2 || word_at(bytes, 8) != bytes.size())
            throw Error(cat("is not a whole glTF binary of version 2: tells of ", word_at(bytes, 8),
                            " bytes and has ", bytes.size()));
        const std::string_view text = chunk_at(bytes, file_header, "JSON");
        const size_t second = file_header + chunk_header + text.size();
        const std::string_view binary = chunk_at(bytes, second, std::string_view("BIN\0", 4));
        try {
            return cache_of(Json::parse(text), binary);
        } catch (const Json::exception&) {
            throw Error("is not a glTF of one mesh with a morph target per frame, as drape writes it");
        }
    });
}

}  // namespace drape
