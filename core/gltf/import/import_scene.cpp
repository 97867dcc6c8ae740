#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/gtc/type_ptr.hpp>

#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"
#include "core/scene/bind_chains.h"

namespace stretch::gltf {

namespace {

std::vector<NodeIndex> nodesOf(const Json& json, std::string_view key) {
  const std::vector<int> indices = indicesOf(json, key);
  std::vector<NodeIndex> nodes;
  std::transform(indices.begin(), indices.end(), std::back_inserter(nodes),
                 [](int index) { return NodeIndex(index); });
  return nodes;
}

Transform restOf(const Json& json) {
  Transform rest;
  if (const std::vector<double> v = numbersOf(json, "translation"); v.size() == 3) {
    rest.translation = {v[0], v[1], v[2]};
  }
  if (const std::vector<double> v = numbersOf(json, "scale"); v.size() == 3) {
    rest.scale = {v[0], v[1], v[2]};
  }
  if (const std::vector<double> v = numbersOf(json, "rotation"); v.size() == 4) {
    const Quat rotation(v[3], v[0], v[1], v[2]);
    const double length = glm::length(rotation);
    rest.rotation = length > 1e-12 ? rotation / length : Quat(1.0, 0.0, 0.0, 0.0);
  }
  return rest;
}

Node importNode(const Json& json) {
  Node node;
  node.name = shownName(json);
  node.children = nodesOf(json, "children");
  node.mesh = indexOr(json, "mesh");
  node.skin = node.mesh >= 0 ? indexOr(json, "skin") : -1;
  node.rest = restOf(json);
  if (const std::vector<double> numbers = numbersOf(json, "matrix"); numbers.size() == 16) {
    node.matrix = glm::make_mat4(numbers.data());
    node.rest = toTransform(*node.matrix);
  }
  const Json* mark = findPath(json, {"extras", "stretch_engine"});
  node.isBindLeaf = mark != nullptr && flagOr(*mark, "bind", false);
  node.isBindCorner = node.isBindLeaf && flagOr(*mark, "corner", false);
  for (const double weight : numbersOf(json, "weights")) {
    node.morphWeights.push_back(static_cast<float>(weight));
  }
  return node;
}

std::vector<Node> importNodes(const Json& json) {
  std::vector<Node> nodes(sizeOf(json, "nodes"));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i] = importNode(element(json, "nodes", i));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const NodeIndex child : nodes[i].children) {
      nodes[at(child)].parent = NodeIndex(i);
    }
  }
  return nodes;
}

// Without a scene everything is shown.
std::vector<NodeIndex> importRoots(const Json& json, const std::vector<Node>& nodes) {
  if (sizeOf(json, "scenes") > 0) {
    const int shown = std::max(indexOr(json, "scene"), 0);
    return nodesOf(element(json, "scenes", static_cast<std::size_t>(shown)), "nodes");
  }
  std::vector<NodeIndex> roots;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].parent.exists()) {
      roots.emplace_back(i);
    }
  }
  return roots;
}

// The last row of an inverse bind matrix is 0 0 0 1; exporters leave rounding there.
bool makeAffine(Mat4& matrix) {
  constexpr double tolerance = 1e-3;
  const bool isAffine = std::abs(matrix[0][3]) < tolerance && std::abs(matrix[1][3]) < tolerance &&
                        std::abs(matrix[2][3]) < tolerance && std::abs(matrix[3][3] - 1.0) < tolerance;
  for (std::size_t column = 0; column < 4; ++column) {
    matrix[column][3] = column == 3 ? 1.0 : 0.0;
  }
  return isAffine;
}

std::vector<Mat4> readInverseBind(const Source& source, int accessor, std::size_t joints,
                                  const std::string& where, Problems& problems) {
  const std::optional<AccessorShape> shape = shapeOf(source, accessor);
  if (!shape || shape->type != "MAT4" || shape->component != ComponentType::float32 ||
      shape->count < joints) {
    problems.error(where, "is not an accessor with one float MAT4 for each joint");
    std::vector<Mat4> unread(joints, Mat4(1.0));
    return unread;
  }
  const Json& json = element(source.json, "accessors", static_cast<std::size_t>(accessor));
  if (find(json, "bufferView") == nullptr && find(json, "sparse") == nullptr) {
    problems.warning(where, "has no data: all its matrices are zero, and what they move is a point");
    Mat4 point(0.0);
    point[3][3] = 1.0;
    std::vector<Mat4> points(joints, point);
    return points;
  }
  const std::vector<float> numbers = readFloats(source, accessor);
  std::vector<Mat4> matrices(joints);
  bool isSound = true;
  for (std::size_t i = 0; i < joints; ++i) {
    matrices[i] = Mat4(glm::make_mat4(numbers.data() + 16 * i));
    const bool isFinite = std::all_of(numbers.begin() + static_cast<std::ptrdiff_t>(16 * i),
                                      numbers.begin() + static_cast<std::ptrdiff_t>(16 * i + 16),
                                      [](float number) { return std::isfinite(number); });
    isSound = isFinite && makeAffine(matrices[i]) && isSound;
  }
  if (!isSound) {
    problems.error(where, "holds matrices that are not affine or not finite");
  }
  return matrices;
}

std::vector<Skin> importSkins(const Source& source, Problems& problems) {
  std::vector<Skin> skins(sizeOf(source.json, "skins"));
  for (std::size_t i = 0; i < skins.size(); ++i) {
    const Json& json = element(source.json, "skins", i);
    Skin& skin = skins[i];
    skin.name = shownName(json);
    skin.joints = nodesOf(json, "joints");
    skin.fileJoints = skin.joints.size();
    const int accessor = indexOr(json, "inverseBindMatrices");
    skin.inverseBind = accessor < 0 ? std::vector<Mat4>(skin.joints.size(), Mat4(1.0))
                                    : readInverseBind(source, accessor, skin.joints.size(),
                                                      at("skins", i) + ".inverseBindMatrices", problems);
  }
  return skins;
}

} // namespace

Scene importScene(const Source& source, Problems& problems, Pictures pictures) {
  Scene scene;
  scene.nodes = importNodes(source.json);
  scene.roots = importRoots(source.json, scene.nodes);
  scene.skins = importSkins(source, problems);
  if (!problems.hasErrors()) {
    scene.meshes = importMeshes(source, scene, problems);
  }
  scene.materials = importMaterials(source, problems);
  scene.images = importImages(source, scene.materials, problems, pictures);
  scene.humanoid = importHumanoid(source, problems);
  scene.cameras = importCameras(source, problems);
  if (!problems.hasErrors()) {
    foldBindLeaves(scene);
  }
  return scene;
}

} // namespace stretch::gltf
