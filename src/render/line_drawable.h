// Strokes over the shaded picture: wire and springs.
#pragma once

#include "render/gl_objects.h"
#include "render/picture.h"
#include "render/shader.h"

namespace drape {

class LineDrawable {
public:
    explicit LineDrawable(const Gl& gl);

    void update(const Gl& gl, const Segments& segments);
    void draw(const Gl& gl) const;

private:
    GLsizei segments_ = 0;
    Buffer buffer_;
    GlName vertices_;
};

}  // namespace drape
