layout(std140) uniform Looks {
  vec4 look_part[156];
};
// A colour (w: shine) per material, then the build (x: height).
const int parts_of_look = 12, build_part = 11;
int look_of(int avatar) {
  return int(record[avatar + hips].w) * parts_of_look;
}
float height_of(int look) {
  return look_part[look + build_part].x;
}
