in vec2 place;
uniform sampler2D image;
uniform float opacity;
out vec4 pixel;

void main() {
  vec4 color = texture(image, place);
  pixel = vec4(color.rgb, opacity * color.a);
}
