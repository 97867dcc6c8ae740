in vec2 floorPlace;
uniform vec2 centre;
uniform float radius;
uniform float cellSize; // World units between fine lines; every fifth is stronger.
uniform float cover; // How much of the background the floor hides between its lines.
uniform vec3 floorColor;
uniform vec3 lineColor;
uniform float lineWidth; // Pixels.
uniform vec3 shadowColor;
uniform bool fromBelow;
uniform bool hasShadow;
uniform sampler2D shadow; // (contact, key shadow)
uniform vec4 shadowArea;  // Floor x, z of the centre; half sizes.
uniform vec2 shadowStrength;

out vec4 pixel;

float lines(vec2 coordinate, float width) {
  vec2 perPixel = fwidth(coordinate);
  vec2 distance = abs(fract(coordinate - 0.5) - 0.5) / max(perPixel, 1e-9);
  vec2 line = clamp(0.5 * width + 0.5 - distance, 0.0, 1.0);
  // Lines closer than a few pixels melt into the floor instead of flickering.
  vec2 apart = 1.0 - smoothstep(0.08, 0.35, perPixel);
  line *= apart;
  return max(line.x, line.y);
}

float darkness() {
  if (!hasShadow) {
    return 0.0;
  }
  vec2 place = 0.5 + 0.5 * (floorPlace - shadowArea.xy) / shadowArea.zw;
  vec2 inside = step(0.0, place) * step(place, vec2(1.0));
  vec2 dark = texture(shadow, place).rg * shadowStrength * inside.x * inside.y;
  return 1.0 - (1.0 - dark.x) * (1.0 - dark.y);
}

// Composited over the background: alpha is what the floor hides of it.
void main() {
  float away = length(floorPlace - centre) / radius;
  float fade = 1.0 - smoothstep(0.12, 0.95, away);
  float line = max(0.40 * lines(floorPlace / cellSize, lineWidth), 0.85 * lines(floorPlace / (5.0 * cellSize), lineWidth));
  if (fromBelow) {
    pixel = vec4(lineColor, 0.5 * line * fade);
    return;
  }
  float dark = darkness();
  vec3 color = mix(floorColor, lineColor, line);
  color = mix(color, shadowColor, dark);
  float alpha = max(fade * fade * cover, max(line * fade, dark * smoothstep(0.0, 0.3, fade)));
  pixel = vec4(dithered(color, gl_FragCoord.xy), alpha);
}
