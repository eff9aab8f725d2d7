/// How far a place is from the attention: 0 near it, 1 far away.
float distance_from_focus(vec3 world) {
  return smoothstep(focus.z, focus.z * 1.35 + 3.0, distance(world.xz, focus.xy));
}

/// Gentle filmic curve (Reinhard with a white point): holds the middle, rolls off above, never
/// reaches white.
vec3 filmic(vec3 c) {
  c = max(c, vec3(0.0)) + 0.004;
  return c * (1.0 + c * 0.16) / (1.0 + c * 0.30);
}

/// As it is written where nothing is blended: the shader encodes sRGB where it can (IEC 61966-2-1;
/// from 0.002 on to within a thousandth, and filmic() shows nothing darker), and else the
/// framebuffer does.
vec3 written(vec3 c) {
#ifdef ENCODES
  vec3 a = sqrt(c), b = sqrt(a), d = sqrt(b);
  return 0.662002687 * a + 0.684122060 * b - 0.323583601 * d - 0.0225411470 * c;
#else
  return c;
#endif
}

/// What a matte surface shows. `sky` and `sun` are the shares of each that arrive.
vec3 lit(vec3 albedo, vec3 normal, float sky, float sun_share) {
  vec3 ambient = mix(bounce_colour.rgb, sky_colour.rgb, 0.5 + 0.5 * normal.y);
  float facing = max(dot(normal, sun.xyz), 0.0);
  // Light that bounces between close surfaces keeps corners from going dead, and warms them.
  vec3 occluded = sky * (1.0 + vec3(0.30, 0.24, 0.16) * (1.0 - sky));
  return albedo * (ambient * occluded + sun_colour.rgb * (facing * sun_share));
}

/// The colour as it is shown: curve, the goal's gallery brighter, the far ones towards paper.
vec3 shown(vec3 light, vec3 world) {
  float near_goal = goal.z > 0.0 ? 1.0 - smoothstep(goal.z * 0.5, goal.z, distance(world.xz, goal.xy)) : 0.0;
  vec3 c = filmic(light * (1.0 + goal.w * near_goal));
  return mix(c, paper.rgb, focus.w * distance_from_focus(world));
}
