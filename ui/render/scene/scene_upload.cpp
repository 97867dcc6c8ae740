#include "ui/render/scene/scene_upload.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <epoxy/gl.h>

#include "core/base/check.h"

namespace stretch::ui {

namespace {

struct ShapeVertex {
  glm::vec3 position;
  glm::vec3 normal;
};

struct SurfaceVertex {
  glm::vec2 texCoord;
  glm::vec2 emissiveTexCoord;
  glm::vec4 color;
};

std::vector<ShapeVertex> shapeOf(const std::vector<glm::vec3>& positions,
                                 const std::vector<glm::vec3>& normals) {
  std::vector<ShapeVertex> shape(positions.size());
  for (std::size_t i = 0; i < shape.size(); ++i) {
    shape[i] = {positions[i], i < normals.size() ? normals[i] : glm::vec3(0.0F, 1.0F, 0.0F)};
  }
  return shape;
}

std::vector<SurfaceVertex> surfaceOf(const Primitive& primitive, const std::vector<glm::vec4>& colors) {
  std::vector<SurfaceVertex> surface(primitive.positions.size());
  for (std::size_t i = 0; i < surface.size(); ++i) {
    surface[i].texCoord = i < primitive.texCoords.size() ? primitive.texCoords[i] : glm::vec2(0.0F);
    surface[i].emissiveTexCoord =
        i < primitive.emissiveTexCoords.size() ? primitive.emissiveTexCoords[i] : surface[i].texCoord;
    surface[i].color = i < colors.size() ? colors[i] : glm::vec4(1.0F);
  }
  return surface;
}

int influenceCountOf(const Primitive& primitive) {
  int count = 0;
  for (const VertexInfluences& influences : primitive.influences) {
    for (int i = VertexInfluences::capacity; i > count; --i) {
      if (influences.weights[static_cast<std::size_t>(i - 1)] != 0.0F) {
        count = i;
      }
    }
  }
  return count;
}

UploadedPart uploadPart(const Primitive& primitive, int mesh, std::size_t number) {
  UploadedPart part;
  part.mesh = mesh;
  part.primitive = number;
  part.material = primitive.material;
  part.vertexCount = static_cast<int>(primitive.positions.size());
  part.indexCount = static_cast<int>(primitive.indices.size());
  part.influenceCount = std::max(influenceCountOf(primitive), primitive.influences.empty() ? 0 : 1);
  part.hasTexCoords = !primitive.texCoords.empty();
  part.hasColors = !primitive.colors.empty();
  part.shape = uploadBuffer(bytesOf(shapeOf(primitive.positions, primitive.normals)));
  part.surface = uploadBuffer(bytesOf(surfaceOf(primitive, primitive.colors)));
  part.indices = uploadBuffer(bytesOf(primitive.indices));
  if (!primitive.influences.empty()) {
    check(primitive.influences.size() == primitive.positions.size(), "one set of influences for each vertex");
    part.influences = uploadBuffer(bytesOf(primitive.influences));
  }
  if (!primitive.morphTargets.empty()) {
    part.positions = primitive.positions;
    part.normals = primitive.normals;
    part.targets = primitive.morphTargets;
  }
  return part;
}

void addPoseInput(DrawItem& item, const UploadedPart& part) {
  item.poseInput = GlVertexArray::create();
  constexpr std::size_t shapeStride = sizeof(ShapeVertex);
  addAttribute(item.poseInput, part.shape, {0, 3, shapeStride, offsetof(ShapeVertex, position)});
  addAttribute(item.poseInput, part.shape, {1, 3, shapeStride, offsetof(ShapeVertex, normal)});
  if (part.influenceCount > 0) {
    constexpr std::size_t stride = sizeof(VertexInfluences);
    constexpr std::size_t joints = offsetof(VertexInfluences, joints);
    constexpr std::size_t weights = offsetof(VertexInfluences, weights);
    addAttribute(item.poseInput, part.influences, {2, 4, stride, joints, true});
    addAttribute(item.poseInput, part.influences, {3, 4, stride, joints + 4 * sizeof(std::uint16_t), true});
    addAttribute(item.poseInput, part.influences, {4, 4, stride, weights});
    addAttribute(item.poseInput, part.influences, {5, 4, stride, weights + 4 * sizeof(float)});
  }
}

DrawItem makeItem(const UploadedPart& part, std::size_t partIndex, NodeIndex node, int skin) {
  DrawItem item;
  item.part = partIndex;
  item.node = node;
  item.skin = part.influenceCount > 0 ? skin : -1;
  addPoseInput(item, part);
  item.posed = GlBuffer::create();
  glBindBuffer(GL_ARRAY_BUFFER, item.posed.name());
  constexpr std::size_t stride = posedFloats * sizeof(float);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(stride) * part.vertexCount, nullptr, GL_DYNAMIC_COPY);
  item.surface = GlVertexArray::create();
  addAttribute(item.surface, item.posed, {0, 3, stride, 0});
  addAttribute(item.surface, item.posed, {1, 3, stride, 3 * sizeof(float)});
  addAttribute(item.surface, item.posed, {2, 2, stride, 6 * sizeof(float)});
  addAttribute(item.surface, part.surface, {3, 2, sizeof(SurfaceVertex), offsetof(SurfaceVertex, texCoord)});
  addAttribute(item.surface, part.surface, {4, 4, sizeof(SurfaceVertex), offsetof(SurfaceVertex, color)});
  addAttribute(item.surface, part.surface,
               {5, 2, sizeof(SurfaceVertex), offsetof(SurfaceVertex, emissiveTexCoord)});
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, part.indices.name());
  return item;
}

