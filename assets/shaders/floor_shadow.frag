in float heightShare;
uniform bool contact; // Ambient darkness close to the floor, else the shadow of the key light.
out vec2 darkness;

void main() {
  float height = max(heightShare, 0.0);
  float below = smoothstep(-0.12, -0.04, heightShare);
  float near = 0.65 * exp(-16.0 * height) + 0.35 * exp(-2.6 * height);
  float thrown = 1.0 - 0.45 * clamp(height, 0.0, 1.0);
  darkness = contact ? vec2(near * below, 0.0) : vec2(0.0, thrown * below);
}
