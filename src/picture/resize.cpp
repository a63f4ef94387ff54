#include "picture/resize.h"

#include <new>

#include "base/assert.h"

#define STB_IMAGE_RESIZE_IMPLEMENTATION
#define STB_IMAGE_RESIZE_STATIC
// old C inside
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image_resize.h>
#pragma GCC diagnostic pop

namespace drape {

Image resized(const Image& image, int width, int height) {
    DRAPE_ASSERT(width > 0 && height > 0);
    if (width == image.width && height == image.height) return image;
    Image other(width, height);
    if (!stbir_resize_uint8_srgb(image.rgb.data(), image.width, image.height, 0, other.rgb.data(), width,
                                 height, 0, 3, STBIR_ALPHA_CHANNEL_NONE, 0))
        throw std::bad_alloc();
    return other;
}

}  // namespace drape
