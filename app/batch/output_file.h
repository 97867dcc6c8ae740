#pragma once

#include <string>
#include <vector>

#include "app/batch/command_line.h"
#include "core/base/result.h"

namespace stretch::app {

/// File that a verb writes.
struct OutputFile {
  std::string path;
  bool inPlace = false;                                 ///< It may be one of the files that the verb reads.
  std::vector<std::string> endings = {".glb", ".gltf"}; ///< That its name may have; empty: any.
};

/// Declares -o and --in-place. A name that can be no output of the verb is a wrong argument.
void addOutputFile(CommandLine& line, OutputFile& output, const std::string& help);

/// Refuses a name that can be no output, whatever is read: one without an ending of the output's, but for a
/// .vrm or .vrma where it may be a character. Nothing is wrong with one without a path.
[[nodiscard]] Status checkName(const OutputFile& output);

/// Refuses an output before there is any work: one of the files that are read, under whatever name, unless
/// that was asked for; another ending, but that of a .vrm or .vrma that is read first and stays one; and a
/// place where no file can be written. Nothing is wrong with one without a path.
[[nodiscard]] Status checkOutput(const OutputFile& output, const std::vector<std::string>& inputs);

} // namespace stretch::app
