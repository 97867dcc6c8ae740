#include "app/session.h"

#include <algorithm>
#include <utility>

#include "app/files/save.h"
#include "core/base/check.h"

namespace stretch::app {

Session::Session(Document document) : history_(std::move(document)) {
  if (history_.current().carriedWork) {
    savePath_ = history_.current().source->path;
  }
}

bool Session::edit(Document changed, std::string label) {
  if (isDragging()) {
    return false;
  }
  const bool pushed = history_.push(std::move(changed), std::move(label));
  dropInvalidSelection();
  return pushed;
}

void Session::begin(std::string label) {
  cancel();
  preview_ = history_.current();
  dragLabel_ = std::move(label);
}

void Session::preview(Document changed) {
  check(isDragging(), "a preview belongs to a drag that was begun");
  preview_ = std::move(changed);
}

void Session::commit() {
  check(isDragging(), "a commit ends a drag that was begun");
  Document changed = std::move(*preview_);
  preview_.reset();
  history_.push(std::move(changed), std::move(dragLabel_));
  dropInvalidSelection();
}

void Session::cancel() {
  preview_.reset();
  dropInvalidSelection();
}

bool Session::undo() {
  cancel();
  const bool done = history_.undo();
  dropInvalidSelection();
  return done;
}

bool Session::redo() {
  cancel();
  const bool done = history_.redo();
  dropInvalidSelection();
  return done;
}

const FrameState& Session::frameAt(double frame) {
  const Document& shown = document();
  const double fps = shown.clips->empty() ? 1.0 : clipOf(shown, view_.clip).framesPerSecond;
  return cache_.frame(shown, view_.clip, frame / fps);
}

const FrameState& Session::originalAt(double frame) {
  const Document& shown = document();
  const double fps = shown.clips->empty() ? 1.0 : clipOf(shown, view_.clip).framesPerSecond;
  return cache_.original(shown, view_.clip, frame / fps);
}

const rig::MotionState& Session::motion() {
  return *sharedMotion();
}

std::shared_ptr<const rig::MotionState> Session::sharedMotion() {
  return cache_.motion(document(), view_.clip);
}

const std::vector<TrailPaths>& Session::paths(std::size_t samplesPerFrame) {
  return cache_.paths(document(), view_.clip, samplesPerFrame);
}

const std::vector<WeightReport>& Session::weightReports() {
  return cache_.weightReports(document(), view_.clip);
}

std::filesystem::path Session::proposedSavePath() const {
  if (!savePath_.empty()) {
    return savePath_;
  }
  std::filesystem::path proposed = document().source->path;
  proposed.replace_filename(proposed.stem().string() + "-stretched.glb");
  return proposed;
}

Status Session::save(const std::filesystem::path& path, bool clean) {
  cancel();
  const Status saved = saveDocument(history_.current(), path, {.clean = clean});
  // A clean export is a copy for others: the work itself is not saved by it.
  if (saved && !clean) {
    savePath_ = path;
    history_.markSaved();
  }
  return saved;
}

void Session::dropInvalidSelection() {
  const Document& shown = document();
  if (findTrail(shown, view_.selectedTrail) == nullptr) {
    view_.selectedTrail = 0;
    view_.selectedSpheres.clear();
  }
  std::erase_if(view_.selectedLimbs,
                [&](const std::string& limb) { return findLimb(shown, limb) == nullptr; });
}

} // namespace stretch::app
