#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <glm/geometric.hpp>

#include "app/auto/held_things.h"
#include "app/auto/held_together.h"
#include "app/auto/moment_weights.h"
#include "app/auto/planned_trail.h"
#include "app/auto/poses_of_strokes.h"
#include "app/auto/whole_check.h"
#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/starting_settings.h"
#include "app/standing_floor.h"
#include "rig/motion/order.h"
#include "rig/trail/release.h"

namespace stretch::app {

namespace {

constexpr double idleStrength = 1.0; // reaches per second: a breath and a swaying tail are below, a slow walk
                                     // above
constexpr double weakShare = 0.15;   // of the clip's strongest: what is weaker is no action beside it
constexpr double calmClip = 0.5;     // of what is full: a clip whose strongest has that gets all of it, too
constexpr double leastShare = 0.2;   // of the style's exaggeration, for the weakest of a weak clip
constexpr double nearStrongest = 0.6; // of the clip's strongest: what is weaker gets less, as a wind-up
                                      // beside its strike
constexpr double shortLimb = 0.25;    // of the body: what is shorter goes farther, to be seen as much
constexpr double mostFarther = 1.5;   // times
constexpr double longestLimb = 1.0;   // of a body that is no biped: legs and tail, but not wings
constexpr double shortestRelease = 2.0;
constexpr double seenRelease = 1.0 / 6.0; // seconds: a way back that is shorter is a jump
constexpr double asStrong = 0.8;          // of a stronger one: both lead
constexpr double besideBeats = 1.0 / 3.0; // of the exaggeration: a spine that is stretched tears at the wings
constexpr double swungAlong = 1.0 / 3.0; // of the exaggeration: a tail beside a stronger limb only follows it
constexpr double sharedWay = 0.5;        // of the next range: until then it has hardly begun
constexpr double carriedBack = 0.5; // of what a scale adds: where the limb itself goes so far, it is no jump
constexpr double fullOvershoot = 1.0 / 3.0; // seconds of a way back: in less it would be a jerk the other way

bool overlap(const rig::Moment& a, const rig::Moment& b) {
  return std::max(a.startFrame, b.startFrame) < std::min(a.endFrame, b.endFrame);
}

class Planner {
public:
  Planner(const ClipGround& ground, const std::vector<rig::Moment>& moments, const AutoSettings& settings,
          const std::map<std::size_t, std::string>& refused)
      : ground_(ground), moments_(moments), settings_(settings), refused_(refused) {
    std::vector<const rig::Moment*> counted;
    for (const std::vector<rig::Moment>* const all : {&moments, &settings.beside}) {
      for (std::size_t i = 0; i < all->size(); ++i) {
        const rig::Moment& moment = (*all)[i];
        const bool isRefused = (all == &moments && refused.contains(i)) || !refusalOf(moment).empty();
        if (hasOwnTrail(moment) || !isRefused) {
          counted.push_back(&moment);
        }
      }
    }
    weights_ = MomentWeights(ground.document, counted);
  }

  [[nodiscard]] AutoPlan plan() {
    plan_.leftOut.resize(moments_.size());
    std::vector<bool> isTried(moments_.size(), false);
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      for (std::size_t k = i; k < moments_.size(); ++k) {
        if (!isTried[k] && (k == i || (plan_.leftOut[i].empty() && goTogether(moments_[i], moments_[k]) &&
                                       !hasStrongerAlone(k, i)))) {
          plan_.leftOut[k] = tried(k);
          isTried[k] = true;
        }
      }
    }
    plan_.holds.props = propsFor(ground_, plan_);
    swingTogether();
    addTrunk();
    giveRoom();
    plan_.holds.grips = gripsFor(ground_, plan_);
    return std::move(plan_);
  }

private:
  // Both sides choose the same of what has no room beside each other.
  [[nodiscard]] bool goTogether(const rig::Moment& one, const rig::Moment& other) const {
    return one.kind == rig::MomentKind::stroke && one.kind == other.kind && arePartners(ground_, one, other);
  }

