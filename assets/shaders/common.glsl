// Colours that a person chose are sRGB; light is added in linear light; pixels leave as sRGB.
vec3 toLinear(vec3 srgb) {
  return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, srgb));
}

vec3 toSrgb(vec3 linear) {
  vec3 clamped = clamp(linear, 0.0, 1.0);
  return mix(12.92 * clamped, 1.055 * pow(clamped, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, clamped));
}

// Half a step of an 8-bit channel of ordered noise: keeps dark gradients from showing bands.
vec3 dithered(vec3 srgb, vec2 pixel) {
  float noise = fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715))));
  return srgb + (noise - 0.5) / 255.0;
}
