#include "render/renderer.h"

#include <algorithm>
#include <utility>

#include "base/assert.h"
#include "base/error.h"
#include "base/timer.h"
#include "render/colour_bar.h"
#include "render/colour_map.h"
#include "render/drawables.h"
#include "render/frame_uniforms.h"
#include "render/line_drawable.h"
#include "render/programs.h"
#include "render/targets.h"

namespace drape {

namespace {

constexpr int ground_key = 0;  // ground and backdrop fade into each other: one surface

Eigen::Matrix4f matrix_of(const Pose& pose) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = pose.rotation;
    m.topRightCorner<3, 1>() = pose.translation;
    return m.cast<float>();
}

Points posed(const Points& points, const Pose& pose) {
    return (pose.rotation * points).colwise() + pose.translation;
}

Segments wire_of(const ClothDrawable& cloth) {
    Segments wire;
    wire.ends = cloth.edges();
    wire.colour.assign(static_cast<size_t>(wire.ends.cols() / 2), Colour{0.05f, 0.06f, 0.09f});
    return wire;
}

}  // namespace

struct Renderer::Parts {
    RenderSettings settings;
    std::unique_ptr<Context> context;
    Gl gl;
    Programs programs;
    Targets targets;
    Buffer uniforms;
    GlName nothing;  // a vertex array without attributes, for full-screen passes
    GlName tint_colours;
    std::vector<ClothDrawable> cloths;
    std::vector<SolidDrawable> solids;
    std::vector<GroundDrawable> grounds;
    LineDrawable lines;
    Vec3 centre = Vec3::Zero();
    double radius = 1;

    Parts(const RenderSettings& wanted, std::unique_ptr<Context> made,
          const std::vector<DrawnCloth>& drawn_cloths, const std::vector<DrawnSolid>& drawn_solids);

    void update(const FrameInput& frame);
    void place_scene(const FrameInput& frame);
    void cast_shadows(const FrameInput& frame) const;
    void draw_seen(const FrameInput& frame, const Program& program) const;
    void see(const FrameInput& frame) const;
    void occlude() const;
    void shade(const FrameInput& frame) const;
    PixelBox outlined(const FrameInput& frame) const;
    void antialias(const FrameInput& frame) const;
    void draw_overlay(const FrameInput& frame);
    Image read() const;

    void screen_pass(const Program& program, std::initializer_list<GLuint> textures) const;
    void begin(GLuint framebuffer, int width, int height) const {
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl.Viewport(0, 0, width, height);
    }
};

Renderer::Parts::Parts(const RenderSettings& wanted, std::unique_ptr<Context> made,
                       const std::vector<DrawnCloth>& drawn_cloths,
                       const std::vector<DrawnSolid>& drawn_solids)
    : settings(wanted),
      context((made->make_current(), std::move(made))),
      gl(*context),
      programs(gl),
      targets(gl, settings.width, settings.height),
      uniforms(gl),
      nothing(make_vertex_array(gl, {})),
      tint_colours(make_colour_texture(gl, settings.scale.colour ? settings.scale.colour : diverging_colour)),
      lines(gl) {
    for (const DrawnCloth& cloth : drawn_cloths) cloths.emplace_back(gl, cloth);
    for (const DrawnSolid& solid : drawn_solids) {
        solids.emplace_back(gl, solid);
        if (solid.is_ground) grounds.emplace_back(gl);
    }
    if (grounds.empty() && settings.ground) grounds.emplace_back(gl);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.check("setting up the renderer");
}

// Where things are this frame, what light falls on them, and the numbers all shaders share.
void Renderer::Parts::update(const FrameInput& frame) {
    DRAPE_ASSERT(frame.cloth.size() == cloths.size() && frame.solid.size() == solids.size());
    const bool tinted = settings.overlay == Overlay::tint;
    for (size_t c = 0; c < cloths.size(); ++c)
        cloths[c].update(gl, frame.cloth[c], frame.room.empty() ? Eigen::VectorXd() : frame.room.at(c),
                         tinted ? frame.tint.at(c) : Eigen::VectorXf());
    place_scene(frame);
}

void Renderer::Parts::place_scene(const FrameInput& frame) {
    const View view(settings.camera, static_cast<double>(settings.width) / settings.height);
    Eigen::AlignedBox3d region = settings.bounds;
    if (region.isEmpty())
        for (const Points& x : frame.cloth)
            for (int v = 0; v < x.cols(); ++v) region.extend(Vec3(x.col(v)));
    if (region.isEmpty()) region.extend(settings.camera.at);
    centre = region.center();
    radius = std::max(region.diagonal().norm() / 2, 1e-3);

    // the shadow map also covers the solids in the picture: one out of sight changes no pixel
    Eigen::AlignedBox3d casters = region;
    size_t ground = 0;
    for (size_t s = 0; s < solids.size(); ++s) {
        const Vec3 middle = frame.solid[s] * solids[s].centre();
        if (solids[s].is_ground()) {
            grounds[ground++].place(gl, middle, frame.solid[s].rotation * solids[s].facing(), centre,
                                    12 * radius);
        } else if (!view.misses(middle, solids[s].radius())) {
            casters.extend(Vec3(middle - Vec3::Constant(solids[s].radius())));
            casters.extend(Vec3(middle + Vec3::Constant(solids[s].radius())));
        }
    }
    if (ground == 0 && settings.ground)
        grounds[0].place(gl, Vec3(0, settings.ground_height, 0), Vec3::UnitY(), centre, 12 * radius);
    const Light light = place_light(view, casters.center(), casters.diagonal().norm() / 2);
    const FrameUniforms values = frame_uniforms(view, light, {settings.width, settings.height},
                                                Targets::shadow_texels, centre, radius);
    uniforms.fill_bytes(gl, &values, sizeof values, GL_STREAM_DRAW);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms);
}

