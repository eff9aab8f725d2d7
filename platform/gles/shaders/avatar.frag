// Smooth matte surfaces: light wraps round, and a faint rim sets the figure off the floor.
in vec3 world;
in vec3 normal;
in vec4 base;
in vec2 light;
in vec2 cloth;
flat in vec3 second;
flat in vec2 share;  // of the cloth that each set of bands covers
out vec4 colour;

/// How much of this pixel bands cover that repeat with every whole `x`, `share` of it wide.
float bands(float x, float share) {
  float blur = fwidth(x) + 1e-5;
  float off = abs(fract(x) - 0.5);
  float sharp = 1.0 - smoothstep(0.5 * (share - blur), 0.5 * (share + blur), off);
  return mix(sharp, share, smoothstep(0.4, 0.9, blur));
}

void main() {
  vec3 n = normalize(normal);
  vec3 to_eye = normalize(eye.xyz - world);
  vec3 tone = mix(base.rgb, second, bands(cloth.x, share.x) * bands(cloth.y, share.y));
  const float wrap = 0.35;
  float facing = max((dot(n, sun.xyz) + wrap) / ((1.0 + wrap) * (1.0 + wrap)), 0.0);
  vec3 ambient = mix(bounce_colour.rgb, sky_colour.rgb, 0.5 + 0.5 * n.y);
  vec3 c = tone * (ambient * light.x + sun_colour.rgb * (facing * mix(0.25, 1.0, light.y)));
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
  colour = vec4(shown(c, world), 1.0);
}
