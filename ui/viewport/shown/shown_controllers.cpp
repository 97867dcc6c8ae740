#include "ui/viewport/shown/shown_controllers.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "app/commands/table/selection.h"
#include "app/locators/locator_edits.h"
#include "ui/render/picking/picking.h"

namespace stretch::ui {

namespace {

BodySide sideOf(const std::string& id) {
  return id.starts_with("left-")    ? BodySide::left
         : id.starts_with("right-") ? BodySide::right
                                    : BodySide::centre;
}

// From near the joint to the ball at its end, so that neither is covered.
void addPole(const rig::PlacedController& placed, ControllerPicture& picture) {
  constexpr double startShare = 0.25;
  picture.lines.push_back({glm::mix(*placed.jointWorld, placed.placeWorld, startShare), placed.placeWorld});
  picture.knob = placed.placeWorld;
}

ControllerPicture pictureOf(const rig::PlacedController& placed,
                            const std::vector<rig::ControllerShape>& shapes) {
  ControllerPicture picture;
  picture.side = sideOf(placed.id);
  if (placed.jointWorld) {
    addPole(placed, picture);
    return picture;
  }
  const auto shape = std::ranges::find(shapes, placed.id, &rig::ControllerShape::controller);
  if (shape == shapes.end()) {
    picture.ring = placed.placeWorld;
    return picture;
  }
  for (const std::vector<Vec3>& line : shape->lines) {
    std::vector<Vec3>& points = picture.lines.emplace_back();
    for (const Vec3& point : line) {
      points.push_back(placed.placeWorld + placed.orientationWorld * point);
    }
  }
  return picture;
}

std::optional<double> pixelsTo(const View& view, const std::optional<Vec3>& place, const Vec2& mousePixels) {
  const auto seen = place ? projectToPixels(view, *place) : std::nullopt;
  return seen ? std::optional(glm::distance(seen->pixels, mousePixels)) : std::nullopt;
}

// Half the way to the nearest other ring, for each picture that has one.
void giveRings(std::vector<ControllerPicture>& pictures) {
  for (ControllerPicture& picture : pictures) {
    for (const ControllerPicture& other : pictures) {
      if (&other != &picture && picture.ring && other.ring) {
        const double half = 0.5 * glm::distance(*picture.ring, *other.ring);
        picture.ringRoom = std::min(half, picture.ringRoom.value_or(half));
      }
    }
  }
}

// From beside the joint above, so that the mouse finds that one too; in dashes where the place is a guess.
void addBone(const Vec3& from, const Vec3& to, bool sure, ControllerPicture& picture) {
  constexpr double startShare = 0.2;
  constexpr int dashes = 5;
  if (sure) {
    picture.lines.push_back({glm::mix(from, to, startShare), to});
    return;
  }
  for (int dash = 0; dash < dashes; ++dash) {
    const double step = (1.0 - startShare) / dashes;
    const double start = startShare + step * dash;
    picture.lines.push_back({glm::mix(from, to, start), glm::mix(from, to, start + 0.5 * step)});
  }
}

ShownController shownLocator(const rig::Locators& locators, const rig::Locator& locator) {
  constexpr double sureFrom = 0.5;
  ShownController shown;
  shown.placed.id = locator.name;
  shown.placed.placeWorld = locator.position;
  shown.placed.orientationWorld = locator.orientation;
  shown.placed.carrierAxesWorld = glm::mat3_cast(locator.orientation);
  const rig::BodySide side = rig::sideOfLocator(locator.name);
  shown.picture.side = side == rig::BodySide::left    ? BodySide::left
                       : side == rig::BodySide::right ? BodySide::right
                                                      : BodySide::centre;
  if (locator.confidence >= sureFrom) {
    shown.picture.ring = locator.position;
  } else {
    shown.picture.knob = locator.position;
  }
  if (const rig::Locator* const parent =
          rig::findLocator(locators, rig::parentLocator(locators, locator.name))) {
    addBone(parent->position, locator.position, locator.confidence >= sureFrom, shown.picture);
  }
  return shown;
}

std::vector<ShownController> shownLocators(const rig::Locators& locators) {
  std::vector<ShownController> shown;
  for (const rig::Locator& locator : locators.list) {
    shown.push_back(shownLocator(locators, locator));
  }
  return shown;
}

} // namespace

const std::vector<std::string>& selectedHandles(const app::Session& session) {
  return app::showsLocators(session) ? session.view().selection.locators()
                                     : session.view().selection.controllers();
}

bool showsControllers(const app::Session& session, const ViewportOverlays& overlays) {
  return overlays.controllers || !session.view().selection.controllers().empty();
}

std::vector<ShownController> shownControllers(app::Session& session, const ViewportOverlays& overlays) {
  if (app::showsLocators(session)) {
    return shownLocators(session.document().locators);
  }
  std::vector<ShownController> shown;
  if (!showsControllers(session, overlays) || session.view().showOriginal) {
    return shown;
  }
  const std::vector<rig::ControllerShape>& shapes = session.controllerShapes();
  for (const rig::PlacedController& placed : session.controllersAt(session.view().frame)) {
    const bool onJoint = placed.kind == rig::ControllerKind::joint;
    if (!onJoint || overlays.skeleton || app::isControllerSelected(session, placed.id)) {
      shown.push_back({placed, pictureOf(placed, shapes)});
    }
  }
  return shown;
}

std::optional<std::string> pickController(const View& view, const std::vector<ShownController>& shown,
                                          const Vec2& mousePixels) {
  constexpr double hitPoints = 20.0;
  std::optional<std::string> best;
  double bestPixels = hitPoints * view.viewport.pixelsPerPoint;
  const auto take = [&](const ShownController& controller, std::optional<double> pixels) {
    if (pixels && *pixels < bestPixels) {
      best = controller.placed.id;
      bestPixels = *pixels;
    }
  };
  for (const ShownController& controller : shown) {
    for (const std::vector<Vec3>& line : controller.picture.lines) {
      const auto hit = pickPolyline(view, line, mousePixels, hitPoints);
      take(controller, hit ? std::optional(hit->distancePixels) : std::nullopt);
    }
    take(controller, pixelsTo(view, controller.picture.knob, mousePixels));
    take(controller, pixelsTo(view, controller.picture.ring, mousePixels));
  }
  return best;
}

std::vector<std::string> controllersInBox(const View& view, const std::vector<ShownController>& shown,
                                          const Vec2& low, const Vec2& high) {
  std::vector<std::string> inside;
  for (const ShownController& controller : shown) {
    const auto place = projectToPixels(view, controller.placed.placeWorld);
    if (place && place->pixels.x >= low.x && place->pixels.x <= high.x && place->pixels.y >= low.y &&
        place->pixels.y <= high.y) {
      inside.push_back(controller.placed.id);
    }
  }
  return inside;
}

std::optional<ControllerHandles> controllerHandles(const app::Session& session,
                                                   const std::vector<ShownController>& shown) {
  const std::vector<std::string>& selected = selectedHandles(session);
  const ShownController* const last = selected.empty() ? nullptr : findShown(shown, selected.back());
  return last == nullptr ? std::nullopt
                         : std::optional(ControllerHandles{last->placed.placeWorld, last->placed.moves,
                                                           last->placed.turns});
}

std::vector<ControllerPicture> controllerPictures(const std::vector<ShownController>& shown,
                                                  const std::vector<std::string>& selected,
                                                  const std::string& hovered) {
  std::vector<ControllerPicture> pictures;
  for (const ShownController& controller : shown) {
    pictures.push_back(controller.picture);
    pictures.back().selected = std::ranges::find(selected, controller.placed.id) != selected.end();
    pictures.back().hovered = controller.placed.id == hovered;
  }
  giveRings(pictures);
  return pictures;
}

const ShownController* findShown(const std::vector<ShownController>& shown, const std::string& id) {
  const auto found =
      std::ranges::find_if(shown, [&](const ShownController& one) { return one.placed.id == id; });
  return found == shown.end() ? nullptr : &*found;
}

} // namespace stretch::ui
