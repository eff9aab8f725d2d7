// Plaster, cut faces, cases, frames: one colour, light kept at the vertices.
in vec3 world;
in vec3 normal;
in vec2 uv;
in vec2 light;
out vec4 colour;
uniform vec4 albedo;
uniform float glow;
void main() {
  vec3 n = normalize(normal);
  colour = vec4(written(shown(lit(albedo.rgb, n, light.x, light.y) + albedo.rgb * glow, world)), 1.0);
}
