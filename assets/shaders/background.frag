in vec2 place;
uniform vec3 topColor;
uniform vec3 bottomColor;
out vec4 pixel;

void main() {
  vec3 color = mix(bottomColor, topColor, smoothstep(0.0, 1.0, place.y));
  pixel = vec4(dithered(color, gl_FragCoord.xy), 1.0);
}
