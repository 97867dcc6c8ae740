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
  std::string name;                ///< Not empty, at most 100 bytes, without ".json" at its end.
  SeenPose pose;                   ///< In standard form (standardised).
  std::filesystem::path file = {}; ///< File that it was read from; its name may be another one.
};

/// Poses of a folder, and why its other files are none.
struct PoseFolder {
  std::vector<LibraryPose> poses;   ///< By name.
  std::vector<std::string> refused; ///< A line for each file that cannot be read as a pose.
};

/// Reads a file that holds a pose; an error names the file and the key.
[[nodiscard]] Result<LibraryPose> loadPose(const std::filesystem::path& path);

/// Writes a pose as such a file. An error for a name that a pose may not have.
[[nodiscard]] Status savePose(const LibraryPose& pose, const std::filesystem::path& path);

[[nodiscard]] std::filesystem::path posesFolder();
[[nodiscard]] std::filesystem::path pictureOfPose(const std::filesystem::path& file);

[[nodiscard]] PoseFolder posesIn(const std::filesystem::path& folder);

/// "Pose 1", or the next number that no pose of the folder and none of its files has.
[[nodiscard]] std::string freePoseName(const std::filesystem::path& folder);

/// Gives a pose that was read from a file another name, and its file and picture that name; answers the file.
/// An error where another file stands in its place, and for a name that a pose may not have.
[[nodiscard]] Result<std::filesystem::path> renamePose(const LibraryPose& pose, const std::string& newName);

/// Removes the file of a pose and its picture.
[[nodiscard]] Status removePose(const LibraryPose& pose);

/// The pose of a name, or in a file where `text` ends with ".json". An error lists the names.
[[nodiscard]] Result<LibraryPose> findPose(const std::string& text, const std::filesystem::path& folder);

} // namespace stretch::app
