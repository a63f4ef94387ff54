// For antialiasing, four times a pixel: which surface, how deep.
uniform float surface_key;
layout(location = 0) out uint seen;

void main() {
    uint key = uint(surface_key) + (gl_FrontFacing ? 0u : 1u);
    seen = key << 24 | uint(clamp(gl_FragCoord.z, 0.0, 1.0) * 16777215.0);
}
