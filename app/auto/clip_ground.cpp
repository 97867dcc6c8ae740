#include "app/auto/clip_ground.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "app/evaluate/planted_feet.h"
#include "app/evaluate/way_back.h"
#include "app/standing_floor.h"
#include "core/anim/frames.h"
#include "rig/retarget/standing.h"

namespace stretch::app {

namespace {

// Of limbs and mesh in one frame.
void lowerTo(const FrameState& frame, const LimbPlaces& places, ClipGround& ground) {
  ground.lowest = std::min(ground.lowest, lowestOf(places));
  const std::optional<Vec3> vertex = ground.lowestVertexIn(frame);
  ground.lowestVertices.push_back(vertex ? vertex->y : std::numeric_limits<double>::infinity());
  ground.lowestVertex = std::min(ground.lowestVertex, ground.lowestVertices.back());
}

Vec3 middleOf(const LimbPlaces& places) {
  Vec3 sum(0.0);
  for (const std::vector<Vec3>& points : places) {
    sum += points.front();
  }
  return sum / static_cast<double>(places.size());
}

// Points of all limbs at a time, seen from the middle of their bases.
std::vector<Vec3> poseAt(const ClipGround& ground, double seconds) {
  const LimbPlaces places = placesOf(ground.limbs, evaluateOriginal(ground.document, ground.clip, seconds));
  const Vec3 middle = middleOf(places);
  std::vector<Vec3> points;
  for (const std::vector<Vec3>& limb : places) {
    std::ranges::transform(limb, std::back_inserter(points),
                           [&](const Vec3& point) { return point - middle; });
  }
  return points;
}

// Limbs that are at the clip's end neither where they are at its beginning nor before that by no more than
// they go on to move in two and a half frames, as in clips that leave out the last frame because it is the
// first; wherever the body got to and whatever else moves.
struct LimbsApart {
  std::size_t count = std::numeric_limits<std::size_t>::max();
  double farthest = 0.0; // world units
};

LimbsApart limbsApart(const ClipGround& ground) {
  const double same = 0.02 * ground.document.body.height;
  constexpr double uneven = 1.5; // of a step, which is seldom like the next
  const Clip& clip = clipOf(ground.document, ground.clip);
  const double frame = 1.0 / clip.framesPerSecond;
  if (ground.limbs.empty() || clip.endSeconds - clip.startSeconds < 1.5 * frame) {
    return {};
  }
  const std::vector<Vec3> first = poseAt(ground, clip.startSeconds);
  const std::vector<Vec3> second = poseAt(ground, clip.startSeconds + frame);
  const std::vector<Vec3> beforeLast = poseAt(ground, clip.endSeconds - frame);
  const std::vector<Vec3> last = poseAt(ground, clip.endSeconds);
  const auto isApart = [&](std::size_t i) {
    const Vec3 gap = first[i] - last[i];
    const Vec3 step = 0.5 * (second[i] - first[i] + last[i] - beforeLast[i]);
    return glm::length(gap) > same && glm::length(gap - step) > std::max(same, uneven * glm::length(step));
  };
  LimbsApart apart{0, 0.0};
  std::size_t point = 0;
  for (const std::vector<Vec3>& places : ground.places.front()) {
    const std::size_t next = point + places.size();
    bool any = false;
    for (; point < next; ++point) {
      any = any || isApart(point);
      apart.farthest = std::max(apart.farthest, glm::length(first[point] - last[point]));
    }
    apart.count += any ? 1U : 0U;
  }
  return apart;
}

// From where the foot comes down to where it leaves the ground: it is at its place before it rests and after.
Vec2 withContact(const ClipGround& ground, std::size_t leg, Vec2 stand) {
  const double near = 0.02 * ground.document.body.height;
  const double most = std::round(0.1 * ground.framesPerSecond);
  const auto isNear = [&](double frame, double standing) {
    return frame >= 0.0 && frame <= ground.lastFrame &&
           glm::length(ground.placesAt(frame)[leg].back() - ground.placesAt(standing)[leg].back()) < near;
  };
  const Vec2 rest = stand;
  while (rest.x - stand.x < most && isNear(stand.x - 1.0, rest.x)) {
    stand.x -= 1.0;
  }
  while (stand.y - rest.y < most && isNear(stand.y + 1.0, rest.y)) {
    stand.y += 1.0;
  }
  return stand;
}

// Feet that rest low, if only for three frames or on something: what is planted is longer and flatter.
void addRests(ClipGround& ground) {
  for (std::size_t i = 0; i < ground.limbs.size(); ++i) {
    if (!isLeg(ground.limbs[i])) {
      continue;
    }
    std::vector<Vec3> foot;
    std::ranges::transform(ground.places, std::back_inserter(foot),
                           [&](const LimbPlaces& places) { return places[i].back(); });
    for (const rig::Stand& stand :
         rig::standingIn(foot, ground.framesPerSecond, ground.document.body.height)) {
      ground.stands[ground.limbs[i].id].push_back(
          withContact(ground, i, {static_cast<double>(stand.first), static_cast<double>(stand.last)}));
    }
  }
}

// What overlaps is one.
std::vector<Vec2> joined(std::vector<Vec2> stands) {
  std::ranges::sort(stands, {}, &Vec2::x);
  std::vector<Vec2> apart;
  for (const Vec2& stand : stands) {
    if (!apart.empty() && stand.x <= apart.back().y) {
      apart.back().y = std::max(apart.back().y, stand.y);
    } else {
      apart.push_back(stand);
    }
  }
  return apart;
}

bool isIn(const std::vector<Vec2>& stands, double frame) {
  return std::ranges::any_of(stands, [&](const Vec2& s) { return s.x <= frame && frame <= s.y; });
}

// Where each leg stands, and where its foot is down and slow while another one stands: it carries as well,
// though it slides.
std::map<std::string, std::vector<Vec2>> withSlides(const ClipGround& ground) {
  const double near = 0.01 * ground.document.body.height;
  const double slow = 1.5 * ground.document.body.height / ground.framesPerSecond;
  std::map<std::string, std::vector<Vec2>> down = ground.stands;
  for (std::size_t i = 0; i < ground.limbs.size(); ++i) {
    const std::string& leg = ground.limbs[i].id;
    const auto foot = [&](double frame) { return ground.placesAt(frame)[i].back(); };
    const auto height = [&](const LimbPlaces& places) { return places[i].back().y; };
    const double lowest = height(*std::ranges::min_element(ground.places, {}, height));
    for (double frame = 1.0; isLeg(ground.limbs[i]) && frame <= ground.lastFrame; frame += 1.0) {
      const bool isOtherDown = std::ranges::any_of(
          ground.stands, [&](const auto& other) { return other.first != leg && isIn(other.second, frame); });
      if (isOtherDown && foot(frame).y < lowest + near && foot(frame - 1.0).y < lowest + near &&
          glm::length(foot(frame) - foot(frame - 1.0)) < slow) {
        down[leg].emplace_back(frame - 1.0, frame);
      }
    }
    down[leg] = joined(std::move(down[leg]));
  }
  return down;
}

// A floor along which feet slide that never stand still: on most frames the lowest vertex is all but as high.
// It is as low as that ever is, but for what swings far below, as a sword.
std::optional<double> floorOfSlides(const ClipGround& ground) {
  constexpr double same = 0.01; // of the height
  constexpr double near = 0.03; // of the height: a heel or toes that dip
  std::vector<double> lowest = ground.lowestVertices;
  std::ranges::sort(lowest);
  const double usual = lowest[lowest.size() / 2];
  if (ground.soles.empty() || !std::isfinite(usual)) {
    return std::nullopt; // no legs, or no mesh
  }
  const auto isWithin = [&](double share) {
    return [=, reach = share * ground.document.body.height](double height) {
      return std::abs(height - usual) < reach;
    };
  };
  return 2 * std::ranges::count_if(lowest, isWithin(same)) > std::ssize(lowest)
             ? std::optional(*std::ranges::find_if(lowest, isWithin(near)))
             : std::nullopt;
}

} // namespace

double lowestOf(const LimbPlaces& places) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec3>& points : places) {
    for (const Vec3& point : points) {
      lowest = std::min(lowest, point.y);
    }
  }
  return lowest;
}

