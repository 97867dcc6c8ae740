#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// How a vertex follows the bones: at most eight, weights sum to 1, unused slots hold bone 0 with weight 0.
struct Influences {
  static constexpr std::size_t capacity = 8;
  std::array<std::uint16_t, capacity> bones{};
  std::array<float, capacity> weights{};

  friend bool operator==(const Influences&, const Influences&) = default;
};

/// A bone of the bind pose, in the space of the mesh.
struct SkinBone {
  Vec3 pivot{0.0};               ///< Point where it begins; its transforms turn and stretch about this point.
  Vec3 end{0.0};                 ///< Point where it ends.
  Quat axes{1.0, 0.0, 0.0, 0.0}; ///< Bone space to mesh space: x runs along the bone.
  int parent = -1;               ///< The bone that it hangs on; -1: none. Not used where bones are chained.
  std::string name = {};         ///< Empty: by its number.

  friend bool operator==(const SkinBone&, const SkinBone&) = default;
};

/// Transform of a bone in one frame: v -> position + rotation * E diag(scale) E^-1 * (v - pivot), E =
/// stretchAxes.
struct BonePose {
  Vec3 position{0.0};                ///< Place of the pivot, in the space of the mesh.
  Quat rotation{1.0, 0.0, 0.0, 0.0}; ///< From the bind pose; unit; successive frames lie on one hemisphere.
  Vec3 scale{1.0};                   ///< Along the stretch axes, x, y, z.
  Quat stretchAxes{1.0, 0.0, 0.0, 0.0}; ///< Stretch axes to mesh space of the bind pose; usually
                                        ///< SkinBone::axes.
};

/// A bind mesh with bones and their motion: what a mesh sequence is compressed to.
struct SkinnedSequence {
  std::string name;
  std::string clipName; ///< Name of the motion; empty: that of the sequence.
  std::vector<glm::vec3> bindPositions;
  std::vector<Triangle> triangles;
  std::vector<Influences> influences; ///< One for each vertex.
  std::vector<SkinBone> bones;
  std::vector<BonePose> poses; ///< Frame after frame, one for each bone.
  double framesPerSecond = 30.0;
  std::shared_ptr<const gltf::MeshSurface> surface; ///< Looks of the mesh; null: nothing but its
                                                    ///< shape.
  bool chained = false; ///< Bone b + 1 begins where bone b ends, in every frame (positions need not be
                        ///< stored).

  [[nodiscard]] std::size_t frameCount() const { return bones.empty() ? 0 : poses.size() / bones.size(); }
  [[nodiscard]] const BonePose& pose(std::size_t frame, std::size_t bone) const {
    return poses[frame * bones.size() + bone];
  }
  [[nodiscard]] BonePose& pose(std::size_t frame, std::size_t bone) {
    return poses[frame * bones.size() + bone];
  }
};

/// The mesh of the first frame as the bind mesh, named and dressed as the sequence; no bones yet.
[[nodiscard]] SkinnedSequence withoutBones(const MeshSequence& sequence);

/// The name of a bone, by its number where it has none: "bone_3".
[[nodiscard]] std::string nameOfBone(const SkinnedSequence& sequence, std::size_t bone);

/// The smallest and the largest factor that a bone is scaled by along any axis, and when.
struct ScaleRange {
  double least = 1.0;
  double most = 1.0;
  std::size_t leastFrame = 0;
  std::size_t mostFrame = 0;
};
[[nodiscard]] ScaleRange scaleRangeOf(const SkinnedSequence& sequence, std::size_t bone);

/// The affine map of one bone in one frame, bind pose to posed.
[[nodiscard]] Mat4 skinMatrix(const SkinBone& bone, const BonePose& pose);

/// Linear blend skinning of one frame, the reference that files and graphics cards are held against. Writes
/// one position for each vertex to `out`.
void skinFrame(const SkinnedSequence& sequence, std::size_t frame, std::span<glm::vec3> out);

/// All frames.
[[nodiscard]] MeshSequence skinAllFrames(const SkinnedSequence& sequence);

} // namespace stretch::skinning
