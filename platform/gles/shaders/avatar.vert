uniform sampler2D light_map, shade_map;
out vec3 world;
out vec3 normal;
out vec4 base;
out vec2 light;
const float shade_range = 2.0;
const uint own_material = 10u;
void main() {
  int avatar = gl_InstanceID * record_size;
  int look = look_of(avatar);
  Skinned it = skin(avatar, height_of(look));
  world = it.place;
  normal = it.normal;
  base = look_part[look + int(material)];
  if (material == own_material) base.rgb = pow(own_colour.rgb, vec3(2.2));
  vec2 at = (world.xz - lightmap.xy) * lightmap.zw;
  vec2 share = textureLod(light_map, at, 0.0).rg;
  // The shade of walls reaches up to a height; the sky opens as one rises above the floor.
  float height = world.y - sun.w;
  float shade = textureLod(shade_map, at, 0.0).r * shade_range;
  // The body shades itself: folds and hollows see less of the sun, too.
  light.y = smoothstep(shade - 0.15, shade + 0.15, height + 0.02) * mix(0.35, 1.0, occlusion);
  light.x = occlusion * mix(share.r, 1.0, clamp(height / 1.5, 0.0, 1.0));
  gl_Position = view_projection * vec4(world, 1.0);
}