double straightLength(const std::vector<Vec3>& points) {
  return glm::length(points.back() - points.front());
}

LimbPlaces placesOf(const std::vector<rig::Limb>& limbs, const FrameState& frame) {
  LimbPlaces places;
  for (const rig::Limb& limb : limbs) {
    places.push_back(rig::pointsToLead(limb, frame));
  }
  return places;
}

const LimbPlaces& ClipGround::placesAt(double frame) const {
  const auto last = static_cast<double>(places.size() - 1);
  return places[static_cast<std::size_t>(std::clamp(std::round(frame), 0.0, last))];
}

const std::vector<Vec3>& ClipGround::pointsOf(const std::string& limb, double frame) const {
  const auto place = std::ranges::find(limbs, limb, &rig::Limb::id) - limbs.begin();
  return placesAt(frame)[static_cast<std::size_t>(place)];
}

Vec3 ClipGround::reachOf(const std::string& limb, double frame) const {
  const std::vector<Vec3>& points = pointsOf(limb, frame);
  return points.back() - points.front();
}

std::optional<Vec3> ClipGround::lowestVertexIn(const FrameState& frame) const {
  const skinning::SurfacePart& whole = facts->character().whole();
  return whole.lowest(whole.posed(frame));
}

double ClipGround::lowestVertexAt(double frame) const {
  const auto last = static_cast<double>(lowestVertices.size() - 1);
  return lowestVertices[static_cast<std::size_t>(std::clamp(std::round(frame), 0.0, last))];
}