  // Whether the limb has a clearly stronger stroke that leads as `first` does, and in which the other side
  // has no part: it goes before what goes along with that.
  [[nodiscard]] bool hasStrongerAlone(std::size_t place, std::size_t first) const {
    for (std::size_t i = first + 1; i < place; ++i) {
      const rig::Moment& own = moments_[i];
      if (own.limb == moments_[place].limb && own.kind == rig::MomentKind::stroke &&
          moments_[place].strength < asStrong * own.strength &&
          own.strength >= asStrong * moments_[first].strength && !refused_.contains(i) &&
          refusalOf(own).empty() && std::ranges::none_of(moments_, [&](const rig::Moment& other) {
            return arePartners(ground_, own, other);
          })) {
        return true;
      }
    }
    return false;
  }

  // Empty where a trail was made.
  [[nodiscard]] std::string tried(std::size_t place) {
    const rig::Moment& moment = moments_[place];
    if (std::string why = refusalOf(moment); !why.empty()) {
      return why;
    }
    if (const auto refused = refused_.find(place); refused != refused_.end()) {
      return refused->second;
    }
    if (weights_.fastest() < idleStrength) {
      return "it is too weak to be an action";
    }
    if (isWeak(moment)) {
      if (!hasStrongPartner(moment)) {
        return "it is weak beside the clip's strongest";
      }
    }
    const rig::Limb& limb = *findLimb(ground_.document, moment.limb);
    PlannedTrail planned = trailOf(place, limb, *rangeOf(moment, limb));
    if (!leavesWaysBack(planned)) {
      return "there is no room for the way back";
    }
    plan_.trails.push_back(std::move(planned));
    return {};
  }

