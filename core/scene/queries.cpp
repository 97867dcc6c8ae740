#include "core/scene/queries.h"

namespace stretch {

std::set<NodeIndex> skinJoints(const Scene& scene) {
  std::set<NodeIndex> joints;
  for (const Skin& skin : scene.skins) {
    joints.insert(skin.joints.begin(), skin.joints.end());
  }
  return joints;
}

std::size_t vertexCount(const Scene& scene) {
  std::size_t count = 0;
  for (const Mesh& mesh : scene.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      count += primitive.positions.size();
    }
  }
  return count;
}

} // namespace stretch
