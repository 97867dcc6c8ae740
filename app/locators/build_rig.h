#pragma once

#include <vector>

#include "app/document.h"
#include "core/base/result.h"
#include "core/gltf/patch/added_skeleton.h"
#include "rig/body/locators/locators.h"

namespace stretch::app {

/// The joints that are made at locators.
[[nodiscard]] std::vector<gltf::SkeletonJoint> jointsAt(const rig::Locators& locators);

/// The document with joints made at the locators, appended to its file as nodes: what the file has is not
/// changed, no vertex follows them yet (docs/from_a_mesh.md). Its limbs are those that are found on them. The
/// locators stay with the document. Error, one line: a locator that the plan needs is missing, or the
/// character has limbs already.
[[nodiscard]] Result<Document> withRigAt(const Document& document, const rig::Locators& locators);

/// The joints of the character that stand for these locators, in their order: of the same names, named by
/// skins, each below the one that it hangs on, at rest where the bind pose has them. Empty unless there is
/// one for each.
[[nodiscard]] std::vector<NodeIndex> jointsOfLocators(const Scene& scene, const rig::Locators& locators);

/// Whether there are joints for the document's locators: made at them, or found by fitting.
[[nodiscard]] bool isRigBuilt(const Document& document);

/// Whether such joints are there, and a locator was moved away from its own.
[[nodiscard]] bool areLocatorsMoved(const Document& document);

/// The document before its rig was built: without the joints, with the locators. Error: no rig was built, or
/// something uses it: a mesh that is bound to it, a clip, trails, adjustments or holds.
[[nodiscard]] Result<Document> withoutRig(const Document& document);

/// The document whose limbs go by the joints that are nearest to locators that were moved; no joint is made.
/// Locators where the limbs are leave them alone. Error: joints that are no chain, which it names.
[[nodiscard]] Result<Document> withLimbsAt(const Document& document, const rig::Locators& locators);

} // namespace stretch::app
