noperspective in vec3 edgeDistance;
uniform vec4 lineColor;
uniform float lineWidth; // Pixels.
out vec4 pixel;

void main() {
  float nearest = min(edgeDistance.x, min(edgeDistance.y, edgeDistance.z));
  float coverage = clamp(0.5 * lineWidth + 0.5 - nearest, 0.0, 1.0);
  if (coverage <= 0.0) {
    discard;
  }
  pixel = vec4(lineColor.rgb, lineColor.a * coverage);
}
