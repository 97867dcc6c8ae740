#include "assets/dummy/glb_writer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <map>

#include "core/gltf/json/json.h"

namespace stretch::assets {

namespace {

using Json = nlohmann::ordered_json;

constexpr int arrayBuffer = 34962;
constexpr int elementArrayBuffer = 34963;
constexpr int unsignedByte = 5121;
constexpr int unsignedShort = 5123;
constexpr int singleFloat = 5126;

/// Nearest multiple of 2^-20 (about a micrometre), exact in single precision below 16.
float rounded(double value) {
  constexpr double grid = 1048576.0;
  return static_cast<float>(std::floor(value * grid + 0.5) / grid);
}

/// Collects accessors and their bytes.
class Buffer {
public:
  template <typename Value>
  int add(const std::vector<Value>& values, int componentType, const char* type, int components,
          int target = 0) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    const std::size_t offset = bytes_.size();
    const std::size_t size = values.size() * sizeof(Value);
    bytes_.resize(offset + size);
    std::memcpy(bytes_.data() + offset, values.data(), size);
    Json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}};
    if (target != 0) {
      view["target"] = target;
    }
    views_.push_back(view);
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", componentType},
                          {"count", values.size() / static_cast<std::size_t>(components)},
                          {"type", type}});
    return static_cast<int>(accessors_.size()) - 1;
  }

  void setNormalized(int accessor) { accessors_[static_cast<std::size_t>(accessor)]["normalized"] = true; }

  void setBounds(int accessor, const std::vector<float>& values, std::size_t width) {
    std::vector<float> low(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width));
    std::vector<float> high = low;
    for (std::size_t i = 0; i < values.size(); ++i) {
      low[i % width] = std::min(low[i % width], values[i]);
      high[i % width] = std::max(high[i % width], values[i]);
    }
    accessors_[static_cast<std::size_t>(accessor)]["min"] = low;
    accessors_[static_cast<std::size_t>(accessor)]["max"] = high;
  }

  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  [[nodiscard]] const Json& views() const { return views_; }
  [[nodiscard]] const Json& accessors() const { return accessors_; }

private:
  std::vector<std::uint8_t> bytes_;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
};

template <typename Member>
std::vector<float> collect(const SkinnedMesh& mesh, Member member) {
  std::vector<float> values;
  for (const SkinnedVertex& vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      values.push_back(rounded((vertex.*member)[axis]));
    }
  }
  return values;
}

/// Normals rounded to single precision must still be 1 long within the validator's tolerance: the grid is
/// fine enough.
Json writePrimitive(Buffer& buffer, const SkinnedMesh& mesh, int material, bool skinned) {
  const std::vector<float> positions = collect(mesh, &SkinnedVertex::position);
  std::vector<std::uint16_t> colors;
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (const SkinnedVertex& vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      // A grid of 1/1024 absorbs differences in the last bits of the powers behind the colours.
      const double level = std::floor(std::clamp(vertex.color[axis], 0.0, 1.0) * 1023.0 + 0.5);
      colors.push_back(static_cast<std::uint16_t>(level * 64.0 + level / 16.0));
    }
    colors.push_back(65535);
    for (std::size_t i = 0; i < 4; ++i) {
      joints.push_back(static_cast<std::uint8_t>(vertex.influences.joints[i]));
      weights.push_back(static_cast<float>(vertex.influences.weights[i]));
    }
  }
  std::vector<std::uint16_t> indices;
  for (const auto& triangle : mesh.triangles) {
    for (const int corner : triangle) {
      indices.push_back(static_cast<std::uint16_t>(corner));
    }
  }
  const int position = buffer.add(positions, singleFloat, "VEC3", 3, arrayBuffer);
  buffer.setBounds(position, positions, 3);
  const int normal = buffer.add(collect(mesh, &SkinnedVertex::normal), singleFloat, "VEC3", 3, arrayBuffer);
  const int color = buffer.add(colors, unsignedShort, "VEC4", 4, arrayBuffer);
  buffer.setNormalized(color);
  Json attributes{{"POSITION", position}, {"NORMAL", normal}, {"COLOR_0", color}};
  if (skinned) {
    attributes["JOINTS_0"] = buffer.add(joints, unsignedByte, "VEC4", 4, arrayBuffer);
    attributes["WEIGHTS_0"] = buffer.add(weights, singleFloat, "VEC4", 4, arrayBuffer);
  }
  const int index = buffer.add(indices, unsignedShort, "SCALAR", 1, elementArrayBuffer);
  return {{"attributes", attributes}, {"indices", index}, {"material", material}};
}