GlTexture uploadTexture(const Image& image) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const bool complete =
      image.width > 0 && image.height > 0 &&
      image.rgba.size() == 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (!complete || image.width > largest || image.height > largest) {
    return {};
  }
  GlTexture texture = GlTexture::create();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

// Parts of each mesh lie next to each other: firstPart[mesh] .. firstPart[mesh + 1].
std::vector<std::size_t> uploadParts(const std::vector<Mesh>& meshes, std::vector<UploadedPart>& parts) {
  std::vector<std::size_t> firstPart;
  std::size_t number = 0;
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    firstPart.push_back(parts.size());
    for (const Primitive& primitive : meshes[mesh].primitives) {
      if (!primitive.positions.empty() && !primitive.indices.empty()) {
        parts.push_back(uploadPart(primitive, static_cast<int>(mesh), number));
      }
      ++number;
    }
  }
  firstPart.push_back(parts.size());
  return firstPart;
}

std::vector<bool> shownNodes(const Scene& scene) {
  std::vector<bool> shown(scene.nodes.size(), false);
  for (const NodeIndex root : scene.roots) {
    shown[at(root)] = true;
  }
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    if (parent.exists() && shown[at(parent)]) {
      shown[at(node)] = true;
    }
  }
  return shown;
}

} // namespace

UploadedScene uploadScene(const Scene& scene) {
  const GlStateGuard guard;
  auto textures = std::make_shared<std::vector<GlTexture>>();
  for (const Image& image : scene.images) {
    textures->push_back(uploadTexture(image));
  }
  return uploadMeshes(scene, scene.meshes, std::move(textures));
}

UploadedScene uploadMeshes(const Scene& scene, const std::vector<Mesh>& meshes,
                           std::shared_ptr<const std::vector<GlTexture>> textures) {
  const GlStateGuard guard;
  UploadedScene uploaded;
  uploaded.textures = std::move(textures);
  const std::vector<std::size_t> firstPart = uploadParts(meshes, uploaded.parts);
  const std::vector<bool> shown = shownNodes(scene);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (node.mesh < 0 || !shown[i]) {
      continue;
    }
    const auto mesh = static_cast<std::size_t>(node.mesh);
    for (std::size_t part = firstPart[mesh]; part < firstPart[mesh + 1]; ++part) {
      uploaded.items.push_back(makeItem(uploaded.parts[part], part, NodeIndex(i), node.skin));
    }
  }
  return uploaded;
}

void morph(UploadedPart& part, const std::vector<float>& weights) {
  if (part.targets.empty() || weights == part.shapeWeights) {
    return;
  }
  std::vector<glm::vec3> positions = part.positions;
  std::vector<glm::vec3> normals = part.normals;
  for (std::size_t target = 0; target < std::min(weights.size(), part.targets.size()); ++target) {
    const float weight = weights[target];
    const MorphTarget& offsets = part.targets[target];
    for (std::size_t i = 0; weight != 0.0F && i < std::min(positions.size(), offsets.positions.size()); ++i) {
      positions[i] += weight * offsets.positions[i];
    }
    for (std::size_t i = 0; weight != 0.0F && i < std::min(normals.size(), offsets.normals.size()); ++i) {
      normals[i] += weight * offsets.normals[i];
    }
  }
  replaceBuffer(part.shape, bytesOf(shapeOf(positions, normals)));
  part.shapeWeights = weights;
}

void reshape(UploadedScene& uploaded, const Scene& scene, const SceneShape& shape) {
  std::vector<const Primitive*> primitives;
  for (const Mesh& mesh : scene.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      primitives.push_back(&primitive);
    }
  }
  check(shape.size() == primitives.size(), "a shape for each primitive");
  for (const UploadedPart& part : uploaded.parts) {
    const PrimitiveShape& moved = shape[part.primitive];
    check(moved.positions.size() == static_cast<std::size_t>(part.vertexCount), "a place for each vertex");
    replaceBuffer(part.shape, bytesOf(shapeOf(moved.positions, moved.normals)));
    if (!moved.colors.empty()) {
      replaceBuffer(part.surface, bytesOf(surfaceOf(*primitives[part.primitive], moved.colors)));
    }
  }
}

} // namespace stretch::ui
