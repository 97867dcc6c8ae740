#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "core/anim/frame_state.h"
#include "ui/render/scene/scene_shape.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

/// Finds the box around what a scene shows, fast enough for every frame: it poses a fixed sample of the
/// vertices, or the joints of a scene without a mesh.
class BoundsSampler {
public:
  /// Takes at most about `sampleCount` vertices, evenly over all drawn primitives. Morph targets are left
  /// out.
  explicit BoundsSampler(const Scene& scene, std::size_t sampleCount = 3000);

  /// Box of the posed sample in world units; empty when the scene draws nothing.
  [[nodiscard]] Box boxOf(const Scene& scene, const FrameState& frame) const;

  /// Takes the places of the sample from a shape of the scene.
  void reshape(const SceneShape& shape);

private:
  struct Sample {
    glm::vec3 position;
    VertexInfluences influences;
  };
  struct Group {
    NodeIndex node;
    int skin = -1;
    std::size_t primitive = 0; ///< Counted through all meshes of the scene.
    std::vector<Sample> samples;
  };
  void addJoints(const Scene& scene); ///< For a scene without a mesh.

  std::size_t step_ = 1; ///< From one vertex of a sample to the next.
  std::vector<Group> groups_;
};

/// Returns the floor on which a character of that box stands: 0, glTF's ground, unless its lowest point lies
/// far from it (more than a tenth of its height), then that point.
[[nodiscard]] double floorHeightOf(const Box& characterBox);

/// Measures that floor, shadows and lights need to know of a scene, in world units.
struct SceneMeasures {
  double floorHeight = 0.0;     ///< y.
  double characterHeight = 1.0; ///< Sets the grid's cell and the reach of the lights; above 0.
};

/// Those of a scene at rest.
[[nodiscard]] SceneMeasures measuresOf(const Scene& scene, const BoundsSampler& bounds);

} // namespace stretch::ui
