#include "app/session.h"

#include <utility>

#include "app/files/save.h"

namespace stretch::app {

Session::Session(Document document) : Editing(std::move(document)) {
  if (history().current().carriedWork) {
    savePath_ = history().current().source->path;
  }
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

const Clip& Session::shownClip() {
  return cache_.keyed(document(), view_.clip);
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
  Status saved = saveDocument(history().current(), path, {.clean = clean});
  // A clean export is a copy for others: the work itself is not saved by it.
  if (saved && !clean) {
    savePath_ = path;
    markSaved();
  }
  return saved;
}

void Session::documentChanged() {
  const Document& shown = document();
  if (findTrail(shown, view_.selectedTrail) == nullptr) {
    view_.selectedTrail = 0;
    view_.selectedSpheres.clear();
  }
  std::erase_if(view_.selectedLimbs,
                [&](const std::string& limb) { return findLimb(shown, limb) == nullptr; });
}

} // namespace stretch::app
