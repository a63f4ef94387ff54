// Woven cloth, two-sided: threads, fuzz that catches light at grazing angles, light through thin cloth,
// a woven band along the border.
in vec3 world;
in vec3 world_normal;
in vec3 weave_at;  // metres along warp and weft, metres from the border
in float tint_at;

uniform vec3 front, back, stripe;  // albedo
uniform float thread_spacing;      // [m]
uniform vec3 band;                 // the stripe runs from band.x to band.y metres inside the border; hem: band.z
uniform float tinted;              // 1: colours tell a number of the vertices
layout(binding = 1) uniform sampler2D tint_colours;
layout(location = 0) out vec4 colour;

// 1 between the two edges, antialiased.
float between(float at, float low, float high, float soft) {
    return clamp((at - low) / soft + 0.5, 0.0, 1.0) * clamp((high - at) / soft + 0.5, 0.0, 1.0);
}

void main() {
    vec2 light = open_and_lit();
    vec3 v = normalize(eye.xyz - world), l = to_light.xyz;
    vec3 n = normalize(gl_FrontFacing ? world_normal : -world_normal);
    n = normalize(n + v * max(0.03 - dot(n, v), 0.0));  // interpolated normals may turn away at the outline

    // the directions of the threads in space, from how both change over the picture
    vec2 at = weave_at.xy / thread_spacing, dx = dFdx(at), dy = dFdy(at);
    vec3 px = dFdx(world), py = dFdy(world);
    vec3 warp = px * dy.y - py * dx.y, weft = py * dx.x - px * dy.x;
    float turned = dx.x * dy.y - dx.y * dy.x < 0.0 ? -1.0 : 1.0;
    warp = normalize((warp - n * dot(n, warp)) * turned + vec3(1e-12, 0.0, 0.0));
    weft = normalize((weft - n * dot(n, weft)) * turned + vec3(0.0, 1e-12, 0.0));
    Weave woven = weave_pattern(at, max(length(dx), length(dy)));
    vec3 m = normalize(n + warp * woven.slope.x + weft * woven.slope.y);

    float soft = max(fwidth(weave_at.z), 1e-6);
    float striped = between(weave_at.z, band.x, band.y, soft);
    float hem = between(weave_at.z, band.z - 0.001, band.z + 0.001, soft + 0.001);
    vec3 side = gl_FrontFacing ? front : back, other = gl_FrontFacing ? back : front;
    // the band is woven through: on the back it shows in the front's colour
    vec3 albedo = mix(side, gl_FrontFacing ? stripe : front, striped) * woven.tone * (1.0 - 0.25 * hem);
    if (tinted > 0.0) albedo = vec3(0.42 * woven.tone);
    vec3 dark_side = mix(other, stripe, striped);

    float nl = dot(m, l), nv = max(dot(n, v), 0.0), smooth_nl = dot(n, l);
    vec3 h = normalize(l + v);
    // fibres scatter broadly: the terminator is soft, the middle flat
    float diffuse = max(nl * 0.88 + 0.12, 0.0);
    diffuse = mix(diffuse, sqrt(diffuse), 0.25) * smoothstep(-0.12, 0.10, smooth_nl);
    // sheen of upright fuzz (Estevez and Kulla 2017, inverted Gaussian replaced by a power of the sine)
    float sine = sqrt(max(1.0 - pow(dot(n, h), 2.0), 0.0));
    float facing = max(smooth_nl, 0.0);
    float sheen = 0.55 * sine * sine * sine * facing / (4.0 * (facing + nv - facing * nv) + 0.05);
    float fuzz = pow(1.0 - nv, 3.0);
    // a lengthwise gleam on each thread (Kajiya and Kay 1989)
    float along = dot(mix(warp, weft, woven.across), h);
    float gleam = 0.045 * pow(max(1.0 - along * along, 0.0), 16.0) * facing;

    vec3 key = key_light * (light.y * 0.36);
    vec3 through = albedo * dark_side * max(-smooth_nl, 0.0) * 0.85;
    vec3 tint = mix(vec3(1.0), albedo / max(max(albedo.r, albedo.g), max(albedo.b, 0.05)), 0.65);
    vec3 sky = ambient_light(mix(n, m, 0.6)) * with_bounces(light.x, albedo);
    vec3 shaded = albedo * woven.gap * (key * diffuse + sky) + key * (through + tint * (sheen + gleam)) +
                  tint * ambient_light(n) * (fuzz * 0.22 * light.x);
    colour = display(shaded);
    if (tinted > 0.0) {  // the map's colours, with just enough shade to read the form
        vec3 told = textureLod(tint_colours, vec2(tint_at * 0.5 + 0.5, 0.5), 0.0).rgb;
        colour.rgb = to_srgb(told) * min(0.5 + 0.62 * colour.g, 1.06) * (gl_FrontFacing ? 1.0 : 0.8);
    }
}
