#include <cmath>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/named.h"
#include "app/things/checks.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

bool hasFiniteNumbers(const rig::OffsetKey& key) {
  const Vec3 sum = key.move + key.turn + key.moveSlope + key.turnSlope;
  return std::isfinite(sum.x + sum.y + sum.z + key.frame + key.value + key.valueSlope);
}

Status checkTimes(const Ground& ground, const rig::Adjustment& adjustment) {
  const double last = lastFrameFor(ground, adjustment.clip);
  const Vec2 range = adjustment.rangeFrames.value_or(Vec2(0.0, last));
  if (!std::isfinite(range.x + (adjustment.rangeFrames ? range.y : 0.0)) ||
      (adjustment.rangeFrames && !(range.x < range.y))) {
    return Error{"the range has no length", adjustment.controller, "set its end after its start"};
  }
  if ((range.x > last && !stoodAt(ground.before, adjustment, range.x)) || range.y < 0.0) {
    return outsideClip("the range", last, adjustment.controller);
  }
  for (std::size_t i = 0; i < adjustment.keys.size(); ++i) {
    const double frame = adjustment.keys[i].frame;
    const bool isPast = frame > range.y + frameTolerance &&
                        (adjustment.rangeFrames || !stoodAt(ground.before, adjustment, frame));
    if (frame < range.x - frameTolerance || isPast) {
      return Error{fmt::format("the key at frame {:g} lies outside of {:g} to {:g}", frame, range.x, range.y),
                   adjustment.controller, "give frames of the range, or of the clip where there is none"};
    }
    if (i > 0 && frame - adjustment.keys[i - 1].frame < frameTolerance) {
      return Error{fmt::format("two keys stand at frame {:g}", frame), adjustment.controller,
                   "leave one of them out"};
    }
  }
  return Success{};
}

Status checkOffset(const rig::OffsetKey& key, const rig::Controller& controller, double height) {
  constexpr double farthest = 1000.0; // heights of the character
  constexpr double mostTurns = 100.0;
  const bool moves = key.move != Vec3(0.0) || key.moveSlope != Vec3(0.0);
  const bool turns = key.turn != Vec3(0.0) || key.turnSlope != Vec3(0.0);
  if (moves && !controller.moves) {
    return Error{"turns and does not move", controller.id, "leave 'move' out"};
  }
  if (turns && !controller.turns) {
    return Error{"moves and does not turn", controller.id, "leave 'turn' out"};
  }
  const double way = std::max(glm::length(key.move), glm::length(key.moveSlope));
  const double angle = std::max(glm::length(key.turn), glm::length(key.turnSlope));
  if (way > farthest * height || angle > mostTurns * 2.0 * pi) {
    return Error{fmt::format("the offset at frame {:g} is out of proportion", key.frame), controller.id,
                 "move by at most a thousand heights of the character, turn by at most a hundred turns"};
  }
  return Success{};
}

Status checkValueOf(const rig::OffsetKey& key, const rig::Attribute& attribute) {
  constexpr double most = 1000.0;
  if (std::abs(key.value) > most || std::abs(key.valueSlope) > most) {
    return Error{fmt::format("the value at frame {:g} is out of proportion", key.frame), attribute.id,
                 fmt::format("give a number from {:g} to {:g}", attribute.minimum, attribute.maximum)};
  }
  return Success{};
}

Status checkKeys(const Ground& ground, const rig::Adjustment& adjustment) {
  const Document& document = ground.document;
  const rig::ControllerList& list = *ground.controllers;
  const rig::Attribute* const attribute = list.attribute(adjustment.controller);
  const Result<rig::Controller> controller = attribute != nullptr
                                                 ? Result<rig::Controller>(rig::Controller{})
                                                 : findController(document, list, adjustment.controller);
  if (!controller) {
    return controller.error();
  }
  if (adjustment.keys.empty()) {
    return Error{"has no keys", adjustment.controller, "give one, such as {\"frame\": 0, ...}"};
  }
  for (const rig::OffsetKey& key : adjustment.keys) {
    if (!hasFiniteNumbers(key)) {
      return Error{"a number of a key is not finite", adjustment.controller, "give a number"};
    }
    Status fits = attribute != nullptr ? checkValueOf(key, *attribute)
                                       : checkOffset(key, *controller, document.body.height);
    if (!fits) {
      return fits;
    }
  }
  return Success{};
}

} // namespace

Status checkAlone(const Ground& ground, const rig::Adjustment& adjustment) {
  if (Status clip = checkClip(ground.document, adjustment.clip); !clip) {
    return clip;
  }
  Status keys = checkKeys(ground, adjustment);
  return keys ? checkTimes(ground, adjustment) : keys;
}

} // namespace stretch::app
