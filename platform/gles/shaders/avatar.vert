uniform sampler2D light_map;
uniform vec4 material_colour[8];  // w: shine
out vec3 world;
out vec3 normal;
out vec4 base;
out vec2 light;
const float shade_range = 2.0;
void main() {
  mat4 m = skin();
  vec4 p = m * vec4(position, 1.0);
  world = p.xyz;
  normal = mat3(m) * normal_in;
  base = material_colour[material];
  vec2 at = (world.xz - lightmap.xy) * lightmap.zw;
  vec3 share = textureLod(light_map, at, 0.0).rgb;
  // The shade of walls reaches up to a height; the sky opens as one rises above the floor.
  float height = world.y - sun.w;
  float shade = share.b * shade_range;
  light.y = smoothstep(shade - 0.15, shade + 0.15, height + 0.02);
  light.x = occlusion * mix(share.r, 1.0, clamp(height / 1.5, 0.0, 1.0));
  // The body shades itself: what looks down sees the floor close by.
  gl_Position = view_projection * p;
}
