uniform mat4 viewProjection;
uniform vec2 centre;
uniform float radius;
uniform float floorHeight;

out vec2 floorPlace; // World x, z.

void main() {
  vec2 corner = vec2(gl_VertexID % 2 == 0 ? -1.0 : 1.0, gl_VertexID / 2 == 0 ? -1.0 : 1.0);
  floorPlace = centre + radius * corner;
  gl_Position = viewProjection * vec4(floorPlace.x, floorHeight, floorPlace.y, 1.0);
}
