layout(location = 0) in vec3 position;
layout(location = 2) in vec2 uv_in;
layout(location = 3) in vec2 light_in;  // x: the number of the gallery's tint, of 255
out vec3 world;
out vec2 uv;
flat out vec3 gallery;
uniform vec4 tints[8];  // the last is none
void main() {
  world = position;
  uv = uv_in;
  gallery = tints[min(int(light_in.x * 255.0 + 0.5), 7)].rgb;
  gl_Position = view_projection * vec4(world, 1.0);
}
