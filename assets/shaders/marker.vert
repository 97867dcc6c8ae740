// One instance a mark of constant size on the screen.
layout(location = 0) in vec3 centre; // World.
layout(location = 1) in vec4 fill;   // sRGB
layout(location = 2) in vec4 edge;
layout(location = 3) in vec4 shape; // Radius and edge width (pixels), kind, turn (radians).

uniform mat4 viewProjection;
uniform vec2 viewportSize;
uniform float nearest;

out vec2 offset; // Pixels from the centre.
flat out vec4 fillColor;
flat out vec4 edgeColor;
flat out vec4 form;

void main() {
  vec4 clip = viewProjection * vec4(centre, 1.0);
  float reach = 1.5 * shape.x + shape.y + 1.5;
  vec2 corner = vec2(gl_VertexID % 2 == 0 ? -1.0 : 1.0, gl_VertexID / 2 == 0 ? -1.0 : 1.0);
  offset = reach * corner;
  fillColor = fill;
  edgeColor = edge;
  form = shape;
  gl_Position = clip.w < nearest ? vec4(2.0, 2.0, 2.0, 1.0) : clip + vec4(2.0 * offset / viewportSize * clip.w, 0.0, 0.0);
}
