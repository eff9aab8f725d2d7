uniform vec4 place;  // xyz: middle; w: half side
out vec2 local;
out vec3 world;
void main() {
  local = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0);
  world = place.xyz + vec3(local.x, 0.0, -local.y) * place.w;
  local *= place.w;
  gl_Position = view_projection * vec4(world, 1.0);
}
