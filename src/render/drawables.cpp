#include "render/drawables.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "mesh/normals.h"
#include "render/weave_coordinates.h"

namespace drape {

namespace {

constexpr double crease_deg = 40;  // solids: edges sharper than this stay edges
// threads finer than this many pixels would melt into a smooth sheet, which reads as rubber
constexpr double least_thread_pixels = 3.1;
constexpr int floats = static_cast<int>(sizeof(float));

void append(std::vector<float>& to, const Vec3& v) {
    for (const double value : {v.x(), v.y(), v.z()}) to.push_back(static_cast<float>(value));
}

}  // namespace

Eigen::Vector3f linear_light(const Colour& srgb) {
    Eigen::Vector3f light;
    for (int c = 0; c < 3; ++c) {
        const float encoded = srgb[static_cast<size_t>(c)];
        light[c] = encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
    }
    return light;
}

ClothDrawable::ClothDrawable(const Gl& gl, const DrawnCloth& cloth)
    : mesh_(cloth.mesh),
      look_(cloth.look),
      surface_(*cloth.mesh, with_weave_coordinates(*cloth.mesh), smoothing_levels(cloth.mesh->triangles())),
      moving_(gl),
      weave_(gl),
      tint_(gl),
      indices_(gl) {
    const DrawnMesh& drawn = surface_.drawn();
    const Eigen::VectorXf border = border_distance(surface_.rest(), surface_.faces());
    // the band was drawn for a cloth half a metre deep from border to middle
    band_scale_ = std::min(border.maxCoeff(), 0.6f) / 0.5f;
    std::vector<float> weave;
    weave.reserve(drawn.vertex.size() * 3);
    for (size_t i = 0; i < drawn.vertex.size(); ++i) {
        const auto uv = drawn.uv.col(static_cast<Eigen::Index>(i));
        weave.insert(weave.end(), {uv.x(), uv.y(), border[drawn.vertex[i]]});
    }
    weave_.fill(gl, weave, GL_STATIC_DRAW);
    indices_.fill_bytes(gl, drawn.faces.data(), static_cast<size_t>(drawn.faces.size()) * sizeof(int),
                        GL_STATIC_DRAW);
    tint_.fill(gl, std::vector<float>(drawn.vertex.size(), 0.0f));
    vertices_ = make_vertex_array(gl,
                                  {{0, &moving_, 3, 6 * floats, 0},
                                   {1, &moving_, 3, 6 * floats, 3 * floats},
                                   {2, &weave_, 3},
                                   {3, &tint_, 1}},
                                  &indices_);
}

void ClothDrawable::update(const Gl& gl, In simulated, const Eigen::VectorXd& room,
                           const Eigen::VectorXf& tint) {
    DRAPE_ASSERT(simulated.cols() == mesh_->vertices());
    x_ = surface_.positions(simulated, room);
    const Points normals = vertex_normals(x_, surface_.faces());
    const std::vector<int>& vertex = surface_.drawn().vertex;
    std::vector<float> moving;
    moving.reserve(vertex.size() * 6);
    for (const int v : vertex) {
        append(moving, x_.col(v));
        append(moving, normals.col(v));
    }
    moving_.fill(gl, moving);
    if (tint.size() == 0) return;
    DRAPE_ASSERT(tint.size() == mesh_->vertices());
    const Eigen::VectorXf fine = surface_.spread(tint);
    std::vector<float> values;
    for (const int v : vertex) values.push_back(fine[v]);
    tint_.fill(gl, values);
}

void ClothDrawable::set_look(const Program& program, double pixel) const {
    program.set("front", linear_light(look_.front));
    program.set("back", linear_light(look_.back));
    program.set("stripe", linear_light(look_.stripe));
    program.set("thread_spacing",
                static_cast<float>(std::max(look_.thread_spacing, least_thread_pixels * pixel)));
    program.set("band", look_.stripes ? Eigen::Vector3f(band_scale_ * Eigen::Vector3f(0.055f, 0.078f, 0.012f))
                                      : Eigen::Vector3f(-2, -1, 0.012f * band_scale_));
}

void ClothDrawable::draw(const Gl& gl) const {
    gl.BindVertexArray(vertices_);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(surface_.drawn().faces.size()), GL_UNSIGNED_INT,
                    nullptr);
}

