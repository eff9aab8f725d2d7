// One avatar after another: soles, hips, shadow, then three rows a joint.
layout(std140) uniform Avatars {
  vec4 record[1024];
};
const int left_foot = 0;     // xyz: on the floor; w: height of the sole
const int right_foot = 1;
const int hips = 2;          // xyz; w: look
const int shadow_window = 3; // xy: world x and z of its middle; z: half its side in metres
const int shadow_tile = 4;   // of the atlas. xy: middle in clip space; zw: half size
const int first_matrix_row = 5;
