// Plain weave: warp and weft cross over and under. Every detail fades before it is smaller than two pixels,
// so that nothing swims or makes moire.

struct Weave {
    vec2 slope;    // of the surface along warp and weft axes
    float gap;     // 1 on a thread, less between threads
    float tone;    // uneven yarn: brightness about 1
    float across;  // 1: the thread on top runs along the second axis
};

float random(vec2 cell) {
    uvec2 c = uvec2(ivec2(cell));
    uint h = c.x * 0x9E3779B1u ^ c.y * 0x85EBCA77u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    return float((h ^ (h >> 12)) & 0xFFFFu) / 65535.0;
}

// Smooth noise along a thread: `thread` its number, `along` in lengths of one blot.
float yarn(float thread, float along) {
    float cell = floor(along), part = along - cell;
    return mix(random(vec2(thread, cell)), random(vec2(thread, cell + 1.0)), part * part * (3.0 - 2.0 * part));
}

// `at` in threads along both axes, `footprint` of a pixel in threads. Seen from afar every shape here is a
// single sine a thread, which a pixel grid can hold; close by, crossings turn crisp.
Weave weave_pattern(vec2 at, float footprint) {
    float fine = 1.0 - smoothstep(0.28, 0.58, footprint);
    float broad = 1.0 - smoothstep(1.2, 2.5, footprint);
    float crisp = 1.0 - smoothstep(0.08, 0.25, footprint);
    vec2 cell = floor(at), c = (at - cell) * 2.0 - 1.0;  // c: across a thread, -1 to 1
    vec2 wave = sin(3.14159265 * c), valley = 0.5 - 0.5 * cos(3.14159265 * c);
    vec2 crossing = cos(1.57079633 * c);
    float parity = mod(cell.x + cell.y, 2.0) * 2.0 - 1.0;
    // 0: the warp thread is on top and runs along the second axis, 1: the weft thread along the first
    float top = clamp(0.5 + mix(0.5, 3.0, crisp) * parity * crossing.x * crossing.y, 0.0, 1.0);
    Weave w;
    w.slope = fine * wave * mix(vec2(0.50, 0.26), vec2(0.26, 0.50), top);
    w.gap = 1.0 - fine * (0.30 * mix(valley.x, valley.y, top) + 0.16 * mix(valley.y, valley.x, top));
    float warp = yarn(cell.x, at.y * 0.06), weft = yarn(cell.y + 977.0, at.x * 0.06);
    float bands = yarn(floor(at.x * 0.25) + 31.0, at.y * 0.02) + yarn(floor(at.y * 0.25) + 613.0, at.x * 0.02);
    w.tone = 1.0 + fine * 0.14 * (mix(warp, weft, top) - 0.5) +
             broad * (0.05 * (warp + weft - 1.0) + 0.03 * (bands - 1.0));
    w.across = mix(0.5, 1.0 - top, fine);
    return w;
}
