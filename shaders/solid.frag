// Obstacles: unglazed clay, quiet beside the cloth.
in vec3 world;
in vec3 world_normal;
uniform vec3 albedo;
layout(location = 0) out vec4 colour;

void main() {
    vec2 light = open_and_lit();
    vec3 n = normalize(world_normal), v = normalize(eye.xyz - world), l = to_light.xyz, h = normalize(l + v);
    float nl = max(dot(n, l), 0.0), nv = max(dot(n, v), 0.0), nh = max(dot(n, h), 0.0);
    vec3 diffuse = albedo * (key_light * (nl * light.y * 0.36) + ambient_light(n) * with_bounces(light.x, albedo));
    float rim = pow(1.0 - nv, 4.0) * 0.10;
    float gloss = 0.035 * pow(nh, 18.0) * light.y * nl;
    colour = display(diffuse + (gloss * key_light + rim * sky_light * light.x));
}
