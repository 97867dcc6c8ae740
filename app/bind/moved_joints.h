#pragma once

#include <memory>
#include <vector>

#include "app/bind/body_to_bind.h"
#include "app/document.h"
#include "core/gltf/patch/edits.h"
#include "rig/body/locators/locators.h"

namespace stretch::app {

/// A joint that is to stand elsewhere in the bind pose.
struct JointMove {
  NodeIndex node;
  Mat4 from; ///< World, in the bind pose.
  Mat4 to;
  Mat4 parentFrom{1.0}; ///< Likewise for the node above it; identity without one.
  Mat4 parentTo{1.0};
};

/// Moves that take the document's joints to locators that they stand for (jointsOfLocators): those, and what
/// hangs on them, which keeps its place on the joint above. Empty where nothing moves.
[[nodiscard]] std::vector<JointMove> movesTo(const Scene& scene, const rig::Locators& locators);

/// The skeleton with the joints where they are moved to.
[[nodiscard]] SkeletonToBind moved(SkeletonToBind skeleton, const std::vector<JointMove>& moves);

/// The clips with keys by which the moved joints bend the mesh as before: it turns as it did, about the new
/// places. Null stays null.
using SharedClips = std::shared_ptr<const std::vector<Clip>>;
[[nodiscard]] SharedClips withMovedJoints(const SharedClips& clips, const std::vector<JointMove>& moves);

/// Puts the moves into edits of the document's file: nodes, inverse bind matrices, keys of its clips.
void addMoves(const Document& document, const std::vector<JointMove>& moves, gltf::Edits& edits);

} // namespace stretch::app
