#include "assets/dummy/glb_writer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/gltf/json/json.h"
#include "core/gltf/write/new_file.h"

namespace stretch::assets {

namespace {

/// Nearest multiple of 2^-20 (about a micrometre), exact in single precision below 16.
float rounded(double value) {
  constexpr double grid = 1048576.0;
  return static_cast<float>(std::floor(value * grid + 0.5) / grid);
}

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
gltf::NewPrimitive writePrimitive(gltf::NewFile& file, const SkinnedMesh& mesh, std::size_t material,
                                  bool skinned) {
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
  gltf::NewPrimitive primitive;
  constexpr gltf::ViewTarget vertices = gltf::ViewTarget::vertices;
  primitive.attributes["POSITION"] = file.addAccessor(collect(mesh, &SkinnedVertex::position),
                                                      {.width = 3, .target = vertices, .bounds = true});
  primitive.attributes["NORMAL"] =
      file.addAccessor(collect(mesh, &SkinnedVertex::normal), {.width = 3, .target = vertices});
  primitive.attributes["COLOR_0"] =
      file.addAccessor(colors, {.width = 4, .target = vertices, .normalised = true});
  if (skinned) {
    primitive.attributes["JOINTS_0"] = file.addAccessor(joints, {.width = 4, .target = vertices});
    primitive.attributes["WEIGHTS_0"] = file.addAccessor(weights, {.width = 4, .target = vertices});
  }
  primitive.indices = file.addAccessor(indices, {.target = gltf::ViewTarget::indices});
  primitive.material = material;
  return primitive;
}

std::vector<double> roundedPlace(const Vec3& place) {
  return {rounded(place.x), rounded(place.y), rounded(place.z)};
}

/// Nodes: the joints first, so that a joint's node has its index; then the skinned mesh, then the props.
void writeNodes(gltf::NewFile& file, const Character& character) {
  for (const Joint& joint : character.skeleton) {
    const bool isRoot = joint.parent < 0;
    const auto parent = static_cast<std::size_t>(std::max(joint.parent, 0));
    const std::size_t node =
        file.addNode(joint.name, isRoot ? std::nullopt : std::optional<std::size_t>(parent));
    const Vec3 origin = isRoot ? Vec3(0.0) : character.skeleton[parent].position;
    file.setNode(node, Channel::translation, roundedPlace(joint.position - origin));
  }
  file.setMesh(file.addNode("Dummy"), 0, 0);
  for (std::size_t prop = 0; prop < character.props.size(); ++prop) {
    const std::size_t node = file.addNode(character.props[prop].part.name);
    file.setMesh(node, prop + 1, std::nullopt);
    file.setNode(node, Channel::translation, roundedPlace(character.props[prop].position));
  }
}

void writeSkin(gltf::NewFile& file, const std::vector<Joint>& skeleton) {
  std::vector<float> matrices;
  std::vector<std::size_t> joints;
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
  file.addSkin("Dummy", file.addAccessor(matrices, {.width = 16}), 0, joints);
}

void appendValue(std::vector<float>& values, const Vec4& value, int width) {
  for (int i = 0; i < width; ++i) {
    values.push_back(rounded(value[i]));
  }
}

void writeMotion(gltf::NewFile& file, const Motion& motion) {
  const std::size_t clip = file.addClip(motion.name);
  std::map<std::vector<int>, std::size_t> inputs;
  for (const MotionTrack& track : motion.tracks) {
    if (!inputs.contains(track.frames)) {
      std::vector<float> times;
      for (const int frame : track.frames) {
        times.push_back(static_cast<float>(frame / motion.framesPerSecond));
      }
      inputs[track.frames] = file.addAccessor(times, {.bounds = true});
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
    const std::size_t output = file.addAccessor(values, {.width = static_cast<std::size_t>(width)});
    const std::size_t sampler =
        file.addSampler(clip, inputs[track.frames], output,
                        track.inTangents.empty() ? Interpolation::linear : Interpolation::cubicSpline);
    file.addChannel(clip, sampler, static_cast<std::size_t>(track.joint),
                    track.isTranslation ? Channel::translation : Channel::rotation);
  }
}

/// Adds a part to a mesh, with a material of its own.
void writePart(gltf::NewFile& file, std::size_t mesh, const Part& part, bool skinned) {
  const std::size_t material = file.addMaterial({.name = part.name, .roughness = part.roughness});
  file.addPrimitive(mesh, writePrimitive(file, part.mesh, material, skinned));
}

} // namespace

std::vector<std::uint8_t> writeGlb(const Character& character) {
  gltf::NewFile file({"Stretch-Engine make-dummy",
                      "CC0 1.0: dedicated to the public domain by the Stretch-Engine authors", "Dummy"});
  const std::size_t body = file.addMesh("Dummy");
  for (const Part& part : character.parts) {
    writePart(file, body, part, true);
  }
  for (const Prop& prop : character.props) {
    writePart(file, file.addMesh(prop.part.name), prop.part, false);
  }
  writeNodes(file, character);
  writeSkin(file, character.skeleton);
  for (const Motion& motion : character.motions) {
    writeMotion(file, motion);
  }
  gltf::Source source = file.finish();
  return gltf::writeGlb({source.json->dump(), true, std::move(source.buffers.front()), {}, {}}).value();
}

} // namespace stretch::assets
