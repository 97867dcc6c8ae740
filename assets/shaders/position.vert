// Passes that need nothing but where the surface is.
layout(location = 0) in vec3 position;
uniform mat4 viewProjection;

void main() { gl_Position = viewProjection * vec4(position, 1.0); }
