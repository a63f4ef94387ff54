#include "video/film.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "io/png.h"
#include "picture/panes.h"
#include "picture/resize.h"

namespace drape {

namespace {

constexpr int difference_gain = 16;

void demand_one_size(const std::vector<Take>& takes) {
    const Sequence& first = takes.at(0).sequence;
    for (const Take& take : takes)
        if (take.sequence.width != first.width || take.sequence.height != first.height)
            throw Error(cat(take.sequence.files[0], ": is ", take.sequence.width, "x", take.sequence.height,
                            " pixels, ", first.files[0], " ", first.width, "x", first.height));
}

// The picture that is in the file, which may have changed since the sequence was found.
Image picture_of(const Take& take, int k) {
    const std::string& file = take.sequence.files[static_cast<size_t>(k)];
    const Image image = read_png(file);
    if (image.width != take.sequence.width || image.height != take.sequence.height)
        throw Error(cat(file, ": is ", image.width, "x", image.height, " pixels, the others ",
                        take.sequence.width, "x", take.sequence.height));
    return take.width > 0 ? resized(image, take.width, take.height()) : image;
}

void write_into(Image& image, const Take& take, int k) {
    draw_caption(image, take.captions.of(take.sequence.first + k));
    draw_caption(image, {take.label, {}}, Corner::top_left);
}

class Concatenated final : public Film {
public:
    explicit Concatenated(std::vector<Take> takes) : takes_(std::move(takes)) { demand_one_size(takes_); }

    int frames() const override {
        int sum = 0;
        for (const Take& take : takes_) sum += take.sequence.frames();
        return sum;
    }

    Image frame(int k) const override {
        auto take = takes_.begin();
        for (; k >= take->sequence.frames(); ++take) k -= take->sequence.frames();
        Image image = picture_of(*take, k);
        write_into(image, *take, k);
        return image;
    }

private:
    std::vector<Take> takes_;
};

class Panes final : public Film {
public:
    Panes(std::vector<Take> takes, const PaneLayout& layout) : takes_(std::move(takes)), layout_(layout) {
        demand_one_size(takes_);
        const Sequence& first = takes_[0].sequence;
        for (const Take& take : takes_)
            if (take.sequence.frames() != first.frames())
                throw Error(cat(take.sequence.folder, ": has ", take.sequence.frames(), " frames, ",
                                first.folder, " ", first.frames(), " (panes run together)"));
        if (layout.difference && takes_.size() != 2)
            throw Error(cat("a difference is of two sequences, not of ", takes_.size()));
    }

    int frames() const override { return takes_[0].sequence.frames(); }

    Image frame(int k) const override {
        std::vector<Image> panes;
        for (const Take& take : takes_) panes.push_back(picture_of(take, k));
        if (layout_.difference) panes.push_back(amplified_difference(panes[0], panes[1], difference_gain));
        for (size_t i = 0; i < takes_.size(); ++i) write_into(panes[i], takes_[i], k);
        if (layout_.difference)
            draw_caption(panes.back(), {cat("difference × ", difference_gain), {}}, Corner::top_left);
        return beside(panes, layout_.columns > 0 ? layout_.columns : static_cast<int>(panes.size()));
    }

private:
    std::vector<Take> takes_;
    PaneLayout layout_;
};

}  // namespace

int Take::height() const {
    const double scale = static_cast<double>(width) / sequence.width;
    return width > 0 ? std::max(1, static_cast<int>(std::lround(scale * sequence.height))) : sequence.height;
}

std::unique_ptr<Film> one_after_the_other(std::vector<Take> takes) {
    return std::make_unique<Concatenated>(std::move(takes));
}

std::unique_ptr<Film> side_by_side(std::vector<Take> takes, const PaneLayout& layout) {
    return std::make_unique<Panes>(std::move(takes), layout);
}

}  // namespace drape
