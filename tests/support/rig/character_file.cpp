#include "tests/support/rig/character_file.h"

#include "core/math/bounds.h"

namespace stretch::test {

namespace {

using gltf::Json;

template <typename Vectors>
std::vector<float> numbersOf(const Vectors& vectors, int width) {
  std::vector<float> numbers;
  for (const auto& vector : vectors) {
    for (int i = 0; i < width; ++i) {
      numbers.push_back(static_cast<float>(vector[i]));
    }
  }
  return numbers;
}

Json nodeOf(const Node& node) {
  Json json = Json::object();
  json["name"] = node.name;
  const Transform& rest = node.rest;
  json["translation"] = {rest.translation.x, rest.translation.y, rest.translation.z};
  json["rotation"] = {rest.rotation.x, rest.rotation.y, rest.rotation.z, rest.rotation.w};
  json["scale"] = {rest.scale.x, rest.scale.y, rest.scale.z};
  for (const NodeIndex child : node.children) {
    json["children"].push_back(child.value);
  }
  if (node.mesh >= 0) {
    json["mesh"] = node.mesh;
  }
  if (node.skin >= 0) {
    json["skin"] = node.skin;
  }
  return json;
}

Json primitiveOf(GlbBuilder& file, const Primitive& primitive) {
  std::vector<glm::vec3> positions = primitive.positions;
  std::vector<VertexInfluences> influences = primitive.influences;
  while (positions.size() % 3 != 0) {
    positions.push_back(positions.back());
    if (!influences.empty()) {
      influences.push_back(influences.back());
    }
  }
  Json json;
  const int accessor = file.floats(numbersOf(positions, 3), "VEC3", 3);
  Bounds bounds;
  for (const glm::vec3& position : positions) {
    bounds.add(Vec3(position));
  }
  Json& described = file.json["accessors"][static_cast<std::size_t>(accessor)];
  described["min"] = {bounds.low.x, bounds.low.y, bounds.low.z};
  described["max"] = {bounds.high.x, bounds.high.y, bounds.high.z};
  json["attributes"]["POSITION"] = accessor;
  if (!influences.empty()) {
    std::vector<std::uint16_t> joints;
    std::vector<float> weights;
    for (const VertexInfluences& vertex : influences) {
      joints.insert(joints.end(), vertex.joints.begin(), vertex.joints.begin() + 4);
      weights.insert(weights.end(), vertex.weights.begin(), vertex.weights.begin() + 4);
    }
    json["attributes"]["JOINTS_0"] = file.accessor(joints, 5123, "VEC4", 4);
    json["attributes"]["WEIGHTS_0"] = file.floats(weights, "VEC4", 4);
  }
  return json;
}

Json clipOf(GlbBuilder& file, const Clip& clip) {
  const char* const paths[] = {"translation", "rotation", "scale", "weights"};
  Json json;
  json["name"] = clip.name;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    const int input = file.floats(track->times, "SCALAR", 1);
    Json& times = file.json["accessors"][static_cast<std::size_t>(input)];
    times["min"] = {track->times.front()};
    times["max"] = {track->times.back()};
    const int output = file.floats(track->values, track->width == 4 ? "VEC4" : "VEC3",
                                   static_cast<std::size_t>(track->width));
    json["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", "LINEAR"}});
    json["channels"].push_back(
        {{"sampler", json["samplers"].size() - 1},
         {"target", {{"node", track->node.value}, {"path", paths[static_cast<int>(track->channel)]}}}});
  }
  return json;
}

} // namespace

GlbBuilder characterFile(const Scene& scene, const std::vector<Clip>& clips) {
  GlbBuilder file;
  file.json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
  file.json["scenes"][0]["nodes"] = Json::array();
  for (const NodeIndex root : scene.roots) {
    file.json["scenes"][0]["nodes"].push_back(root.value);
  }
  for (const Node& node : scene.nodes) {
    file.json["nodes"].push_back(nodeOf(node));
  }
  for (const Mesh& mesh : scene.meshes) {
    Json json;
    json["name"] = mesh.name;
    for (const Primitive& primitive : mesh.primitives) {
      json["primitives"].push_back(primitiveOf(file, primitive));
    }
    file.json["meshes"].push_back(json);
  }
  for (const Skin& skin : scene.skins) {
    Json json;
    for (const NodeIndex joint : skin.joints) {
      json["joints"].push_back(joint.value);
    }
    std::vector<float> binds;
    for (const Mat4& bind : skin.inverseBind) {
      const std::vector<float> numbers = numbersOf(std::vector<Vec4>{bind[0], bind[1], bind[2], bind[3]}, 4);
      binds.insert(binds.end(), numbers.begin(), numbers.end());
    }
    json["inverseBindMatrices"] = file.floats(binds, "MAT4", 16);
    file.json["skins"].push_back(json);
  }
  for (const Clip& clip : clips) {
    file.json["animations"].push_back(clipOf(file, clip));
  }
  return file;
}

} // namespace stretch::test
