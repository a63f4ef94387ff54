in float aside;
in vec3 line_colour;
uniform float half_width, opacity;
layout(location = 0) out vec4 colour;

void main() { colour = vec4(line_colour, opacity * clamp(half_width + 0.5 - abs(aside), 0.0, 1.0)); }
