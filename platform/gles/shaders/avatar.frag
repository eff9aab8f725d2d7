// Smooth matte surfaces: light wraps round, and a faint rim sets the figure off the floor.
in vec3 world;
in vec3 normal;
in vec4 base;
in vec2 light;
out vec4 colour;

void main() {
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  vec3 to_eye = normalize(eye.xyz - world);
  vec3 tone = base.rgb;
  const float wrap = 0.35;
  float facing = max((dot(n, sun.xyz) + wrap) / ((1.0 + wrap) * (1.0 + wrap)), 0.0);
  vec3 ambient = mix(bounce_colour.rgb, sky_colour.rgb, 0.5 + 0.5 * n.y);
  vec3 c = tone * (ambient * light.x + sun_colour.rgb * (facing * mix(0.25, 1.0, light.y)));
  c += tone * lamp.rgb * max(dot(n, normalize(to_eye + vec3(0.3, 0.9, 0.0))), 0.0);
  float turned = 1.0 - max(dot(n, to_eye), 0.0);
  float rim = turned * turned * turned;
  c += (0.20 * rim * light.x) * mix(vec3(1.0), tone, 0.5) * sky_colour.rgb;
  vec3 half_way = normalize(to_eye + sun.xyz);
  float gleam = max(dot(n, half_way), 0.0);
  gleam *= gleam * gleam;
  gleam *= gleam;
  gleam *= gleam;
  gleam *= gleam;  // to the 24th
  c += base.w * gleam * sun_colour.rgb * light.y;
  colour = vec4(written(shown(c, world)), 1.0);
}
