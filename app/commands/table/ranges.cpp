#include "app/commands/table/ranges.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/place_trails.h"
#include "app/evaluate/way_back.h"

namespace stretch::app {

namespace {

constexpr double sameRangeFrames = 0.5;
constexpr double halfWindowSeconds = 0.25; ///< Either side of the playhead, for a limb that stands still.

double lengthOf(const Vec2& range) {
  return range.y - range.x;
}

double sharedTime(const Vec2& a, const Vec2& b) {
  return std::max(0.0, std::min(a.y, b.y) - std::max(a.x, b.x));
}

/// Whether most of the time that either of them takes is both's: two arms on one bat.
bool isOneMovement(const Vec2& a, const Vec2& b) {
  constexpr double most = 0.55;
  return sharedTime(a, b) >= most * (std::max(a.y, b.y) - std::min(a.x, b.x));
}

bool isPlayheadPlaced(const ViewState& view) {
  return view.frame >= 0.5; // At the start nobody looked for a place in time yet.
}

/// The stroke's range, or the leading one.
Vec2 ownOrLeading(const std::optional<rig::Moment>& stroke, const Vec2& leading, bool isThere) {
  if (!stroke) {
    return leading;
  }
  const Vec2 own(stroke->startFrame, stroke->endFrame);
  const bool isElsewhere = isThere && sharedTime(own, leading) < 1.0;
  return isElsewhere || isOneMovement(own, leading) ? leading : own;
}

/// What is left of the pieces without what lies between `start` and `end`.
std::vector<Vec2> without(const std::vector<Vec2>& pieces, double start, double end) {
  std::vector<Vec2> left;
  for (const Vec2& piece : pieces) {
    if (end <= piece.x || start >= piece.y) {
      left.push_back(piece);
      continue;
    }
    left.emplace_back(piece.x, std::min(piece.y, start));
    left.emplace_back(std::max(piece.x, end), piece.y);
  }
  std::erase_if(left, [](const Vec2& piece) { return lengthOf(piece) < 1.0; });
  return left;
}

bool isSameRange(const rig::TrailSettings& settings, const Vec2& range) {
  return std::abs(settings.startFrame - range.x) < sameRangeFrames &&
         std::abs(settings.endFrame - range.y) < sameRangeFrames;
}

} // namespace

std::optional<rig::Moment> proposedMoment(const Session& session, const std::string& limbId) {
  constexpr double nearSeconds = 0.25;
  const std::vector<rig::Moment> own = session.momentsOf(limbId);
  const double rate = clipOf(session.document(), session.view().clip).framesPerSecond;
  const rig::Moment* const proposed = isPlayheadPlaced(session.view())
                                          ? rig::momentAt(own, session.view().frame, nearSeconds * rate)
                                          : rig::strongestMoment(own);
  return proposed == nullptr ? std::nullopt : std::optional(*proposed);
}

Vec2 rangeBeside(const Session& session, const rig::Limb& limb, const Vec2& leading) {
  constexpr double asStrong = 0.5;
  const std::optional<rig::Moment> proposed = proposedMoment(session, limb.id);
  const std::vector<rig::Moment> own = session.momentsOf(limb.id);
  const rig::Moment* const meanwhile = rig::momentAt(own, 0.5 * (leading.x + leading.y));
  const bool movesAlong = proposed && meanwhile->strength >= asStrong * proposed->strength;
  const bool isPlaced = isPlayheadPlaced(session.view());
  return ownOrLeading(movesAlong && !isPlaced ? std::optional(*meanwhile) : proposed, leading, isPlaced);
}

Vec2 rangeBesideStroke(const Session& session, const rig::Limb& limb, const Vec2& leading) {
  const std::vector<rig::Moment> own = session.momentsOf(limb.id);
  const rig::Moment* const stroke = rig::momentAt(own, 0.5 * (leading.x + leading.y));
  return ownOrLeading(stroke == nullptr ? std::nullopt : std::optional(*stroke), leading, true);
}

bool crossesSeam(const Session& session, const rig::Limb& limb, const rig::Moment& stroke) {
  const std::vector<rig::Moment> strokes = session.momentsOf(limb.id);
  const double last = lastFrame(session.document(), session.view().clip);
  const auto beginsThere = [](const rig::Moment& one) { return one.startFrame < 0.5; };
  const auto endsThere = [&](const rig::Moment& one) { return one.endFrame > last - 0.5; };
  const bool wholeClip = beginsThere(stroke) && endsThere(stroke);
  return (beginsThere(stroke) || endsThere(stroke)) && !wholeClip &&
         std::any_of(strokes.begin(), strokes.end(), beginsThere) &&
         std::any_of(strokes.begin(), strokes.end(), endsThere) &&
         endsMeet(session.document(), session.view().clip);
}

Vec2 proposedRange(const Session& session, const rig::Limb& limb) {
  const ViewState& view = session.view();
  const double last = lastFrame(session.document(), view.clip);
  if (const std::optional<rig::Moment> moment = proposedMoment(session, limb.id)) {
    return {moment->startFrame, moment->endFrame};
  }
  const double half =
      std::max(1.0, std::round(halfWindowSeconds * clipOf(session.document(), view.clip).framesPerSecond));
  const double start = std::clamp(std::round(view.frame) - half, 0.0, std::max(0.0, last - 1.0));
  return {start, std::clamp(std::round(view.frame) + half, std::min(start + 1.0, last), last)};
}

bool isRangeSet(const ViewState& view) {
  return view.rangeEnd >= view.rangeStart;
}

Vec2 workingRange(const Session& session, const rig::Limb& limb) {
  return isRangeSet(session.view()) ? shownRange(session) : proposedRange(session, limb);
}

Vec2 shownRange(const Session& session) {
  const ViewState& view = session.view();
  const double last = lastFrame(session.document(), view.clip);
  if (isRangeSet(view)) {
    return {std::clamp(view.rangeStart, 0.0, last), std::clamp(view.rangeEnd, 0.0, last)};
  }
  const rig::Limb* const limb =
      view.selection.limbs().empty() ? nullptr : findLimb(session.document(), view.selection.limbs().front());
  return limb == nullptr ? Vec2(0.0, last) : proposedRange(session, *limb);
}

void setRangeByHand(Session& session, const Vec2& range) {
  ViewState& view = session.view();
  view.rangeStart = range.x;
  view.rangeEnd = range.y;
  const rig::Trail* const trail = selectedTrail(session);
  if (trail != nullptr && (trail->settings.startFrame < range.x || trail->settings.endFrame > range.y)) {
    view.selection.dropTrail();
  }
}

std::optional<Vec2> freeRange(const Document& document, const std::string& limbId, int clip,
                              const Vec2& range, double frame) {
  std::vector<Vec2> pieces{range};
  for (const rig::Trail& trail : document.trails) {
    if (trail.limb == limbId && trail.clip == clip) {
      pieces = without(pieces, trail.settings.startFrame, trail.settings.endFrame);
    }
  }
  const auto holds = [&](const Vec2& piece) { return piece.x <= frame && frame <= piece.y; };
  const auto best = std::max_element(pieces.begin(), pieces.end(), [&](const Vec2& a, const Vec2& b) {
    return holds(a) != holds(b) ? holds(b) : lengthOf(a) < lengthOf(b);
  });
  return best == pieces.end() ? std::nullopt : std::optional(*best);
}

std::optional<RangeClash> rangeClash(const Session& session) {
  const ViewState& view = session.view();
  if (selectedTrail(session) != nullptr || !isRangeSet(view)) {
    return std::nullopt;
  }
  const Document& document = session.document();
  const Vec2 wanted(view.rangeStart, view.rangeEnd);
  for (const std::string& limb : view.selection.limbs()) {
    const rig::Trail* const present = overlappingTrail(document, limb, view.clip, wanted.x, wanted.y);
    if (present != nullptr && !isSameRange(present->settings, wanted)) {
      return RangeClash{limb,
                        {present->settings.startFrame, present->settings.endFrame},
                        wanted,
                        freeRange(document, limb, view.clip, wanted, view.frame)};
    }
  }
  return std::nullopt;
}

} // namespace stretch::app
