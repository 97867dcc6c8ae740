#include "skinning/export/encode_gltf.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "core/gltf/json.h"
#include "skinning/export/gltf_buffers.h"
#include "skinning/export/mesh_writer.h"

namespace stretch::skinning {
namespace {

using gltf::Json;

/// Values of a property over the frames: 3 numbers per frame, or 4 (x, y, z, w) for rotations.
using Course = std::vector<float>;

template <typename Value>
Course courseOf(std::size_t frames, Value&& value) {
  Course course;
  course.reserve(3 * frames);
  for (std::size_t k = 0; k < frames; ++k) {
    const Vec3 v = value(k);
    course.insert(course.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
  }
  return course;
}

void append(Course& course, const Quat& q) {
  course.insert(course.end(), {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                               static_cast<float>(q.w)});
}

bool isConstant(const Course& course, std::size_t width, double tolerance) {
  for (std::size_t i = width; i < course.size(); ++i) {
    if (std::abs(static_cast<double>(course[i] - course[i % width])) > tolerance) {
      return false;
    }
  }
  return true;
}

bool areAlike(const Course& a, const Course& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(static_cast<double>(a[i] - b[i])) > tolerance) {
      return false;
    }
  }
  return a.size() == b.size();
}

/// A quaternion as the file will give it back.
Quat asStored(const Quat& q, bool quantise) {
  if (!quantise) {
    return q;
  }
  const auto round = [](double x) { return std::round(std::clamp(x, -1.0, 1.0) * 32767.0) / 32767.0; };
  return glm::normalize(Quat(round(q.w), round(q.x), round(q.y), round(q.z)));
}

/// Scales over all bones and frames, and whether they are one course in time multiplied by a constant for
/// each bone.
struct ScalePlan {
  bool any = false;          ///< Some scale is not 1.
  bool common = false;       ///< scale = common course x factor of the bone.
  std::vector<Vec3> factors; ///< One for each bone, where it is common.
  bool allFactorsOne = false;
};

class Encoder {
public:
  Encoder(const SkinnedSequence& sequence, const EncodeSettings& settings)
      : sequence_(sequence), settings_(settings), buffers_(json_), frames_(sequence.frameCount()),
        lengthTolerance_(settings.tolerance * boxDiagonal(sequence.bindPositions)) {}

  EncodedClip encode() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "Stretch-Engine"}};
    json_["scene"] = 0;
    armature_ = writeMeshes(sequence_, settings_.quantise, json_, buffers_);
    json_["nodes"].push_back({{"name", "armature"}, {"children", Json::array()}});
    addScene();
    addTimes();
    addBones();
    addSkin();
    return finish();
  }

