#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "app/auto/held_together.h"
#include "app/auto/planned_trail.h"
#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/starting_settings.h"
#include "app/standing_floor.h"
#include "rig/motion/order.h"

namespace stretch::app {

namespace {

constexpr double weakShare = 0.1;     // of the clip's strongest: what is weaker is no action beside it
constexpr double fullStrength = 12.0; // reaches per second: from here on a moment gets all that the style
                                      // says
constexpr double leastShare = 0.35;   // of the style's exaggeration, for the weakest
constexpr double shortestRange = 2.0; // frames
constexpr double shortestRelease = 2.0;
constexpr double asStrong = 0.8;  // of a stronger one: both lead
constexpr double sharedWay = 0.5; // of the next range: until then it has hardly begun

double clipStrength(const std::vector<rig::Moment>& moments) {
  double strongest = 0.0;
  for (const rig::Moment& moment : moments) {
    strongest = moment.limb == rig::wholeBody ? strongest : std::max(strongest, moment.strength);
  }
  return strongest;
}

bool overlap(const rig::Moment& a, const rig::Moment& b) {
  return std::max(a.startFrame, b.startFrame) < std::min(a.endFrame, b.endFrame);
}

class Planner {
public:
  Planner(const ClipGround& ground, const std::vector<rig::Moment>& moments, const AutoSettings& settings)
      : ground_(ground), moments_(moments), settings_(settings), strongest_(clipStrength(moments)) {}

  [[nodiscard]] AutoPlan plan() {
    plan_.leftOut.resize(moments_.size());
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      plan_.leftOut[i] = tried(i);
    }
    giveRoom();
    plan_.grips = gripsFor(ground_, plan_);
    return std::move(plan_);
  }

private:
  // Empty where a trail was made.
  [[nodiscard]] std::string tried(std::size_t place) {
    const rig::Moment& moment = moments_[place];
    if (moment.kind == rig::MomentKind::landing || moment.limb == rig::wholeBody) {
      return "a landing is of the whole body, whose feet stay where they are";
    }
    const rig::Limb* const limb = findLimb(ground_.document, moment.limb);
    if (limb == nullptr) {
      return "the character has no such limb";
    }
    if (overlappingTrail(ground_.document, moment.limb, ground_.clip, moment.startFrame, moment.endFrame) !=
        nullptr) {
      return "a trail is there already";
    }
    if (moment.strength < weakShare * strongest_) {
      return "it is weak beside the clip's strongest";
    }
    const std::optional<Vec2> range = rangeOf(moment, *limb);
    if (!range) {
      return "the foot carries the body there";
    }
    if (carriesStandingLeg(*limb, *range)) {
      return "it carries a leg that stands";
    }
    addTrail(place, *limb, *range);
    return {};
  }

  // A leg that stands has no stroke; one that is put down comes back to its place before.
  [[nodiscard]] std::optional<Vec2> rangeOf(const rig::Moment& moment, const rig::Limb& limb) const {
    Vec2 range(moment.startFrame, moment.endFrame);
    for (const Vec2& stand : isLeg(limb) ? ground_.standsOf(limb.id) : std::vector<Vec2>{}) {
      if (stand.x <= range.x) {
        range.x = std::max(range.x, std::min(stand.y - 1.0, range.y));
      } else if (stand.x < range.y + shortestRelease) {
        const double back = std::max(shortestRelease, std::round(0.3 * (stand.x - range.x)));
        range.y = std::min(range.y, stand.x - back);
      }
    }
    return range.y - range.x >= shortestRange ? std::optional(range) : std::nullopt;
  }

  [[nodiscard]] bool carriesStandingLeg(const rig::Limb& limb, const Vec2& range) const {
    return std::ranges::any_of(ground_.limbs, [&](const rig::Limb& leg) {
      const std::vector<Vec2>& stands = ground_.standsOf(leg.id);
      return leg.id != limb.id && !stands.empty() && rig::carries(*ground_.document.scene, limb, leg) &&
             std::ranges::any_of(stands, [&](const Vec2& s) { return s.x < range.y && range.x < s.y; });
    });
  }

  // Share of the style's exaggeration: of the moment's own strength, and less beside a stronger limb.
  [[nodiscard]] double shareOf(const rig::Moment& moment) const {
    const double own = std::clamp(moment.strength / fullStrength, leastShare, 1.0);
    const bool follows = moment.kind == rig::MomentKind::stroke &&
                         std::ranges::any_of(moments_, [&](const rig::Moment& other) {
                           return other.kind == rig::MomentKind::stroke && other.limb != moment.limb &&
                                  overlap(moment, other) && moment.strength < asStrong * other.strength;
                         });
    return own * (follows ? settings_.style.spread.limbs : 1.0);
  }

