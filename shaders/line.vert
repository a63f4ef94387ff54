// A line segment as a strip a little wider than its stroke; faces the viewer at any slant.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 tint;

uniform float half_width;  // of the stroke [pixels]
uniform float lift;        // towards the viewer, as a fraction of the distance

out float aside;  // from the middle of the stroke [pixels]
out vec3 line_colour;

void main() {
    vec4 a = to_clip * vec4(mix(from, eye.xyz, lift), 1.0), b = to_clip * vec4(mix(to, eye.xyz, lift), 1.0);
    vec2 along = (b.xy / b.w - a.xy / a.w) * size.xy;
    along = dot(along, along) > 1e-8 ? normalize(along) : vec2(1.0, 0.0);
    float sign_aside = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    vec4 end = gl_VertexID < 2 ? a : b;
    aside = sign_aside * (half_width + 1.0);
    end.xy += vec2(-along.y, along.x) * aside * 2.0 * size.zw * end.w;
    line_colour = tint;
    gl_Position = end;
}
