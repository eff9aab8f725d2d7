// A tile of the shadow atlas.
uniform int record_size;
out vec2 local;
out vec2 place;  // world x and z
flat out vec2 feet;
flat out vec3 tile_uv;
flat out float half_side;
void main() {
  int avatar = gl_InstanceID * record_size;
  vec4 window = record[avatar + shadow_window];
  vec4 tile = record[avatar + shadow_tile];
  local = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  place = window.xy + local * window.z;
  feet = 0.5 * (record[avatar + left_foot].xz + record[avatar + right_foot].xz);
  tile_uv = 0.5 * vec3(1.0 + tile.xy, tile.z);
  half_side = window.z;
  gl_Position = vec4(tile.xy + local * tile.zw, 0.0, 1.0);
}
