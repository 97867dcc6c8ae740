layout(location = 0) in vec3 position; // World space: posed by skin.vert.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 attributes;
layout(location = 3) in vec2 texCoord;
layout(location = 4) in vec4 color;
layout(location = 5) in vec2 emissiveTexCoord;

uniform mat4 viewProjection;
uniform mat3x2 uvTransform;
uniform mat3x2 emissiveUvTransform;

out vec3 worldPosition;
out vec3 worldNormal;
out vec2 surfaceAttributes;
out vec2 uv;
out vec2 emissiveUv;
out vec4 vertexColor;

void main() {
  worldPosition = position;
  worldNormal = normal;
  surfaceAttributes = attributes;
  uv = uvTransform * vec3(texCoord, 1.0);
  emissiveUv = emissiveUvTransform * vec3(emissiveTexCoord, 1.0);
  vertexColor = color;
  gl_Position = viewProjection * vec4(position, 1.0);
}
