// An exhibit's image, lit a little by a lamp of its own so that it can be known from afar.
in vec3 world;
in vec3 normal;
in vec2 uv;
in vec2 light;
out vec4 colour;
uniform sampler2D image;
uniform float glow;
void main() {
  vec3 n = normalize(normal);
  vec4 texel = texture(image, uv);
  vec3 base = mix(vec3(0.7), texel.rgb, texel.a);
  colour = vec4(written(shown(lit(base, n, light.x, light.y) * 0.42 + base * (0.56 + glow), world)), 1.0);
}
