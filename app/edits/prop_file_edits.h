#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/document.h"

namespace stretch::app {

/// A file that becomes a prop, and the hands that take it.
struct PropFile {
  std::filesystem::path path;
  std::vector<std::string> hands; ///< Limbs; one or two arms.
  int clip = 0;
  double frame = 0.0; ///< At which it is put into the hands.
};

struct AddedProp {
  Document document;
  std::string node; ///< Name of the node that carries it: what a prop names.
};

/// Adds the thing of a file beside the source, not held yet: its origin in the middle of the hand, or between
/// both, where the clip with its adjustments has them at the frame. A file of that name that is there already
/// is taken again. Refused with a line that names the file: one that is not there or broken, without a mesh,
/// with a skinned one, and the open file itself.
[[nodiscard]] Result<AddedProp> withPropFile(const Document& document, const PropFile& file);

/// The same, held firmly by the hands over the whole clip, bound at the frame.
[[nodiscard]] Result<AddedProp> holdPropFile(const Document& document, const PropFile& file);

/// Without the added files that no prop of any clip holds.
[[nodiscard]] Result<Document> withoutUnheldFiles(const Document& document);

/// With these files added in the place of those that are.
[[nodiscard]] Result<Document> withAddedFiles(const Document& document, std::vector<gltf::AddedFile> files);

} // namespace stretch::app
