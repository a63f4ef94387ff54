layout(location = 0) in vec3 position;
uniform mat4 model;

void main() { gl_Position = vec4((to_shadow * (model * vec4(position, 1.0))).xyz * 2.0 - 1.0, 1.0); }