  void addTrail(std::size_t place, const rig::Limb& limb, const Vec2& range) {
    const rig::Moment& moment = moments_[place];
    PlannedTrail planned;
    planned.moment = place;
    planned.trail.limb = limb.id;
    planned.trail.clip = ground_.clip;
    planned.trail.exaggerated = true;
    planned.trail.connected = true;
    rig::TrailSettings& settings = planned.trail.settings;
    settings = rig::styledSettings(startingTrail(ground_.document, ground_.clip, limb, range),
                                   settings_.style, limb.kind, settings_.strength * shareOf(moment));
    planned.styleScale = settings.scale;
    stopAtGround(limb, settings);
    plan_.trails.push_back(std::move(planned));
  }

  void stopAtGround(const rig::Limb& limb, rig::TrailSettings& settings) const {
    if (isLeg(limb) && !settings.stopAt) {
      settings.stopAt = floorForLeg(ground_.document, ground_.clip, limb, settings.endFrame);
    }
    if (!settings.stopAt) {
      const double ground = std::max(ground_.lowest, ground_.floor.value_or(ground_.lowest));
      settings.stopAt = rig::StopPlane{{0.0, ground, 0.0}, {0.0, -1.0, 0.0}};
    }
  }

  // The way back of each trail ends before the next one of its limb has gone far, before its foot stands and,
  // where the clip is no loop, before its end.
  void giveRoom() {
    for (std::size_t i = 0; i < plan_.trails.size(); ++i) {
      const double room = roomAfter(plan_.trails[i].trail);
      std::optional<double>& release = plan_.trails[i].trail.settings.releaseFrames;
      if (release) {
        release = std::max(std::min(*release, room), std::min(room, shortestRelease));
      } else if (room < ground_.lastFrame) {
        const rig::TrailSettings& settings = plan_.trails[i].trail.settings;
        release = std::min(room, std::max(shortestRelease, 0.5 * (settings.endFrame - settings.startFrame)));
      }
    }
    plan_.loops = ground_.endsMeet && !hasWeight(ground_.document, ground_.clip) &&
                  std::ranges::any_of(plan_.trails, [&](const PlannedTrail& planned) {
                    return windowOf(planned.trail.settings).y > ground_.lastFrame ||
                           planned.trail.settings.endFrame >= ground_.lastFrame;
                  });
  }

  // Frames after the tip; lastFrame and more: nothing is in the way.
  [[nodiscard]] double roomAfter(const rig::Trail& trail) const {
    const double tip = trail.settings.endFrame;
    const double turn = ground_.endsMeet ? ground_.lastFrame : 0.0;
    double room = turn > 0.0 ? 2.0 * ground_.lastFrame : ground_.lastFrame - tip;
    const auto endBefore = [&](double frame) {
      const double after = frame >= tip ? frame - tip : frame + turn - tip;
      room = after >= 0.0 ? std::min(room, after) : room;
    };
    for (const PlannedTrail& other : plan_.trails) {
      const rig::TrailSettings& next = other.trail.settings;
      if (other.trail.limb == trail.limb && (other.trail.settings != trail.settings || turn > 0.0)) {
        endBefore(next.startFrame + sharedWay * (next.endFrame - next.startFrame));
      }
    }
    for (const Vec2& stand : ground_.standsOf(trail.limb)) {
      endBefore(stand.x);
    }
    return room;
  }

  const ClipGround& ground_;
  const std::vector<rig::Moment>& moments_;
  const AutoSettings& settings_;
  double strongest_ = 0.0;
  AutoPlan plan_;
};

} // namespace

AutoPlan planTrails(const ClipGround& ground, const std::vector<rig::Moment>& moments,
                    const AutoSettings& settings) {
  return Planner(ground, moments, settings).plan();
}

Vec2 windowOf(const rig::TrailSettings& settings) {
  const double range = settings.endFrame - settings.startFrame;
  return {settings.startFrame, settings.endFrame + settings.releaseFrames.value_or(range)};
}

void leaveOut(AutoPlan& plan, std::size_t place, const std::string& why) {
  const PlannedTrail& planned = plan.trails[place];
  plan.leftOut[planned.moment] = why;
  std::erase_if(plan.grips, [&](const rig::Grip& grip) {
    return grip.leader == planned.trail.limb && grip.time.rangeFrames.x == planned.trail.settings.startFrame;
  });
  plan.trails.erase(plan.trails.begin() + static_cast<std::ptrdiff_t>(place));
}

} // namespace stretch::app
