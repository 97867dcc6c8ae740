layout(location = 0) in vec3 position; // World space: posed by skin.vert.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 attributes;
layout(location = 3) in vec2 texCoord;
layout(location = 4) in vec4 color;

uniform mat4 viewProjection;
uniform vec4 uvTransform;

out vec3 worldPosition;
out vec3 worldNormal;
out vec2 surfaceAttributes;
out vec2 uv;
out vec4 vertexColor;

void main() {
  worldPosition = position;
  worldNormal = normal;
  surfaceAttributes = attributes;
  uv = texCoord * uvTransform.xy + uvTransform.zw;
  vertexColor = color;
  gl_Position = viewProjection * vec4(position, 1.0);
}
