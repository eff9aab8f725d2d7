// The table: paper, with the building's shadow softly on it.
in vec3 world;
in vec2 uv;
out vec4 colour;
uniform sampler2D light_map;
void main() {
  vec2 share = texture(light_map, uv).rg;
  vec3 full = sky_colour.rgb + sun_colour.rgb * sun.y;
  vec3 here = sky_colour.rgb * share.r + sun_colour.rgb * (sun.y * share.g);
  vec3 tone = mix(vec3(1.0), here / full, 0.62);
  // Soft towards the edge, so that the plate's border never shows.
  vec2 border = min(uv, 1.0 - uv) / (abs(lightmap.zw) * 2.5);
  float inside = clamp(min(border.x, border.y), 0.0, 1.0);
  float keep = inside * (1.0 - 0.7 * focus.w * distance_from_focus(world));
  colour = vec4(written(paper.rgb * mix(vec3(1.0), tone, keep)), 1.0);
}
