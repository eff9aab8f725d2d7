layout(std140) uniform Looks {
  vec4 look_part[132];
};
// A colour (w: shine) per material, the pattern's (w: length of hair), the build, two sets of bands.
const int parts_of_look = 11, second_part = 7, build_part = 8, bands_part = 9;
const uint hair_material = 1u;
const uint coat_material = 2u;
struct Build {
  float height, shoulders, hips, hair_volume, hair_length;
};
int look_of(int avatar) {
  return int(record[avatar + hips].w) * parts_of_look;
}
Build build_of(int look) {
  vec4 b = look_part[look + build_part];
  return Build(b.x, b.y, b.z, b.w, look_part[look + second_part].w);
}
