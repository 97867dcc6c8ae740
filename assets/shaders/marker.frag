in vec2 offset;
flat in vec4 fillColor;
flat in vec4 edgeColor;
flat in vec4 form;
uniform float opacity;
out vec4 pixel;

// Signed distance to the outline of the shape, pixels; negative inside.
float distanceTo(int kind, float radius) {
  if (kind == 3) {
    vec2 a = abs(offset);
    return (a.x + a.y - 1.25 * radius) * 0.70710678;
  }
  if (kind == 4) {
    vec2 across = vec2(cos(form.w), sin(form.w));
    vec2 local = abs(vec2(dot(offset, across), dot(offset, vec2(-across.y, across.x))));
    vec2 beyond = local - vec2(max(0.28 * radius, 0.6), radius);
    return length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0);
  }
  return length(offset) - radius;
}

vec3 shadedAsSphere(vec3 color, float radius) {
  vec2 place = offset / max(radius, 1e-3);
  vec3 normal = vec3(place, sqrt(max(1.0 - dot(place, place), 0.0)));
  float light = clamp(dot(normal, normalize(vec3(-0.45, 0.65, 0.62))), 0.0, 1.0);
  float gloss = pow(light, 24.0);
  return mix(color * mix(0.62, 1.08, light), vec3(1.0), 0.55 * gloss);
}

void main() {
  int kind = int(form.z + 0.5); // 0 disc, 1 sphere, 2 ring, 3 diamond, 4 tick
  float radius = form.x;
  float distance = distanceTo(kind, radius);
  float inner = clamp(0.5 - distance, 0.0, 1.0);
  float outer = clamp(0.5 + form.y - distance, 0.0, 1.0);
  vec4 fill = kind == 1 ? vec4(shadedAsSphere(fillColor.rgb, radius), fillColor.a) : fillColor;
  float edgeAlpha = (outer - inner) * edgeColor.a;
  float fillAlpha = kind == 2 ? 0.0 : inner * fill.a;
  if (kind == 2) {
    float ring = clamp(0.5 + 0.5 * form.y - abs(distance), 0.0, 1.0);
    edgeAlpha = ring * edgeColor.a;
  }
  float alpha = edgeAlpha + fillAlpha;
  if (alpha <= 0.002) {
    discard;
  }
  pixel = vec4((edgeColor.rgb * edgeAlpha + fill.rgb * fillAlpha) / alpha, alpha * opacity);
}
