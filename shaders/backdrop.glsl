// The paper roll behind the scene: dark above, light where it meets the floor.
vec3 backdrop(vec2 pixel) {
    float up = pixel.y * size.w;
    float aside = (pixel.x * size.z - 0.5);
    vec3 light = mix(vec3(0.62, 0.645, 0.69), vec3(0.062, 0.088, 0.128), smoothstep(0.35, 1.08, up));
    return light * (1.0 - 0.7 * aside * aside);
}
