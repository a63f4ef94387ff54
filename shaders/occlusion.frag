// At half size: how much of the sky a point sees, and how much of the key light.
layout(binding = 0) uniform sampler2D depth_map;
layout(binding = 1) uniform sampler2D seen_map;
layout(binding = 2) uniform sampler2D shadow_map;
layout(location = 0) out vec4 open_lit_depth;

const int sky_taps = 10, blocker_taps = 8, light_taps = 16;

// A disc filled evenly: golden-angle spiral.
vec2 disc(int i, int n) {
    float r = sqrt((float(i) + 0.5) / float(n)), a = 2.399963 * float(i);
    return r * vec2(cos(a), sin(a));
}

// Obscurance over nearby seen points (McGuire et al. 2012, scalable ambient obscurance).
float open_sky(vec3 p, vec3 n, float z, mat2 turn, ivec2 pixel) {
    float radius = depth.w, reach = min(radius / (z * depth.z), 90.0), sum = 0.0;
    ivec2 last = ivec2(size.xy) - 1;
    for (int i = 0; i < sky_taps; ++i) {
        vec2 offset = turn * disc(i, sky_taps);
        ivec2 tap = clamp(pixel + ivec2(round(offset * length(offset) * reach)), ivec2(0), last);
        vec3 v = eye.xyz + view_ray(vec2(tap) + 0.5) * view_depth(texelFetch(depth_map, tap, 0).x) - p;
        float vv = dot(v, v), vn = dot(v, n) - 0.0015 * z;
        float near = max(radius * radius - vv, 0.0);
        sum += near * near * near * max(vn, 0.0) / (vv + 1e-5);
    }
    return max(0.0, 1.0 - sum * 5.0 / (pow(radius, 5.0) * float(sky_taps)));
}

// Percentage-closer soft shadow (Fernando 2005): the mean blocker's height over the receiver tells how far
// the key light's edge smears. Receiver depths follow its tangent plane, so that wide filters make no acne.
float lit(vec3 p, vec3 n, mat2 turn) {
    float facing = dot(n, to_light.xyz);
    n = facing < 0.0 ? -n : n;  // thin cloth is lit through its back
    vec3 at = (to_shadow * vec4(p + n * (1.2 * shadow.z), 1.0)).xyz;
    float steep = max(abs(facing), 0.12);
    vec2 slope = vec2(dot(n, light_right.xyz), dot(n, light_up.xyz)) / steep;  // metres deeper per metre aside
    float z = at.z * shadow.y - 1.5 * shadow.z;
    float per_metre = 1.0 / shadow.x;
    ivec2 last = textureSize(shadow_map, 0) - 1;
    vec2 texels = vec2(last + 1);

    float search = 0.35 * to_light.w * scene.w, found = 0.0, height = 0.0;
    for (int i = 0; i < blocker_taps; ++i) {
        vec2 offset = turn * disc(i, blocker_taps) * search;
        ivec2 tap = clamp(ivec2((at.xy + offset * per_metre) * texels), ivec2(0), last);
        float blocker = texelFetch(shadow_map, tap, 0).x * shadow.y;
        float above = z + dot(slope, offset) - blocker;
        found += above > 0.0 ? 1.0 : 0.0;
        height += max(above, 0.0);
    }
    float blur = clamp(to_light.w * height / max(found, 1.0), 1.5 * shadow.z, search);
    // wholly lit or wholly dark: a single tap tells
    int taps = found > 0.0 && found < float(blocker_taps) ? light_taps : 1;
    float through = 0.0;
    for (int i = 0; i < taps; ++i) {
        vec2 offset = turn * disc(i, light_taps) * blur;
        ivec2 tap = clamp(ivec2((at.xy + offset * per_metre) * texels), ivec2(0), last);
        float blocker = texelFetch(shadow_map, tap, 0).x * shadow.y;
        through += z + dot(slope, offset) > blocker ? 0.0 : 1.0;
    }
    bool inside = all(greaterThan(at.xy, vec2(0.0))) && all(lessThan(at.xy, vec2(1.0)));
    return inside ? through / float(taps) : 1.0;
}

void main() {
    ivec2 pixel = min(2 * ivec2(gl_FragCoord.xy), ivec2(size.xy) - 1);
    float stored = texelFetch(depth_map, pixel, 0).x;
    float z = view_depth(stored);
    vec3 p = eye.xyz + view_ray(vec2(pixel) + 0.5) * z;
    vec3 n = unfold(texelFetch(seen_map, pixel, 0).xy);
    // interleaved gradient noise (Jimenez 2014) turns the taps; the blur after this pass takes it out
    float angle = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    open_lit_depth = vec4(open_sky(p, n, z, turn, pixel), lit(p, n, turn), z, 1.0);
}
