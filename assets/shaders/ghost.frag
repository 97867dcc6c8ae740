in vec3 worldPosition;
in vec3 worldNormal;
uniform vec4 tint;
uniform vec3 eye;
uniform vec3 viewForward;
uniform bool orthographic;
out vec4 pixel;

// Flat, with a firmer edge so that the silhouette can be read through other ghosts.
void main() {
  vec3 toEye = orthographic ? -viewForward : normalize(eye - worldPosition);
  float edge = 1.0 - abs(dot(normalize(worldNormal), toEye));
  pixel = vec4(tint.rgb, tint.a * mix(0.55, 1.0, edge * edge));
}
