// Softens the shadows in the atlas, the more the further they fall: once a texel of it, since a shadow
// has many more pixels in the picture.
in vec2 local;
in vec2 place;  // world x and z
out vec4 colour;
uniform sampler2D shadow_atlas;
flat in vec2 feet;      // their middle, world x and z
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

void main() {
  vec2 away = -normalize(sun.xz);
  float fallen = max(dot(place - feet, away), 0.0);
  float blur = (0.02 + 0.075 * fallen) / half_side;
  colour = vec4(shadow_at(local, blur));
}
