flat in vec4 ends;
flat in vec4 cuts;
flat in vec2 hasCut;
flat in vec2 widths;
flat in vec2 dash;
flat in vec2 lengths;
flat in vec4 colorFrom;
flat in vec4 colorTo;

uniform float outline;
uniform vec4 outlineColor;
uniform float opacity;

out vec4 pixel;

// Neighbours meet at the bisector of their joint: each pixel belongs to one of them, so translucent lines show no beads.
bool belongsToNeighbour(vec2 here) {
  bool beforeStart = hasCut.x > 0.5 && dot(here - ends.xy, cuts.xy) < 0.0;
  bool afterEnd = hasCut.y > 0.5 && dot(here - ends.zw, cuts.zw) >= 0.0;
  return beforeStart || afterEnd;
}

// Dashes have round ends: distance to the nearest dash along the line, 0 inside.
float distanceFromDash(float position, float halfWidth) {
  float period = dash.x + dash.y;
  float inside = mod(position, period);
  float left = max(inside - (dash.x - halfWidth), 0.0);
  float right = max(period + halfWidth - inside, 0.0);
  float start = max(halfWidth - inside, 0.0);
  return inside <= dash.x - halfWidth ? start : min(left, right);
}

void main() {
  vec2 here = gl_FragCoord.xy;
  if (belongsToNeighbour(here)) {
    discard;
  }
  vec2 along = ends.zw - ends.xy;
  float size = max(length(along), 1e-4);
  float share = clamp(dot(here - ends.xy, along) / (size * size), 0.0, 1.0);
  float halfWidth = 0.5 * mix(widths.x, widths.y, share);
  float distance = length(here - ends.xy - share * along);
  if (dash.x > 0.0) {
    distance = length(vec2(distance, distanceFromDash(mix(lengths.x, lengths.y, share), halfWidth)));
  }
  float inner = clamp(halfWidth + 0.5 - distance, 0.0, 1.0) * min(1.0, 2.0 * halfWidth);
  float outer = outline > 0.0 ? clamp(halfWidth + outline + 0.5 - distance, 0.0, 1.0) * outlineColor.a : 0.0;
  vec4 color = mix(colorFrom, colorTo, share);
  float alpha = max(inner, outer) * color.a * opacity;
  if (alpha <= 0.002) {
    discard;
  }
  pixel = vec4(mix(outlineColor.rgb, color.rgb, inner / max(max(inner, outer), 1e-4)), alpha);
}
