#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/anim/clip.h"
#include "core/math/transform.h"
#include "core/scene/scene.h"

// Internal to skinning/export: what single properties of a skinned clip do to its mesh.

namespace stretch::skinning {

/// Nodes that take the same values: of one sampler.
struct ClipCourse {
  Channel channel = Channel::translation;
  std::vector<std::size_t> nodes;
  std::vector<Vec4> values; ///< One for each frame: x, y, z and for rotations w.
};

/// A skinned clip with some of its vertices, those that reach farthest out from every joint: how far they
/// move when a property has other values than it had. Properties stay as they were set last.
class PosedProbes {
public:
  /// `courses` with a value for every frame; what they do not name stays as the scene has it at rest. `also`:
  /// more vertices to look at, counted as the scene draws them.
  PosedProbes(const Scene& scene, std::vector<ClipCourse> courses, std::size_t frames,
              const std::vector<std::size_t>& also);

  [[nodiscard]] std::size_t frameCount() const { return frames_; }
  [[nodiscard]] const std::vector<ClipCourse>& courses() const { return courses_; }

  /// Nodes and vertices that move when some courses change.
  struct Followers {
    std::vector<std::size_t> nodes; ///< Parents first.
    std::vector<std::size_t> joints;
    std::vector<std::size_t> probes;
  };
  /// Courses that change together.
  struct Group {
    std::vector<std::size_t> courses;
    Followers followers;
  };
  [[nodiscard]] Group groupOf(const std::vector<std::size_t>& courses) const;

  /// How far the farthest probe is in a frame from where it was at first, if the courses of a group had these
  /// values; past `enough` it is not looked for any farther.
  [[nodiscard]] double farthest(std::size_t frame, const Group& group, const std::vector<Vec4>& values,
                                double enough) const;
  void set(std::size_t frame, const Group& group, const std::vector<Vec4>& values);

private:
  struct Probe {
    Vec3 place{0.0};
    std::vector<std::pair<std::size_t, double>> joints; ///< With weights.
  };
  void addProbes(const Scene& scene, const std::vector<std::size_t>& also);
  void addFrame(const std::vector<Transform>& rest, const Followers& all, std::size_t frame);
  [[nodiscard]] Followers followersOf(const std::vector<std::size_t>& targets) const;
  static Vec3 placeOf(const Probe& probe, const std::vector<Mat4>& skins);
  void putAll(const Group& group, const std::vector<Vec4>& values, std::vector<Transform>& locals) const;
  void pose(const Followers& followers, const std::vector<Transform>& locals, std::vector<Mat4>& worlds,
            std::vector<Mat4>& skins) const;

  std::size_t frames_;
  std::vector<ClipCourse> courses_;
  std::vector<int> parents_;
  std::vector<std::size_t> order_; ///< Order of the nodes, parents first.
  std::vector<std::size_t> joints_;
  std::vector<Mat4> inverseBind_;
  std::vector<Probe> probes_;
  std::vector<std::vector<Transform>> locals_; ///< By frame.
  std::vector<std::vector<Mat4>> worlds_;
  std::vector<std::vector<Mat4>> skins_;  ///< By frame, one for each joint.
  std::vector<std::vector<Vec3>> source_; ///< By frame: where the probes were at first.
};

} // namespace stretch::skinning
