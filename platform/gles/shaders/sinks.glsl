// Walls sink where they would hide something (runtime/scene/sunk_walls.h).
uniform sampler2D wall_levels;
uniform vec3 window;  // xy: its middle, floor frame; z: half its side, metres
uniform vec3 cut;     // x: height of the cut; y: as low as it sinks; z: 1 where things hang on the wall

vec3 placed(vec3 p) {
  vec2 plan = vec2(p.x, -p.z);
  vec2 off = abs(plan - window.xy);
  float level = textureLod(wall_levels, plan / (2.0 * window.z), 0.0).r;
  level *= step(max(off.x, off.y), window.z - 0.25);
  float sunk = (cut.x - cut.y) * level;
  p.y = mix(min(p.y, sun.w + cut.x - sunk), p.y - sunk, cut.z);
  return p;
}
