// What an avatar takes from the light on the floor: its sun shadow, softer the further it falls, and
// the contact of its feet. Multiplies what is there.
in vec2 local;
in vec3 world;
out vec4 colour;
uniform sampler2D light_map;
uniform sampler2D shadow_atlas;
uniform vec4 window;
uniform vec4 tile_uv;   // xy: middle of the tile; zw: half size, in texture coordinates
uniform vec4 foot[2];   // xyz: place; w: height of the sole
uniform vec4 centre;    // xyz: the hips

float shadow_at(vec2 p) {
  vec2 edge = 1.0 - smoothstep(0.90, 1.0, abs(p));
  return texture(shadow_atlas, tile_uv.xy + clamp(p, -1.0, 1.0) * tile_uv.zw).r * edge.x * edge.y;
}

float contact(vec4 sole) {
  float spread = 0.09 + sole.w * 0.9;
  vec2 d = (world.xz - sole.xz) / spread;
  return 0.62 * exp(-dot(d, d)) * exp(-sole.w * 9.0);
}

void main() {
  vec2 away = -normalize(sun.xz);
  vec2 from_feet = world.xz - 0.5 * (foot[0].xz + foot[1].xz);
  float fallen = max(dot(from_feet, away), 0.0);
  float blur = (0.012 + 0.050 * fallen) / window.z;
  float covered = 0.0;
  // Vogel's spiral: even cover with few taps.
  for (int i = 0; i < 12; ++i) {
    float r = sqrt((float(i) + 0.5) / 12.0);
    float a = float(i) * 2.39996;
    covered += shadow_at(local + blur * 1.6 * r * vec2(cos(a), sin(a)));
  }
  covered /= 12.0;
  vec2 share = texture(light_map, (world.xz - lightmap.xy) * lightmap.zw).rg;
  float sun_light = dot(sun_colour.rgb, vec3(0.33)) * sun.y * share.g;
  float sky_light = dot(sky_colour.rgb, vec3(0.33)) * share.r;
  float dark = covered * sun_light / (sun_light + sky_light);
  vec2 to_body = (world.xz - centre.xz) / 0.42;
  float sky_taken = 0.24 * exp(-dot(to_body, to_body));
  float contact_taken = 1.0 - (1.0 - contact(foot[0])) * (1.0 - contact(foot[1]));
  float keep = (1.0 - dark * 0.92) * (1.0 - sky_taken) * (1.0 - contact_taken);
  keep = mix(keep, 1.0, focus.w * distance_from_focus(world));
  // Shade is a little warm: what fills it has bounced off the floor.
  colour = vec4(pow(vec3(keep), vec3(0.92, 1.0, 1.06)), 1.0);
}
