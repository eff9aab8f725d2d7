// Thin panes: more opaque at grazing angles and at their cut edges.
in vec3 world;
in vec3 normal;
in vec2 uv;
in vec2 light;
out vec4 colour;
void main() {
  vec3 n = normalize(normal);
  vec3 to_eye = normalize(eye.xyz - world);
  float grazing = pow(1.0 - abs(dot(n, to_eye)), 4.0);
  vec3 half_way = normalize(to_eye + sun.xyz);
  float glint = pow(max(dot(n, half_way), 0.0), 40.0) * 0.35;
  float alpha = clamp(light.x + 0.22 * grazing + glint, 0.0, 0.8);
  colour = vec4(shown(vec3(0.86, 0.93, 0.93), world), alpha);
}
