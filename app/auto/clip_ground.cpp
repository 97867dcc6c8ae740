#include "app/auto/clip_ground.h"

#include <algorithm>
#include <limits>

#include "app/evaluate/evaluate.h"
#include "app/evaluate/planted_feet.h"
#include "app/evaluate/way_back.h"
#include "app/standing_floor.h"
#include "core/anim/frames.h"

namespace stretch::app {

LimbPlaces placesOf(const std::vector<rig::Limb>& limbs, const FrameState& frame) {
  LimbPlaces places;
  for (const rig::Limb& limb : limbs) {
    places.push_back(rig::pointsToLead(limb, frame));
  }
  return places;
}

const LimbPlaces& ClipGround::placesAt(double frame) const {
  const double last = static_cast<double>(places.size() - 1);
  return places[static_cast<std::size_t>(std::clamp(std::round(frame), 0.0, last))];
}

const std::vector<Vec2>& ClipGround::standsOf(const std::string& leg) const {
  static const std::vector<Vec2> none;
  const auto found = stands.find(leg);
  return found == stands.end() ? none : found->second;
}

ClipGround clipGround(const Document& document, int clip) {
  ClipGround ground{document, clip};
  const Clip& motion = clipOf(document, clip);
  ground.framesPerSecond = motion.framesPerSecond;
  ground.lastFrame = std::max(0.0, wholeFrameAtMost(endInFrames(motion)));
  ground.endsMeet = endsMeet(document, clip);
  ground.limbs = allLimbs(document);
  ground.lowest = std::numeric_limits<double>::infinity();
  Document source = document; // trails and weight that are there are no part of the ground
  source.trails.clear();
  source.weights.clear();
  const rig::MotionState state = prepareMotion(source, clip);
  for (double frame = 0.0; frame <= ground.lastFrame; frame += 1.0) {
    ground.places.push_back(placesOf(ground.limbs, evaluate(source, state, frame / ground.framesPerSecond)));
    for (const std::vector<Vec3>& points : ground.places.back()) {
      for (const Vec3& point : points) {
        ground.lowest = std::min(ground.lowest, point.y);
      }
    }
  }
  for (const rig::Pin& pin : plantedFeet(document, clip, {0.0, ground.lastFrame}).pins) {
    ground.stands[pin.limb].push_back(pin.time.rangeFrames);
  }
  ground.floor = floorHeight(document, clip);
  return ground;
}

} // namespace stretch::app
