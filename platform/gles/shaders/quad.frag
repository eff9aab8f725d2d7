in vec2 uv;
in vec2 local;
flat in vec2 half_size;
flat in vec4 tint;
flat in vec4 shape;
flat in vec4 clip;
in float height;
out vec4 colour;
uniform sampler2D image;

/// Signed distance in pixels to a rectangle with round corners.
float rounded(vec2 p, vec2 half_extent, float corner) {
  vec2 q = abs(p) - half_extent + corner;
  return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - corner;
}

/// How much is seen at this height.
float seen() {
  vec2 from_edges = vec2(height - clip.x, clip.y - height);
  vec2 share = clamp(from_edges / max(clip.zw, vec2(1e-3)), 0.0, 1.0);
  return share.x * share.y;
}

void main() {
  float corner = min(shape.x, min(half_size.x, half_size.y));
  float d = rounded(local, half_size, corner);
  float inside = clamp(0.5 - d, 0.0, 1.0);
  if (shape.z < 0.5) {  // solid
    colour = vec4(tint.rgb, tint.a * inside);
  } else if (shape.z < 1.5) {  // text
    colour = vec4(tint.rgb, tint.a * texture(image, uv).r);
  } else if (shape.z < 2.5) {  // image
    vec4 texel = texture(image, uv);
    colour = vec4(texel.rgb * tint.rgb, texel.a * tint.a * inside);
  } else if (shape.z < 3.5) {  // shadow: close to a Gaussian of the rectangle
    float x = clamp(0.5 - 0.5 * d / max(shape.y, 0.5), 0.0, 1.0);
    colour = vec4(tint.rgb, tint.a * x * x * (3.0 - 2.0 * x));
  } else if (shape.z > 4.5) {  // frame
    float line = abs(d + 0.5 * shape.y) - 0.5 * shape.y;
    colour = vec4(tint.rgb, tint.a * clamp(0.5 - line, 0.0, 1.0));
  } else {  // ring
    float radius = min(half_size.x, half_size.y);
    float ring = abs(length(local) - radius + 0.5 * shape.y) - 0.5 * shape.y;
    colour = vec4(tint.rgb, tint.a * clamp(0.5 - ring, 0.0, 1.0));
  }
  colour.a *= seen();
}
