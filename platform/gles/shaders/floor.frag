// Oak planks or stone slabs, under the baked light.
in vec3 world;
in vec2 uv;
flat in vec3 gallery;  // its tint
out vec4 colour;
uniform sampler2D light_map;
uniform vec4 albedo;
uniform vec4 grain;  // x: length and y: width of a plank or slab; z: how much they differ; w: joint

float hash(vec2 p) {
  p = fract(p * vec2(0.1031, 0.1130));
  p += dot(p, p.yx + 33.33);
  return fract((p.x + p.y) * p.x);
}

/// 1 in a joint of half-width `half_width` at whole numbers of x, filtered over `footprint`.
float joint(float x, float half_width, float footprint) {
  float d = abs(fract(x + 0.5) - 0.5);
  float w = half_width + 0.5 * footprint;
  return (1.0 - smoothstep(w - footprint, w + footprint, d)) * min(1.0, 2.0 * half_width / footprint);
}

void main() {
  vec2 plan = vec2(world.x, -world.z);
  float row = plan.y / grain.y;
  float along = plan.x / grain.x + hash(vec2(floor(row), 7.0));
  vec2 footprint = vec2(fwidth(plan.x) / grain.x, fwidth(plan.y) / grain.y);
  vec2 piece = vec2(floor(along), floor(row));
  float fade = 1.0 - smoothstep(0.25, 0.9, max(footprint.y, footprint.x));
  float tint = (hash(piece) - 0.5) * grain.z * fade;
  // Along the grain the tone drifts slowly; across, quickly.
  float figure = (hash(floor(vec2(plan.x * 1.5, row * 9.0) + piece * 17.0)) - 0.5) * 0.25 * grain.z *
                 (1.0 - smoothstep(0.02, 0.10, footprint.y));
  float seam = max(joint(row, grain.w / grain.y, footprint.y), joint(along, grain.w / grain.x, footprint.x));
  vec3 base = albedo.rgb * gallery * (1.0 + tint + figure) * (1.0 - 0.26 * fade * seam);
  vec2 share = texture(light_map, uv).rg;
  colour = vec4(written(shown(lit(base, vec3(0.0, 1.0, 0.0), share.r, share.g), world)), 1.0);
}
