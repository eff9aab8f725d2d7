// What an avatar takes from the light on the floor: its sun shadow, softer the further it falls, and
// the contact of its feet. Multiplies what is there.
in vec2 local;
in vec3 world;
out vec4 colour;
uniform sampler2D light_map;
uniform sampler2D shadow_atlas;
flat in vec4 foot[2];   // xyz: place; w: height of the sole
flat in vec3 centre;    // the hips
flat in vec3 tile_uv;   // xy: middle of the tile; z: half its side, in texture coordinates
flat in float half_side;

/// How much of a disc of `blur` (in half sides of the window) round a place the body covers.
float shadow_at(vec2 p, float blur) {
  // Texels of the finest level under the disc; the coarser levels are its average.
  float texels = blur * tile_uv.z * float(textureSize(shadow_atlas, 0).x);
  float level = log2(max(texels, 1.0));
  float sum = 0.0;
  for (int i = 0; i < 5; ++i) {
    vec2 to = i == 0 ? vec2(0.0) : blur * 0.75 * vec2(i < 3 ? 1.0 : -1.0, (i & 1) == 0 ? 1.0 : -1.0);
    vec2 at = tile_uv.xy + clamp(p + to, -0.97, 0.97) * tile_uv.z;
    sum += textureLod(shadow_atlas, at, level).r;
  }
  vec2 edge = 1.0 - smoothstep(0.86, 0.98, abs(p));
  return sum / 5.0 * edge.x * edge.y;
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
  float blur = (0.02 + 0.075 * fallen) / half_side;
  float covered = shadow_at(local, blur);
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