void Renderer::Parts::cast_shadows(const FrameInput& frame) const {
    gl.Enable(GL_DEPTH_TEST);
    begin(targets.shadow_frame, Targets::shadow_texels, Targets::shadow_texels);
    const float far = 1;
    gl.ClearNamedFramebufferfv(targets.shadow_frame, GL_DEPTH, 0, &far);
    gl.Enable(GL_DEPTH_CLAMP);
    programs.shadow.use();
    programs.shadow.set("model", Eigen::Matrix4f(Eigen::Matrix4f::Identity()));
    for (const ClothDrawable& cloth : cloths) cloth.draw(gl);
    for (size_t s = 0; s < solids.size(); ++s) {
        if (solids[s].is_ground()) continue;
        programs.shadow.set("model", matrix_of(frame.solid[s]));
        solids[s].draw(gl);
    }
    gl.Disable(GL_DEPTH_CLAMP);
}

// Everything, with a key per surface and side.
void Renderer::Parts::draw_seen(const FrameInput& frame, const Program& program) const {
    program.use();
    float key = ground_key;
    program.set("model", Eigen::Matrix4f(Eigen::Matrix4f::Identity()));
    program.set("surface_key", key);
    for (const GroundDrawable& ground : grounds) ground.draw(gl);
    const auto next_key = [&] { program.set("surface_key", key = key < 250 ? key + 2 : 2); };
    for (const ClothDrawable& cloth : cloths) {
        next_key();
        cloth.draw(gl);
    }
    for (size_t s = 0; s < solids.size(); ++s) {
        if (solids[s].is_ground()) continue;
        next_key();
        program.set("model", matrix_of(frame.solid[s]));
        solids[s].draw(gl);
    }
}

void Renderer::Parts::see(const FrameInput& frame) const {
    targets.clear_seen(gl);
    begin(targets.seen_frame, settings.width, settings.height);
    draw_seen(frame, programs.geometry);
}

void Renderer::Parts::screen_pass(const Program& program, std::initializer_list<GLuint> textures) const {
    program.use();
    GLuint unit = 0;
    for (const GLuint texture : textures) gl.BindTextureUnit(unit++, texture);
    gl.BindVertexArray(nothing);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::Parts::occlude() const {
    gl.Disable(GL_DEPTH_TEST);
    begin(targets.occlusion_frame, targets.half_width, targets.half_height);
    screen_pass(programs.occlusion, {targets.depth, targets.seen, targets.shadow});
    for (const bool across : {true, false}) {
        begin(across ? targets.blur_frame : targets.occlusion_frame, targets.half_width, targets.half_height);
        programs.blur.set("direction", across ? Eigen::Vector2f(1, 0) : Eigen::Vector2f(0, 1));
        screen_pass(programs.blur, {across ? targets.occlusion : targets.blur});
    }
    gl.Enable(GL_DEPTH_TEST);
}

void Renderer::Parts::shade(const FrameInput& frame) const {
    begin(targets.colour_frame, settings.width, settings.height);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_EQUAL);
    screen_pass(programs.backdrop, {targets.occlusion, tint_colours});
    const Eigen::Matrix4f here = Eigen::Matrix4f::Identity();
    programs.ground.use();
    programs.ground.set("model", here);
    for (const GroundDrawable& ground : grounds) {
        ground.set_look(programs.ground, radius);
        ground.draw(gl);
    }
    programs.solid.use();
    for (size_t s = 0; s < solids.size(); ++s) {
        if (solids[s].is_ground()) continue;
        programs.solid.set("model", matrix_of(frame.solid[s]));
        solids[s].set_look(programs.solid);
        solids[s].draw(gl);
    }
    const View view(settings.camera, static_cast<double>(settings.width) / settings.height);
    const double pixel =
        2 * view.tan_y / settings.height * (settings.camera.at - settings.camera.from).norm();
    programs.cloth.use();
    programs.cloth.set("model", here);
    programs.cloth.set("tinted", settings.overlay == Overlay::tint ? 1.0f : 0.0f);
    for (const ClothDrawable& cloth : cloths) {
        cloth.set_look(programs.cloth, pixel);
        cloth.draw(gl);
    }
    gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LESS);
}

