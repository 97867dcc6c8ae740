#include "skinning/export/append_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/anim/frame_state.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "core/gltf/source/fields.h"
#include "skinning/body/given_skeleton.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/export/frame_stream.h"
#include "skinning/fit/alternate.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::skinning {
namespace {

using gltf::Json;

/// One value of a frame, and what takes it.
struct BaseCourse {
  Channel channel = Channel::rotation;
  bool isShort = false;
  std::vector<std::size_t> nodes;
};

/// What a stream's base holds.
struct StreamBase {
  Scene scene;
  std::vector<SkinBone> bones;
  std::vector<std::size_t> joints; ///< Nodes of the bones that others hang on.
  std::vector<BaseCourse> courses;
  std::size_t frameBytes = 0;
};

/// The vertices that a scene draws, one after the other.
struct DrawnMesh {
  std::vector<glm::vec3> positions;
  std::vector<VertexInfluences> influences;
  std::vector<std::uint32_t> indices; ///< Each primitive's from 0.
};

DrawnMesh drawnMesh(const Scene& scene) {
  DrawnMesh drawn;
  for (const NodeIndex node : drawnMeshNodes(scene)) {
    for (const Primitive& p : scene.meshes[at(scene.nodes[at(node)].mesh)].primitives) {
      drawn.positions.insert(drawn.positions.end(), p.positions.begin(), p.positions.end());
      drawn.influences.insert(drawn.influences.end(), p.influences.begin(), p.influences.end());
      drawn.indices.insert(drawn.indices.end(), p.indices.begin(), p.indices.end());
    }
  }
  return drawn;
}

Error noStream(const std::filesystem::path& path, const std::string& why) {
  return {why, path.string(), "give a folder that compress --stream has written"};
}

/// Nodes that only carry a stretch, as this program names them below a joint.
bool carriesStretch(const Node& node) {
  return node.name.starts_with("stretch_") || node.name.starts_with("bind_") ||
         node.name.starts_with("back_");
}

std::optional<std::vector<BaseCourse>> coursesOf(const Json& format, std::size_t nodes) {
  std::vector<BaseCourse> courses;
  for (std::size_t c = 0; c < gltf::sizeOf(format, "courses"); ++c) {
    const Json& told = gltf::element(format, "courses", c);
    BaseCourse course;
    const std::string path = gltf::textOr(told, "path");
    constexpr int shorts = 5122;
    course.isShort = gltf::indexOr(told, "componentType") == shorts;
    course.channel = path == "rotation" ? Channel::rotation
                     : path == "scale"  ? Channel::scale
                                        : Channel::translation;
    const std::vector<int> moved = gltf::indicesOf(told, "nodes");
    if (moved.empty() || std::ranges::any_of(moved, [&](int node) {
          return node < 0 || std::cmp_greater_equal(node, nodes);
        })) {
      return std::nullopt;
    }
    course.nodes.assign(moved.begin(), moved.end());
    courses.push_back(std::move(course));
  }
  return courses;
}

std::size_t bytesOf(const BaseCourse& course) {
  return course.channel == Channel::rotation ? 4 * (course.isShort ? sizeof(std::int16_t) : sizeof(float))
                                             : 3 * sizeof(float);
}

Result<StreamBase> readBase(const std::filesystem::path& path) {
  auto loaded = gltf::loadAsItStands(path, gltf::Pictures::headers);
  if (!loaded) {
    return loaded.error();
  }
  const Json extras = loaded->source->json->value("extras", Json::object());
  const Json format = extras.is_object() ? extras.value("stretch_stream", Json::object()) : Json::object();
  if (!format.is_object() || gltf::wholeOr(format, "version", 0) != streamVersion ||
      loaded->scene->skins.empty()) {
    return noStream(path, "the file is not the base of a stream of this version");
  }
  auto bones = readSkeleton(path);
  if (!bones) {
    return bones.error();
  }
  StreamBase base{*loaded->scene, std::move(bones).value(), {}, {}, gltf::wholeOr(format, "frameBytes", 0)};
  auto courses = coursesOf(format, base.scene.nodes.size());
  std::size_t bytes = streamHeaderBytes;
  for (const BaseCourse& course : courses.value_or(std::vector<BaseCourse>{})) {
    bytes += bytesOf(course);
  }
  if (!courses || bytes != base.frameBytes) {
    return noStream(path, "what the base says of its frames does not fit together");
  }
  base.courses = std::move(*courses);
  for (NodeIndex joint : base.scene.skins.front().joints) {
    while (carriesStretch(base.scene.nodes[at(joint)]) && base.scene.nodes[at(joint)].parent.exists()) {
      joint = base.scene.nodes[at(joint)].parent;
    }
    base.joints.push_back(at(joint));
  }
  return base;
}

/// The vertices of the sequence that a file of it draws, and the bind mesh of the base at these vertices.
struct Matched {
  std::vector<std::uint32_t> places;
  SkinnedSequence skinned;
};

Result<Matched> matched(const StreamBase& base, const MeshSequence& sequence,
                        const std::filesystem::path& path) {
  Matched result;
  SkinnedSequence& skinned = result.skinned;
  skinned = withoutBones(sequence);
  skinned.bones = {SkinBone{}};
  skinned.poses = {BonePose{}};
  Influences first;
  first.weights[0] = 1.0F;
  skinned.influences.assign(sequence.vertexCount, first);
  EncodedClip written = encodeGltf(skinned);
  gltf::Problems problems;
  const DrawnMesh own = drawnMesh(gltf::importScene(written.source, problems, gltf::Pictures::headers));
  const DrawnMesh known = drawnMesh(base.scene);
  if (own.positions.size() != known.positions.size() || own.indices != known.indices ||
      known.influences.size() != known.positions.size()) {
    return Error{fmt::format("the base is of another mesh: it draws {} vertices and {} triangles, the "
                             "sequence {} and {}",
                             known.positions.size(), known.indices.size() / 3, own.positions.size(),
                             own.indices.size() / 3),
                 path.string(), "give frames of the mesh that the stream was made of"};
  }
  result.places = std::move(written.places);
  for (std::size_t v = 0; v < result.places.size(); ++v) {
    skinned.bindPositions[result.places[v]] = known.positions[v];
    Influences& influences = skinned.influences[result.places[v]];
    influences.bones = known.influences[v].joints;
    influences.weights = known.influences[v].weights;
  }
  skinned.bones = base.bones;
  skinned.poses.clear();
  return result;
}

/// Writes the frames as the base describes them, and keeps what a client makes of them.
class FrameWriter {
public:
  FrameWriter(const StreamBase& base, const SkinnedSequence& skinned) : base_(base), skinned_(skinned) {
    for (std::size_t b = 0; b < base_.joints.size(); ++b) {
      boneOf_[base_.joints[b]] = b;
    }
    for (std::size_t b = 0; b < base_.joints.size(); ++b) {
      for (NodeIndex node = base_.scene.skins.front().joints[b]; carriesStretch(base_.scene.nodes[at(node)]);
           node = base_.scene.nodes[at(node)].parent) {
        stretchOf_[at(node)] = b;
      }
    }
    for (std::size_t c = 0; c < base_.courses.size(); ++c) {
      for (const std::size_t node : base_.courses[c].nodes) {
        coursesOf_[node].push_back(c);
      }
    }
    order_ = parentsFirst(base_.scene);
  }

