// Small shaded solids of the handles.
layout(location = 0) in vec3 position; // World.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color; // sRGB
uniform mat4 viewProjection;
uniform mat4 view;
out vec3 eyeNormal;
flat out vec4 solidColor;

void main() {
  eyeNormal = mat3(view) * normal;
  solidColor = color;
  gl_Position = viewProjection * vec4(position, 1.0);
}
