// From scene light to the picture's sRGB bytes.

// A photographic shoulder and hardly a toe: dark cloth keeps its hue instead of going black and garish.
vec3 tone_map(vec3 x) {
    vec3 exposed = 1.0 - exp(-1.4 * x);
    return exposed * (0.78 + 0.22 * exposed);
}

vec3 to_srgb(vec3 linear) {
    return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, greaterThan(linear, vec3(0.0031308)));
}

vec4 display(vec3 light) { return vec4(to_srgb(tone_map(light)), 1.0); }