double ClipGround::leastHeightAt(double frame) const {
  return std::min(groundHeight(), lowestVertexAt(frame));
}

void ClipGround::closeLoop() {
  endsMeet = true;
  wraps = clipOf(document, clip).startSeconds < 1.5 / framesPerSecond && !hasWeight(document, clip);
}

const std::vector<Vec2>& ClipGround::standsOf(const std::string& leg, bool orSlides) const {
  static const std::vector<Vec2> none;
  const std::map<std::string, std::vector<Vec2>>& all = orSlides ? slides : stands;
  const auto found = all.find(leg);
  return found == all.end() ? none : found->second;
}

ClipGround clipGround(const Document& document, int clip) {
  ClipGround ground{document, clip};
  const Clip& motion = clipOf(document, clip);
  ground.framesPerSecond = motion.framesPerSecond;
  ground.lastFrame = std::max(0.0, wholeFrameAtMost(endInFrames(motion)));
  ground.turnFrames =
      std::round(endInFrames(motion) - std::max(0.0, motion.startSeconds * motion.framesPerSecond));
  ground.limbs = allLimbs(document);
  ground.lowest = std::numeric_limits<double>::infinity();
  ground.lowestVertex = ground.lowest;
  ground.facts = std::make_shared<ClipFacts>(document, clip);
  Document source = document; // trails and weight that are there are no part of the ground
  source.trails.clear();
  source.weights.clear();
  const rig::MotionState state = prepareMotion(source, clip);
  for (double frame = 0.0; frame <= ground.lastFrame; frame += 1.0) {
    const FrameState shown = evaluate(source, state, frame / ground.framesPerSecond);
    ground.places.push_back(placesOf(ground.limbs, shown));
    lowerTo(shown, ground.places.back(), ground);
    for (const rig::Limb& limb : ground.limbs) {
      if (isLeg(limb)) {
        ground.soles[limb.id].push_back(rig::endPosition(limb, shown).y -
                                        footDepth(*document.scene, limb, *ground.facts->places(), shown));
      }
    }
  }
  constexpr double near = 0.15; // of the height
  const LimbsApart apart = limbsApart(ground);
  ground.nearlyMeets = apart.count <= ground.limbs.size() / 4 && apart.farthest < near * document.body.height;
  if (apart.count == 0 || endsMeet(document, clip)) {
    ground.closeLoop();
  }
  const StandingFloor& standing = ground.facts->standing();
  if (standing.flies) {
    ground.lowest = -std::numeric_limits<double>::infinity();
    ground.lowestVertex = ground.lowest;
    std::ranges::fill(ground.lowestVertices, ground.lowest);
    return ground;
  }
  for (const rig::Pin& pin : plantedFeet(document, clip, {0.0, ground.lastFrame}).pins) {
    ground.stands[pin.limb].push_back(pin.time.rangeFrames);
  }
  addRests(ground);
  for (auto& [leg, stands] : ground.stands) {
    stands = joined(std::move(stands));
  }
  ground.slides = withSlides(ground);
  ground.floor = standing.floor ? standing.floor : floorOfSlides(ground);
  return ground;
}

} // namespace stretch::app
