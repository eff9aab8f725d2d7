// Marks on the floor, drawn by their distance to a shape. Metres.
in vec2 local;  // floor frame
in vec3 world;
out vec4 colour;
uniform vec4 tone;      // rgb; a: opacity
uniform vec4 mark;      // x: radius; y, z: direction; w: kind
uniform vec4 inner_tone;

float filled(float d) {
  float aa = max(fwidth(d), 1e-4);
  return 1.0 - smoothstep(-0.5 * aa, 0.5 * aa, d);
}

/// Covers what is under it with `c`.
vec4 over(vec4 under, vec3 c, float alpha) {
  float a = alpha + under.a * (1.0 - alpha);
  return vec4((c * alpha + under.rgb * under.a * (1.0 - alpha)) / max(a, 1e-4), a);
}

void main() {
  float r = mark.x;
  float d = length(local);
  vec4 c = vec4(0.05, 0.03, 0.02, 0.28 * (1.0 - smoothstep(r * 0.95, r * 1.25, d)));
  if (mark.w < 0.5) {  // you are here
    vec2 forward = mark.yz;
    vec2 p = vec2(dot(local, forward), dot(local, vec2(-forward.y, forward.x)));
    float reach = length(p);
    float wedge = abs(atan(p.y, p.x)) - 0.62;
    float cone = max(wedge * reach, reach - r * 2.6);
    c = vec4(tone.rgb, 0.42 * filled(cone) * (1.0 - smoothstep(r, r * 2.6, reach)));
    c = over(c, vec3(0.05, 0.03, 0.02), 0.30 * (1.0 - smoothstep(r * 0.95, r * 1.22, d)));
    c = over(c, inner_tone.rgb, filled(d - r));
    c = over(c, tone.rgb, filled(d - r * 0.74));
  } else if (mark.w < 1.5) {  // goal: a ring with a dot
    c = over(c, inner_tone.rgb, filled(d - r));
    c = over(c, tone.rgb, filled(abs(d - r * 0.80) - r * 0.13));
    c = over(c, tone.rgb, filled(d - r * 0.30));
  } else if (mark.w < 2.5) {  // an exhibit
    c = over(c, inner_tone.rgb, filled(d - r));
    c = over(c, tone.rgb, filled(d - r * 0.62));
  } else if (mark.w > 3.5) {  // a doorway: light lies in it, and fades out of it
    vec2 through = mark.yz;
    float along = dot(local, through);
    float across = abs(dot(local, vec2(-through.y, through.x)));
    float fade = exp(-along * along / 0.22);
    c = vec4(tone.rgb, fade * (1.0 - smoothstep(r - 0.18, r + 0.02, across)));
  } else {  // the chosen exhibit
    c = over(c, inner_tone.rgb, filled(d - r));
    c = over(c, tone.rgb, filled(d - r * 0.86));
    c = over(c, inner_tone.rgb, filled(d - r * 0.34));
  }
  colour = vec4(c.rgb, c.a * tone.a);
}
