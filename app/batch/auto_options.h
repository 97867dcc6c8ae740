#pragma once

#include <string>

#include "app/batch/options.h"

namespace stretch::app {

/// `exaggerate --auto`: every moment of a clip, or of all, in one style.
struct AutoArguments {
  bool wanted = false;
  bool allClips = false;
  std::string style; ///< Name, or file; empty: the average of the measured ones.
  std::string strength;
  SettingTexts settings; ///< Settings that differ from the style's.

  /// The first option given that only goes with --auto; empty where none is.
  [[nodiscard]] std::string ownOption() const;
};

/// Declares --auto and what goes with it.
void addAutoOptions(CommandLine& line, AutoArguments& arguments);

/// Exaggerates the document's clip, or all clips, and reports what became of each moment.
[[nodiscard]] Result<gltf::Json> autoExaggerated(const AutoArguments& arguments, const FileArguments& input,
                                                 Document& document);

/// Prints that report as lines of text; warnings on standard error.
void printAuto(const gltf::Json& report);

} // namespace stretch::app