/// Nodes: the joints first, so that a joint's node has its index; then the skinned mesh, then the props.
Json writeNodes(const Character& character) {
  const std::vector<Joint>& skeleton = character.skeleton;
  Json nodes = Json::array();
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton[j];
    const Vec3 origin =
        joint.parent < 0 ? Vec3(0.0) : skeleton[static_cast<std::size_t>(joint.parent)].position;
    const Vec3 offset = joint.position - origin;
    Json node{{"name", joint.name}};
    Json children = Json::array();
    for (std::size_t other = 0; other < skeleton.size(); ++other) {
      if (skeleton[other].parent == static_cast<int>(j)) {
        children.push_back(other);
      }
    }
    if (!children.empty()) {
      node["children"] = children;
    }
    node["translation"] = {rounded(offset.x), rounded(offset.y), rounded(offset.z)};
    nodes.push_back(node);
  }
  nodes.push_back({{"name", "Dummy"}, {"mesh", 0}, {"skin", 0}});
  int mesh = 1;
  for (const Prop& prop : character.props) {
    const Vec3& at = prop.position;
    nodes.push_back({{"name", prop.part.name},
                     {"mesh", mesh++},
                     {"translation", {rounded(at.x), rounded(at.y), rounded(at.z)}}});
  }
  return nodes;
}

Json writeSkin(Buffer& buffer, const std::vector<Joint>& skeleton) {
  std::vector<float> matrices;
  Json joints = Json::array();
  std::vector<std::array<float, 3>> origins;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    // Sums of the rounded offsets that the nodes hold, so that the bind pose is the rest pose exactly.
    const Joint& joint = skeleton[j];
    const auto parent = static_cast<std::size_t>(std::max(joint.parent, 0));
    std::array<float, 3> origin{};
    for (int axis = 0; axis < 3; ++axis) {
      const double above = joint.parent < 0 ? 0.0 : skeleton[parent].position[axis];
      const float base = joint.parent < 0 ? 0.0F : origins[parent][static_cast<std::size_t>(axis)];
      origin[static_cast<std::size_t>(axis)] = base + rounded(joint.position[axis] - above);
    }
    origins.push_back(origin);
    const auto negated = [&](std::size_t axis) { return 0.0F - origin[axis]; };
    const std::array<float, 16> matrix{1.0F, 0.0F, 0.0F, 0.0F, 0.0F,       1.0F,       0.0F,       0.0F,
                                       0.0F, 0.0F, 1.0F, 0.0F, negated(0), negated(1), negated(2), 1.0F};
    matrices.insert(matrices.end(), matrix.begin(), matrix.end());
    joints.push_back(j);
  }
  const int accessor = buffer.add(matrices, singleFloat, "MAT4", 16);
  return {{"name", "Dummy"}, {"inverseBindMatrices", accessor}, {"skeleton", 0}, {"joints", joints}};
}

void appendValue(std::vector<float>& values, const Vec4& value, int width) {
  for (int i = 0; i < width; ++i) {
    values.push_back(rounded(value[i]));
  }
}

