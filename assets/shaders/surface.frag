in vec3 worldPosition;
in vec3 worldNormal;
in vec2 surfaceAttributes; // (stretch ratio, highlight)
in vec2 uv;
in vec2 emissiveUv;
in vec4 vertexColor;

uniform vec4 baseColor;
uniform vec3 emissive;
uniform bool hasTexture;
uniform sampler2D baseColorTexture;
uniform bool hasEmissiveTexture;
uniform sampler2D emissiveTexture;
uniform int alphaMode; // 0 opaque, 1 mask, 2 blend
uniform bool solidPart; // Of a blended surface: the pixels that hide what is behind them, or the others.
uniform float alphaCutoff;
uniform bool unlit;

uniform int shading; // 0 material, 1 stretch heat-map, 2 weights, 3 clay
uniform sampler2D stretchColors;
uniform vec2 stretchRange; // log2 of the ratios at the ends of stretchColors
uniform sampler2D weightColors; // From weight 0 to 1.
uniform vec3 selectionLine;
uniform vec3 selectionGround;
uniform float linePixels; // Half the width of the line.

uniform vec3 eye;
uniform vec3 viewForward;
uniform bool orthographic;
uniform vec3 keyDirection; // Towards the lights, world space.
uniform vec3 fillDirection;
uniform vec3 rimDirection;
uniform float floorHeight;
uniform float characterHeight;

uniform bool hasShadow;
uniform sampler2DShadow shadowMap;
uniform mat4 shadowMatrix; // World to shadow map, 0..1.
uniform float shadowTexel; // Size of a texel of the shadow map in world units.

out vec4 pixel;

float keyVisibility(vec3 normal) {
  if (!hasShadow) {
    return 1.0;
  }
  vec3 moved = worldPosition + normal * (1.8 * shadowTexel);
  vec3 place = (shadowMatrix * vec4(moved, 1.0)).xyz;
  vec2 texel = 1.25 / vec2(textureSize(shadowMap, 0));
  float lit = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      lit += texture(shadowMap, vec3(place.xy + texel * vec2(x, y), place.z - 0.0008));
    }
  }
  return lit / 9.0;
}

// A studio: a warm key from above, a cool fill from the other side, a rim from behind and light from all around.
vec3 litColor(vec3 albedo, vec3 normal, vec3 toEye) {
  float above = clamp((worldPosition.y - floorHeight) / max(0.35 * characterHeight, 1e-6), 0.0, 1.0);
  float nearFloor = mix(0.72, 1.0, smoothstep(0.0, 1.0, above));
  vec3 sky = vec3(0.44, 0.46, 0.50);
  vec3 ground = vec3(0.20, 0.185, 0.175);
  vec3 around = mix(ground * nearFloor, sky, 0.5 + 0.5 * normal.y) * mix(nearFloor, 1.0, 0.5);

  float wrap = 0.18;
  float towardsKey = (dot(normal, keyDirection) + wrap) / (1.0 + wrap);
  float visible = keyVisibility(normal);
  vec3 key = vec3(1.0, 0.965, 0.91) * (0.92 * max(towardsKey, 0.0) * visible);
  vec3 fill = vec3(0.72, 0.82, 1.0) * (0.20 * max(dot(normal, fillDirection) * 0.6 + 0.4, 0.0));

  float edge = 1.0 - clamp(dot(normal, toEye), 0.0, 1.0);
  float rimShape = edge * edge * edge * clamp(dot(normal, rimDirection) + 0.35, 0.0, 1.0);
  vec3 rim = vec3(0.85, 0.92, 1.0) * (0.42 * rimShape);

  vec3 halfway = normalize(keyDirection + toEye);
  float gloss = pow(clamp(dot(normal, halfway), 0.0, 1.0), 28.0) * 0.06 * visible;
  return albedo * (around + key + fill) + rim * (0.25 + 0.75 * albedo) + gloss;
}

// Leaves mid-tones alone and rolls highlights off, so that nothing white burns out.
vec3 rolledOff(vec3 color) {
  const float knee = 0.72;
  vec3 over = max(color - knee, 0.0) / (1.0 - knee);
  return min(color, knee) + (1.0 - knee) * (1.0 - exp(-over));
}

vec4 materialColor() {
  vec4 color = baseColor * vertexColor;
  if (hasTexture) {
    color *= texture(baseColorTexture, uv);
  }
  return color;
}

vec3 emitted() {
  return hasEmissiveTexture ? emissive * texture(emissiveTexture, emissiveUv).rgb : emissive;
}

vec3 stretchColor() {
  float place = (log2(max(surfaceAttributes.x, 1e-3)) - stretchRange.x) / (stretchRange.y - stretchRange.x);
  return texture(stretchColors, vec2(clamp(place, 0.002, 0.998), 0.5)).rgb;
}

vec3 albedoFor(vec4 material) {
  vec3 clay = vec3(0.30);
  if (shading == 1) {
    return stretchColor();
  }
  if (shading == 2) {
    return texture(weightColors, vec2(clamp(surfaceAttributes.y, 0.002, 0.998), 0.5)).rgb;
  }
  return shading == 3 ? clay : material.rgb;
}

// The selected limb: a little nearer to the lightness of the line around it, so that it keeps its own hue whatever that
// is; where what is selected begins on the surface, the line.
vec3 pickedOut(vec3 color, float share) {
  vec3 inner = toLinear(selectionLine);
  color = mix(color, inner, 0.07 * share);
  float slope = fwidth(share);
  float away = abs(share - 0.5) / max(slope, 1e-5); // Pixels.
  vec3 line = mix(toLinear(selectionGround), inner, 1.0 - smoothstep(linePixels - 0.5, linePixels + 0.5, away));
  float begins = smoothstep(0.002, 0.008, slope); // What belongs by half all over begins nowhere.
  return mix(color, line, begins * (1.0 - smoothstep(2.0 * linePixels - 0.5, 2.0 * linePixels + 0.5, away)));
}

void main() {
  vec4 material = materialColor();
  if (alphaMode == 1 && material.a < alphaCutoff) {
    discard;
  }
  if (alphaMode == 2 && (material.a > 0.996) != solidPart) {
    discard;
  }
  vec3 toEye = orthographic ? -viewForward : normalize(eye - worldPosition);
  vec3 normal = normalize(worldNormal);
  normal = dot(normal, toEye) < 0.0 && !gl_FrontFacing ? -normal : normal;
  vec3 albedo = albedoFor(material);
  vec3 color = unlit && shading == 0 ? albedo : rolledOff(litColor(albedo, normal, toEye) + (shading == 0 ? emitted() : vec3(0.0)));
  if (shading != 2) {
    color = pickedOut(color, clamp(surfaceAttributes.y, 0.0, 1.0));
  }
  pixel = vec4(toSrgb(color), alphaMode == 2 ? material.a : 1.0);
}
