#pragma once

#include <string>
#include <vector>

#include "app/batch/command_line.h"
#include "app/document.h"

namespace stretch::app {

/// A pose of the library that a clip takes at a frame.
struct PoseRequest {
  std::string pose; ///< Name or file; empty: none.
  double frame = 0.0;
  std::string range; ///< "A:B"; empty: the whole clip.
  double amount = 1.0;
  bool isMirrored = false;
};

/// Declares --pose and the options that go with it.
void addPoseRequest(CommandLine& line, PoseRequest& request);

/// Outcome of a request.
struct TakenPose {
  Document document;
  std::string name;
  std::vector<std::string> controllers; ///< Those that were moved or turned.
  std::vector<std::string> missed;      ///< Held elsewhere.
};

/// The document with the pose keyed at the frame. Errors name the option.
[[nodiscard]] Result<TakenPose> withPose(const Document& document, int clip, const PoseRequest& request);

} // namespace stretch::app
