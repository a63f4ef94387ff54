// Cloths and solids as the driver holds them: buffers, and the call that draws them.
#pragma once

#include "render/gl_objects.h"
#include "render/picture.h"
#include "render/shader.h"
#include "render/smooth_surface.h"

namespace drape {

// Light, not display values: what shaders compute with.
Eigen::Vector3f linear_light(const Colour& srgb);

class ClothDrawable {
public:
    ClothDrawable(const Gl& gl, const DrawnCloth& cloth);

    // `simulated`: a column per simulated vertex; `tint`: one each, or none.
    void update(const Gl& gl, In simulated, const Eigen::VectorXd& room, const Eigen::VectorXf& tint);
    // `pixel`: what a pixel spans where the camera looks [m].
    void set_look(const Program& program, double pixel) const;
    void draw(const Gl& gl) const;
    // Simulated edges of the last update, as drawn: pairs of columns.
    Points edges() const;
    const Points& positions() const { return x_; }  // as drawn

private:
    const Mesh* mesh_;
    ClothLook look_;
    SmoothSurface surface_;
    Points x_;  // of the last update
    float band_scale_ = 1;
    Buffer moving_, weave_, tint_, indices_;
    GlName vertices_;
};

class SolidDrawable {
public:
    SolidDrawable(const Gl& gl, const DrawnSolid& solid);

    void set_look(const Program& program) const;
    void draw(const Gl& gl) const;
    bool is_ground() const { return is_ground_; }
    Vec3 centre() const {
        return box_.isEmpty() ? Vec3(Vec3::Zero()) : box_.center();
    }  // in the solid's frame
    double radius() const {
        return box_.isEmpty() ? 0 : box_.diagonal().norm() / 2;
    }                                        // of a sphere around it [m]
    Points corners() const;                  // of a box around it
    Vec3 facing() const { return facing_; }  // mean normal, in the solid's frame

private:
    Colour colour_;
    bool is_ground_;
    Eigen::AlignedBox3d box_;
    Vec3 facing_ = Vec3::UnitY();
    GLsizei vertices_drawn_ = 0;
    Buffer buffer_;
    GlName vertices_;
};

// An endless plane as two triangles, wide enough that its rim has faded into the backdrop.
class GroundDrawable {
public:
    explicit GroundDrawable(const Gl& gl);

    // The plane through `point` facing `normal`, drawn around the foot of `centre`, `reach` metres each way.
    void place(const Gl& gl, const Vec3& point, const Vec3& normal, const Vec3& centre, double reach);
    void set_look(const Program& program, double scene_radius) const;
    void draw(const Gl& gl) const;

private:
    Vec3 grid_x_ = Vec3::UnitX(), grid_z_ = Vec3::UnitZ();
    Buffer buffer_;
    GlName vertices_;
};

}  // namespace drape
