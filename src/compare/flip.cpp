#include "compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "compare/vision.h"

namespace drape {

namespace {

constexpr double per_degree =
    3840 * std::numbers::pi / 180;  // pixels, seen from as far as the screen is wide

// The contrast sensitivity of a channel: sums of Gaussians a sqrt(pi / b) exp(-pi^2 r^2 / b), r in degrees.
struct Sensitivity {
    double a, b;
    double sigma() const { return std::sqrt(b / 2) / std::numbers::pi * per_degree; }  // [pixels]
};
constexpr Sensitivity light_dark{1, 0.0047}, red_green{1, 0.0053};
constexpr std::array<Sensitivity, 2> blue_yellow{Sensitivity{34.1, 0.04}, Sensitivity{13.5, 0.025}};

constexpr int narrow = 5;        // radius of the two sharp channels: what lies beyond weighs under 1e-4
constexpr int wide = 10;         // three sigma of the widest: all of these radii are in pixels
constexpr int feature = 9;       // three sigma of edges and points
constexpr double width = 0.082;  // of an edge as the eye detects it, two sigma [degrees]

struct Filters {
    std::vector<float> light, colour;
    std::array<std::vector<float>, 2> blue;
    std::array<float, 2> blue_share{};  // of the two Gaussians
    std::vector<float> smooth, slope,
        bulge;  // a Gaussian and its derivatives: positive weights sum to 1, negative to -1

    Filters();
};

void balance(std::vector<float>& weights) {
    float positive = 0, negative = 0;
    for (const float weight : weights) (weight > 0 ? positive : negative) += weight;
    for (float& weight : weights) weight /= weight > 0 ? positive : -negative;
}

Filters::Filters()
    : light(gaussian(light_dark.sigma(), narrow)), colour(gaussian(red_green.sigma(), narrow)) {
    std::array<double, 2> volume{};
    for (size_t i = 0; i < 2; ++i) {
        const Sensitivity& part = blue_yellow[i];
        blue[i] = gaussian(part.sigma(), wide);
        double sum = 0;
        for (int x = -wide; x <= wide; ++x) sum += std::exp(-x * x / (2 * part.sigma() * part.sigma()));
        volume[i] = part.a * std::sqrt(std::numbers::pi / part.b) * sum * sum;
    }
    for (size_t i = 0; i < 2; ++i) blue_share[i] = static_cast<float>(volume[i] / (volume[0] + volume[1]));
    const double sigma = width / 2 * per_degree;
    smooth = slope = bulge = gaussian(sigma, feature);
    for (int x = -feature; x <= feature; ++x) {
        const auto i = static_cast<size_t>(x + feature);
        slope[i] *= static_cast<float>(-x);
        bulge[i] *= static_cast<float>(x * x / (sigma * sigma) - 1);
    }
    balance(slope);
    balance(bulge);
}

// A picture's tile as the eye has it.
struct Seen {
    Opponent colours;                  // blurred, in Hunt's L*a*b*
    std::vector<float> edges, points;  // how strong they are at each pixel
};

std::vector<float> strength(const Plane& y, const Filters& filters, const std::vector<float>& derivative) {
    const Plane across = filtered(y, derivative, filters.smooth),
                down = filtered(y, filters.smooth, derivative);
    std::vector<float> length(across.values.size());
    for (size_t i = 0; i < length.size(); ++i) {
        const float u = across.values[i] / 116, v = down.values[i] / 116;
        length[i] = std::sqrt(u * u + v * v);
    }
    return length;
}

Seen seen(const Image& image, const Tile& tile, const Filters& filters) {
    const Opponent sharp = opponent_colours(image, tile, wide);
    Seen result;
    result.colours = {filtered(sharp.y, filters.light, filters.light),
                      filtered(sharp.cx, filters.colour, filters.colour),
                      filtered(sharp.cz, filters.blue[0], filters.blue[0])};
    const Plane more = filtered(sharp.cz, filters.blue[1], filters.blue[1]);
    for (size_t i = 0; i < more.values.size(); ++i) {
        float& cz = result.colours.cz.values[i];
        cz = filters.blue_share[0] * cz + filters.blue_share[1] * more.values[i];
    }
    to_hunt_lab(result.colours);
    result.edges = strength(sharp.y, filters, filters.slope);
    result.points = strength(sharp.y, filters, filters.bulge);
    return result;
}

// HyAB: lightness apart, plus the distance of the other two.
float hyab(const Opponent& one, const Opponent& other, size_t i) {
    const float a = one.cx.values[i] - other.cx.values[i], b = one.cz.values[i] - other.cz.values[i];
    return std::abs(one.y.values[i] - other.y.values[i]) + std::sqrt(a * a + b * b);
}

constexpr float colour_exponent = 0.7F;

// the largest distance that colours can have, green from blue, to the exponent
float largest_distance() {
    Image pure(2, 1);
    pure.pixel(0, 0)[1] = pure.pixel(1, 0)[2] = 255;
    Opponent green = opponent_colours(pure, {0, 0, 1, 1}, 0), blue = opponent_colours(pure, {1, 0, 2, 1}, 0);
    to_hunt_lab(green);
    to_hunt_lab(blue);
    return std::pow(hyab(green, blue, 0), colour_exponent);
}

// Distances up to 0.4 of the largest take 0.95 of the scale.
float spread(float distance, float largest) {
    constexpr float knee = 0.4F, share = 0.95F;
    const float bend = knee * largest;
    return distance < bend ? share / bend * distance
                           : share + (distance - bend) / (largest - bend) * (1 - share);
}

}  // namespace

double ErrorMap::mean() const {
    double sum = 0;
    for (const float e : error) sum += e;
    return error.empty() ? 0 : sum / static_cast<double>(error.size());
}

ErrorMap flip(const Image& picture, const Image& reference) {
    static const Filters filters;
    static const float largest = largest_distance();
    DRAPE_ASSERT(picture.width == reference.width && picture.height == reference.height);
    ErrorMap map{picture.width, picture.height, std::vector<float>(picture.rgb.size() / 3)};
    for (const Tile& tile : changed_tiles(picture, reference, wide)) {
        const Seen one = seen(picture, tile, filters), other = seen(reference, tile, filters);
        for (int y = 0; y < tile.height(); ++y) {
            float* error = &map.error[static_cast<size_t>(tile.top + y) * static_cast<size_t>(map.width) +
                                      static_cast<size_t>(tile.left)];
            for (int x = 0; x < tile.width(); ++x) {
                const auto i = static_cast<size_t>(y * tile.width() + x);
                const float apart = hyab(one.colours, other.colours, i);
                if (apart == 0) continue;
                const float features = std::max(std::abs(one.edges[i] - other.edges[i]),
                                                std::abs(one.points[i] - other.points[i]));
                const float colour = spread(std::pow(apart, colour_exponent), largest);
                error[x] = std::pow(colour, 1 - std::sqrt(features / std::numbers::sqrt2_v<float>));
            }
        }
    }
    return map;
}

}  // namespace drape
