#pragma once

#include <string>
#include <vector>

#include "core/gltf/source/source.h"

namespace stretch::assets {

/// A bundled file with its first clip, looked at frame by frame.
class PlayedClip {
public:
  /// `name` as in bundledFiles().
  explicit PlayedClip(const std::string& name);

  [[nodiscard]] const Scene& scene() const { return *loaded_.scene; }
  [[nodiscard]] const Clip& clip() const { return loaded_.clips.front(); }
  [[nodiscard]] int lastFrame() const;
  [[nodiscard]] std::vector<Mat4> worlds(double frame) const;
  /// World place of a node's origin, or of a point in its space.
  [[nodiscard]] Vec3 at(const std::string& node, double frame, const Vec3& point = Vec3(0.0)) const;
  /// Of the body, by the usual shares of its segments.
  [[nodiscard]] Vec3 centreOfMass(double frame) const;

  /// The lowest vertex of the body.
  [[nodiscard]] Vec3 lowest(double frame) const;
  /// How deep a vertex of the body lies at most inside a box.
  [[nodiscard]] double depthInBox(double frame, const Vec3& low, const Vec3& high) const;
  /// How deep the skin of the trunk, head and legs lies at most within a rod of that radius between two
  /// points.
  [[nodiscard]] double depthInBody(double frame, const Vec3& from, const Vec3& to, double radius) const;

private:
  enum class Skinned { all, withoutArms };
  [[nodiscard]] std::vector<Vec3> vertices(double frame, Skinned which) const;

  gltf::Loaded loaded_;
};

/// Middle of the closed glove in the space of the hand's joint, and its radius.
[[nodiscard]] Vec3 gloveMiddle(bool isLeft);
inline constexpr double gloveRadius = 0.075;

} // namespace stretch::assets
