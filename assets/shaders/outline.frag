in float highlight;
uniform vec4 color;
out vec4 pixel;

void main() {
  if (highlight < 0.5) {
    discard;
  }
  pixel = color;
}
