#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace stretch::skinning {

/// Frames in the order of the numbers in their names, and what is odd about these.
struct FrameFiles {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> warnings;
};

/// Orders meshes, at least one. Those whose names differ in numbers alone are a series: it is played, and
/// what stands beside it is left out and told. An error for several series and for equal numbers. A '-'
/// before a number is its sign where the same names have a 0 without it, and 1.25 lies between 1 and 2 where
/// frames have such names. Where no two are alike all are played in the order of their names, which is told.
[[nodiscard]] Result<FrameFiles> framesInOrder(const std::vector<std::filesystem::path>& files);

/// The meshes beside a mesh that have its name but for the number at the end, with it; it alone where there
/// are none.
[[nodiscard]] std::vector<std::filesystem::path> seriesOf(const std::filesystem::path& mesh);

/// The folder that a file lies in.
[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& file);

/// The files in a folder that are wanted, in no order; an error where it cannot be read.
[[nodiscard]] Result<std::vector<std::filesystem::path>>
filesIn(const std::filesystem::path& folder, bool (*wanted)(const std::filesystem::path&));

} // namespace stretch::skinning
