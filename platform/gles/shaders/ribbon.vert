layout(location = 0) in vec2 place;     // world x and z
layout(location = 1) in vec2 ribbon_in; // x: metres along; y: metres across, from the middle
out vec2 ribbon;
out vec3 world;
uniform float lift;
void main() {
  ribbon = ribbon_in;
  world = vec3(place.x, sun.w + lift, place.y);
  gl_Position = view_projection * vec4(world, 1.0);
}