  /// Appends the frame to `bytes`; answers the pose that a client has of it.
  Pose write(std::size_t frame, std::size_t number, std::vector<std::uint8_t>& bytes) {
    Pose pose = restPose(base_.scene);
    std::vector<Mat4> worlds(base_.scene.nodes.size(), Mat4(1.0));
    std::vector<std::optional<Vec4>> values(base_.courses.size());
    for (const NodeIndex node : order_) {
      const NodeIndex parent = base_.scene.nodes[at(node)].parent;
      const Mat4 above = parent.exists() ? worlds[at(parent)] : Mat4(1.0);
      Transform& local = pose.locals[at(node)];
      const Transform wanted = wantedLocal(frame, at(node), above, local);
      for (const std::size_t c : coursesOf_[at(node)]) {
        const BaseCourse& course = base_.courses[c];
        if (!values[c]) { // Of nodes that share a course the first one says what it is.
          values[c] = stored(course, valueOf(wanted, course.channel));
        }
        set(local, course.channel, *values[c]);
        pose.usesMatrix[at(node)] = false;
      }
      worlds[at(node)] = above * toMatrix(local);
    }
    putStreamHeader(number, bytes);
    for (std::size_t c = 0; c < base_.courses.size(); ++c) {
      put(base_.courses[c], values[c].value_or(Vec4(0.0, 0.0, 0.0, 1.0)), bytes);
    }
    return pose;
  }

private:
  /// What would pose the node as the fit has it, its parents as a client has them.
  [[nodiscard]] Transform wantedLocal(std::size_t frame, std::size_t node, const Mat4& above,
                                      const Transform& rest) const {
    Transform wanted = rest;
    if (const auto bone = boneOf_.find(node); bone != boneOf_.end()) {
      const BonePose& pose = skinned_.pose(frame, bone->second);
      const Quat turned = pose.rotation * skinned_.bones[bone->second].axes;
      wanted.rotation = glm::normalize(glm::conjugate(rotationOf(above)) * turned);
      wanted.translation = transformPoint(glm::inverse(above), pose.position);
    }
    if (const auto bone = stretchOf_.find(node); bone != stretchOf_.end()) {
      wanted.rotation = Quat(1.0, 0.0, 0.0, 0.0);
    }
    const auto bound = std::ranges::find(base_.scene.skins.front().joints, NodeIndex(node));
    const bool carries = stretchOf_.contains(node) || bound != base_.scene.skins.front().joints.end();
    if (carries) {
      const std::size_t bone = stretchOf_.contains(node) ? stretchOf_.at(node) : boneOf_.at(node);
      wanted.scale = skinned_.pose(frame, bone).scale / heldBelow(node, bone);
    }
    return wanted;
  }

