// Antialiasing: shading happened once a pixel, visibility four times. Each of the four samples takes the
// colour of the shaded neighbours that lie on its own surface (subpixel reconstruction, Chajdas et al. 2011).
layout(binding = 0) uniform sampler2D colour_map;
layout(binding = 1) uniform sampler2D depth_map;
layout(binding = 2) uniform sampler2D seen_map;    // normal, key
layout(binding = 3) uniform usampler2DMS key_map;  // key and depth of four samples
layout(location = 0) out vec4 colour;

// where the four samples lie in a pixel
const vec4 place_x = vec4(0.375, 0.875, 0.125, 0.625), place_y = vec4(0.125, 0.375, 0.625, 0.875);

vec4 view_depths(uvec4 stored) {
    vec4 z = vec4(stored & 0xFFFFFFu) / 16777215.0;
    return depth.x * depth.y / (depth.y - z * (depth.y - depth.x));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(size.xy) - 1;
    vec3 own = texelFetch(colour_map, pixel, 0).rgb;
    vec4 seen = texelFetch(seen_map, pixel, 0);
    float own_key = round(seen.z * 255.0), own_z = view_depth(texelFetch(depth_map, pixel, 0).x);
    uvec4 stored = uvec4(texelFetch(key_map, pixel, 0).x, texelFetch(key_map, pixel, 1).x,
                         texelFetch(key_map, pixel, 2).x, texelFetch(key_map, pixel, 3).x);
    vec4 key = vec4(stored >> 24), z = view_depths(stored);

    // how much deeper the surface may run within a pixel; ground and backdrop count as one and never differ
    float facing = abs(dot(unfold(seen.xy), normalize(view_ray(gl_FragCoord.xy))));
    float tolerance = own_z * depth.z * (0.75 + 1.5 / max(facing, 0.08));
    bvec4 apart = lessThan(vec4(tolerance), abs(z - own_z));
    bool edge = any(notEqual(key, vec4(own_key))) || (own_key != 0.0 && any(apart));

    // squares stand for linear light, near enough for a mean of neighbours
    vec4 red = vec4(0.0), green = vec4(0.0), blue = vec4(0.0), total = vec4(1e-9);
    int count = edge ? 9 : 1;
    for (int i = 0; i < count; ++i) {
        ivec2 offset = ivec2(i % 3, i / 3) - 1, at = clamp(pixel + offset, ivec2(0), last);
        vec3 light = texelFetch(colour_map, at, 0).rgb;
        float its_key = round(texelFetch(seen_map, at, 0).z * 255.0);
        vec4 dx = float(offset.x) + 0.5 - place_x, dy = float(offset.y) + 0.5 - place_y;
        vec4 off = (view_depth(texelFetch(depth_map, at, 0).x) - z) / tolerance;
        off = its_key == 0.0 ? vec4(0.0) : off;
        vec4 weight = 1.0 / ((0.1 + dx * dx + dy * dy) * (1.0 + 8.0 * off * off * off * off));
        weight = mix(vec4(0.0), weight, equal(key, vec4(its_key)));
        red += light.r * light.r * weight;
        green += light.g * light.g * weight;
        blue += light.b * light.b * weight;
        total += weight;
    }
    // a sample on something too thin to have been shaded nearby keeps the pixel's own colour
    vec4 known = vec4(greaterThan(total, vec4(1e-6))) / total;
    vec4 share = vec4(lessThanEqual(total, vec4(1e-6)));
    vec3 mean = vec3(dot(red, known), dot(green, known), dot(blue, known)) + own * own * dot(share, vec4(1.0));
    colour = vec4(edge ? sqrt(mean * 0.25) : own, 1.0);
}
