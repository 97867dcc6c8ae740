#include "app/edits/pose/adjustment_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <glm/geometric.hpp>

namespace stretch::app {

namespace {

constexpr double sameKeyFrame = 1e-3;

bool hasFiniteNumbers(const rig::OffsetKey& key) {
  const Vec3 sum = key.move + key.turn + key.moveSlope + key.turnSlope;
  return std::isfinite(sum.x + sum.y + sum.z + key.frame + key.value + key.valueSlope);
}

Vec2 timeOf(const rig::Adjustment& adjustment) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  return adjustment.rangeFrames.value_or(Vec2(-endless, endless));
}

bool overlap(const rig::Adjustment& a, const rig::Adjustment& b) {
  const Vec2 first = timeOf(a);
  const Vec2 second = timeOf(b);
  return a.controller == b.controller && a.clip == b.clip && first.x < second.y && second.x < first.y;
}

Status checkTimes(const Document& document, const rig::Adjustment& adjustment, Entry entry) {
  const Clip& clip = clipOf(document, adjustment.clip);
  const bool mayBeCut = entry == Entry::file; // The clip, since the work was saved.
  const double last = mayBeCut ? std::numeric_limits<double>::infinity()
                               : std::ceil(clip.endSeconds * clip.framesPerSecond - sameKeyFrame);
  const Vec2 range = adjustment.rangeFrames.value_or(Vec2(0.0, std::max(last, 0.0)));
  if (!std::isfinite(range.x + (adjustment.rangeFrames ? range.y : 0.0)) ||
      (adjustment.rangeFrames && !(range.x < range.y))) {
    return Error{"the range has no length", adjustment.controller, "set its end after its start"};
  }
  if (range.x > last || range.y < 0.0) {
    return Error{fmt::format("the range lies outside the clip, which has the frames 0 to {:g}", last),
                 adjustment.controller, "give frames of the clip"};
  }
  for (std::size_t i = 0; i < adjustment.keys.size(); ++i) {
    const double frame = adjustment.keys[i].frame;
    if (frame < range.x - sameKeyFrame || frame > range.y + sameKeyFrame) {
      return Error{fmt::format("the key at frame {:g} lies outside of {:g} to {:g}", frame, range.x, range.y),
                   adjustment.controller, "give frames of the range, or of the clip where there is none"};
    }
    if (i > 0 && frame - adjustment.keys[i - 1].frame < sameKeyFrame) {
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

Status checkKeys(const Document& document, const rig::ControllerList& list,
                 const rig::Adjustment& adjustment) {
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

Status checkAdjustment(const Document& document, const rig::ControllerList& list,
                       const rig::Adjustment& adjustment, Entry entry) {
  if (document.clips == nullptr || adjustment.clip < 0 || at(adjustment.clip) >= document.clips->size()) {
    return Error{"the file has no such clip", fmt::format("clip {}", adjustment.clip),
                 "open a file with an animation"};
  }
  Status keys = checkKeys(document, list, adjustment);
  return keys ? checkTimes(document, adjustment, entry) : keys;
}

} // namespace

rig::ControllerList controllersOf(const Document& document) {
  return rig::controllersOf(*document.scene, document.body.limbs, document.body.hips);
}

std::vector<rig::Controller> jointControllersOf(const Document& document) {
  return rig::jointControllers(*document.scene, document.body.limbs, document.body.hips);
}

Result<rig::Controller> findController(const Document& document, const rig::ControllerList& list,
                                       const std::string& id) {
  return rig::controllerNamed(*document.scene, document.body.limbs, document.body.hips, list, id);
}

Result<Document> placeAdjustments(const Document& document, std::span<const rig::Adjustment> wanted,
                                  Entry entry) {
  Document changed = document;
  const rig::ControllerList list = controllersOf(document);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (const Status fits = checkAdjustment(document, list, wanted[i], entry); !fits) {
      return fits.error();
    }
    const auto before = wanted.first(i);
    if (std::ranges::any_of(before,
                            [&](const rig::Adjustment& other) { return overlap(other, wanted[i]); })) {
      return Error{"two adjustments of one controller overlap in time", wanted[i].controller,
                   "give each a range of its own, or join their keys"};
    }
    std::erase_if(changed.adjustments, [&](const rig::Adjustment& old) {
      return std::ranges::find(before, old) == before.end() && overlap(old, wanted[i]);
    });
    changed.adjustments.push_back(wanted[i]);
  }
  return changed;
}

Document removeAdjustments(const Document& document, const std::string& controller, int clip) {
  Document changed = document;
  std::erase_if(changed.adjustments, [&](const rig::Adjustment& adjustment) {
    return adjustment.controller == controller && adjustment.clip == clip;
  });
  return changed;
}

} // namespace stretch::app
