#include <algorithm>
#include <map>
#include <memory>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/change.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/mouse_stage.h"
#include "ui/viewport/tools.h"

using namespace stretch;
using namespace stretch::ui;
using test::MouseStage;

// What lies under the mouse at each place of the viewport, and what each button and modifier does there.

namespace {

struct Sight {
  const char* name;
  void (*prepare)(MouseStage&);
};

void exaggerateArm(MouseStage& stage) {
  app::Session& session = stage.session();
  session.edit(test::withNewTrail(session.document(), {.startFrame = 2.0, .endFrame = 12.0}), "Exaggerate");
  app::selectTrail(session, session.document().trails.front().id);
  session.view().frame = 20.0;
}

const Sight sights[] = {
    {"the body alone", [](MouseStage&) {}},
    {"a trail", exaggerateArm},
    {"a sphere with tangents",
     [](MouseStage& stage) {
       exaggerateArm(stage);
       app::Session& session = stage.session();
       session.view().selection.editTrails().spheres = {
           app::placedSpheres(session, session.view().selection.trail())[1].frame};
     }},
    {"controllers",
     [](MouseStage& stage) {
       stage.ui.overlays.controllers = true;
       stage.session().view().frame = 20.0;
     }},
    {"handles of a hand",
     [](MouseStage& stage) {
       stage.session().view().frame = 20.0;
       app::selectController(stage.session(), "left-hand", false);
     }},
    {"handles of an elbow that turns",
     [](MouseStage& stage) {
       stage.ui.overlays.controllers = stage.ui.overlays.skeleton = true;
       app::selectController(stage.session(), "head", false);
     }},
};

std::unique_ptr<MouseStage> stageOf(const Sight& sight) {
  auto stage = std::make_unique<MouseStage>(test::boxer());
  sight.prepare(*stage);
  stage->frame();
  stage->frame();
  return stage;
}

std::string underMouse(const ViewportState& viewport) {
  std::string text;
  if (viewport.hoveredHandle) {
    text += fmt::format(" handle {} {}", static_cast<int>(viewport.hoveredHandle->kind),
                        viewport.hoveredHandle->axis);
  }
  text += viewport.hoveredController.empty() ? "" : " controller " + viewport.hoveredController;
  text += viewport.hoveredSphere ? fmt::format(" sphere {:.4g}", *viewport.hoveredSphere) : "";
  text += viewport.hoveredAxis ? fmt::format(" axis {}", *viewport.hoveredAxis) : "";
  text += viewport.hoveredTangent ? fmt::format(" tangent {}", *viewport.hoveredTangent) : "";
  text += viewport.hoveredTrail != 0 ? fmt::format(" trail {}", viewport.hoveredTrail) : "";
  text += viewport.hoveredLimb.empty() ? "" : " " + viewport.hoveredLimb;
  text += viewport.hoveredEnd ? " end" : "";
  return text.empty() ? " nothing" : text;
}

/// The kind of what is under the mouse: of handles each one, of others one stands for all.
std::string kindOf(const ViewportState& viewport) {
  std::string kind = fmt::format("{} {} {} {} {} {} {}", viewport.hoveredController.empty(),
                                 viewport.hoveredSphere.has_value(), viewport.hoveredAxis.value_or(9),
                                 viewport.hoveredTangent.has_value(), viewport.hoveredTrail,
                                 viewport.hoveredLimb.empty(), viewport.hoveredEnd);
  if (viewport.hoveredHandle) {
    kind +=
        fmt::format(" {} {}", static_cast<int>(viewport.hoveredHandle->kind), viewport.hoveredHandle->axis);
  }
  return kind;
}

/// A place where something is under the mouse.
struct HitPlace {
  std::string under;
  Vec2 at;
};
using HitPlaces = std::map<std::string, HitPlace>;

constexpr int step = 7; ///< Pixels between the places that are tried.

/// Row by row: how many places in a line have the same under them.
std::string placesText(MouseStage& stage, HitPlaces& places) {
  std::string text;
  for (int y = 60; y < 560; y += step) {
    std::string row;
    std::string last;
    int count = 0;
    const auto tell = [&] {
      row += count > 0 ? fmt::format(" , {} of{}", count, last) : "";
      count = 0;
    };
    for (int x = 220; x < 640; x += step) {
      stage.pointAt(Vec2(x, y));
      const std::string under = underMouse(stage.viewport);
      places.try_emplace(kindOf(stage.viewport), HitPlace{under, Vec2(x, y)});
      if (under != last) {
        tell();
      }
      last = under;
      ++count;
    }
    tell();
    text += fmt::format("    {}{}\n", y, row);
  }
  return text;
}

struct Press {
  const char* name;
  void (*make)(MouseStage&, const Vec2&);
};

const Vec2 dragged(34.0, -22.0);

const Press presses[] = {
    {"click",
     [](MouseStage& stage, const Vec2& at) {
       stage.pointAt(at);
       stage.click();
     }},
    {"click with Shift",
     [](MouseStage& stage, const Vec2& at) {
       stage.shift = true;
       stage.pointAt(at);
       stage.click();
     }},
    {"click with Alt",
     [](MouseStage& stage, const Vec2& at) {
       stage.alt = true;
       stage.pointAt(at);
       stage.click();
     }},
    {"double click",
     [](MouseStage& stage, const Vec2& at) {
       stage.pointAt(at);
       stage.doubleClick();
     }},
    {"right click",
     [](MouseStage& stage, const Vec2& at) {
       stage.pointAt(at);
       stage.click(ImGuiMouseButton_Right);
     }},
    {"drag", [](MouseStage& stage, const Vec2& at) { stage.drag(at, at + dragged); }},
    {"drag with Shift",
     [](MouseStage& stage, const Vec2& at) {
       stage.shift = true;
       stage.drag(at, at + dragged);
     }},
    {"drag with Ctrl",
     [](MouseStage& stage, const Vec2& at) {
       stage.control = true;
       stage.drag(at, at + dragged);
     }},
    {"drag with Alt",
     [](MouseStage& stage, const Vec2& at) {
       stage.alt = true;
       stage.drag(at, at + dragged);
     }},
    {"drag of the middle button",
     [](MouseStage& stage, const Vec2& at) { stage.drag(at, at + dragged, ImGuiMouseButton_Middle); }},
    {"drag of the right button",
     [](MouseStage& stage, const Vec2& at) { stage.drag(at, at + dragged, ImGuiMouseButton_Right); }},
    {"wheel",
     [](MouseStage& stage, const Vec2& at) {
       stage.pointAt(at);
       stage.turnWheel(1.0F);
     }},
    {"wheel while it is dragged",
     [](MouseStage& stage, const Vec2& at) {
       stage.pointAt(at);
       stage.press();
       stage.pointAt(at + dragged);
       stage.turnWheel(2.0F);
       stage.pointAt(at + 1.2 * dragged);
       stage.release();
     }},
};

test::Lines linesOf(MouseStage& stage) {
  test::Lines lines;
  test::addSession(lines, stage.session());
  const Camera& camera = stage.viewport.camera;
  ++lines[fmt::format("camera : at {:.3f} {:.3f} {:.3f} , {:.3f} away , turned {:.3f} {:.3f} , {}",
                      camera.target.x, camera.target.y, camera.target.z, camera.distance, camera.yawRadians,
                      camera.pitchRadians, static_cast<int>(camera.projection))];
  ++lines[fmt::format("menu of {}", static_cast<int>(stage.ui.menu.asked))];
  ++lines[fmt::format("gesture {} , falloff {:.4g}", static_cast<int>(stage.viewport.gesture),
                      stage.viewport.falloffRadius)];
  for (const Toast& toast : stage.ui.toasts) {
    ++lines["news : " + toast.text];
  }
  return lines;
}

std::string pressesText(const Sight& sight, const std::string& under, const Vec2& at) {
  std::string text;
  for (const NavigationStyle style : {NavigationStyle::maya, NavigationStyle::blender}) {
    if (style == NavigationStyle::blender && under != " nothing") {
      continue; // Only what turns the view differs.
    }
    for (const Press& press : presses) {
      const std::unique_ptr<MouseStage> stage = stageOf(sight);
      stage->ui.navigation = style;
      const test::Lines before = linesOf(*stage);
      press.make(*stage, at);
      constexpr int most = 20;
      const std::string done = test::changeText(before, linesOf(*stage), most);
      text += fmt::format("  {} ,{} , {}{}\n{}", press.name, under,
                          style == NavigationStyle::maya ? "as in Maya" : "as in Blender",
                          done.empty() ? " : nothing" : "", done);
    }
  }
  return text;
}

} // namespace

TEST_CASE(
    "What lies under the mouse at each place, and what each button does there, is as it was looked at") {
  std::string text;
  for (const Sight& sight : sights) {
    HitPlaces places;
    text += std::string(sight.name) + "\n" + placesText(*stageOf(sight), places);
    for (const auto& [kind, place] : places) {
      text += pressesText(sight, place.under, place.at);
    }
  }
  test::compareWithRecord("mouse-in-viewport", text);
}