  // One that can be done.
  [[nodiscard]] bool hasStrongPartner(const rig::Moment& weak) const {
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      const rig::Moment& other = moments_[i];
      if (!isWeak(other) && arePartners(ground_, weak, other) && !refused_.contains(i) &&
          refusalOf(other).empty()) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool isWeak(const rig::Moment& moment) const {
    return weights_.of(moment) < weakShare * weights_.strongestBeside(moment);
  }

  [[nodiscard]] bool hasOwnTrail(const rig::Moment& moment) const {
    return overlappingTrail(ground_.document, moment.limb, ground_.clip, moment.startFrame,
                            moment.endFrame) != nullptr;
  }

  // Why a moment can have no trail, however strong it is; empty where it can.
  [[nodiscard]] std::string refusalOf(const rig::Moment& moment) const {
    if (moment.kind == rig::MomentKind::landing || moment.limb == rig::wholeBody) {
      return "a landing is of the whole body, whose feet stay where they are";
    }
    const rig::Limb* const limb = findLimb(ground_.document, moment.limb);
    if (limb == nullptr) {
      return "the character has no such limb";
    }
    if (hasOwnTrail(moment)) {
      return "a trail is there already";
    }
    if (endOf(moment) - moment.startFrame < shortestRange) {
      return "there is no room for the way back";
    }
    const std::optional<Vec2> range = rangeOf(moment, *limb);
    if (!range) {
      return textOf(FaultKind::stand);
    }
    if (moment.kind == rig::MomentKind::stroke && foldsIn(ground_, *limb, *range)) {
      return "the limb folds in";
    }
    if (moment.kind == rig::MomentKind::stroke && isDraggedBack(*limb, range->y)) {
      return "the foot would be dragged back along the ground";
    }
    if (crawls(ground_, *limb, *range)) {
      return "the body crawls along the ground by it";
    }
    return carriesStandingLeg(*limb, *range) ? "it carries a leg that stands" : "";
  }

  // A clip that is no loop ends as it did: a stroke that its end cuts off comes back before that.
  [[nodiscard]] double endOf(const rig::Moment& moment) const {
    const double back = std::max(shortestRelease, std::round(0.3 * (moment.endFrame - moment.startFrame)));
    const bool isCutOff = !ground_.wraps && moment.endFrame > ground_.lastFrame - shortestRelease;
    return isCutOff ? ground_.lastFrame - back : moment.endFrame;
  }

  // A leg that stands has no stroke; one that is put down comes back to its place before, over the seam of a
  // loop too.
  [[nodiscard]] std::optional<Vec2> rangeOf(const rig::Moment& moment, const rig::Limb& limb) const {
    Vec2 range(moment.startFrame, endOf(moment));
    const bool isStroke = moment.kind == rig::MomentKind::stroke;
    std::vector<Vec2> stands = isLeg(limb) ? ground_.standsOf(limb.id, isStroke) : std::vector<Vec2>{};
    if (ground_.wraps && !stands.empty()) {
      stands.emplace_back(ground_.aTurnLater(stands.front().x), stands.front().y + ground_.turnFrames);
    }
    for (const Vec2& stand : stands) {
      if (stand.x <= range.x) {
        range.x = std::max(range.x, std::min(stand.y - 1.0, range.y));
      } else if (stand.x < range.y + shortestRelease) {
        const double back = std::max(shortestRelease, std::round(0.3 * (stand.x - range.x)));
        range.y = std::min(range.y, stand.x - back);
      }
    }
    return range.y - range.x >= shortestRange ? std::optional(range) : std::nullopt;
  }

  // One that is put down by then comes back before that.
  [[nodiscard]] bool isDraggedBack(const rig::Limb& limb, double tip) const {
    const double back = tip + seenFrames();
    return isOnGround(ground_, limb, {tip, back}) &&
           std::ranges::none_of(ground_.standsOf(limb.id), [&](const Vec2& stand) {
             const double again = ground_.wraps ? ground_.aTurnLater(stand.x) : stand.x;
             return (tip < stand.x && stand.x <= back) || (tip < again && again <= back);
           });
  }

  [[nodiscard]] bool carriesStandingLeg(const rig::Limb& limb, const Vec2& range) const {
    return std::ranges::any_of(ground_.limbs, [&](const rig::Limb& leg) {
      const std::vector<Vec2>& stands = ground_.standsOf(leg.id);
      return leg.id != limb.id && !stands.empty() && rig::carries(*ground_.document.scene, limb, leg) &&
             std::ranges::any_of(stands, [&](const Vec2& s) { return s.x < range.y && range.x < s.y; });
    });
  }

  [[nodiscard]] bool isFollower(const std::string& limb) const {
    const rig::LimbKind kind = findLimb(ground_.document, limb)->kind;
    return kind == rig::LimbKind::tail || kind == rig::LimbKind::feeler;
  }

  // Share of the style's exaggeration: of the moment's own strength, which counts by the clip's strongest
  // where that is calm, as in a slow walk; less beside the clip's strongest, and beside a stronger limb at
  // the same time.
  [[nodiscard]] double shareOf(const rig::Moment& moment) const {
    const double beside = weights_.strongestBeside(moment);
    const double full = std::clamp(beside, calmClip * fullStrength, fullStrength);
    const double own = std::clamp(weights_.of(moment) / full, leastShare, 1.0) *
                       std::min(1.0, weights_.of(moment) / (nearStrongest * beside));
    const double swung = isFollower(moment.limb) ? swungAlong : 1.0;
    const double torn = isBesideBeats(moment) ? besideBeats : 1.0;
    return own * torn * (isBesideStronger(moment) ? swung * settings_.style.spread.limbs : 1.0);
  }

  // Wings hang on the spine, or beside it in the same mesh.
  [[nodiscard]] bool isBesideBeats(const rig::Moment& moment) const {
    return weights_.isLedByBeats() && findLimb(ground_.document, moment.limb)->kind == rig::LimbKind::spine &&
           std::ranges::any_of(moments_, [&](const rig::Moment& other) {
             const rig::Limb* const limb = findLimb(ground_.document, other.limb);
             return limb != nullptr && isBeat(*limb, other) && overlap(moment, other);
           });
  }

  // What swings along counts by how fast it is alone: light as it is, it would take the eye.
  [[nodiscard]] bool isBesideStronger(const rig::Moment& moment) const {
    return moment.kind == rig::MomentKind::stroke &&
           std::ranges::any_of(moments_, [&](const rig::Moment& other) {
             const bool isStronger = isFollower(moment.limb)
                                         ? moment.strength < asStrong * other.strength
                                         : weights_.of(moment) < asStrong * weights_.of(other);
             return other.kind == rig::MomentKind::stroke && other.limb != moment.limb && isStronger &&
                    overlap(moment, other) && other.limb != rig::wholeBody;
           });
  }

  // A style's numbers are of limbs as long as people have them.
  [[nodiscard]] double fartherBy(const rig::Limb& limb) const {
    const double usual = shortLimb * ground_.document.body.size;
    return reachesOut(limb) && limb.restLength > 0.0 ? std::clamp(usual / limb.restLength, 1.0, mostFarther)
                                                     : 1.0;
  }

  // Whether this trail and the stronger ones of its limb come back from each other without a jump.
  [[nodiscard]] bool leavesWaysBack(const PlannedTrail& planned) const {
    const rig::Trail& trail = planned.trail;
    return std::ranges::all_of(plan_.trails, [&](const PlannedTrail& other) {
      return other.trail.limb != trail.limb ||
             (comesBackBefore(planned, other.trail.settings) && comesBackBefore(other, trail.settings));
    });
  }

  // There is time for it, or the limb itself goes on as far by then, as from a wind-up into its strike; the
  // ground shows it of a step.
  [[nodiscard]] bool comesBackBefore(const PlannedTrail& planned, const rig::TrailSettings& next) const {
    const rig::Trail& trail = planned.trail;
    const rig::TrailSettings& settings = trail.settings;
    double room = next.startFrame + sharedWay * (next.endFrame - next.startFrame) - settings.endFrame;
    room += room < 0.0 && ground_.wraps ? ground_.turnFrames : 0.0;
    if (room < 0.0 || room >= seenFrames()) {
      return true;
    }
    const auto way = [&](double from, double to) {
      return glm::distance(reachAt(ground_, trail.limb, to), ground_.reachOf(trail.limb, from));
    };
    const double added = (settings.scale - 1.0) * way(settings.startFrame, settings.endFrame);
    double back = 0.0; // at its farthest: by then it may be on its way out again
    for (double frame = 1.0; frame <= std::round(room); frame += 1.0) {
      back = std::max(back, way(settings.endFrame, settings.endFrame + frame));
    }
    return !isStep(planned) && back >= carriedBack * added;
  }

  [[nodiscard]] bool isStep(const PlannedTrail& planned) const {
    return moments_[planned.moment].kind == rig::MomentKind::cycle &&
           isLeg(*findLimb(ground_.document, planned.trail.limb));
  }

  [[nodiscard]] double seenFrames() const {
    return std::max(shortestRelease, std::round(seenRelease * ground_.framesPerSecond));
  }

  [[nodiscard]] PlannedTrail trailOf(std::size_t place, const rig::Limb& limb, const Vec2& range) const {
    const rig::Moment& moment = moments_[place];
    PlannedTrail planned;
    planned.moment = place;
    planned.trail.limb = limb.id;
    planned.trail.clip = ground_.clip;
    planned.trail.exaggerated = true;
    planned.trail.connected = true;
    rig::TrailSettings& settings = planned.trail.settings;
    settings = rig::styledSettings(
        startingTrail(ground_.document, ground_.clip, limb, range), settings_.style, limb.kind,
        settings_.strength * shareOf(moment) * (isBesideStronger(moment) ? 1.0 : fartherBy(limb)));
    if (ground_.document.body.plan != "biped" && reachesOut(limb) && limb.kind != rig::LimbKind::wing) {
      settings.scale =
          std::min(settings.scale, std::max(1.0, longestLimb * ground_.document.body.size / limb.restLength));
    }
    const bool isStroke = moment.kind == rig::MomentKind::stroke;
    planned.isBent =
        limb.kind == rig::LimbKind::arm && isStroke && isPosedBent(ground_, limb, range, settings.scale);
    if (limb.kind == rig::LimbKind::arm && !isStroke && sweepsGround(ground_, limb, range, settings.scale)) {
      settings.axes[1] = false;
    }
    if (limb.kind == rig::LimbKind::arm && isStroke && goesLevel(ground_, limb, range)) {
      settings.axes[1] = false;
    }
    if (isStroke && isUpInTheAir(ground_, limb, range)) {
      settings.axes = {settings.axes[0], false, settings.axes[2]}; // its foot comes no nearer the ground,
      settings.bend = rig::Bend::keep;                             // and its knee stays as it is
    }
    stopAtGround(limb, settings);
    return planned;
  }

  // The spine goes along with each strike of a limb that hangs on it, where it does nothing of its own.
  void addTrunk() {
    const rig::Limb* const spine = rig::limbAt(ground_.document.body.limbs, rig::biped::spine);
    const rig::Spread& spread = settings_.style.spread;
    if (spine == nullptr || spine->ledByFirst || spread.trunk <= 0.0) {
      return;
    }
    const double late = std::round(spread.lateFrames / 24.0 * ground_.framesPerSecond);
    for (std::size_t i = 0, leading = plan_.trails.size(); i < leading; ++i) {
      const rig::Trail& lead = plan_.trails[i].trail;
      const rig::Limb& limb = *findLimb(ground_.document, lead.limb);
      const Vec2 range(lead.settings.startFrame + late, lead.settings.endFrame + late);
      if (reachesOut(limb) && isStrike(moments_[plan_.trails[i].moment]) &&
          rig::carries(*ground_.document.scene, *spine, limb) && isFree(*spine, range)) {
        plan_.trails.push_back(followerOf(plan_.trails[i], limb, *spine, range));
      }
    }
  }

  [[nodiscard]] static bool isStrike(const rig::Moment& moment) {
    return moment.kind == rig::MomentKind::stroke && moment.strength >= 0.5 * fullStrength;
  }

  [[nodiscard]] bool isFree(const rig::Limb& limb, const Vec2& range) const {
    return range.y <= ground_.lastFrame - shortestRelease && !carriesStandingLeg(limb, range) &&
           overlappingTrail(ground_.document, limb.id, ground_.clip, range.x, range.y) == nullptr &&
           std::ranges::none_of(plan_.trails, [&](const PlannedTrail& other) {
             const rig::TrailSettings& settings = other.trail.settings;
             return other.trail.limb == limb.id && settings.startFrame < range.y &&
                    range.x < settings.endFrame + (range.y - range.x);
           });
  }

  // Pulled the way that the limb goes, evenly along the range.
  [[nodiscard]] PlannedTrail followerOf(const PlannedTrail& lead, const rig::Limb& limb,
                                        const rig::Limb& spine, const Vec2& range) const {
    const Vec3 way = ground_.reachOf(limb.id, lead.trail.settings.endFrame) -
                     ground_.reachOf(limb.id, lead.trail.settings.startFrame);
    const double strength = settings_.strength * settings_.style.spread.trunk;
    const double pull = (rig::styledScale(settings_.style, spine.kind, strength) - 1.0) * spine.restLength;
    PlannedTrail follower = lead;
    follower.follows = true;
    follower.trail.limb = spine.id;
    rig::TrailSettings& settings = follower.trail.settings;
    settings = rig::styledSettings(startingTrail(ground_.document, ground_.clip, spine, range),
                                   settings_.style, spine.kind, 0.0);
    settings.scale = 1.0;
    if (const double length = glm::length(way); length > 0.0) {
      pullAlong(follower, pull / length * way);
    }
    return follower;
  }

  // What two hands swing goes where the stronger arm takes it: the other one reaches as far, at the same
  // time, where nothing else has it.
  void swingTogether() {
    for (std::size_t i = 0; i < plan_.trails.size(); ++i) { // strongest first
      const rig::Trail lead = plan_.trails[i].trail;
      for (std::size_t k = i + 1; k < plan_.trails.size(); ++k) {
        rig::Trail& other = plan_.trails[k].trail;
        if (areOnOneThing(lead, other) && areMostlyAtOnce(lead.settings, other.settings) &&
            isFreeBut(k, lead.settings)) {
          other.settings = lead.settings;
          break;
        }
      }
    }
  }

  [[nodiscard]] static bool areMostlyAtOnce(const rig::TrailSettings& a, const rig::TrailSettings& b) {
    const double shared = std::min(a.endFrame, b.endFrame) - std::max(a.startFrame, b.startFrame);
    return shared >= 0.5 * std::min(a.endFrame - a.startFrame, b.endFrame - b.startFrame);
  }

  // Whether no other trail of this one's limb is in the range.
  [[nodiscard]] bool isFreeBut(std::size_t place, const rig::TrailSettings& range) const {
    const std::string& limb = plan_.trails[place].trail.limb;
    bool isFree =
        overlappingTrail(ground_.document, limb, ground_.clip, range.startFrame, range.endFrame) == nullptr;
    for (std::size_t i = 0; i < plan_.trails.size(); ++i) {
      const rig::TrailSettings& other = plan_.trails[i].trail.settings;
      isFree = isFree && (i == place || plan_.trails[i].trail.limb != limb ||
                          other.endFrame <= range.startFrame || range.endFrame <= other.startFrame);
    }
    return isFree;
  }

  [[nodiscard]] bool areOnOneThing(const rig::Trail& lead, const rig::Trail& other) const {
    return lead.limb != other.limb && areOnProp(plan_, lead.limb, other.limb, lead.settings.endFrame);
  }

  void stopAtGround(const rig::Limb& limb, rig::TrailSettings& settings) const {
    if (isLeg(limb) && !settings.stopAt) {
      settings.stopAt = floorForLeg(ground_.document, ground_.clip, limb, settings.endFrame);
    }
    if (!settings.stopAt && std::isfinite(ground_.lowest)) {
      const double ground = std::max(ground_.lowest, ground_.floor.value_or(ground_.lowest));
      settings.stopAt = rig::StopPlane{{0.0, ground, 0.0}, {0.0, -1.0, 0.0}};
    }
  }

  // The way back of each trail begins when the limb itself starts back, where there is room for that. It ends
  // before the next one of its limb has gone far, before its foot stands and, where the clip is no loop,
  // before its end. A step of a cycle is taken back for as long as the ground carries the foot: in less the
  // foot would skate. Spine, neck and tail settle for as long as they went out at least. A tail gets no
  // shorter than it is: long as it is, it would pop.
  void giveRoom() {
    for (PlannedTrail& planned : plan_.trails) {
      rig::TrailSettings& settings = planned.trail.settings;
      const double wanted = settings.releaseFrames.value_or(0.5 * (settings.endFrame - settings.startFrame));
      const double carried = isStep(planned) ? roomAfter(planned.trail, 0.0) : 0.0;
      const bool settles = isChain(*findLimb(ground_.document, planned.trail.limb));
      const double out = settles && !planned.follows ? settings.endFrame - settings.startFrame : 0.0;
      const double room = roomAfter(planned.trail, sharedWay);
      const rig::Moment& moment = moments_[planned.moment];
      const bool leads = moment.kind == rig::MomentKind::stroke &&
                         weights_.of(moment) >= nearStrongest * weights_.strongestBeside(moment) &&
                         !planned.follows;
      const bool goesRound = moment.kind == rig::MomentKind::cycle;
      const double still = goesRound ? stillFor(ground_, planned.trail, room) : 0.0;
      const double release = std::clamp(room - still, 0.0, std::max({wanted, seenFrames(), carried, out}));
      if (const double share = (still + release) / seenFrames();
          share < 1.0 && isStep(planned) && standsAfter(planned.trail, room)) {
        settings = withShare(settings, share * share); // else the foot snaps back to where it is put down
      }
      settings.lingerFrames = leads ? heldFor(ground_, planned.trail, room - release) : still;
      settings.releaseFrames = settings.lingerFrames + release;
      const double time = std::min(1.0, release / ground_.framesPerSecond / fullOvershoot);
      settings.overshoot *= isStep(planned) || isFollower(planned.trail.limb) ? 0.0 : time * time;
    }
    letGoTogether();
    bringBackTogether();
    plan_.loops = ground_.wraps; // until it is known whether anything goes on at its start
  }

  // Limbs of two sides that strike at once are let go at once, and are back at once, where both have the
  // room.
  void letGoTogether() {
    for (PlannedTrail& one : plan_.trails) {
      for (const PlannedTrail& other : plan_.trails) {
        rig::TrailSettings& settings = one.trail.settings;
        const rig::TrailSettings& late = other.trail.settings;
        const double held = late.endFrame + late.lingerFrames - settings.endFrame;
        const double back = late.endFrame + *late.releaseFrames - settings.endFrame;
        if (goTogether(moments_[one.moment], moments_[other.moment]) && !one.follows && !other.follows &&
            back <= roomAfter(one.trail, sharedWay)) {
          settings.lingerFrames = std::max(settings.lingerFrames, held);
          settings.releaseFrames = std::max(*settings.releaseFrames, back);
        }
      }
    }
  }

  // Two hands that swing one thing come back as the stronger arm does.
  void bringBackTogether() {
    for (std::size_t i = 0; i < plan_.trails.size(); ++i) { // strongest first
      const rig::Trail lead = plan_.trails[i].trail;
      for (std::size_t k = i + 1; k < plan_.trails.size(); ++k) {
        rig::Trail& other = plan_.trails[k].trail;
        if (areOnOneThing(lead, other) && lead.settings.startFrame == other.settings.startFrame &&
            lead.settings.endFrame == other.settings.endFrame) {
          other.settings.lingerFrames = lead.settings.lingerFrames;
          other.settings.releaseFrames = lead.settings.releaseFrames;
        }
      }
    }
  }

  // Whether the limb's foot is put down so many frames after the tip.
  [[nodiscard]] bool standsAfter(const rig::Trail& trail, double frames) const {
    const double frame = trail.settings.endFrame + frames;
    return std::ranges::any_of(ground_.standsOf(trail.limb), [&](const Vec2& stand) {
      return stand.x == frame || (ground_.wraps && ground_.aTurnLater(stand.x) == frame);
    });
  }

  // Frames after the tip, up to this share of the next range of the limb.
  [[nodiscard]] double roomAfter(const rig::Trail& trail, double share) const {
    const double tip = trail.settings.endFrame;
    const double turn = ground_.wraps ? ground_.turnFrames : 0.0;
    const double end = ground_.lastFrame - tip; // less a frame: keys go straight from each frame to the next
    double room = turn > 0.0 ? 2.0 * turn : std::max(end - 1.0, std::min(end, shortestRelease));
    const auto endBefore = [&](double frame) {
      const double after = (frame >= tip || turn <= 0.0 ? frame : ground_.aTurnLater(frame)) - tip;
      room = after >= 0.0 ? std::min(room, after) : room;
    };
    for (const PlannedTrail& other : plan_.trails) {
      const rig::TrailSettings& next = other.trail.settings;
      if (other.trail.limb == trail.limb && (other.trail.settings != trail.settings || turn > 0.0)) {
        endBefore(next.startFrame + share * (next.endFrame - next.startFrame));
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
  const std::map<std::size_t, std::string>& refused_;
  MomentWeights weights_;
  AutoPlan plan_;
};

} // namespace

AutoPlan planTrails(const ClipGround& ground, const std::vector<rig::Moment>& moments,
                    const AutoSettings& settings, const std::map<std::size_t, std::string>& refused) {
  return Planner(ground, moments, settings, refused).plan();
}

} // namespace stretch::app
