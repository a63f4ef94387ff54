// What is seen where: the normal towards the viewer, and a key that tells surfaces and their sides apart.
in vec3 world_normal;
uniform float surface_key;  // of the front; the back's is one more
layout(location = 0) out vec4 seen;

void main() {
    vec3 n = normalize(gl_FrontFacing ? world_normal : -world_normal);
    seen = vec4(fold(n), (surface_key + (gl_FrontFacing ? 0.0 : 1.0)) / 255.0, 1.0);
}
