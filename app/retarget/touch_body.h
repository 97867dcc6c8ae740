#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "app/retarget/body_chart.h"
#include "app/retarget/body_parts.h"
#include "core/anim/frame_state.h"
#include "skinning/geometry/inside.h"

namespace stretch::app {

/// A vertex beside a surface.
struct NearVertex {
  std::size_t vertex = 0;
  skinning::SurfacePoint point; ///< The nearest one of the surface.
  double distance = 0.0;        ///< World units.
};

/// A biped as far as hands touch it: what arms are made of, and where they are beside trunk and head. Large
/// surfaces are looked at in even steps: at most 100 vertices of each hand, 60 of each forearm.
struct TouchBody {
  explicit TouchBody(const rig::Skeleton& body);
  TouchBody(const TouchBody&) = delete;
  TouchBody& operator=(const TouchBody&) = delete;

  /// Whether trunk and an arm are shown at all.
  [[nodiscard]] bool hasSurface() const;

  /// World positions of all vertices.
  [[nodiscard]] std::vector<Vec3> placesOf(const std::vector<Mat4>& worlds) const;

  /// Vertices of a hand that are nearer than `limit` to trunk and head.
  [[nodiscard]] std::vector<NearVertex> nearTrunk(const std::vector<Vec3>& places, std::size_t side,
                                                  double limit) const;

  /// Vertices of hand and forearm that are inside trunk and head, and not so in the bind pose; distances are
  /// how deep.
  [[nodiscard]] std::vector<NearVertex> inTrunk(const std::vector<Vec3>& places, std::size_t side) const;

  /// How deep the deepest of them is, of the height; 0: none is.
  [[nodiscard]] double depthOf(const std::vector<Vec3>& places, std::size_t side) const;

  /// Wrist of an arm that the body has.
  [[nodiscard]] Vec3 wrist(const std::vector<Mat4>& worlds, std::size_t side) const;

  const rig::Skeleton& skeleton;
  BodyParts parts;
  BodyChart chart;
  std::array<std::vector<std::size_t>, 2> hands;
  std::array<std::vector<std::size_t>, 2> arms; ///< Forearms and hands, but for what is inside in the bind
                                                ///< pose.
  std::array<double, 2> handSizes{};            ///< From the wrist, world units, > 0.
};

/// Those of the vertices that are nearer than `limit` to the triangles.
[[nodiscard]] std::vector<NearVertex> nearVertices(const skinning::PlacedSurface& surface,
                                                   const std::vector<std::size_t>& vertices, double limit);

} // namespace stretch::app
