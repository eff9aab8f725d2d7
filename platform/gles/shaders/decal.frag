// What an avatar takes from the light on the floor: its sun shadow and the contact of its feet.
// Multiplies what is there.
in vec2 local;
in vec3 world;
out vec4 colour;
uniform sampler2D light_map;
uniform sampler2D shadow_atlas;  // softened
flat in vec4 foot[2];   // xyz: place; w: height of the sole
flat in vec3 centre;    // the hips
flat in vec3 tile_uv;   // xy: middle of the tile; z: half its side, in texture coordinates

float contact(vec4 sole) {
  float spread = 0.09 + sole.w * 0.9;
  vec2 d = (world.xz - sole.xz) / spread;
  return 0.62 * exp(-dot(d, d)) * exp(-sole.w * 9.0);
}

void main() {
  float covered = texture(shadow_atlas, tile_uv.xy + clamp(local, -0.98, 0.98) * tile_uv.z).r;
  vec2 share = texture(light_map, (world.xz - lightmap.xy) * lightmap.zw).rg;
  vec3 sun_light = sun_colour.rgb * (sun.y * share.g);
  vec3 sky_light = sky_colour.rgb * share.r;
  vec3 dark = covered * sun_light / (sun_light + sky_light);
  vec2 to_body = (world.xz - centre.xz) / 0.42;
  float sky_taken = 0.24 * exp(-dot(to_body, to_body));
  float contact_taken = 1.0 - (1.0 - contact(foot[0])) * (1.0 - contact(foot[1]));
  vec3 keep = (1.0 - dark * 0.95) * (1.0 - sky_taken) * (1.0 - contact_taken);
  colour = vec4(mix(keep, vec3(1.0), focus.w * distance_from_focus(world)), 1.0);
}
