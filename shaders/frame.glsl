// What every shader of a frame knows (frame_uniforms.h fills it). World space in metres, y up.
layout(std140, binding = 0) uniform Frame {
    mat4 to_clip;      // world to clip
    mat4 to_shadow;    // world to the shadow map's [0, 1]^3
    vec4 eye;          // camera position
    vec4 ray_x;        // world = eye + view_depth * (ray_z + ndc.x ray_x + ndc.y ray_y)
    vec4 ray_y;
    vec4 ray_z;
    vec4 to_light;     // unit vector towards the key light; w: tangent of its angular radius
    vec4 light_right;  // unit axes of the shadow map
    vec4 light_up;
    vec4 size;         // picture: width, height [pixels] and their inverses
    vec4 depth;        // near, far [m], width of a pixel at one metre [m], radius of ambient occlusion [m]
    vec4 shadow;       // map: width, depth range, one texel [m], one texel as fraction of the map
    vec4 scene;        // centre and radius of all that matters [m]
};

// Depth along the view axis [m] from a depth buffer's value.
float view_depth(float z) { return depth.x * depth.y / (depth.y - z * (depth.y - depth.x)); }

vec3 view_ray(vec2 pixel) {
    vec2 ndc = pixel * size.zw * 2.0 - 1.0;
    return ray_z.xyz + ndc.x * ray_x.xyz + ndc.y * ray_y.xyz;
}

// A unit vector folded into the unit square (octahedral map) and back.
vec2 fold(vec3 n) {
    n /= abs(n.x) + abs(n.y) + abs(n.z);
    vec2 upper = n.xy;
    vec2 lower = (1.0 - abs(n.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(n.xy, vec2(0.0)));
    return (n.z >= 0.0 ? upper : lower) * 0.5 + 0.5;
}

vec3 unfold(vec2 e) {
    e = e * 2.0 - 1.0;
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    float t = max(-n.z, 0.0);
    n.xy -= mix(vec2(-t), vec2(t), greaterThanEqual(n.xy, vec2(0.0)));
    return normalize(n);
}
