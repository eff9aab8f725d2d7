layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in uvec4 joint;
layout(location = 3) in vec4 weight;
layout(location = 4) in uint material;
layout(location = 5) in float occlusion;
layout(std140) uniform Palette {
  mat4 palette[64];
};
mat4 skin() {
  return palette[joint.x] * weight.x + palette[joint.y] * weight.y + palette[joint.z] * weight.z +
         palette[joint.w] * weight.w;
}
