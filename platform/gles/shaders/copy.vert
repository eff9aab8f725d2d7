// The whole picture onto a panel that may be mounted turned.
uniform int quarter_turns;
// Of the picture, as a share of its size.
uniform vec2 shift;
out vec2 uv;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
  vec2 p = corner - 0.5;
  for (int i = 0; i < quarter_turns; ++i) p = vec2(p.y, -p.x);
  uv = p + 0.5 - shift;
}
