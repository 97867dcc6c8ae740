#pragma once

#include <vector>

#include "app/document.h"
#include "core/base/result.h"
#include "core/gltf/added_skeleton.h"
#include "rig/body/locators.h"

namespace stretch::app {

/// The joints that are made at locators.
[[nodiscard]] std::vector<gltf::SkeletonJoint> jointsAt(const rig::Locators& locators);

/// The document with joints made at the locators, appended to its file as nodes: what the file has is not
/// changed, no vertex follows them yet (docs/from_a_mesh.md). Its limbs are those that are found on them. The
/// locators stay with the document. Error, one line: a locator that the plan needs is missing, or the
/// character has limbs already.
[[nodiscard]] Result<Document> withRigAt(const Document& document, const rig::Locators& locators);

/// Whether the joints at the document's locators are made.
[[nodiscard]] bool isRigBuilt(const Document& document);

/// The document before its rig was built: without the joints, with the locators. Error: no rig was built, or
/// something uses it: a mesh that is bound to it, a clip, trails, adjustments or holds.
[[nodiscard]] Result<Document> withoutRig(const Document& document);

/// The document whose limbs go by the joints that are nearest to locators that were moved; no joint is made.
/// Locators where the limbs are leave them alone. Error: joints that are no chain, which it names.
[[nodiscard]] Result<Document> withLimbsAt(const Document& document, const rig::Locators& locators);

} // namespace stretch::app