private:
  void addScene() {
    Json roots = Json::array();
    for (std::size_t node = 0; node <= armature_; ++node) {
      roots.push_back(node);
    }
    json_["scenes"] = Json::array({{{"nodes", std::move(roots)}}});
  }

  // --- tracks
  // -----------------------------------------------------------------------------------------------------

  void addTimes() {
    std::vector<float> times;
    for (std::size_t k = 0; k < frames_; ++k) {
      times.push_back(static_cast<float>(static_cast<double>(k) / sequence_.framesPerSecond));
    }
    json_["animations"] =
        Json::array({{{"name", sequence_.clipName.empty() ? sequence_.name : sequence_.clipName},
                      {"channels", Json::array()},
                      {"samplers", Json::array()}}});
    times_ = buffers_.addFloats(times, "SCALAR", 1, GltfBuffers::Target::none, true);
    clipBytes_ += buffers_.bytesOf(times_);
  }

  struct StoredCourse {
    Course course;
    std::size_t width = 3;
    std::size_t sampler = 0;
  };

  std::size_t samplerFor(const Course& course, std::size_t width, double tolerance) {
    for (const StoredCourse& stored : stored_) {
      if (stored.width == width && areAlike(stored.course, course, tolerance)) {
        return stored.sampler;
      }
    }
    const bool rotation = width == 4;
    const std::size_t output =
        rotation && settings_.quantise
            ? buffers_.addNormalised(course, "VEC4", 4)
            : buffers_.addFloats(course, rotation ? "VEC4" : "VEC3", width, GltfBuffers::Target::none, false);
    clipBytes_ += buffers_.bytesOf(output);
    Json& samplers = json_["animations"][0]["samplers"];
    samplers.push_back({{"input", times_}, {"output", output}, {"interpolation", "LINEAR"}});
    stored_.push_back({course, width, samplers.size() - 1});
    return samplers.size() - 1;
  }

  /// The property of a node: the value itself where it does not change, a channel where it does.
  void setProperty(std::size_t node, const char* path, const Course& course, std::size_t width,
                   double tolerance) {
    json_["nodes"][node][path] =
        std::vector<float>(course.begin(), course.begin() + static_cast<std::ptrdiff_t>(width));
    if (!isConstant(course, width, tolerance)) {
      const std::size_t sampler = samplerFor(course, width, tolerance);
      json_["animations"][0]["channels"].push_back(
          {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
    }
  }

  // --- bones
  // ------------------------------------------------------------------------------------------------------

  std::size_t addNode(const std::string& name, std::size_t parent) {
    json_["nodes"].push_back({{"name", name}});
    const std::size_t node = json_["nodes"].size() - 1;
    json_["nodes"][parent]["children"].push_back(node);
    return node;
  }

  [[nodiscard]] Quat jointRotation(std::size_t frame, std::size_t bone) const {
    return sequence_.pose(frame, bone).rotation * sequence_.bones[bone].axes;
  }

  /// Rotations below the parents as they will be read back, so that rounding does not add up along the chain.
  Course rotationCourse(std::size_t bone, std::vector<Quat>& parents) {
    Course course;
    Quat before(1.0, 0.0, 0.0, 0.0);
    for (std::size_t k = 0; k < frames_; ++k) {
      Quat local = glm::normalize(glm::conjugate(parents[k]) * jointRotation(k, bone));
      local = k > 0 && glm::dot(local, before) < 0.0 ? -local : local;
      before = local;
      append(course, local);
      parents[k] = glm::normalize(parents[k] * asStored(local, settings_.quantise));
    }
    return course;
  }

  Course placeCourse(std::size_t bone) const {
    if (!sequence_.chained || bone == 0) {
      return courseOf(frames_, [&](std::size_t k) { return sequence_.pose(k, bone).position; });
    }
    const SkinBone& parent = sequence_.bones[bone - 1];
    const double length = glm::length(sequence_.bones[bone].pivot - parent.pivot);
    return courseOf(
        frames_, [&](std::size_t k) { return Vec3(length * sequence_.pose(k, bone - 1).scale.x, 0.0, 0.0); });
  }

  Course scaleCourse(std::size_t bone) const {
    return courseOf(frames_, [&](std::size_t k) { return sequence_.pose(k, bone).scale; });
  }

  /// Stretch axes as the bone sees them, the bone's own where they are those.
  Course axesCourse(std::size_t bone, bool inverse) const {
    Course course;
    Quat before(1.0, 0.0, 0.0, 0.0);
    for (std::size_t k = 0; k < frames_; ++k) {
      Quat axes = glm::conjugate(sequence_.bones[bone].axes) * sequence_.pose(k, bone).stretchAxes;
      axes = glm::dot(axes, before) < 0.0 ? -axes : axes;
      before = axes;
      append(course, inverse ? glm::conjugate(axes) : axes);
    }
    return course;
  }

  /// Scales are measured against the middle frame, where a body that settles first has come to rest.
  ScalePlan planScales() const {
    ScalePlan plan{false, true, {}, true};
    const std::size_t middle = frames_ / 2;
    for (std::size_t b = 0; b < sequence_.bones.size(); ++b) {
      const Vec3 factor = sequence_.pose(middle, b).scale / sequence_.pose(middle, 0).scale;
      plan.factors.push_back(factor);
      plan.allFactorsOne = plan.allFactorsOne && largest(factor - Vec3(1.0)) <= settings_.tolerance;
      for (std::size_t k = 0; k < frames_; ++k) {
        const Vec3& scale = sequence_.pose(k, b).scale;
        plan.any = plan.any || largest(scale - Vec3(1.0)) > settings_.tolerance;
        // Tilting changes the load a little all the time: a ten-thousandth of a bone's thickness is not worth
        // a track.
        plan.common = plan.common &&
                      largest(scale - factor * sequence_.pose(k, 0).scale) <= 100.0 * settings_.tolerance;
      }
    }
    return plan;
  }

  static double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

  void addBones() {
    const ScalePlan scales = planScales();
    std::vector<Quat> parents(frames_, Quat(1.0, 0.0, 0.0, 0.0));
    std::size_t parent = armature_;
    for (std::size_t b = 0; b < sequence_.bones.size(); ++b) {
      const std::string number = std::to_string(b);
      const std::size_t joint = addNode("bone_" + number, parent);
      if (!sequence_.chained) {
        parents.assign(frames_, Quat(1.0, 0.0, 0.0, 0.0));
      }
      setProperty(joint, "translation", placeCourse(b), 3, lengthTolerance_);
      setProperty(joint, "rotation", rotationCourse(b, parents), 4, settings_.tolerance);
      bound_.push_back(scales.any ? addStretch(b, joint, scales) : joint);
      parent = sequence_.chained ? joint : armature_;
    }
  }

  /// The nodes that carry the stretch of a bone; answers the one that the mesh is bound to.
  std::size_t addStretch(std::size_t bone, std::size_t joint, const ScalePlan& scales) {
    const std::string number = std::to_string(bone);
    const Course axes = axesCourse(bone, false);
    const bool ownAxes = areAlike(axes, identityCourse(), settings_.tolerance);
    if (ownAxes && !scales.common) {
      const std::size_t leaf = sequence_.chained ? addNode("stretch_" + number, joint) : joint;
      setProperty(leaf, "scale", scaleCourse(bone), 3, settings_.tolerance);
      return leaf;
    }
    const std::size_t stretch = addNode("stretch_" + number, joint);
    if (!ownAxes) {
      setProperty(stretch, "rotation", axes, 4, settings_.tolerance);
    }
    setProperty(stretch, "scale", scaleCourse(scales.common ? 0 : bone), 3, settings_.tolerance);
    if (ownAxes && scales.allFactorsOne) {
      return stretch;
    }
    const std::size_t leaf = addNode("bind_" + number, stretch);
    if (scales.common) {
      const Vec3& factor = scales.factors[bone];
      json_["nodes"][leaf]["scale"] = {factor.x, factor.y, factor.z};
    }
    if (ownAxes) {
      return leaf;
    }
    const std::size_t back = scales.common ? addNode("back_" + number, leaf) : leaf;
    setProperty(back, "rotation", axesCourse(bone, true), 4, settings_.tolerance);
    return back;
  }

  [[nodiscard]] Course identityCourse() const {
    Course course;
    for (std::size_t k = 0; k < frames_; ++k) {
      append(course, Quat(1.0, 0.0, 0.0, 0.0));
    }
    return course;
  }

  void addSkin() {
    std::vector<float> matrices;
    for (const SkinBone& bone : sequence_.bones) {
      const Mat3 turn = glm::transpose(glm::mat3_cast(bone.axes));
      const Vec3 shift = -(turn * bone.pivot);
      for (glm::length_t column = 0; column < 4; ++column) {
        const Vec3 values = column < 3 ? turn[column] : shift;
        matrices.insert(matrices.end(), {static_cast<float>(values.x), static_cast<float>(values.y),
                                         static_cast<float>(values.z), column < 3 ? 0.0F : 1.0F});
      }
    }
    const std::size_t bind = buffers_.addFloats(matrices, "MAT4", 16, GltfBuffers::Target::none, false);
    json_["skins"] = Json::array({{{"name", sequence_.name},
                                   {"inverseBindMatrices", bind},
                                   {"skeleton", armature_},
                                   {"joints", bound_}}});
  }

  EncodedClip finish() {
    Json& clip = json_["animations"][0];
    const std::size_t samplers = clip["samplers"].size();
    if (clip["channels"].empty()) {
      json_.erase("animations"); // glTF wants at least one channel in a clip.
    }
    std::vector<std::uint8_t> bytes = buffers_.bytes();
    while (bytes.size() % 4 != 0) {
      bytes.push_back(0);
    }
    json_["buffers"] = Json::array({{{"byteLength", bytes.size()}}});
    EncodedClip result;
    result.bytesPerFrame =
        static_cast<double>(clipBytes_) / static_cast<double>(std::max<std::size_t>(frames_, 1));
    result.bytesOnce = bytes.size() - clipBytes_;
    result.joints = sequence_.bones.size();
    result.samplers = samplers;
    result.source.json = std::move(json_);
    result.source.buffers.push_back(std::move(bytes));
    result.source.hasBinaryChunk = true;
    return result;
  }

  const SkinnedSequence& sequence_;
  const EncodeSettings& settings_;
  Json json_;
  GltfBuffers buffers_;
  std::size_t frames_;
  double lengthTolerance_;
  std::size_t armature_ = 0; ///< Node that holds the bones, behind those of the meshes.
  std::size_t times_ = 0;
  std::size_t clipBytes_ = 0;
  std::vector<StoredCourse> stored_;
  std::vector<std::size_t> bound_;
};

} // namespace

EncodedClip encodeGltf(const SkinnedSequence& sequence, const EncodeSettings& settings) {
  return Encoder(sequence, settings).encode();
}

std::size_t sourceBytesPerFrame(const MeshSequence& sequence) {
  return sequence.vertexCount * sizeof(glm::vec3);
}

} // namespace stretch::skinning
