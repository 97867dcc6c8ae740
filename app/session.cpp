#include "app/session.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/edits/keys/rate_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/evaluate/clip_moments.h"
#include "app/files/bundled_folder.h"
#include "app/files/save.h"
#include "app/files/user_files.h"
#include "app/locators/locator_edits.h"
#include "app/things/time_map.h"
#include "core/anim/frames.h"
#include "core/anim/sampling.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/detection.h"

namespace stretch::app {

namespace {

Result<Document> withUnkeyed(const Document& document, const UnkeyedPose& pose) {
  std::vector<ControllerOffset> offsets;
  std::vector<AttributeValue> values;
  for (const auto& [id, offset] : pose.offsets) {
    offsets.push_back(offset);
  }
  for (const auto& [id, value] : pose.values) {
    values.push_back({id, value});
  }
  return setOffsets(document, pose.clip, pose.frame, offsets, values, {});
}

std::size_t clipCount(const Document& document) {
  return document.clips == nullptr ? 0 : document.clips->size();
}

} // namespace

bool isPosedWithoutKey(const ViewState& view) {
  const UnkeyedPose& pose = view.unkeyed;
  return !pose.empty() && pose.clip == view.clip && sameFrame(pose.frame, view.frame);
}

Session::Session(Document document) : Editing(std::move(document)) {
  if (history().current().carriedWork) {
    savePath_ = history().current().source->path;
  }
  for (const rig::Trail& trail : history().current().trails) {
    knownTrails_.push_back(trail.id);
  }
  knownClips_ = clipCount(history().current());
  followRate();
}

const FrameState& Session::frameAt(double frame) {
  const Document& shown = document();
  const double fps = shown.clips->empty() ? 1.0 : clipOf(shown, view_.clip).framesPerSecond;
  if (const Document* const posed = posedWithoutKey(frame)) {
    return posed_->cache.frame(*posed, view_.clip, frame / fps);
  }
  return cache_.frame(shown, view_.clip, frame / fps);
}

const Document* Session::posedWithoutKey(double frame) {
  UnkeyedPose& pose = view_.unkeyed;
  if (!pose.empty() && (pose.clip != view_.clip || !sameFrame(pose.frame, view_.frame))) {
    pose = {};
  }
  if (pose.empty() || !sameFrame(pose.frame, frame)) {
    return nullptr;
  }
  if (!posed_ || posed_->pose != pose || !sameDocument(posed_->from, document())) {
    Result<Document> made = withUnkeyed(document(), pose);
    Document shown = made ? std::move(made).value() : document();
    if (!posed_) {
      posed_.emplace();
    }
    posed_->pose = pose;
    posed_->made = std::move(shown);
    posed_->from = document();
  }
  return &posed_->made;
}

const Document& Session::posedDocument() {
  const Document* const posed = posedWithoutKey(view_.frame);
  return posed != nullptr ? *posed : document();
}

const std::vector<rig::PlacedController>& Session::controllersAt(double frame) {
  const Document& shown = document();
  const double fps = shown.clips->empty() ? 1.0 : clipOf(shown, view_.clip).framesPerSecond;
  if (const Document* const posed = posedWithoutKey(frame)) {
    return posed_->cache.controllers(*posed, view_.clip, frame / fps);
  }
  return cache_.controllers(shown, view_.clip, frame / fps);
}

const std::vector<rig::ControllerShape>& Session::controllerShapes() {
  return cache_.shapes(document(), view_.clip);
}

const FrameState& Session::shownAt(double frame) {
  if (!showsLocators(document(), view_.showLocators)) {
    return frameAt(frame);
  }
  const std::shared_ptr<const Scene>& scene = document().scene;
  if (bindPoseOf_ != scene) {
    bindPose_ = frameOf(*scene, restPose(*scene), 0.0);
    bindPose_.worlds = rig::bindPoseWorlds(*scene);
    bindPoseOf_ = scene;
  }
  return bindPose_;
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
  return cache_.keyed(document(), view_.clip, view_.keyPlaces);
}

const std::vector<WeightReport>& Session::weightReports() {
  return cache_.weightReports(document(), view_.clip);
}

const std::vector<LimbPop>& Session::pops() {
  constexpr std::int64_t block = 120; // frames: a playhead that moves within one asks for nothing new
  const std::int64_t first = static_cast<std::int64_t>(view_.frame) / block * block;
  const PopsKey key{sharedMotion(), {first - block / 2, first + block + block / 2}};
  return isDragging() && pops_.last() != nullptr
             ? *pops_.last()
             : pops_.of(key, [&](const auto*) { return limbPops(document(), *key.motion, key.frames); });
}

std::filesystem::path Session::proposedSavePath() const {
  if (!savePath_.empty()) {
    return savePath_;
  }
  const std::filesystem::path& source = document().source->path;
  const std::string name = source.stem().string() + "-stretched.glb";
  const bool besideSource = !isBundled(source) && isWritableFolder(source.parent_path());
  return (besideSource ? source.parent_path() : documentsFolder()) / name;
}

Result<double> Session::save(const std::filesystem::path& path, bool clean, const SavedForm& form) {
  cancel();
  const SavedEdits made = editsOf(history().current(), {.clean = clean, .form = form});
  const Status saved = saveEdits(history().current(), made.edits, path);
  // A clean export is a copy for others: the work itself is not saved by it.
  if (saved && !clean) {
    savePath_ = path;
    markSaved();
  }
  return saved ? Result<double>(made.missOfHeight) : Result<double>(saved.error());
}

const std::vector<rig::Moment>& Session::moments() const {
  const Document& shown = document();
  MomentsKey key{shown.scene, shown.clips, view_.clip, allLimbs(shown), shown.body.hips};
  return isDragging() && moments_.last() != nullptr
             ? *moments_.last()
             : moments_.of(std::move(key), [&](const auto*) { return app::momentsOf(shown, view_.clip); });
}

std::vector<rig::Moment> Session::momentsOf(const std::string& limbId) const {
  std::vector<rig::Moment> own;
  std::ranges::copy_if(moments(), std::back_inserter(own),
                       [&](const rig::Moment& moment) { return moment.limb == limbId; });
  std::ranges::sort(own, {}, &rig::Moment::startFrame);
  return own;
}

void Session::followSelection() {
  if (ratedClip_ != view_.clip) {
    followRate(); // Another clip is looked at, at a rate of its own.
  }
  const rig::Trail* const trail = findTrail(document(), view_.selection.trail());
  const Followed now = trail == nullptr
                           ? Followed{}
                           : Followed{trail->id, trail->settings.startFrame, trail->settings.endFrame};
  if (trail != nullptr && !(now == followed_)) {
    const Vec2 wanted(now.startFrame, now.endFrame);
    rangeBefore_ = rangeByHand();
    view_.rangeStart = wanted.x;
    view_.rangeEnd = wanted.y;
  } else if (trail == nullptr && followed_.trail != 0) {
    const Vec2 before = rangeByHand().value_or(Vec2(0.0, -1.0));
    view_.rangeStart = before.x;
    view_.rangeEnd = before.y;
    rangeBefore_.reset();
  }
  followed_ = now;
}

std::optional<Vec2> Session::rangeByHand() const {
  const Vec2 range(view_.rangeStart, view_.rangeEnd);
  const bool isOfTrail = followed_.trail != 0 && range == Vec2(followed_.startFrame, followed_.endFrame);
  return isOfTrail ? rangeBefore_ : range.y >= range.x ? std::optional(range) : std::nullopt;
}

// A clip that was imported goes by undo while it is viewed: what was viewed before it came is viewed again.
void Session::followClips() {
  const std::size_t count = clipCount(document());
  if (count > knownClips_) {
    viewedBefore_[count] = {view_.clip, view_.frame};
  } else if (view_.clip >= static_cast<int>(count) && view_.clip > 0) {
    const auto before = viewedBefore_.upper_bound(count);
    const Viewed back = before == viewedBefore_.end() ? Viewed{} : before->second;
    view_.clip = std::clamp(back.clip, 0, std::max(0, static_cast<int>(count) - 1));
    view_.frame = back.frame;
    view_.rangeStart = 0.0;
    view_.rangeEnd = -1.0;
  }
  knownClips_ = count;
}

void Session::followRate() {
  const Document& shown = document();
  const bool exists = view_.clip >= 0 && static_cast<std::size_t>(view_.clip) < shown.clips->size();
  const double now = exists ? clipOf(shown, view_.clip).framesPerSecond : 0.0;
  if (exists && ratedClip_ == view_.clip && rate_ > 0.0 && now != rate_) {
    const double factor = now / rate_;
    const bool isPosed = isPosedWithoutKey(view_);
    view_.frame = std::round(view_.frame * factor);
    view_.unkeyed.frame = isPosed ? view_.frame : view_.unkeyed.frame;
    if (view_.rangeEnd >= view_.rangeStart) {
      view_.rangeStart = std::round(view_.rangeStart * factor);
      view_.rangeEnd = std::max(view_.rangeStart + 1.0, std::round(view_.rangeEnd * factor));
    }
    if (rangeBefore_) {
      rangeBefore_->x = std::round(rangeBefore_->x * factor);
      rangeBefore_->y = std::max(rangeBefore_->x + 1.0, std::round(rangeBefore_->y * factor));
    }
    if (!view_.selection.spheres().empty()) {
      for (double& frame : view_.selection.editTrails().spheres) {
        frame *= factor;
      }
    }
    if (view_.copiedTrail && view_.copiedTrail->clip == view_.clip) {
      view_.copiedTrail = mapped(*view_.copiedTrail, TimeMap{.factor = factor});
    }
  }
  ratedClip_ = view_.clip;
  rate_ = now;
}

void Session::keepHandles() {
  const Document& shown = document();
  const rig::ControllerList list = controllersOf(shown);
  std::vector<std::string> controllers = view_.selection.controllers();
  std::erase_if(controllers, [&](const std::string& id) { return !findController(shown, list, id).ok(); });
  view_.selection.setControllers(std::move(controllers));
  std::vector<std::string> locators = view_.selection.locators();
  std::erase_if(locators, [&](const std::string& name) {
    return !showsLocators(shown, view_.showLocators) || rig::findLocator(shown.locators, name) == nullptr;
  });
  view_.selection.setLocators(std::move(locators));
}

void Session::keepSelectedTrail(const std::vector<int>& appeared) {
  const Document& shown = document();
  if (view_.selection.trail() != 0 && findTrail(shown, view_.selection.trail()) == nullptr) {
    lost_ = {view_.selection.trail(), 0.0, 0.0};
    lostSpheres_ = view_.selection.spheres();
    view_.selection.dropTrail();
  }
  if (view_.selection.trail() != 0 || appeared.empty()) {
    return;
  }
  if (std::find(appeared.begin(), appeared.end(), lost_.trail) != appeared.end()) {
    view_.selection.editTrails().trail = lost_.trail;
    view_.selection.editTrails().spheres = std::exchange(lostSpheres_, {});
  } else if (appeared.size() == 1) {
    view_.selection.dropSpheres();
    view_.selection.editTrails().trail = appeared.front();
  }
}

void Session::documentChanged() {
  followClips();
  followRate();
  const Document& shown = document();
  std::vector<int> appeared;
  std::vector<int> trails;
  for (const rig::Trail& trail : shown.trails) {
    trails.push_back(trail.id);
    if (trail.clip == view_.clip &&
        std::find(knownTrails_.begin(), knownTrails_.end(), trail.id) == knownTrails_.end()) {
      appeared.push_back(trail.id);
    }
  }
  knownTrails_ = std::move(trails);
  keepSelectedTrail(appeared);
  if (!view_.selection.limbs().empty()) {
    std::erase_if(view_.selection.editTrails().limbs,
                  [&](const std::string& limb) { return findLimb(shown, limb) == nullptr; });
  }
  if (!view_.selection.trailsBeside().empty()) {
    std::erase_if(view_.selection.editTrails().beside,
                  [&](int trail) { return findTrail(shown, trail) == nullptr; });
  }
  keepHandles();
  keepPickedKeys();
  followSelection();
}

void Session::keepPickedKeys() {
  if (!view_.pickedKeys.empty()) {
    const bool sameClip = view_.pickedClip == view_.clip;
    view_.pickedKeys = sameClip ? stillThere(document(), view_.clip, view_.pickedKeys) : KeySelection{};
  }
}

} // namespace stretch::app
