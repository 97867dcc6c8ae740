#include "app/commands/pose/hold.h"

#include <algorithm>
#include <cmath>

#include "app/commands/table/frames.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/edits/trail/trail_edits.h"

namespace stretch::app {

namespace {

constexpr double atTheSphereFrames = 0.3;

const rig::Trail* trailThere(const Session& session, const std::string& limbId) {
  const ViewState& view = session.view();
  const auto& trails = session.document().trails;
  const auto found = std::find_if(trails.begin(), trails.end(), [&](const rig::Trail& trail) {
    return trail.limb == limbId && trail.clip == view.clip && trail.settings.startFrame <= view.frame &&
           view.frame <= trail.settings.endFrame;
  });
  return found == trails.end() ? nullptr : &*found;
}

/// Around the playhead: the stroke there, else a while before and after.
Vec2 rangeAround(const Session& session, const rig::Limb& limb) {
  const double frame = session.view().frame;
  const std::vector<rig::Moment> own = session.momentsOf(limb.id);
  const rig::Moment* const stroke = rig::momentAt(own, frame);
  if (stroke != nullptr && stroke->startFrame <= frame && frame <= stroke->endFrame) {
    return {stroke->startFrame, stroke->endFrame};
  }
  const Document& document = session.document();
  const double last = lastFrame(document, session.view().clip);
  const double half = std::max(2.0, std::round(0.25 * clipOf(document, session.view().clip).framesPerSecond));
  return {std::max(0.0, std::round(frame) - half), std::min(last, std::round(frame) + half)};
}

} // namespace

Result<HeldLimb> holdLimb(const Session& session, const std::string& limbId) {
  const Document& document = session.document();
  const rig::Limb* const limb = findLimb(document, limbId);
  if (limb == nullptr || !hasClip(document, session.view().clip)) {
    return Error{"there is nothing to pull here", limbTitle(document, limbId), "open a file with a clip"};
  }
  if (const rig::Trail* const trail = trailThere(session, limbId)) {
    Result<Document> connected = setConnected(document, trail->id, true);
    return connected ? Result<HeldLimb>(HeldLimb{std::move(connected).value(), trail->id})
                     : Result<HeldLimb>(connected.error());
  }
  const auto range =
      freeRange(document, limbId, session.view().clip, rangeAround(session, *limb), session.view().frame);
  if (!range) {
    return Error{"there is no room for a trail at this frame", limbTitle(document, limbId),
                 "move the playhead"};
  }
  rig::TrailSettings settings = newTrailSettings(session, *limb, *range);
  settings.scale = 1.0;
  Result<CreatedTrail> created = createTrail(document, {limbId, session.view().clip, settings, true, true});
  return created ? Result<HeldLimb>(HeldLimb{std::move(created->document), created->trailId})
                 : Result<HeldLimb>(created.error());
}

Result<Document> withSphereAt(Session& session, int trailId, double& frame) {
  const rig::SolvedTrail* const solved = solvedTrail(session, trailId);
  if (solved == nullptr) {
    return missingTrail(trailId);
  }
  std::vector<double> frames = solved->controlFrames;
  for (const double control : frames) {
    if (std::abs(control - frame) < atTheSphereFrames) {
      frame = control;
      return session.document();
    }
  }
  frames.push_back(frame);
  return setControlFrames(session.document(), trailId, std::move(frames));
}

} // namespace stretch::app
