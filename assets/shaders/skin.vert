// Poses vertices once a frame; every pass that draws them reads the captured result. The formula is the one of
// the skinning matrices in core: a weighted sum of joint matrices, normals by the inverse transpose of its linear part,
// or as engines have it that turn them by the joints' own matrices (skinning::NormalMatrix).
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in uvec4 jointsA;
layout(location = 3) in uvec4 jointsB;
layout(location = 4) in vec4 weightsA;
layout(location = 5) in vec4 weightsB;

// Texels of each slot: the three rows of an affine matrix, then (stretch ratio, highlight, 0, 0); with plainNormals three
// more, the rows that normals are turned by.
uniform samplerBuffer matrices;
uniform int firstSlot;
uniform bool plainNormals;
uniform int influenceCount; // 0 for a mesh that hangs rigidly on slot firstSlot

out vec3 posedPosition;
out vec3 posedNormal;
out vec2 posedAttributes;

struct Slot {
  vec4 row0;
  vec4 row1;
  vec4 row2;
  vec2 attributes;
  mat3 turn; // columns: the rows for normals
};

Slot fetchSlot(int slot) {
  int texel = (plainNormals ? 7 : 4) * slot;
  Slot fetched;
  fetched.row0 = texelFetch(matrices, texel);
  fetched.row1 = texelFetch(matrices, texel + 1);
  fetched.row2 = texelFetch(matrices, texel + 2);
  fetched.attributes = texelFetch(matrices, texel + 3).xy;
  if (plainNormals) {
    fetched.turn = mat3(texelFetch(matrices, texel + 4).xyz, texelFetch(matrices, texel + 5).xyz,
                        texelFetch(matrices, texel + 6).xyz);
  } else {
    fetched.turn = mat3(fetched.row0.xyz, fetched.row1.xyz, fetched.row2.xyz);
  }
  return fetched;
}

void addInfluence(inout Slot sum, uint joint, float weight) {
  if (weight == 0.0) {
    return;
  }
  Slot slot = fetchSlot(firstSlot + int(joint));
  sum.row0 += weight * slot.row0;
  sum.row1 += weight * slot.row1;
  sum.row2 += weight * slot.row2;
  sum.attributes += weight * slot.attributes;
  sum.turn += weight * slot.turn;
}

Slot blendedSlot() {
  Slot sum = Slot(vec4(0.0), vec4(0.0), vec4(0.0), vec2(0.0), mat3(0.0));
  for (int i = 0; i < min(influenceCount, 4); ++i) {
    addInfluence(sum, jointsA[i], weightsA[i]);
  }
  for (int i = 4; i < influenceCount; ++i) {
    addInfluence(sum, jointsB[i - 4], weightsB[i - 4]);
  }
  return sum;
}

// Rows of the cofactor matrix are cross products: the inverse transpose times the determinant, whose sign is put back.
vec3 transformedNormal(Slot slot) {
  vec3 a = slot.turn[0];
  vec3 b = slot.turn[1];
  vec3 c = slot.turn[2];
  if (plainNormals && influenceCount > 0) {
    vec3 plain = normal * slot.turn;
    float plainSize = length(plain);
    return plainSize > 0.0 ? plain / plainSize : normal;
  }
  vec3 bc = cross(b, c);
  vec3 raw = vec3(dot(bc, normal), dot(cross(c, a), normal), dot(cross(a, b), normal));
  float size = length(raw);
  return size > 0.0 ? raw * (dot(a, bc) < 0.0 ? -1.0 / size : 1.0 / size) : normal;
}

void main() {
  Slot slot = influenceCount == 0 ? fetchSlot(firstSlot) : blendedSlot();
  vec4 point = vec4(position, 1.0);
  posedPosition = vec3(dot(slot.row0, point), dot(slot.row1, point), dot(slot.row2, point));
  posedNormal = transformedNormal(slot);
  posedAttributes = slot.attributes;
}
