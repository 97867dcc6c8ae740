#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/anim/frame_state.h"
#include "ui/render/overlay/overlay.h"
#include "ui/render/picking/picking.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

/// The joints of a character: what its skins name, or without a skin the nodes that carry meshes and those
/// above them; of a file without a mesh all nodes that hang together.
[[nodiscard]] std::vector<NodeIndex> jointsOf(const Scene& scene);

/// Whether the scene shows nothing but its skeleton: no node has a mesh.
[[nodiscard]] bool isStickFigure(const Scene& scene);

/// Bones between joints, through helper nodes that are no joints. Joints without a joint below have none.
[[nodiscard]] std::vector<BoneSegment> boneSegments(const Scene& scene, const FrameState& frame,
                                                    std::span<const NodeIndex> joints);

struct SkeletonStyle {
  glm::vec4 bone{1.0F};
  glm::vec4 selected{1.0F};
  float widthPoints = 3.0F; ///< At the joint; half of it at the far end.
  float jointPoints = 3.0F; ///< Radius.
};

[[nodiscard]] SkeletonStyle skeletonStyle(const Palette& palette);

/// Bones as lines that taper towards the next joint and joints as dots, over the character. `selection`: one
/// for each node, 0..1 (as SceneStyle::highlight); empty for none. `hovered`: a joint whose bone is drawn as
/// under the mouse.
[[nodiscard]] Overlay drawSkeleton(const Scene& scene, const FrameState& frame, const SkeletonStyle& style,
                                   std::span<const float> selection = {},
                                   std::optional<NodeIndex> hovered = std::nullopt);

} // namespace stretch::ui
