uniform sampler2D light_map;
out vec3 world;
out vec3 normal;
out vec4 base;
out vec2 light;
out vec2 cloth;
flat out vec3 second;
flat out vec2 share;
const float shade_range = 2.0;
void main() {
  int avatar = gl_InstanceID * record_size;
  int look = look_of(avatar);
  Skinned it = skin(avatar, build_of(look));
  world = it.place;
  normal = it.normal;
  base = look_part[look + int(material)];
  second = look_part[look + second_part].rgb;
  // The coat's pattern is where two sets of bands cross.
  vec4 one = look_part[look + bands_part], other = look_part[look + bands_part + 1];
  bool is_coat = material == coat_material;
  vec2 bands = vec2(dot(one.xy, it.modelled), dot(other.xy, it.modelled)) + vec2(one.z, other.z);
  cloth = is_coat ? bands : vec2(0.0);
  share = vec2(one.w, other.w);
  vec2 at = (world.xz - lightmap.xy) * lightmap.zw;
  vec3 share = textureLod(light_map, at, 0.0).rgb;
  // The shade of walls reaches up to a height; the sky opens as one rises above the floor.
  float height = world.y - sun.w;
  float shade = share.b * shade_range;
  light.y = smoothstep(shade - 0.15, shade + 0.15, height + 0.02);
  light.x = occlusion * mix(share.r, 1.0, clamp(height / 1.5, 0.0, 1.0));
  // The body shades itself: what looks down sees the floor close by.
  gl_Position = view_projection * vec4(world, 1.0);
}
