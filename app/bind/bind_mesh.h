#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bind/moved_joints.h"
#include "app/document.h"
#include "core/base/result.h"
#include "rig/body/locators/locators.h"
#include "skinning/fit/alternate.h"

namespace stretch::app {

/// How weights are found: by the way inside the body, or by the way on its surface, which has to be closed.
enum class BindWay { volume, surface };

struct BindRequest {
  /// Places where the joints are made, or, where the file has joints for them (jointsOfLocators), moved to.
  /// Nothing: at the joints that the file has.
  std::optional<rig::Locators> locators;
  BindWay way = BindWay::volume;
};

struct BindReport {
  std::size_t joints = 0;
  std::size_t meshes = 0;
  std::size_t vertices = 0;
  std::size_t cubes = 0; ///< That the body was filled with; 0: by the surface.
  std::size_t bytes = 0; ///< That the cubes took, about.
  std::vector<std::string> warnings;
};

struct BoundMeshes {
  std::shared_ptr<const gltf::Source> source; ///< The document's, patched: nothing of it is renumbered.
  std::vector<JointMove> moves;               ///< Moves of joints that were there already.
  BindReport report;
};

/// Binds the meshes of a document to a skeleton (docs/bind.md): all that are drawn to joints made at the
/// locators, or, at the joints that the file has, those that have a skin and those that no joint carries.
/// Error, one line: no mesh with triangles, no joints, a mesh with a skin where joints are to be made, a
/// surface that is not closed, told to stop.
[[nodiscard]] Result<BoundMeshes> bindMeshes(const Document& document, const BindRequest& request,
                                             const skinning::Proceed& proceed = {});

/// The document on the bound source, its limbs found again unless they were corrected by hand, its clips
/// fitted to joints that were moved.
[[nodiscard]] Result<Document> withBoundMeshes(Document document, const BoundMeshes& bound);

} // namespace stretch::app
