layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in vec2 uv_in;
layout(location = 3) in vec2 light_in;  // sky, sun
out vec3 world;
out vec3 normal;
out vec2 uv;
out vec2 light;
void main() {
  world = placed(position);
  normal = normal_in;
  uv = uv_in;
  light = light_in;
  gl_Position = view_projection * vec4(world, 1.0);
}
