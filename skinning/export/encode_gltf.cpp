#include "skinning/export/encode_gltf.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/packed/meshopt_encoding.h"
#include "core/gltf/write/new_file.h"
#include "skinning/export/clip_writer.h"
#include "skinning/export/key_plan.h"
#include "skinning/export/mesh_writer.h"
#include "skinning/export/read_back.h"
#include "skinning/fit/joint_tree.h"

namespace stretch::skinning {
namespace {

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
  /// `keys`: see ClipEncoding.
  Encoder(const SkinnedSequence& sequence, const EncodeSettings& settings, KeyPlan keys = {})
      : sequence_(sequence), settings_(settings), frames_(sequence.frameCount()),
        lengthTolerance_(settings.tolerance * boxDiagonal(sequence.bindPositions)),
        clip_(file_, sequence.clipName.empty() ? sequence.name : sequence.clipName,
              {sequence.framesPerSecond, settings.quantise, std::move(keys)}) {
    if (settings.quantiseMesh) {
      grid_ = gridAround(sequence.bindPositions);
    }
  }

  EncodedClip encode() {
    WrittenMeshes meshes = writeMeshes(sequence_, {settings_.quantise, grid_}, file_);
    places_ = std::move(meshes.places);
    if (grid_) {
      file_.requireExtension("KHR_mesh_quantization");
    }
    armature_ = file_.addNode("armature");
    addBones();
    addSkin();
    return finish();
  }

private:
  [[nodiscard]] Quat jointRotation(std::size_t frame, std::size_t bone) const {
    return sequence_.pose(frame, bone).rotation * sequence_.bones[bone].axes;
  }

  [[nodiscard]] int parentOf(std::size_t bone) const {
    return sequence_.chained ? static_cast<int>(bone) - 1 : sequence_.bones[bone].parent;
  }

  /// Rotations below the parents as they will be read back, so that rounding does not add up along the chain.
  Course rotationCourse(std::size_t bone) {
    Course course;
    Quat before(1.0, 0.0, 0.0, 0.0);
    for (std::size_t k = 0; k < frames_; ++k) {
      const Quat parent = storedRotation(k, parentOf(bone));
      Quat local = glm::normalize(glm::conjugate(parent) * jointRotation(k, bone));
      local = k > 0 && glm::dot(local, before) < 0.0 ? -local : local;
      before = local;
      append(course, local);
      storedRotations_[k * sequence_.bones.size() + bone] =
          glm::normalize(parent * asStored(local, settings_.quantise));
    }
    return course;
  }

  [[nodiscard]] Quat storedRotation(std::size_t frame, int bone) const {
    return bone < 0 ? Quat(1.0, 0.0, 0.0, 0.0)
                    : storedRotations_[frame * sequence_.bones.size() + static_cast<std::size_t>(bone)];
  }

  /// Places below the parents: at a distance in a row, where the joint is in a tree.
  Course placeCourse(std::size_t bone) const {
    const int parent = parentOf(bone);
    if (parent < 0) {
      return courseOf(frames_, [&](std::size_t k) { return sequence_.pose(k, bone).position; });
    }
    const auto above = static_cast<std::size_t>(parent);
    if (!sequence_.chained) {
      return courseOf(frames_, [&](std::size_t k) {
        const Vec3 away = sequence_.pose(k, bone).position - sequence_.pose(k, above).position;
        return glm::conjugate(storedRotation(k, parent)) * away;
      });
    }
    const double length = glm::length(sequence_.bones[bone].pivot - sequence_.bones[above].pivot);
    return courseOf(frames_,
                    [&](std::size_t k) { return Vec3(length * sequence_.pose(k, above).scale.x, 0.0, 0.0); });
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
    const std::size_t count = sequence_.bones.size();
    storedRotations_.resize(frames_ * count);
    bound_.resize(count);
    std::vector<std::size_t> joints(count, armature_);
    for (const std::size_t b : order()) {
      const int parent = parentOf(b);
      joints[b] = file_.addNode(nameOfBone(sequence_, b),
                                parent < 0 ? armature_ : joints[static_cast<std::size_t>(parent)]);
      clip_.setProperty(joints[b], Channel::translation, placeCourse(b), lengthTolerance_);
      clip_.setProperty(joints[b], Channel::rotation, rotationCourse(b), settings_.tolerance);
      bound_[b] = scales.any ? addStretch(b, joints[b], scales) : joints[b];
    }
    if (clip_.samplers() == 0 && frames_ > 1 && count > 0) {
      clip_.holdPlace(joints[0], placeCourse(0));
    }
  }

