#include "ui/viewport/shown_controllers.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "app/commands/selection.h"
#include "ui/render/picking.h"

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

} // namespace

bool showsControllers(const app::Session& session, const ViewportOverlays& overlays) {
  return overlays.controllers || !session.view().selectedControllers.empty();
}

std::vector<ShownController> shownControllers(app::Session& session, const ViewportOverlays& overlays) {
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
  const std::vector<std::string>& selected = session.view().selectedControllers;
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