Points ClothDrawable::edges() const {
    const auto& pairs = surface_.simulated_edges();
    Points ends(3, static_cast<Eigen::Index>(2 * pairs.size()));
    Eigen::Index next = 0;
    for (const auto& [a, b] : pairs) {
        ends.col(next++) = x_.col(a);
        ends.col(next++) = x_.col(b);
    }
    return ends;
}

SolidDrawable::SolidDrawable(const Gl& gl, const DrawnSolid& solid)
    : colour_(solid.colour), is_ground_(solid.is_ground), buffer_(gl) {
    const Mesh& mesh = solid.surface;
    const Points normals = corner_normals(mesh.rest, mesh.faces, crease_deg);
    std::vector<float> corners;
    Vec3 area = Vec3::Zero();
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Vec3 a = mesh.rest.col(mesh.faces(0, f)), b = mesh.rest.col(mesh.faces(1, f)),
                   c = mesh.rest.col(mesh.faces(2, f));
        area += (b - a).cross(c - a);
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 place = mesh.rest.col(mesh.faces(corner, f));
            append(corners, place);
            append(corners, normals.col(3 * f + corner));
            box_.extend(place);
        }
    }
    if (area.norm() > 0) facing_ = area.normalized();
    vertices_drawn_ = static_cast<GLsizei>(mesh.faces.size());
    buffer_.fill(gl, corners, GL_STATIC_DRAW);
    vertices_ =
        make_vertex_array(gl, {{0, &buffer_, 3, 6 * floats, 0}, {1, &buffer_, 3, 6 * floats, 3 * floats}});
}

void SolidDrawable::set_look(const Program& program) const {
    program.set("albedo", linear_light(colour_));
}

Points SolidDrawable::corners() const {
    Points corners(3, box_.isEmpty() ? 0 : 8);
    for (int i = 0; i < corners.cols(); ++i)
        corners.col(i) = box_.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    return corners;
}

void SolidDrawable::draw(const Gl& gl) const {
    gl.BindVertexArray(vertices_);
    gl.DrawArrays(GL_TRIANGLES, 0, vertices_drawn_);
}

GroundDrawable::GroundDrawable(const Gl& gl) : buffer_(gl) {
    vertices_ =
        make_vertex_array(gl, {{0, &buffer_, 3, 6 * floats, 0}, {1, &buffer_, 3, 6 * floats, 3 * floats}});
}

void GroundDrawable::place(const Gl& gl, const Vec3& point, const Vec3& normal, const Vec3& centre,
                           double reach) {
    const Vec3 n = normal.normalized(), foot = centre - n * n.dot(centre - point);
    // grid lines run along the world's axes as well as the plane allows
    const Vec3 along = std::abs(n.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
    grid_x_ = (along - n * n.dot(along)).normalized();
    grid_z_ = grid_x_.cross(n);
    std::vector<float> corners;
    for (const auto& [s, t] : {std::pair{-1, 1}, {1, 1}, {-1, -1}, {1, -1}}) {
        append(corners, foot + reach * (s * grid_x_ + t * grid_z_));
        append(corners, n);
    }
    buffer_.fill(gl, corners);
}

void GroundDrawable::set_look(const Program& program, double scene_radius) const {
    program.set("grid_x", Eigen::Vector3f(grid_x_.cast<float>()));
    program.set("grid_z", Eigen::Vector3f(grid_z_.cast<float>()));
    // bold lines every power of ten metres, or half of it, so that a few of them meet the scene
    const double wanted = 0.8 * scene_radius, power = std::pow(10, std::floor(std::log10(wanted)));
    program.set("grid_spacing", static_cast<float>(wanted > 5 * power ? 5 * power : power));
}

void GroundDrawable::draw(const Gl& gl) const {
    gl.BindVertexArray(vertices_);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace drape
