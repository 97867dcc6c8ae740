layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform vec2 viewportSize;
noperspective out vec3 edgeDistance; // Pixels to each edge.

vec2 pixelsOf(vec4 clip) { return 0.5 * viewportSize * clip.xy / clip.w; }

void emitCorner(int corner, vec3 distance) {
  edgeDistance = distance;
  gl_Position = gl_in[corner].gl_Position;
  gl_Position.z -= 0.00002 * gl_Position.w;
  EmitVertex();
}

void main() {
  for (int i = 0; i < 3; ++i) {
    if (gl_in[i].gl_Position.w <= 0.0) {
      return;
    }
  }
  vec2 a = pixelsOf(gl_in[0].gl_Position);
  vec2 b = pixelsOf(gl_in[1].gl_Position);
  vec2 c = pixelsOf(gl_in[2].gl_Position);
  float twiceArea = abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  emitCorner(0, vec3(twiceArea / max(length(c - b), 1e-6), 0.0, 0.0));
  emitCorner(1, vec3(0.0, twiceArea / max(length(a - c), 1e-6), 0.0));
  emitCorner(2, vec3(0.0, 0.0, twiceArea / max(length(b - a), 1e-6)));
  EndPrimitive();
}
