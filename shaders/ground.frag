// The floor: matte paper with a fine grid, fading into the backdrop so that no horizon shows.
in vec3 world;
in vec3 world_normal;
uniform vec3 grid_x, grid_z;  // unit axes of the grid lines
uniform float grid_spacing;   // between bold lines [m]
layout(location = 0) out vec4 colour;

// Coverage of lines `width` wide and 1 apart, antialiased over the footprint of a pixel.
float lines(vec2 at, vec2 footprint, float width) {
    vec2 soft = max(footprint, vec2(1e-5));
    vec2 off = abs(fract(at - 0.5) - 0.5);
    vec2 line = clamp((0.5 * (width + soft) - off) / soft, 0.0, 1.0) * min(width / soft, 1.0);
    line *= 1.0 - smoothstep(0.15, 0.6, soft);
    return max(line.x, line.y);
}

void main() {
    vec2 light = open_and_lit();
    vec3 n = normalize(world_normal);
    vec3 albedo = vec3(0.52, 0.535, 0.56);
    vec2 at = vec2(dot(world, grid_x), dot(world, grid_z)) / grid_spacing;
    vec2 footprint = abs(dFdx(at)) + abs(dFdy(at));
    float grid = max(0.55 * lines(at, footprint, 0.012), 0.10 * lines(at * 5.0, footprint * 5.0, 0.035));
    vec3 paper = mix(albedo, vec3(0.78), grid);
    float facing = max(dot(n, to_light.xyz), 0.0);
    float away = length(world - scene.xyz) / scene.w;
    float pool = 1.0 / (1.0 + 0.03 * away * away);  // the key light is a lamp, not the sun
    vec3 lit = paper * (key_light * (facing * light.y * pool * 0.36) + ambient_light(n) * (light.x * 0.58));
    float fade = smoothstep(2.2, 7.0, away);
    colour = display(mix(lit, backdrop(gl_FragCoord.xy), fade));
}
