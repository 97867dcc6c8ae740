#include "app/standing_floor.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/anim/frames.h"
#include "rig/limb.h"
#include "rig/motion/evaluate.h"
#include "rig/motion/floor.h"
#include "rig/motion/part_motion.h"
#include "rig/motion/solve_holds.h"
#include "rig/reach/bind_places.h"

namespace stretch::app {

namespace {

// How a foot hangs around its tip: where the limb comes from and goes back to as well.
constexpr int beforeAndAfter = 4;
constexpr double stepSeconds = 0.03;

// From the leg's end down to the lowest vertex of what hangs on it, in the bind pose.
double soleDepth(const Scene& scene, const rig::Limb& leg, const rig::BindPlaces& places) {
  double lowest = rig::endPosition(leg, places.worlds).y;
  const double ankle = lowest;
  const NodeIndex foot = leg.endNode.exists() ? leg.endNode : leg.joints.back();
  for (const NodeIndex node : withSubtrees(scene, {foot})) {
    const Bounds& mesh = places.meshes[at(node)];
    lowest = mesh.empty() ? lowest : std::min(lowest, mesh.low.y);
  }
  return ankle - lowest;
}

// How high the highest of the blocks is that a foot comes down on soon after a time.
std::optional<double> blockTopSoonUnder(const Document& document, int clip, const rig::Limb& leg, double sole,
                                        const std::vector<Bounds>& blocks, double timeSeconds) {
  constexpr int steps = 14;
  constexpr double standing = 1.5; // of the height of the ankle above the sole: on its way to the ground
  const Scene& scene = *document.scene;
  std::optional<double> highest;
  for (int step = 1; step <= steps && !blocks.empty(); ++step) {
    const Vec3 ankle = rig::endPosition(
        leg, rig::sampledFrame(scene, clipOf(document, clip), timeSeconds + step * stepSeconds));
    const std::optional<double> top = blockTopUnder(blocks, ankle);
    highest = top && ankle.y - *top < standing * sole ? std::max(highest.value_or(*top), *top) : highest;
  }
  return highest;
}

bool isHeldIn(const Document& document, int clip, NodeIndex node) {
  return std::ranges::any_of(document.holds.props, [&](const rig::Prop& prop) {
    const NodeIndex held = rig::propNode(*document.scene, prop.node);
    return prop.clip == clip && held.exists() && isAncestorOrSelf(*document.scene, held, node);
  });
}

// No part of the body, not skinned, not held, and neither it nor what carries it has keys in the clip.
bool isBlock(const Document& document, int clip, NodeIndex node) {
  const Scene& scene = *document.scene;
  const auto carriesIt = [&](NodeIndex other) { return isAncestorOrSelf(scene, other, node); };
  const bool isOfBody =
      carriesIt(document.body.hips) || std::ranges::any_of(allLimbs(document), [&](const rig::Limb& limb) {
        return carriesIt(limb.joints.front());
      });
  return !isOfBody && !isHeldIn(document, clip, node) && scene.nodes[at(node)].mesh >= 0 &&
         scene.nodes[at(node)].skin < 0 &&
         std::ranges::none_of(clipOf(document, clip).tracks,
                              [&](const CopyOnWrite<Track>& track) { return carriesIt(track->node); });
}

std::vector<Bounds> blocksIn(const Document& document, int clip, const rig::BindPlaces& places) {
  std::vector<Bounds> blocks;
  for (std::size_t i = 0; i < places.meshes.size(); ++i) {
    if (!places.meshes[i].empty() && isBlock(document, clip, NodeIndex(i))) {
      blocks.push_back(places.meshes[i]);
    }
  }
  return blocks;
}

// How far places of a limb stray from where they are at first, world units.
struct Stray {
  std::vector<Vec3> first = {};
  double base = 0.0;
  double end = 0.0;

