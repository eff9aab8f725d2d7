// Encodes sRGB (IEC 61966-2-1) for a framebuffer that does not.
in vec2 uv;
out vec4 colour;
uniform sampler2D image;
void main() {
  vec3 c = texture(image, uv).rgb;
  colour = vec4(mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)), 1.0);
}
