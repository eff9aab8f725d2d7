// The piece of floor that an avatar and its shadow touch: from behind its feet to beyond the shadow's tip.
uniform int record_size;
out vec2 local;
out vec3 world;
flat out vec4 foot[2];
flat out vec3 centre;
flat out vec3 tile_uv;  // xy: middle of the tile; z: half its side, in texture coordinates
void main() {
  int avatar = gl_InstanceID * record_size;
  vec4 window = record[avatar + shadow_window];
  vec4 tile = record[avatar + shadow_tile];
  foot[0] = record[avatar + left_foot];
  foot[1] = record[avatar + right_foot];
  centre = record[avatar + hips].xyz;
  tile_uv = 0.5 * vec3(1.0 + tile.xy, tile.z);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec2 half_throw = window.xy - centre.xz;
  vec2 along = half_throw / max(length(half_throw), 1e-4);
  vec2 off = corner.x * (half_throw + 0.7 * along) + corner.y * (0.65 - 0.1 * corner.x) * vec2(-along.y, along.x);
  local = off / window.z;
  world = vec3(window.x + off.x, sun.w + 0.016, window.y + off.y);
  gl_Position = view_projection * vec4(world, 1.0);
}
