#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "app/sequence/job.h"
#include "core/scene/scene.h"

namespace stretch::ui {

/// Images of a series, read one after the other beside the window and kept within 256 MB.
class ImageCache {
public:
  /// Called once a frame with the images that are wanted now, the most urgent first: takes what was read and
  /// starts the next. The error is that of an image that could not be read, told once for each.
  [[nodiscard]] Status update(const std::vector<std::filesystem::path>& wanted);

  /// Null where it is not there yet, or cannot be read.
  [[nodiscard]] std::shared_ptr<const Image> at(const std::filesystem::path& file) const;
  /// It was read, and cannot be.
  [[nodiscard]] bool isBroken(const std::filesystem::path& file) const;
  [[nodiscard]] bool isReading() const { return job_ != nullptr; }

private:
  void forgetOthers(const std::vector<std::filesystem::path>& wanted);

  std::map<std::filesystem::path, std::shared_ptr<const Image>> images_; ///< Null: it cannot be read.
  std::filesystem::path reading_;
  std::unique_ptr<app::Job<Image>> job_;
};

} // namespace stretch::ui
