// A rectangle of the interface; one instance each. Screen frame in pixels, y down.
layout(location = 0) in vec4 rect;     // x, y, width, height
layout(location = 1) in vec4 uv_rect;
layout(location = 2) in vec4 colour_in;
layout(location = 3) in vec4 shape_in; // x: corner; y: softness; z: fill, and eight times its side; w: how far it reaches beyond
layout(location = 4) in vec4 clip_in;  // top, bottom; within these it fades: above, below
uniform vec2 screen;
out vec2 uv;
out vec2 local;
flat out vec2 half_size;
flat out vec4 tint;
flat out vec4 shape;
flat out vec4 clip;
out float height;

/// A share of a rectangle, as it is seen from a side: at the lower edge, the left, the upper, the right.
vec2 seen_from(float side, vec2 at) {
  if (side < 0.5) return at;
  if (side < 1.5) return vec2(at.y, 1.0 - at.x);
  if (side < 2.5) return vec2(1.0 - at.x, 1.0 - at.y);
  return vec2(1.0 - at.y, at.x);
}

void main() {
  float side = floor(shape_in.z / 8.0);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 p = rect.xy - shape_in.w + corner * (rect.zw + 2.0 * shape_in.w);
  half_size = 0.5 * rect.zw;
  local = p - (rect.xy + half_size);
  uv = uv_rect.xy + seen_from(side, (p - rect.xy) / max(rect.zw, vec2(1e-6))) * uv_rect.zw;
  tint = colour_in;
  shape = vec4(shape_in.xy, shape_in.z - 8.0 * side, shape_in.w);
  clip = clip_in;
  bool at_end = side > 0.5 && side < 1.5 || side > 2.5;
  height = seen_from(side, p / screen).y * (at_end ? screen.x : screen.y);
  gl_Position = vec4(p.x / screen.x * 2.0 - 1.0, 1.0 - p.y / screen.y * 2.0, 0.0, 1.0);
}