  /// Bones, parents before what hangs on them.
  [[nodiscard]] std::vector<std::size_t> order() const {
    if (!sequence_.chained) {
      return orderOfTree(sequence_.bones);
    }
    std::vector<std::size_t> row(sequence_.bones.size());
    std::iota(row.begin(), row.end(), std::size_t{0});
    return row;
  }

  /// Nothing may hang on a joint that is scaled.
  [[nodiscard]] bool needsLeaf(std::size_t bone) const {
    return sequence_.chained || std::ranges::any_of(sequence_.bones, [&](const SkinBone& other) {
             return other.parent == static_cast<int>(bone);
           });
  }

  /// The nodes that carry the stretch of a bone; answers the one that the mesh is bound to.
  std::size_t addStretch(std::size_t bone, std::size_t joint, const ScalePlan& scales) {
    const std::string& own = sequence_.bones[bone].name;
    const std::string number = own.empty() ? std::to_string(bone) : own;
    const Course axes = axesCourse(bone, false);
    const bool ownAxes = areAlike(axes, identityCourse(), settings_.tolerance);
    if (ownAxes && !scales.common) {
      const std::size_t leaf = needsLeaf(bone) ? file_.addNode("stretch_" + number, joint) : joint;
      clip_.setProperty(leaf, Channel::scale, scaleCourse(bone), settings_.tolerance);
      return leaf;
    }
    const std::size_t stretch = file_.addNode("stretch_" + number, joint);
    if (!ownAxes) {
      clip_.setProperty(stretch, Channel::rotation, axes, settings_.tolerance);
    }
    clip_.setProperty(stretch, Channel::scale, scaleCourse(scales.common ? 0 : bone), settings_.tolerance);
    if (ownAxes && scales.allFactorsOne) {
      return stretch;
    }
    const std::size_t leaf = file_.addNode("bind_" + number, stretch);
    if (scales.common) {
      const Vec3& factor = scales.factors[bone];
      file_.setNode(leaf, Channel::scale, {factor.x, factor.y, factor.z});
    }
    if (ownAxes) {
      return leaf;
    }
    const std::size_t back = scales.common ? file_.addNode("back_" + number, leaf) : leaf;
    clip_.setProperty(back, Channel::rotation, axesCourse(bone, true), settings_.tolerance);
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
      Mat4 inverse(turn);
      inverse[3] = Vec4(-(turn * bone.pivot), 1.0);
      inverse = grid_ ? inverse * grid_->toPlaces() : inverse;
      for (glm::length_t column = 0; column < 4; ++column) {
        const Vec3 values(inverse[column]);
        matrices.insert(matrices.end(), {static_cast<float>(values.x), static_cast<float>(values.y),
                                         static_cast<float>(values.z), column < 3 ? 0.0F : 1.0F});
      }
    }
    file_.addSkin(sequence_.name, file_.addAccessor(matrices, {.width = 16}), armature_, bound_);
  }

  EncodedClip finish() {
    EncodedClip result;
    result.places = std::move(places_);
    result.joints = sequence_.bones.size();
    result.samplers = clip_.samplers();
    result.keys = clip_.keys();
    result.source = file_.finish();
    if (settings_.meshopt) {
      result.source = gltf::withMeshopt(result.source);
    }
    std::size_t clipBytes = 0;
    for (const std::size_t accessor : clip_.accessors()) {
      clipBytes += gltf::storedBytes(result.source.json, accessor);
    }
    result.bytesPerFrame =
        static_cast<double>(clipBytes) / static_cast<double>(std::max<std::size_t>(frames_, 1));
    result.bytesOnce = result.source.buffers[0].size() - clipBytes;
    result.bytesOfJson = result.source.json->dump().size();
    return result;
  }

  const SkinnedSequence& sequence_;
  const EncodeSettings& settings_;
  gltf::NewFile file_;
  std::size_t frames_;
  double lengthTolerance_;
  ClipWriter clip_;
  std::optional<MeshGrid> grid_;
  std::vector<std::uint32_t> places_;
  std::size_t armature_ = 0;          ///< Node that holds the bones, behind those of the meshes.
  std::vector<Quat> storedRotations_; ///< Of joints in the mesh's space as they will be read back: frame
                                      ///< after frame, one for each bone.
  std::vector<std::size_t> bound_;    ///< Node of each bone that the mesh is bound to.
};

} // namespace

