// The body, thrown onto the floor along the sun's rays, as seen from above in its tile of the atlas.
uniform vec4 tile;    // xy: centre in clip space; zw: half size
uniform vec4 window;  // xy: world x and z of its middle; z: half its side in metres
out float lift;
void main() {
  vec4 p = skin() * vec4(position, 1.0);
  float height = max(p.y - sun.w, 0.0);
  vec2 thrown = p.xz - sun.xz * (height / sun.y);
  vec2 local = (thrown - window.xy) / window.z;
  lift = height;
  gl_Position = vec4(tile.xy + local * tile.zw, 0.0, 1.0);
}
