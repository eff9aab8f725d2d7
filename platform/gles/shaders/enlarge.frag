// A picture that was drawn smaller, between its pixels.
in vec2 uv;
out vec4 colour;
uniform sampler2D image;
void main() {
  colour = vec4(texture(image, uv).rgb, 1.0);
}
