#include "render/line_drawable.h"

#include "base/assert.h"

namespace drape {

LineDrawable::LineDrawable(const Gl& gl) : buffer_(gl) {
    constexpr int floats = static_cast<int>(sizeof(float)), stride = 9 * floats;
    vertices_ = make_vertex_array(gl, {{0, &buffer_, 3, stride, 0, true},
                                       {1, &buffer_, 3, stride, 3 * floats, true},
                                       {2, &buffer_, 3, stride, 6 * floats, true}});
}

void LineDrawable::update(const Gl& gl, const Segments& segments) {
    DRAPE_ASSERT(segments.ends.cols() == 2 * static_cast<Eigen::Index>(segments.colour.size()));
    std::vector<float> values;
    values.reserve(segments.colour.size() * 9);
    for (size_t s = 0; s < segments.colour.size(); ++s) {
        for (const Eigen::Index column :
             {2 * static_cast<Eigen::Index>(s), 2 * static_cast<Eigen::Index>(s) + 1})
            for (int axis = 0; axis < 3; ++axis)
                values.push_back(static_cast<float>(segments.ends(axis, column)));
        values.insert(values.end(), segments.colour[s].begin(), segments.colour[s].end());
    }
    segments_ = static_cast<GLsizei>(segments.colour.size());
    buffer_.fill(gl, values);
}

void LineDrawable::draw(const Gl& gl) const {
    gl.BindVertexArray(vertices_);
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, segments_);
}

}  // namespace drape
