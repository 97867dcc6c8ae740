#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/edits/pose/seen_pose.h"
#include "core/base/result.h"

namespace stretch::app {

// Poses of the user's own, each a JSON file (docs/controllers.md, Pose library) with a picture of the same
// name (PNG) in the folder "poses" of the configuration folder.

struct LibraryPose {
  std::string name; ///< Not empty.
  SeenPose pose;    ///< In standard form (standardised).
};

/// Reads a file that holds a pose; an error names the file and the key.
[[nodiscard]] Result<LibraryPose> loadPose(const std::filesystem::path& path);

/// Writes a pose as such a file.
[[nodiscard]] Status savePose(const LibraryPose& pose, const std::filesystem::path& path);

[[nodiscard]] std::filesystem::path posesFolder();
[[nodiscard]] std::filesystem::path pictureOfPose(const std::filesystem::path& folder,
                                                  const std::string& name);

/// The user's poses by name, from files that can be read as one.
[[nodiscard]] std::vector<LibraryPose> userPoses(const std::filesystem::path& folder);

/// Gives a pose of the folder and its picture another name. An error where it is empty or another pose has
/// it.
[[nodiscard]] Status renamePose(const std::filesystem::path& folder, const LibraryPose& pose,
                                const std::string& newName);

/// Takes a pose and its picture out of the folder.
void removePose(const std::filesystem::path& folder, const std::string& name);

/// The pose of a name, or in a file where `text` ends with ".json". An error lists the names.
[[nodiscard]] Result<LibraryPose> findPose(const std::string& text, const std::filesystem::path& folder);

} // namespace stretch::app
