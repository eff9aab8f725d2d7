// The way: its pattern flows towards the goal. Distances are metres.
in vec2 ribbon;
in vec3 world;
out vec4 colour;
uniform sampler2D light_map;
uniform vec4 tone;    // rgb; a: opacity
uniform vec4 way;     // x: length; y: walked; z: flow; w: half width
uniform vec2 pattern; // x: period, 0: solid; y: half the length of a piece

/// Signed distance to a bar of half length `a` and half width `b` with round ends.
float bar(vec2 p, float a, float b) {
  return length(vec2(max(abs(p.x) - (a - b), 0.0), p.y)) - b;
}

float shape() {
  float whole = bar(vec2(ribbon.x - 0.5 * way.x, ribbon.y), 0.5 * way.x + way.w, way.w);
  if (pattern.x == 0.0) return whole;
  float s = mod(ribbon.x - way.z, pattern.x) - 0.5 * pattern.x;
  float thick = way.w * 0.92;
  return max(bar(vec2(s, ribbon.y), max(pattern.y, thick), thick), whole);
}

void main() {
  float d = shape();
  float aa = max(fwidth(d), 1e-4);
  float inside = 1.0 - smoothstep(-0.5 * aa, 0.5 * aa, d);
  // A thread of shadow round it lifts the ribbon off the floor.
  float shadow = (1.0 - smoothstep(0.0, 0.035, d)) * 0.30;
  float behind = 1.0 - smoothstep(way.y - 0.25, way.y + 0.10, ribbon.x);
  vec2 share = texture(light_map, (world.xz - lightmap.xy) * lightmap.zw).rg;
  float light = 0.78 + 0.22 * share.g * share.r;
  vec3 c = tone.rgb * light;
  // A slow sheen travels along the solid way.
  float phase = fract((ribbon.x - way.z) / 2.4) - 0.5;
  float sheen = pattern.x == 0.0 ? exp(-phase * phase * 40.0) : 0.0;
  c = mix(c, mix(tone.rgb, vec3(1.0), 0.55), 0.20 * sheen);
  // Its edges catch the light.
  c *= 1.0 + 0.10 * smoothstep(-0.03, -0.004, d) * sign(ribbon.y);
  // A dark casing: every kind is told from every floor, in light and in shade.
  c = mix(c, vec3(0.012, 0.009, 0.006), smoothstep(-0.030, -0.022, d));
  float opacity = tone.a * mix(1.0, 0.22, behind);
  float far = focus.w * distance_from_focus(world);
  c = mix(c, paper.rgb, far * 0.5);
  float alpha = inside + (1.0 - inside) * shadow;
  colour = vec4(mix(vec3(0.05, 0.03, 0.02), c, inside / max(alpha, 1e-4)), alpha * opacity);
}