  void add(const std::vector<Vec3>& points) {
    first = first.empty() ? points : first;
    base = std::max(base, glm::distance(points.front(), first.front()));
    end = std::max(end, glm::distance(points.back(), first.back()));
  }
};

double lowestOf(const std::vector<rig::Limb>& limbs, bool (*isAsked)(const rig::LimbPlace&),
                const FrameState& pose) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const rig::Limb& limb : limbs) {
    lowest = isAsked(limb) ? std::min(lowest, std::ranges::min(rig::limbPoints(limb, pose), {}, &Vec3::y).y)
                           : lowest;
  }
  return lowest;
}

// How far the wings reach down from where they hang, 0 at most.
double wingsDown(const std::vector<rig::Limb>& limbs, const FrameState& pose) {
  double down = 0.0;
  for (const rig::Limb& limb : limbs) {
    if (limb.kind == rig::LimbKind::wing) {
      const std::vector<Vec3> points = rig::limbPoints(limb, pose);
      down = std::min(down, std::ranges::min(points, {}, &Vec3::y).y - points.front().y);
    }
  }
  return down;
}

bool isWing(const rig::LimbPlace& limb) {
  return limb.kind == rig::LimbKind::wing;
}

// See StandingFloor::flies. Legs that rest as the body does tell nothing: they hang still in the air, too.
bool beatsInTheAir(const Document& document, int clip, const rig::BindPlaces& places) {
  const double clearly = 0.1 * document.body.height;
  const double still = 0.02 * document.body.height;
  constexpr double often = 0.25; // of the frames
  constexpr double mostFrames = 240.0;
  const std::vector<rig::Limb> limbs = allLimbs(document);
  if (std::ranges::none_of(limbs, isWing)) {
    return false;
  }
  FrameState pose;
  pose.worlds = places.worlds;
  double standing = lowestOf(
      limbs, [](const rig::LimbPlace&) { return true; }, pose);
  for (const Bounds& mesh : places.meshes) {
    standing = mesh.empty() ? standing : std::min(standing, mesh.low.y);
  }
  const Clip& motion = clipOf(document, clip);
  const double last = wholeFrameAtMost(endInFrames(motion));
  int looked = 0;
  int below = 0;
  Vec2 downFromTo(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  std::vector<Stray> strays(limbs.size());
  for (double frame = 0.0; frame <= last; frame += std::max(1.0, last / mostFrames), ++looked) {
    pose = rig::sampledFrame(*document.scene, motion, frame / motion.framesPerSecond);
    const double feet = lowestOf(limbs, rig::isLeg, pose);
    const double wings = lowestOf(limbs, isWing, pose);
    const double down = wingsDown(limbs, pose);
    downFromTo = {std::min(downFromTo.x, down), std::max(downFromTo.y, down)};
    below += wings < std::min(standing, feet) - clearly ? 1 : 0;
    for (std::size_t i = 0; i < limbs.size(); ++i) {
      strays[i].add(rig::limbPoints(limbs[i], pose));
    }
  }
  const auto stands = [&](const rig::Limb& limb) {
    const Stray& stray = strays[static_cast<std::size_t>(&limb - limbs.data())];
    return isLeg(limb) && stray.end <= still && stray.base > still;
  };
  const bool beat = downFromTo.y - downFromTo.x > clearly;
  return beat && below > 0 && below >= often * looked && std::ranges::none_of(limbs, stands);
}

} // namespace

