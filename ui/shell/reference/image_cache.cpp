#include "ui/shell/reference/image_cache.h"

#include <algorithm>
#include <utility>

#include "ui/viewport/shown/shown_reference.h"

namespace stretch::ui {

namespace {

constexpr std::size_t mostBytes = 256U << 20U;

std::size_t bytesOf(const std::shared_ptr<const Image>& image) {
  return image == nullptr ? 0 : image->rgba.size();
}

} // namespace

Status ImageCache::update(const std::vector<std::filesystem::path>& wanted) {
  Status status = Success{};
  if (job_ != nullptr && job_->isFinished()) {
    Result<Image> read = job_->take();
    job_.reset();
    std::shared_ptr<const Image>& kept = images_[reading_];
    if (read) {
      kept = std::make_shared<const Image>(std::move(*read));
    } else {
      status = read.error();
    }
    forgetOthers(wanted);
  }
  const auto missing =
      std::ranges::find_if(wanted, [&](const auto& file) { return !images_.contains(file); });
  if (job_ == nullptr && missing != wanted.end()) {
    reading_ = *missing;
    job_ = std::make_unique<app::Job<Image>>(
        [file = reading_](const skinning::Proceed&) { return readReferenceImage(file); });
  }
  return status;
}

std::shared_ptr<const Image> ImageCache::at(const std::filesystem::path& file) const {
  const auto found = images_.find(file);
  return found == images_.end() ? nullptr : found->second;
}

bool ImageCache::isBroken(const std::filesystem::path& file) const {
  const auto found = images_.find(file);
  return found != images_.end() && found->second == nullptr;
}

void ImageCache::forgetOthers(const std::vector<std::filesystem::path>& wanted) {
  std::size_t bytes = 0;
  for (const auto& [file, image] : images_) {
    bytes += bytesOf(image);
  }
  for (auto entry = images_.begin(); entry != images_.end() && bytes > mostBytes;) {
    const bool isWanted = std::ranges::find(wanted, entry->first) != wanted.end();
    bytes -= isWanted ? 0 : bytesOf(entry->second);
    entry = isWanted ? std::next(entry) : images_.erase(entry);
  }
}

} // namespace stretch::ui
