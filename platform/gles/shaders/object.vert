// An exhibit's own shape: it stands on its foot, turned and scaled.
layout(location = 0) in vec3 position;  // shares of its box
layout(location = 1) in vec2 normal_in; // on the octahedron
layout(location = 2) in vec2 uv_in;
layout(location = 3) in vec4 colour_in; // sRGB, and its own shade
uniform vec4 foot;   // xyz; w: scale
uniform vec2 turn;   // cosine and sine about the vertical
uniform vec3 size;
uniform vec4 uv_range;
out vec3 world;
out vec3 normal;
out vec2 uv;
out vec4 tint;
vec3 turned(vec3 p) {
  return vec3(p.x * turn.x + p.z * turn.y, p.y, p.z * turn.x - p.x * turn.y);
}
void main() {
  vec3 n = vec3(normal_in, 1.0 - abs(normal_in.x) - abs(normal_in.y));
  if (n.z < 0.0)
    n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
  normal = turned(normalize(n));
  world = foot.xyz + foot.w * turned((position - vec3(0.5, 0.0, 0.5)) * size);
  uv = uv_range.xy + uv_in * uv_range.zw;
  tint = vec4(pow(colour_in.rgb, vec3(2.2)), colour_in.a);
  gl_Position = view_projection * vec4(world, 1.0);
}
