// A rectangle of the interface; one instance each. Screen frame in pixels, y down.
layout(location = 0) in vec4 rect;     // x, y, width, height
layout(location = 1) in vec4 uv_rect;
layout(location = 2) in vec4 colour_in;
layout(location = 3) in vec4 shape_in; // x: corner; y: softness; z: fill; w: how far it reaches beyond
layout(location = 4) in vec4 clip_in;  // top, bottom; within these it fades: above, below
uniform vec2 screen;
out vec2 uv;
out vec2 local;
flat out vec2 half_size;
flat out vec4 tint;
flat out vec4 shape;
flat out vec4 clip;
out float height;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 p = rect.xy - shape_in.w + corner * (rect.zw + 2.0 * shape_in.w);
  half_size = 0.5 * rect.zw;
  local = p - (rect.xy + half_size);
  uv = uv_rect.xy + (p - rect.xy) / max(rect.zw, vec2(1e-6)) * uv_rect.zw;
  tint = colour_in;
  shape = shape_in;
  clip = clip_in;
  height = p.y;
  gl_Position = vec4(p.x / screen.x * 2.0 - 1.0, 1.0 - p.y / screen.y * 2.0, 0.0, 1.0);
}