namespace {

std::size_t bytesOf(const EncodedClip& clip) {
  return clip.source.buffers[0].size() + clip.bytesOfJson;
}

/// Fewer keys, and how far they move a vertex of any frame.
struct FewerKeys {
  KeyPlan plan;
  double largestPercent = 0.0;
};

MeshSequence framesOf(const gltf::Source& source, const SkinnedSequence& sequence) {
  gltf::Problems problems;
  const Scene scene = gltf::importScene(source, problems, gltf::Pictures::headers);
  const std::vector<Clip> clips = gltf::importClips(source, scene, problems);
  check(!problems.hasErrors(), "what this program writes, it can read");
  return framesShown(scene, clips, sequence.frameCount(), sequence.framesPerSecond);
}

/// Vertices that are moved farther than `tolerance` in some frame, the farthest first, not too many.
std::vector<std::size_t> movedTooFar(const MeshSequence& whole, const MeshSequence& reduced,
                                     double tolerance) {
  constexpr std::size_t most = 64;
  std::vector<std::pair<double, std::size_t>> moved;
  for (std::size_t v = 0; v < whole.vertexCount; ++v) {
    double farthest = 0.0;
    for (std::size_t k = 0; k < whole.frameCount(); ++k) {
      farthest = std::max(farthest, glm::distance(Vec3(whole.frame(k)[v]), Vec3(reduced.frame(k)[v])));
    }
    if (farthest > tolerance) {
      moved.emplace_back(-farthest, v);
    }
  }
  std::ranges::sort(moved);
  std::vector<std::size_t> vertices;
  for (std::size_t i = 0; i < std::min(most, moved.size()); ++i) {
    vertices.push_back(moved[i].second);
  }
  return vertices;
}

/// Keys are planned by some vertices and then measured by all of them; where these are moved too far, the
/// plan is made again with those as well, and with a closer bound. Nothing when it was stopped.
std::optional<FewerKeys> fewerKeys(const SkinnedSequence& sequence, const EncodeSettings& settings,
                                   const Proceed& proceed) {
  constexpr int trials = 6;
  EncodeSettings plain;
  plain.quantise = settings.quantise;
  plain.tolerance = settings.tolerance;
  SkinnedSequence bare = sequence;
  bare.surface = nullptr;
  const gltf::Source every = Encoder(bare, plain).encode().source;
  const MeshSequence whole = framesOf(every, bare);
  const double length = 0.01 * settings.keyTolerancePercent * extentOf(whole).diagonal;
  std::vector<std::size_t> also;
  double bound = 0.985 * length;
  for (int trial = 0; trial < trials; ++trial) {
    const Proceed part = [&](double share) { return !proceed || proceed((trial + share) / trials); };
    auto plan = planKeys(every, bare.frameCount(), bound, also, part);
    if (!plan) {
      return std::nullopt;
    }
    const MeshSequence reduced = framesOf(Encoder(bare, plain, *plan).encode().source, bare);
    const double largest = distancesOf(whole, reduced).largestPercent;
    if (largest <= settings.keyTolerancePercent) {
      return FewerKeys{std::move(*plan), largest};
    }
    bound *= 0.97 * settings.keyTolerancePercent / largest;
    const std::vector<std::size_t> moved = movedTooFar(whole, reduced, 0.9 * length);
    also.insert(also.end(), moved.begin(), moved.end());
  }
  return FewerKeys{};
}

} // namespace

EncodedClip encodeGltf(const SkinnedSequence& sequence, const EncodeSettings& settings) {
  return *encodeGltf(sequence, settings, {});
}

std::optional<EncodedClip> encodeGltf(const SkinnedSequence& sequence, const EncodeSettings& settings,
                                      const Proceed& proceed) {
  EncodedClip every = Encoder(sequence, settings).encode();
  constexpr std::size_t fewestKeys = 2; // A clip lasts by them.
  if (!(settings.keyTolerancePercent > 0.0) || every.keys <= fewestKeys) {
    return every;
  }
  std::optional<FewerKeys> fewer = fewerKeys(sequence, settings, proceed);
  if (!fewer) {
    return std::nullopt;
  }
  if (fewer->plan.empty()) {
    return every;
  }
  EncodedClip clip = Encoder(sequence, settings, std::move(fewer->plan)).encode();
  clip.keyErrorPercent = fewer->largestPercent;
  return bytesOf(clip) < bytesOf(every) ? clip : every;
}

std::size_t sourceBytesPerFrame(const MeshSequence& sequence) {
  return sequence.vertexCount * sizeof(glm::vec3);
}

} // namespace stretch::skinning
