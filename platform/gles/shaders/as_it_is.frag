// A picture as it is read, and between its pixels where it is enlarged.
in vec2 uv;
out vec4 colour;
uniform sampler2D image;
void main() {
  colour = vec4(texture(image, uv).rgb, 1.0);
}
