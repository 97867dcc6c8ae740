#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/edits/pose/hold_edits.h"
#include "rig/plan/body_plan.h"

namespace stretch::app {

/// A file that becomes a prop, and the hands that take it.
struct PropFile {
  std::filesystem::path path;
  std::vector<std::string> hands; ///< Limbs; one or two arms.
  int clip = 0;
  double frame = 0.0; ///< At which it is put into the hands.
  Vec3 place{0.0};    ///< Place of its origin then, world space (evaluate/hand_place.h).
};

struct AddedProp {
  Document document;
  std::string node;                       ///< Name of the node that carries it: what a prop names.
  std::vector<std::string> warnings = {}; ///< Warnings about the file, one line each.
};

/// Adds the thing of a file beside the source, not held yet. Refused with a line that names the file: one
/// that is not there or broken, without a mesh, with a skinned one, and the open file itself.
[[nodiscard]] Result<AddedProp> withPropFile(const Document& document, const PropFile& file);

/// Adds the prop, held firmly by the hands over the whole clip, bound at the frame.
[[nodiscard]] Result<AddedProp> holdPropFile(const Document& document, const PropFile& file);

/// Without the added files that no prop of any clip holds. All of them stay while a chain runs through one.
[[nodiscard]] Result<Document> withoutUnheldFiles(const Document& document);

/// Without the hold, and the file that it was the last to hold.
[[nodiscard]] Result<Document> takeHoldAway(const Document& document, const HoldPlace& place);

/// With these files added in the place of those that are.
[[nodiscard]] Result<Document> withAddedFiles(const Document& document, std::vector<gltf::AddedFile> files);

/// The body as it is found in the source alone: nodes of added files may have the names of limbs.
[[nodiscard]] rig::Body bodyOfSource(const Document& document);

/// Returns the body, read as one of a plan that the user chose.
[[nodiscard]] rig::Body bodyOfSource(const Document& document, const rig::BodyPlan& plan);

} // namespace stretch::app