// Only where something has an outline: ground and backdrop blend softly by themselves.
void Renderer::Parts::antialias(const FrameInput& frame) const {
    const PixelBox box = outlined(frame);
    if (box.width <= 0 || box.height <= 0) return;
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(box.x, box.y, box.width, box.height);
    begin(targets.key_frame, settings.width, settings.height);
    targets.clear_keys(gl);
    draw_seen(frame, programs.key);
    gl.Disable(GL_DEPTH_TEST);
    begin(targets.resolved_frame, settings.width, settings.height);
    screen_pass(programs.resolve, {targets.colour, targets.depth, targets.seen, targets.keys});
    gl.Disable(GL_SCISSOR_TEST);
    gl.Enable(GL_DEPTH_TEST);
    gl.CopyImageSubData(targets.resolved, GL_TEXTURE_2D, 0, box.x, box.y, 0, targets.colour, GL_TEXTURE_2D, 0,
                        box.x, box.y, 0, box.width, box.height, 1);
}

// The pixels that cloths and solids may touch.
PixelBox Renderer::Parts::outlined(const FrameInput& frame) const {
    const View view(settings.camera, static_cast<double>(settings.width) / settings.height);
    Eigen::AlignedBox2d seen;
    for (const ClothDrawable& cloth : cloths) view.project(cloth.positions(), seen);
    for (size_t s = 0; s < solids.size(); ++s)
        if (!solids[s].is_ground()) view.project(posed(solids[s].corners(), frame.solid[s]), seen);
    return pixels_around(seen, settings.width, settings.height);
}

void Renderer::Parts::draw_overlay(const FrameInput& frame) {
    if (settings.overlay != Overlay::wire && settings.overlay != Overlay::springs) return;
    const bool wire = settings.overlay == Overlay::wire;
    begin(targets.colour_frame, settings.width, settings.height);
    gl.DepthFunc(GL_LEQUAL);
    gl.DepthMask(GL_FALSE);
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    programs.line.use();
    const float scale = static_cast<float>(settings.height) / 720;
    programs.line.set("half_width", std::max(wire ? 0.35f * scale : 0.75f * scale, 0.3f));
    programs.line.set("opacity", wire ? 0.55f : 0.9f);
    programs.line.set("lift", wire ? 0.0015f : 0.003f);
    const auto stroke = [&](const Segments& segments) {
        lines.update(gl, segments);
        lines.draw(gl);
    };
    if (wire)
        for (const ClothDrawable& cloth : cloths) stroke(wire_of(cloth));
    else
        stroke(frame.segments);
    gl.Disable(GL_BLEND);
    gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LESS);
}

Image Renderer::Parts::read() const {
    Image image(settings.width, settings.height);
    std::vector<std::uint8_t> rgba(image.rgb.size() / 3 * 4);
    gl.BindFramebuffer(GL_FRAMEBUFFER, targets.colour_frame);
    gl.ReadPixels(0, 0, settings.width, settings.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    // GL's rows start at the bottom
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* from =
            &rgba[static_cast<size_t>(image.height - 1 - y) * static_cast<size_t>(image.width) * 4];
        std::uint8_t* to = image.pixel(0, y);
        for (int x = 0; x < image.width; ++x, from += 4, to += 3) std::copy(from, from + 3, to);
    }
    return image;
}

Renderer::Renderer(const RenderSettings& settings, const std::vector<DrawnCloth>& cloths,
                   const std::vector<DrawnSolid>& solids, Backend backend)
    : parts_(std::make_unique<Parts>(settings, make_context(backend), cloths, solids)) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Image Renderer::draw(const FrameInput& frame, std::vector<StageTime>* stages) {
    Parts& p = *parts_;
    p.context->make_current();
    const auto stage = [&](std::string_view name, auto run) {
        const double start = stages ? process_cpu_seconds() : 0;
        run();
        if (!stages) return;
        p.gl.Finish();
        stages->push_back({name, process_cpu_seconds() - start});
    };
    Image image;
    stage("upload", [&] { p.update(frame); });
    stage("shadow map", [&] { p.cast_shadows(frame); });
    stage("depth", [&] { p.see(frame); });
    stage("occlusion", [&] { p.occlude(); });
    stage("shading", [&] { p.shade(frame); });
    stage("antialiasing", [&] { p.antialias(frame); });
    stage("overlay", [&] { p.draw_overlay(frame); });
    stage("read back", [&] { image = p.read(); });
    p.gl.check("drawing a frame");
    if (p.settings.overlay == Overlay::tint) draw_colour_bar(image, p.settings.scale);
    return image;
}

std::string Renderer::description() const {
    parts_->context->make_current();
    const auto text = [&](GLenum what) { return reinterpret_cast<const char*>(parts_->gl.GetString(what)); };
    return cat(text(GL_RENDERER), ", OpenGL ", text(GL_VERSION));
}

}  // namespace drape
