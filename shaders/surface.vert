// Any surface: cloth (already in world space), solids and ground (posed by `model`).
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 weave;   // cloth only: metres along warp and weft, metres from the border
layout(location = 3) in float tint;  // cloth only: a number on the colour scale, -1 to 1

uniform mat4 model;

out vec3 world;
out vec3 world_normal;
out vec3 weave_at;
out float tint_at;
invariant gl_Position;

void main() {
    vec4 place = model * vec4(position, 1.0);
    world = place.xyz;
    world_normal = mat3(model) * normal;
    weave_at = weave;
    tint_at = tint;
    gl_Position = to_clip * place;
}
