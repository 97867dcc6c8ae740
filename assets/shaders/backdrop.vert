// A rectangle of the viewport, drawn as a strip.
uniform vec4 box; // Left, bottom, right, top; 0..1 is the viewport.
out vec2 place;   // 0..1 from the top left, as images are

void main() {
  vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2);
  place = vec2(corner.x, 1.0 - corner.y);
  gl_Position = vec4(2.0 * mix(box.xy, box.zw, corner) - 1.0, 0.0, 1.0);
}
