layout(location = 0) out vec4 colour;

void main() { colour = display(backdrop(gl_FragCoord.xy)); }
