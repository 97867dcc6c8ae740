// Flattens the character onto the floor along a direction, seen from above.
layout(location = 0) in vec3 position;
uniform vec3 lightDirection; // From the surface towards the light.
uniform float floorHeight;
uniform float characterHeight;
uniform vec4 area; // Floor x, z of the centre; half sizes.

out float heightShare;

void main() {
  float above = position.y - floorHeight;
  vec2 place = position.xz - lightDirection.xz * (above / lightDirection.y);
  heightShare = above / characterHeight;
  gl_Position = vec4((place - area.xy) / area.zw, 0.0, 1.0);
}
