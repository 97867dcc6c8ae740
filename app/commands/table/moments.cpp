#include "app/commands/table/moments.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include <fmt/core.h>

#include "app/commands/table/frames.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "core/anim/frames.h"
#include "rig/trail/limb_path.h"

namespace stretch::app {

namespace {

bool isBody(const rig::Moment& moment) {
  return moment.limb == rig::wholeBody;
}

std::vector<NodeIndex> nodesOf(const Document& document, const rig::Moment& moment) {
  const rig::Limb* const limb = findLimb(document, moment.limb);
  std::vector<NodeIndex> nodes = limb == nullptr ? std::vector<NodeIndex>{document.body.hips} : limb->joints;
  if (limb != nullptr && limb->endNode.exists()) {
    nodes.push_back(limb->endNode);
  }
  return nodes;
}

} // namespace

std::vector<rig::Moment> shownMoments(const Session& session) {
  constexpr double share = 0.2;
  constexpr std::size_t most = 100;
  if (!hasClip(session.document(), session.view().clip)) {
    return {};
  }
  const std::vector<rig::Moment>& all = session.moments();
  const rig::Moment* const strongest = rig::strongestMoment(all);
  std::vector<rig::Moment> shown;
  for (const rig::Moment& moment : all) {
    if (shown.size() < most && moment.strength >= share * strongest->strength) {
      shown.push_back(moment);
    }
  }
  std::ranges::stable_sort(shown, {}, &rig::Moment::tipFrame);
  return shown;
}

std::optional<rig::Moment> currentMoment(const Session& session) {
  const ViewState& view = session.view();
  const std::vector<rig::Moment> shown = shownMoments(session);
  const auto found = std::ranges::find_if(shown, [&](const rig::Moment& moment) {
    return sameFrame(moment.startFrame, view.rangeStart) && sameFrame(moment.endFrame, view.rangeEnd) &&
           limbsOfMoment(session.document(), moment) == view.selection.limbs();
  });
  return found == shown.end() ? std::nullopt : std::optional(*found);
}

std::optional<rig::Moment> nextMoment(const Session& session, bool forwards) {
  std::vector<rig::Moment> shown = shownMoments(session);
  if (shown.empty()) {
    return std::nullopt;
  }
  const std::optional<rig::Moment> current = currentMoment(session);
  if (!forwards) {
    std::ranges::reverse(shown);
  }
  const auto here = current ? std::ranges::find(shown, *current) : shown.end();
  if (here != shown.end()) {
    return std::next(here) == shown.end() ? shown.front() : *std::next(here);
  }
  const double frame = session.view().frame;
  const auto next = std::ranges::find_if(shown, [&](const rig::Moment& moment) {
    return forwards ? moment.tipFrame > frame + 0.5 : moment.tipFrame < frame - 0.5;
  });
  return next == shown.end() ? shown.front() : *next;
}

std::vector<std::string> limbsOfMoment(const Document& document, const rig::Moment& moment) {
  if (!isBody(moment)) {
    return {moment.limb};
  }
  std::vector<std::string> legs;
  for (const rig::Limb& limb : document.body.limbs) {
    if (isLeg(limb)) {
      legs.push_back(limb.id);
    }
  }
  return legs;
}

void goToMoment(Session& session, const rig::Moment& moment) {
  session.view().frame = moment.tipFrame;
  bool add = false;
  for (const std::string& limb : limbsOfMoment(session.document(), moment)) {
    selectLimb(session, limb, add);
    add = true;
  }
  if (selectedTrail(session) == nullptr) {
    setRangeByHand(session, {moment.startFrame, moment.endFrame});
  }
}

std::string momentText(const Document& document, const rig::Moment& moment) {
  std::string name = isBody(moment) ? "body" : limbTitle(document, moment.limb);
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return fmt::format("{}: {} from {:.4g} to {:.4g}, strength {:.2g}", name, rig::momentKindName(moment.kind),
                     moment.startFrame, moment.tipFrame, moment.strength);
}

std::vector<Vec3> pathOfMoment(const Session& session, const rig::Moment& moment) {
  const Document& document = session.document();
  const Clip& clip = clipOf(document, session.view().clip);
  const rig::Limb* const limb = findLimb(document, moment.limb);
  if (limb == nullptr && !document.body.hips.exists()) {
    return {};
  }
  const rig::NodeSampler sampler(*document.scene, clip, nodesOf(document, moment));
  std::vector<Vec3> path;
  FrameState frame;
  for (double at = moment.startFrame; at <= moment.tipFrame; at += 0.5) {
    sampler.sample(at / clip.framesPerSecond, frame);
    path.push_back(limb == nullptr ? positionOf(frame.worlds[stretch::at(document.body.hips)])
                                   : rig::leadingPosition(*limb, frame));
  }
  return path;
}

} // namespace stretch::app
