// One direction of a Gaussian, two texels a tap.
in vec2 place;
uniform sampler2D source;
uniform vec2 stepSize;
out vec2 blurred;

void main() {
  vec2 sum = 0.2270270 * texture(source, place).rg;
  sum += 0.3162162 * (texture(source, place + 1.3846154 * stepSize).rg + texture(source, place - 1.3846154 * stepSize).rg);
  sum += 0.0702703 * (texture(source, place + 3.2307692 * stepSize).rg + texture(source, place - 3.2307692 * stepSize).rg);
  blurred = sum;
}
