// Lit like a jewel in its case: by the room, and by a lamp of its own that stands above whoever
// looks at it.
in vec3 world;
in vec3 normal;
in vec2 uv;
in vec4 tint;
out vec4 colour;
uniform sampler2D image;
uniform float glow;
void main() {
  vec4 texel = texture(image, uv);
  if (texel.a < 0.5) discard;
  vec3 base = tint.rgb * texel.rgb;
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  vec3 to_eye = normalize(eye.xyz - world);
  vec3 level = normalize(vec3(to_eye.x, 0.0, to_eye.z) + vec3(1e-4, 0.0, 0.0));
  vec3 lamp = normalize(0.62 * level + 0.42 * vec3(-level.z, 0.0, level.x) + vec3(0.0, 0.95, 0.0));
  float shade = 0.12 + 0.88 * tint.a;
  vec3 room = mix(bounce_colour.rgb, sky_colour.rgb, 0.5 + 0.5 * n.y) * shade;
  float facing = max(dot(n, lamp), 0.0);
  vec3 warm = vec3(1.02, 0.95, 0.83);
  float shine = pow(max(dot(n, normalize(lamp + to_eye)), 0.0), 36.0) * 0.16 * tint.a;
  float edge = pow(1.0 - max(dot(n, to_eye), 0.0), 3.0) * 0.12 * tint.a;
  vec3 light = base * (0.52 * room + warm * facing * mix(0.45, 1.0, tint.a) + glow) +
               vec3(shine) + edge * sky_colour.rgb;
  colour = vec4(written(shown(light, world)), 1.0);
}
