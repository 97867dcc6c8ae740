// One instance for each segment of a polyline, drawn as a rectangle that faces the viewer.
layout(location = 0) in vec3 before; // World; equals `from` at the start of a line.
layout(location = 1) in vec3 from;
layout(location = 2) in vec3 to;
layout(location = 3) in vec3 after; // Equals `to` at the end of a line.
layout(location = 4) in vec4 fromColor; // sRGB
layout(location = 5) in vec4 toColor;
layout(location = 6) in vec4 style; // Width at from and to (pixels); dash and gap length (pixels, 0 solid).
layout(location = 7) in vec2 along; // Length of the line at from and to, pixels.

uniform mat4 viewProjection;
uniform vec2 viewportSize;
uniform float outline; // Pixels of dark edge around the line.
uniform float nearest; // Smallest clip w that is drawn.

flat out vec4 ends;      // Pixels: from.xy, to.xy.
flat out vec4 cuts;      // Unit normals of the lines at which neighbours take over.
flat out vec2 hasCut;
flat out vec2 widths;
flat out vec2 dash;
flat out vec2 lengths;
flat out vec4 colorFrom;
flat out vec4 colorTo;

vec2 pixelsOf(vec4 clip) { return 0.5 * viewportSize * (clip.xy / clip.w + 1.0); }

vec4 clipped(vec4 clip, vec4 other) {
  float share = clamp((nearest - clip.w) / (other.w - clip.w), 0.0, 1.0);
  return clip.w < nearest ? mix(clip, other, share) : clip;
}

vec2 direction(vec2 a, vec2 b, vec2 fallback) {
  float size = length(b - a);
  return size > 1e-4 ? (b - a) / size : fallback;
}

vec2 cutNormal(vec2 here, vec2 other) {
  vec2 sum = here + other;
  return dot(sum, sum) > 1e-3 ? normalize(sum) : here;
}

void main() {
  vec4 clipFrom = viewProjection * vec4(from, 1.0);
  vec4 clipTo = viewProjection * vec4(to, 1.0);
  vec4 clipBefore = viewProjection * vec4(before, 1.0);
  vec4 clipAfter = viewProjection * vec4(after, 1.0);
  if (clipFrom.w < nearest && clipTo.w < nearest) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec4 start = clipped(clipFrom, clipTo);
  vec4 end = clipped(clipTo, clipFrom);
  vec2 a = pixelsOf(start);
  vec2 b = pixelsOf(end);
  vec2 forward = direction(a, b, vec2(1.0, 0.0));
  hasCut = vec2(before != from && clipBefore.w >= nearest && clipFrom.w >= nearest,
                after != to && clipAfter.w >= nearest && clipTo.w >= nearest);
  cuts.xy = cutNormal(forward, direction(pixelsOf(clipBefore), a, forward));
  cuts.zw = cutNormal(forward, direction(b, pixelsOf(clipAfter), forward));
  ends = vec4(a, b);
  widths = style.xy;
  dash = style.zw;
  lengths = along;
  colorFrom = fromColor;
  colorTo = toColor;

  float reach = 0.5 * max(style.x, style.y) + outline + 1.0;
  bool atEnd = gl_VertexID % 2 == 1;
  float side = gl_VertexID / 2 == 0 ? -1.0 : 1.0;
  vec2 corner = (atEnd ? b + reach * forward : a - reach * forward) + side * reach * vec2(-forward.y, forward.x);
  vec4 clip = atEnd ? end : start;
  gl_Position = vec4((2.0 * corner / viewportSize - 1.0) * clip.w, clip.z, clip.w);
}
