#include "app/evaluate/hand_place.h"

#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "app/evaluate/evaluate.h"
#include "rig/reach/bind_places.h"

namespace stretch::app {

namespace {

// Of the part of the mesh that follows the hand, else the hand's joint.
Vec3 middleOfHand(const Document& document, const rig::Limb& limb, const FrameState& frame) {
  const NodeIndex hand = limb.endNode.exists() ? limb.endNode : limb.joints.back();
  const rig::BindPlaces places = rig::bindPlaces(*document.scene);
  const Bounds& box = places.meshes[at(hand)];
  if (box.empty()) {
    return rig::endPosition(limb, frame);
  }
  const Mat4 moved = frame.worlds[at(hand)] * glm::inverse(places.worlds[at(hand)]);
  return transformPoint(moved, 0.5 * (box.low + box.high));
}

} // namespace

Result<Vec3> placeInHands(const Document& document, const PropFile& file) {
  if (document.clips == nullptr || file.clip < 0 || at(file.clip) >= document.clips->size()) {
    return Error{"the file has no such clip", fmt::format("clip {}", file.clip),
                 "open a file with an animation"};
  }
  if (file.hands.empty()) {
    return Error{"no hand is to hold it", file.path.string(), "name one"};
  }
  if (!std::isfinite(file.frame)) {
    return Error{"the frame at which it is taken is no number", file.path.string(),
                 "give a frame of the clip"};
  }
  const Document adjusted = adjustedOnly(document);
  const double seconds = file.frame / clipOf(adjusted, file.clip).framesPerSecond;
  const FrameState frame = evaluate(adjusted, prepareMotion(adjusted, file.clip), seconds);
  Vec3 sum(0.0);
  for (const std::string& hand : file.hands) {
    const rig::Limb* const limb = findLimb(document, hand);
    if (limb == nullptr) {
      return Error{"the character has no such limb", hand, "give left-arm or right-arm"};
    }
    sum += middleOfHand(document, *limb, frame);
  }
  return sum / static_cast<double>(file.hands.size());
}

Result<AddedProp> putIntoHands(const Document& document, PropFile file) {
  const Result<Vec3> place = placeInHands(document, file);
  if (!place) {
    return place.error();
  }
  file.place = *place;
  return holdPropFile(document, file);
}

} // namespace stretch::app