double footDepth(const Scene& scene, const rig::Limb& leg, const rig::BindPlaces& places,
                 const FrameState& frame) {
  const double ankle = rig::endPosition(leg, frame).y;
  double lowest = ankle;
  const NodeIndex foot = leg.endNode.exists() ? leg.endNode : leg.joints.back();
  for (const NodeIndex node : withSubtrees(scene, {foot})) {
    const Bounds& box = places.meshes[at(node)];
    const Mat4 moved = frame.worlds[at(node)] * glm::inverse(places.worlds[at(node)]);
    for (int corner = 0; corner < 8 && !box.empty(); ++corner) {
      const Vec3 point((corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                       (corner & 4) != 0 ? box.high.z : box.low.z);
      lowest = std::min(lowest, (moved * Vec4(point, 1.0)).y);
    }
  }
  return ankle - lowest;
}

std::optional<double> soleHeight(const Document& document, const rig::BindPlaces& places) {
  std::optional<double> lowest;
  for (const rig::Limb& limb : document.body.limbs) {
    if (isLeg(limb)) {
      const double sole = rig::endPosition(limb, places.worlds).y - soleDepth(*document.scene, limb, places);
      lowest = std::min(lowest.value_or(sole), sole);
    }
  }
  return lowest;
}

StandingFloor standingFloor(const Document& document, int clip, const rig::BindPlaces& places) {
  StandingFloor standing;
  standing.flies = beatsInTheAir(document, clip, places);
  for (const rig::Limb& limb : document.body.limbs) {
    const std::optional<double> height =
        isLeg(limb) && !standing.flies ? rig::standingHeight(*document.scene, clipOf(document, clip), limb)
                                       : std::nullopt;
    if (height) {
      const double sole = *height - soleDepth(*document.scene, limb, places);
      standing.floor = std::min(standing.floor.value_or(sole), sole);
    }
  }
  return standing;
}

std::optional<double> standingEnd(const Document& document, const rig::Limb& leg,
                                  const rig::BindPlaces& places, const StandingFloor& standing) {
  return standing.floor ? std::optional(*standing.floor + soleDepth(*document.scene, leg, places))
                        : std::nullopt;
}

std::optional<double> floorHeight(const Document& document, int clip) {
  return standingFloor(document, clip, rig::bindPlaces(*document.scene)).floor;
}

std::vector<Bounds> blocksOf(const Document& document, int clip) {
  return blocksIn(document, clip, rig::bindPlaces(*document.scene));
}

std::optional<double> blockTopUnder(const std::vector<Bounds>& blocks, const Vec3& place) {
  std::optional<double> top;
  for (const Bounds& box : blocks) {
    const bool isUnder = box.low.x <= place.x && place.x <= box.high.x && box.low.z <= place.z &&
                         place.z <= box.high.z && box.high.y <= place.y;
    top = isUnder ? std::max(top.value_or(box.high.y), box.high.y) : top;
  }
  return top;
}

std::optional<rig::StopPlane> floorForLeg(const Document& document, int clip, const rig::Limb& leg,
                                          double tipFrame) {
  const rig::BindPlaces places = rig::bindPlaces(*document.scene);
  return floorForLeg(document, clip, leg, tipFrame, places, standingFloor(document, clip, places));
}

std::optional<rig::StopPlane> floorForLeg(const Document& document, int clip, const rig::Limb& leg,
                                          double tipFrame, const rig::BindPlaces& places,
                                          const StandingFloor& standing) {
  const std::optional<double> floor = standing.floor;
  if (!floor) {
    return std::nullopt;
  }
  const Clip& motion = clipOf(document, clip);
  const auto frameAt = [&](double seconds) { return rig::sampledFrame(*document.scene, motion, seconds); };
  const double tipSeconds = tipFrame / motion.framesPerSecond;
  double depth = 0.0;
  for (int step = -beforeAndAfter; step <= beforeAndAfter; ++step) {
    depth =
        std::max(depth, footDepth(*document.scene, leg, places, frameAt(tipSeconds + step * stepSeconds)));
  }
  const Vec3 ankle = rig::endPosition(leg, frameAt(tipSeconds));
  const std::vector<Bounds> blocks = blocksIn(document, clip, places);
  const double sole = soleDepth(*document.scene, leg, places);
  const double ground =
      std::max({*floor, blockTopUnder(blocks, ankle).value_or(*floor),
                blockTopSoonUnder(document, clip, leg, sole, blocks, tipSeconds).value_or(*floor)});
  return rig::StopPlane{{0.0, ground + depth, 0.0}, {0.0, -1.0, 0.0}};
}

} // namespace stretch::app
