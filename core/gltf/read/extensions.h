#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/gltf/json/json_document.h"

namespace stretch::gltf {

/// Use that is made of an extension's data. Saving keeps all of it in any case.
enum class ExtensionSupport {
  read,    ///< Read, and shown where it is seen.
  told,    ///< Not shown, which is told where the file uses it.
  ignored, ///< Not shown: the file is shown without it.
  hiding   ///< Not read, and geometry or motion cannot be without it.
};

[[nodiscard]] ExtensionSupport supportOf(std::string_view extension);

/// An extension that a file uses.
struct ExtensionUse {
  std::string name;
  bool isRequired = false; ///< The file says that it cannot be shown without it.
  ExtensionSupport support = ExtensionSupport::ignored;
};

/// In the order of the file, those that it requires without listing them as used last.
[[nodiscard]] std::vector<ExtensionUse> extensionsOf(const Json& json);

} // namespace stretch::gltf
