// A batch of avatars, an instance each, and what they look like (AvatarPass fills both blocks).
layout(location = 0) in vec3 position;   // in parts of `reach`
layout(location = 1) in vec3 normal_in;
layout(location = 2) in uvec4 joint;
layout(location = 3) in vec4 weight;
layout(location = 4) in uint material;
layout(location = 5) in float occlusion;
layout(location = 6) in vec4 own_colour;  // sRGB; of a museum's own character
const float reach = 4.0;  // metres, as body.cpp has it
uniform int record_size;  // vec4s of an avatar in `record`

struct Skinned {
  vec3 place;
  vec3 normal;
};

/// World place and normal of a vertex; `height` is the share of the skeleton's.
Skinned skin(int avatar, float height) {
  vec4 x = vec4(0.0), y = vec4(0.0), z = vec4(0.0);  // rows of the blended matrix
  for (int k = 0; k < 4; ++k) {
    int row = avatar + first_matrix_row + 3 * int(joint[k]);
    x += weight[k] * record[row];
    y += weight[k] * record[row + 1];
    z += weight[k] * record[row + 2];
  }
  vec4 h = vec4(position * reach, 1.0);
  Skinned it;
  it.place = vec3(dot(x, h), dot(y, h), dot(z, h));
  it.normal = vec3(dot(x.xyz, normal_in), dot(y.xyz, normal_in), dot(z.xyz, normal_in));
  // Taller or shorter upright, from the floor, so that no sole slides.
  it.place.y = sun.w + (it.place.y - sun.w) * height;
  it.normal.y /= height;
  return it;
}
