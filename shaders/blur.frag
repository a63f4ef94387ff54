// One direction of the blur that takes the noise out of occlusion.frag, stopping where the surface does.
layout(binding = 0) uniform sampler2D source;  // open sky, light let through, view depth [m]
uniform vec2 direction;
layout(location = 0) out vec4 blurred;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), step = ivec2(direction), last = textureSize(source, 0) - 1;
    vec4 centre = texelFetch(source, pixel, 0);
    // the surface's own slope in depth, from the nearer of both neighbours
    float before = centre.z - texelFetch(source, max(pixel - step, ivec2(0)), 0).z;
    float after = texelFetch(source, min(pixel + step, last), 0).z - centre.z;
    float slope = abs(before) < abs(after) ? before : after;
    vec3 sum = vec3(centre.xy, 1.0);
    for (int i = -3; i <= 3; ++i) {
        if (i == 0) continue;
        vec4 texel = texelFetch(source, clamp(pixel + i * step, ivec2(0), last), 0);
        float off = abs(texel.z - centre.z - float(i) * slope) / (0.004 * centre.z);
        float weight = max(0.0, 1.0 - off) * (1.0 - 0.09 * float(abs(i)));
        sum += vec3(texel.xy, 1.0) * weight;
    }
    blurred = vec4(sum.xy / sum.z, centre.zw);
}