  /// The scale that nodes below one hold in the base, once for all frames.
  [[nodiscard]] Vec3 heldBelow(std::size_t node, std::size_t bone) const {
    Vec3 held(1.0);
    for (NodeIndex below = base_.scene.skins.front().joints[bone]; at(below) != node;
         below = base_.scene.nodes[at(below)].parent) {
      held *= base_.scene.nodes[at(below)].rest.scale;
    }
    return held;
  }

  static Vec4 valueOf(const Transform& local, Channel channel) {
    if (channel == Channel::rotation) {
      return {local.rotation.x, local.rotation.y, local.rotation.z, local.rotation.w};
    }
    return {channel == Channel::scale ? local.scale : local.translation, 0.0};
  }

  static void set(Transform& local, Channel channel, const Vec4& value) {
    if (channel == Channel::rotation) {
      local.rotation = glm::normalize(Quat(value.w, value.x, value.y, value.z));
    } else {
      (channel == Channel::scale ? local.scale : local.translation) = Vec3(value);
    }
  }

  /// A value as the frame will give it back.
  static Vec4 stored(const BaseCourse& course, const Vec4& value) {
    Vec4 rounded(0.0);
    for (glm::length_t i = 0; i < 4; ++i) {
      rounded[i] = course.isShort ? std::round(std::clamp(value[i], -1.0, 1.0) * 32767.0) / 32767.0
                                  : static_cast<double>(static_cast<float>(value[i]));
    }
    return rounded;
  }

  static void put(const BaseCourse& course, const Vec4& value, std::vector<std::uint8_t>& bytes) {
    const glm::length_t numbers = course.channel == Channel::rotation ? 4 : 3;
    for (glm::length_t i = 0; i < numbers; ++i) {
      std::array<std::uint8_t, sizeof(float)> raw{};
      const auto whole = static_cast<std::int16_t>(std::lround(value[i] * 32767.0));
      const auto number = static_cast<float>(value[i]);
      const std::size_t size = course.isShort ? sizeof(whole) : sizeof(number);
      std::memcpy(raw.data(), course.isShort ? static_cast<const void*>(&whole) : &number, size);
      bytes.insert(bytes.end(), raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
    }
  }

  const StreamBase& base_;
  const SkinnedSequence& skinned_;
  std::map<std::size_t, std::size_t> boneOf_;    ///< By node: joints that others hang on.
  std::map<std::size_t, std::size_t> stretchOf_; ///< By node: those that carry the stretch of a bone.
  std::map<std::size_t, std::vector<std::size_t>> coursesOf_;
  std::vector<NodeIndex> order_;
};

/// Bones with weights that stay: fitted several times over, since frames may be far from the bind pose.
void fitToFrames(const StreamBase& base, const MeshSequence& sequence, SkinnedSequence& skinned) {
  constexpr int times = 4;
  FitSettings fit;
  fit.fitWeights = false;
  fit.fitStretch = std::ranges::any_of(
      base.courses, [](const BaseCourse& course) { return course.channel == Channel::scale; });
  for (int i = 0; i < times; ++i) {
    fitFreeBones(sequence, skinned, fit);
  }
}

} // namespace

Result<AppendedFrames> framesForStream(const std::filesystem::path& path, const MeshSequence& sequence,
                                       std::size_t bytesBefore, double mostPercent) {
  const Result<StreamBase> base = readBase(path);
  if (!base) {
    return base.error();
  }
  if (bytesBefore % base->frameBytes != 0) {
    return noStream(path,
                    fmt::format("the frames before take {} bytes, which is no whole number of frames of "
                                "{}",
                                bytesBefore, base->frameBytes));
  }
  Result<Matched> mesh = matched(*base, sequence, path);
  if (!mesh) {
    return mesh.error();
  }
  AppendedFrames appended;
  appended.skinned = std::move(mesh->skinned);
  appended.frameBytes = base->frameBytes;
  appended.firstNumber = bytesBefore / base->frameBytes;
  fitToFrames(*base, sequence, appended.skinned);
  FrameWriter writer(*base, appended.skinned);
  MeshSequence shown = sequence; // What is not drawn stays as it is.
  for (std::size_t k = 0; k < sequence.frameCount(); ++k) {
    const Pose pose = writer.write(k, appended.firstNumber + k, appended.bytes);
    const std::vector<Vec3> positions = skinnedPositions(base->scene, frameOf(base->scene, pose, 0.0));
    for (std::size_t v = 0; v < positions.size(); ++v) {
      shown.frame(k)[mesh->places[v]] = glm::vec3(positions[v]);
    }
  }
  appended.metrics = distancesOf(sequence, shown);
  if (!(appended.metrics.rmsePercent <= mostPercent)) {
    return Error{fmt::format("the bones of the base follow these frames with an error of {:.3g} %, more than "
                             "{:g} %",
                             appended.metrics.rmsePercent, mostPercent),
                 path.string(),
                 "make the stream with --open-stream and more bones, or allow more with --tolerance"};
  }
  return appended;
}

} // namespace stretch::skinning