Json writeMotion(Buffer& buffer, const Motion& motion) {
  Json samplers = Json::array();
  Json channels = Json::array();
  std::map<std::vector<int>, int> inputs;
  for (const MotionTrack& track : motion.tracks) {
    if (!inputs.contains(track.frames)) {
      std::vector<float> times;
      for (const int frame : track.frames) {
        times.push_back(static_cast<float>(frame / motion.framesPerSecond));
      }
      const int input = buffer.add(times, singleFloat, "SCALAR", 1);
      buffer.setBounds(input, times, 1);
      inputs[track.frames] = input;
    }
    const int width = track.isTranslation ? 3 : 4;
    std::vector<float> values;
    for (std::size_t key = 0; key < track.frames.size(); ++key) {
      if (!track.inTangents.empty()) {
        appendValue(values, track.inTangents[key], width);
      }
      appendValue(values, track.values[key], width);
      if (!track.outTangents.empty()) {
        appendValue(values, track.outTangents[key], width);
      }
    }
    const int output = buffer.add(values, singleFloat, track.isTranslation ? "VEC3" : "VEC4", width);
    samplers.push_back({{"input", inputs[track.frames]},
                        {"interpolation", track.inTangents.empty() ? "LINEAR" : "CUBICSPLINE"},
                        {"output", output}});
    channels.push_back(
        {{"sampler", samplers.size() - 1},
         {"target", {{"node", track.joint}, {"path", track.isTranslation ? "translation" : "rotation"}}}});
  }
  return {{"name", motion.name}, {"channels", channels}, {"samplers", samplers}};
}

/// The primitive of a part, and its material added to the list.
Json writePart(Buffer& buffer, const Part& part, bool skinned, Json& materials) {
  Json primitive = writePrimitive(buffer, part.mesh, static_cast<int>(materials.size()), skinned);
  materials.push_back(
      {{"name", part.name},
       {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", part.roughness}}}});
  return primitive;
}

Json writeDocument(Buffer& buffer, const Character& character) {
  Json document;
  document["asset"] = {
      {"version", "2.0"},
      {"generator", "Stretch-Engine make-dummy"},
      {"copyright", "CC0 1.0: dedicated to the public domain by the Stretch-Engine authors"}};
  document["scene"] = 0;
  Json roots{0, character.skeleton.size()};
  for (std::size_t prop = 0; prop < character.props.size(); ++prop) {
    roots.push_back(propNode(character.skeleton, prop));
  }
  document["scenes"] = {{{"name", "Dummy"}, {"nodes", roots}}};
  document["nodes"] = writeNodes(character);
  document["materials"] = Json::array();
  Json primitives = Json::array();
  for (const Part& part : character.parts) {
    primitives.push_back(writePart(buffer, part, true, document["materials"]));
  }
  document["meshes"] = {{{"name", "Dummy"}, {"primitives", primitives}}};
  for (const Prop& prop : character.props) {
    Json primitive = writePart(buffer, prop.part, false, document["materials"]);
    document["meshes"].push_back({{"name", prop.part.name}, {"primitives", Json::array({primitive})}});
  }
  document["skins"] = {writeSkin(buffer, character.skeleton)};
  for (const Motion& motion : character.motions) {
    document["animations"].push_back(writeMotion(buffer, motion));
  }
  document["buffers"] = {{{"byteLength", buffer.bytes().size()}}};
  document["bufferViews"] = buffer.views();
  document["accessors"] = buffer.accessors();
  return document;
}

void appendWord(std::vector<std::uint8_t>& bytes, std::size_t word) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>((word >> shift) & 0xFFU));
  }
}

template <typename Bytes>
void appendChunk(std::vector<std::uint8_t>& glb, std::size_t kind, const Bytes& content,
                 std::uint8_t padding) {
  const std::size_t padded = (content.size() + 3) / 4 * 4;
  appendWord(glb, padded);
  appendWord(glb, kind);
  glb.insert(glb.end(), content.begin(), content.end());
  glb.insert(glb.end(), padded - content.size(), padding);
}

} // namespace

std::vector<std::uint8_t> writeGlb(const Character& character) {
  Buffer buffer;
  const std::string json = writeDocument(buffer, character).dump();
  std::vector<std::uint8_t> glb;
  appendWord(glb, 0x46546C67);
  appendWord(glb, 2);
  const auto paddedSize = [](std::size_t size) { return (size + 3) / 4 * 4; };
  appendWord(glb, 12 + 8 + paddedSize(json.size()) + 8 + paddedSize(buffer.bytes().size()));
  appendChunk(glb, 0x4E4F534A, json, 0x20);
  appendChunk(glb, 0x004E4942, buffer.bytes(), 0);
  return glb;
}

} // namespace stretch::assets
