// A square of floor round an avatar.
uniform vec4 window;
out vec2 local;
out vec3 world;
void main() {
  local = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  world = vec3(window.x + local.x * window.z, sun.w + 0.016, window.y + local.y * window.z);
  gl_Position = view_projection * vec4(world, 1.0);
}
