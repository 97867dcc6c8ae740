// A shell around the surface: as many pixels wider on the screen at any distance.
layout(location = 0) in vec3 position; // World space: posed by skin.vert.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 attributes; // (stretch ratio, highlight)

uniform mat4 viewProjection;
uniform vec2 viewportSize;
uniform float widthPixels;

out float highlight;

void main() {
  vec4 clip = viewProjection * vec4(position, 1.0);
  vec4 ahead = viewProjection * vec4(normal, 0.0);
  // Where the normal leads on the screen; one that leads straight to the eye leads nowhere.
  vec2 away = (ahead.xy * clip.w - clip.xy * ahead.w) * viewportSize;
  float size = length(away);
  vec2 offset = size > 1e-9 ? away / size * (2.0 * widthPixels / viewportSize) : vec2(0.0);
  highlight = attributes.y;
  gl_Position = clip + vec4(offset * clip.w, 0.0, 0.0);
}
