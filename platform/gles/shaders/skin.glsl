// A batch of avatars, an instance each, and what they look like (AvatarPass fills both blocks).
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in uvec4 joint;
layout(location = 3) in vec4 weight;
layout(location = 4) in uint material;
layout(location = 5) in float occlusion;
uniform int record_size;  // vec4s of an avatar in `record`
uniform float stature;    // metres of the body as it was modelled

// World place and normal of a vertex, and where it was in the front view of the body of 1.7 m.
struct Skinned {
  vec3 place;
  vec3 normal;
  vec2 modelled;
};

/// Wider or slimmer, but not at the head, and not at the feet, which stay where they were planted.
void build(inout vec3 p, inout vec3 n, Build look) {
  float trunk = smoothstep(0.10, 0.55, p.y) * (1.0 - smoothstep(1.40, 1.50, p.y));
  float girth = mix(1.0, mix(look.hips, look.shoulders, smoothstep(0.95, 1.32, p.y)), trunk);
  p.xz *= girth;
  n.y *= girth;
  if (material == hair_material) {
    bool brow = p.z > 0.05 && p.y < 1.65;
    float hanging = clamp((1.62 - p.y) / 0.10, 0.0, 1.0) * (1.0 - smoothstep(0.0, 0.06, p.z));
    if (!brow) p += n * look.hair_volume;
    p -= hanging * look.hair_length * vec3(0.0, 1.0, 0.28);
  }
}

Skinned skin(int avatar, Build look) {
  float scale = stature / 1.7;
  vec3 p = position / scale;
  vec3 n = normal_in;
  Skinned it;
  it.modelled = p.xy;
  build(p, n, look);
  vec4 x = vec4(0.0), y = vec4(0.0), z = vec4(0.0);  // rows of the blended matrix
  for (int k = 0; k < 4; ++k) {
    int row = avatar + first_matrix_row + 3 * int(joint[k]);
    x += weight[k] * record[row];
    y += weight[k] * record[row + 1];
    z += weight[k] * record[row + 2];
  }
  vec4 h = vec4(p * scale, 1.0);
  it.place = vec3(dot(x, h), dot(y, h), dot(z, h));
  it.normal = vec3(dot(x.xyz, n), dot(y.xyz, n), dot(z.xyz, n));
  // Taller or shorter upright, from the floor, so that no sole slides.
  it.place.y = sun.w + (it.place.y - sun.w) * look.height;
  it.normal.y /= look.height;
  return it;
}
