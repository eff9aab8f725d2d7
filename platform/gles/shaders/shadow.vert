// The body, thrown onto the floor along the sun's rays, as seen from above in its tile of the atlas.
void main() {
  int avatar = gl_InstanceID * record_size;
  vec3 p = skin(avatar, height_of(look_of(avatar))).place;
  vec4 window = record[avatar + shadow_window];
  vec4 tile = record[avatar + shadow_tile];
  vec2 thrown = p.xz - sun.xz * (max(p.y - sun.w, 0.0) / sun.y);
  vec2 local = (thrown - window.xy) / window.z;
  gl_Position = vec4(tile.xy + local * tile.zw, 0.0, 1.0);
}
