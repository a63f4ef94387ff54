// A studio: one large soft key light, a cool sky above, a warm-grey floor below.
const vec3 key_light = vec3(3.55, 3.36, 3.06);
const vec3 sky_light = vec3(0.43, 0.49, 0.59);
const vec3 floor_light = vec3(0.30, 0.285, 0.27);

layout(binding = 0) uniform sampler2D occlusion;  // half size: open sky, key light let through, view depth [m]

vec3 ambient_light(vec3 n) { return mix(floor_light, sky_light, n.y * 0.5 + 0.5); }

// Open sky and light let through at this fragment: the four half-size texels around it, weighed by how well
// they lie on its own surface.
vec2 open_and_lit() {
    float z = 1.0 / gl_FragCoord.w;
    vec2 slope = vec2(dFdx(z), dFdy(z));
    vec2 at = (gl_FragCoord.xy - 0.5) * 0.5;  // texel t was computed at full-size pixel 2 t
    ivec2 base = ivec2(floor(at));
    vec2 part = at - vec2(base);
    ivec2 last = textureSize(occlusion, 0) - 1;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        vec4 texel = texelFetch(occlusion, clamp(base + corner, ivec2(0), last), 0);
        vec2 near = mix(1.0 - part, part, vec2(corner)) + 0.02;
        float expected = z + dot(slope, 2.0 * (vec2(corner) - part));
        float weight = near.x * near.y / (0.0005 * z + abs(texel.z - expected));
        sum += vec3(texel.xy, 1.0) * weight;
    }
    // no crease is so tight that no light finds in
    return vec2(mix(0.14, 1.0, sum.x / sum.z), sum.y / sum.z);
}

// Light that a coloured crease still gets by bouncing off itself: a fit by Jimenez et al. (2016).
vec3 with_bounces(float open, vec3 albedo) {
    vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    return max(vec3(open), ((open * a + b) * open + c) * open);
}
