// Antialiasing: shading happened once a pixel, visibility four times. Each of the four samples takes the
// colour of the shaded neighbours that lie on its own surface (subpixel reconstruction, Chajdas et al. 2011).
layout(binding = 0) uniform sampler2D colour_map;
layout(binding = 1) uniform sampler2D depth_map;
layout(binding = 2) uniform sampler2D seen_map;     // normal, key
layout(binding = 3) uniform usampler2DMS key_map;   // key and depth of four samples
layout(location = 0) out vec4 colour;

// where llvmpipe's and the usual four samples lie in a pixel
const vec2 place[4] = vec2[](vec2(0.375, 0.125), vec2(0.875, 0.375), vec2(0.125, 0.625), vec2(0.625, 0.875));

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(size.xy) - 1;
    vec3 own = texelFetch(colour_map, pixel, 0).rgb;
    vec4 seen = texelFetch(seen_map, pixel, 0);
    uint own_key = uint(seen.z * 255.0 + 0.5);
    float own_z = view_depth(texelFetch(depth_map, pixel, 0).x);
    vec3 own_n = unfold(seen.xy), ray = view_ray(gl_FragCoord.xy);
    // how much deeper the tangent plane may run within a pixel
    float tolerance = own_z * depth.z * (0.75 + 1.5 / max(abs(dot(own_n, normalize(ray))), 0.08));

    bool edge = false;
    uint key[4];
    float z[4];
    for (int s = 0; s < 4; ++s) {
        uint stored = texelFetch(key_map, pixel, s).x;
        key[s] = stored >> 24;
        z[s] = view_depth(float(stored & 0xFFFFFFu) / 16777215.0);
        edge = edge || key[s] != own_key || (own_key != 0u && abs(z[s] - own_z) > tolerance);
    }
    vec4 sum[4] = vec4[](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    int count = edge ? 9 : 1;
    for (int i = 0; i < count; ++i) {
        ivec2 offset = ivec2(i % 3, i / 3) - 1;
        ivec2 at = clamp(pixel + offset, ivec2(0), last);
        vec3 light = from_srgb(texelFetch(colour_map, at, 0).rgb);
        uint its_key = uint(texelFetch(seen_map, at, 0).z * 255.0 + 0.5);
        float its_z = view_depth(texelFetch(depth_map, at, 0).x);
        for (int s = 0; s < 4; ++s) {
            vec2 apart = vec2(offset) + 0.5 - place[s];
            float near = exp(-2.0 * dot(apart, apart));
            float off = own_key == 0u && key[s] == 0u ? 0.0 : (its_z - z[s]) / tolerance;
            float weight = its_key == key[s] ? near * exp(-off * off) + 1e-6 : 0.0;
            sum[s] += vec4(light, 1.0) * weight;
        }
    }
    vec3 mean = vec3(0.0);
    for (int s = 0; s < 4; ++s) mean += sum[s].w > 0.0 ? sum[s].rgb / sum[s].w : from_srgb(own);
    colour = vec4(edge ? to_srgb(mean * 0.25) : own, 1.0);
}
