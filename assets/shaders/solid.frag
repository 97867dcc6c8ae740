in vec3 eyeNormal;
flat in vec4 solidColor;
uniform float opacity;
out vec4 pixel;

void main() {
  float light = clamp(dot(normalize(eyeNormal), normalize(vec3(-0.4, 0.6, 0.7))), 0.0, 1.0);
  pixel = vec4(solidColor.rgb * mix(0.62, 1.1, light), solidColor.a * opacity);
}
