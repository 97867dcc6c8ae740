// Trails and marks under the mouse: the nearest one, and none where the mouse is elsewhere.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/mouse_stage.h"
#include "ui/render/picking/picking.h"
#include "ui/viewport/tools.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The boxer with two trails of its left arm, one behind the other in time, the first of them selected.
struct TwoTrails : test::MouseStage {
  TwoTrails()
      : MouseStage(test::withNewTrail(
            test::withNewTrail(test::boxer(), {.startFrame = 0.0, .endFrame = 8.0, .scale = 2.0}),
            {.startFrame = 10.0, .endFrame = 20.0, .scale = 1.2})) {
    session().view().frame = 19.0;
    app::selectLimb(session(), "left-arm", false);
    frame();
    REQUIRE(viewport.shown.trails.size() == 2);
  }
  /// Pixels between the mouse and each of the trails; far away where it is out of reach.
  [[nodiscard]] std::array<double, 2> distances(const Vec2& mouse) const {
    std::array<double, 2> away{1e9, 1e9};
    for (std::size_t i = 0; i < 2; ++i) {
      const ShownTrail& trail = viewport.shown.trails[i];
      const auto hit = pickPolyline(
          viewport.view, trail.exaggerated ? trail.drawn.exaggerated : trail.drawn.original, mouse);
      away[i] = hit ? hit->distancePixels : 1e9;
    }
    return away;
  }
};

} // namespace

TEST_CASE("Of two trails within reach of the mouse the nearer one is under it, whichever was made first") {
  TwoTrails stage;
  app::Session& session = stage.session();
  app::selectTrail(session, 0);
  session.view().selection.editTrails().limbs = {"left-arm"};
  session.view().selection.dropTrail();
  stage.ui.overlays.controllers = false;
  std::array<int, 2> nearer{0, 0};
  for (const ShownTrail& trail : std::vector<ShownTrail>(stage.viewport.shown.trails)) {
    for (std::size_t i = 0; i < trail.drawn.exaggerated.size(); i += 2) {
      for (const Vec2& step : {Vec2(0.0, -4.0), Vec2(0.0, 4.0), Vec2(3.0, 0.0)}) {
        const Vec2 mouse = stage.pixelsOf(trail.drawn.exaggerated[i]) + step;
        const std::array<double, 2> away = stage.distances(mouse);
        if (std::max(away[0], away[1]) > 1e6 || std::abs(away[0] - away[1]) < 0.2) {
          continue;
        }
        stage.pointAt(mouse);
        const std::size_t wanted = away[0] < away[1] ? 0 : 1;
        CAPTURE(mouse.x, mouse.y, away[0], away[1]);
        CHECK(stage.viewport.hoveredTrail == stage.viewport.shown.trails[wanted].id);
        ++nearer[wanted];
      }
    }
  }
  CHECK(nearer[0] > 1);
  CHECK(nearer[1] > 1);
}

namespace {

/// Whether nothing at all is marked under the mouse.
bool isNothingMarked(const ViewportState& viewport) {
  return !viewport.hoveredHandle && viewport.hoveredController.empty() && !viewport.hoveredSphere &&
         !viewport.hoveredAxis && !viewport.hoveredTangent && viewport.hoveredTrail == 0 &&
         viewport.hoveredLimb.empty() && !viewport.hoveredEnd && viewport.hoveredJoint == NodeIndex::none;
}

enum class Mark { tangent, sphere, trail, controller, limb, axis };

/// The first of the two trails with its last sphere selected.
struct MarkedTrails : TwoTrails {
  MarkedTrails() {
    app::selectTrail(session(), viewport.shown.trails.front().id);
    spheres_ = app::placedSpheres(session(), session().view().selection.trail());
    session().view().selection.editTrails().spheres = {spheres_.back().frame};
    frame();
    REQUIRE_FALSE(viewport.tangents.handles.empty());
  }
  /// Points at something of a kind until it is marked.
  void mark(Mark kind) {
    ui.overlays.controllers = kind == Mark::controller;
    frame();
    switch (kind) {
    case Mark::tangent:
      pointAt(Vec3(viewport.tangents.handles.front().tipWorld));
      REQUIRE(viewport.hoveredTangent);
      break;
    case Mark::sphere:
      pointAt(spheres_.front().positionWorld);
      REQUIRE(viewport.hoveredSphere);
      break;
    case Mark::trail:
      markOtherTrail();
      break;
    case Mark::controller:
      session().view().selection.dropTrail();
      pointAt(viewport.controllers.back().placed.placeWorld);
      REQUIRE_FALSE(viewport.hoveredController.empty());
      break;
    case Mark::limb:
      pointAt(middleOfArm());
      REQUIRE(viewport.hoveredLimb == "right-arm");
      break;
    case Mark::axis:
      for (double up = 20.0; up < 70.0 && !viewport.hoveredAxis; up += 2.0) {
        pointAt(pixelsOf(spheres_.back().positionWorld) - Vec2(0.0, up));
      }
      REQUIRE(viewport.hoveredAxis);
      break;
    }
  }

private:
  void markOtherTrail() {
    session().view().selection.dropSpheres();
    const ShownTrail other = viewport.shown.trails.back();
    for (double at = other.startFrame; at < other.endFrame && viewport.hoveredTrail == 0; at += 0.5) {
      pointAt(pointOnTrail(other, at, true));
    }
    REQUIRE(viewport.hoveredTrail != 0);
  }
  [[nodiscard]] Vec3 middleOfArm() {
    const rig::Limb& arm = *app::findLimb(session().document(), "right-arm");
    const FrameState& pose = session().shownAt(session().view().frame);
    return 0.5 * (positionOf(pose.worlds[at(arm.joints[0])]) + positionOf(pose.worlds[at(arm.joints[1])]));
  }

  std::vector<app::PlacedSphere> spheres_;
};

} // namespace

TEST_CASE("What was marked under the mouse is so no longer when the mouse leaves, whatever it was") {
  MarkedTrails stage;
  const Mark kind =
      GENERATE(Mark::tangent, Mark::sphere, Mark::trail, Mark::controller, Mark::limb, Mark::axis);
  CAPTURE(static_cast<int>(kind));
  stage.mark(kind);
  SECTION("out of the picture") {
    stage.over = false;
    stage.frame();
  }
  SECTION("on to the view cube") {
    stage.pointAt(Vec2(800.0 - 46.0, 46.0));
  }
  SECTION("on to a picture that moves") {
    stage.ui.time.timeline.playing = true;
    stage.frame();
  }
  SECTION("on to nothing") {
    stage.pointAt(Vec2(60.0, 560.0));
  }
  CHECK(isNothingMarked(stage.viewport));
}

TEST_CASE("Nothing of a trail that is not drawn lies under the mouse: hidden, or beside locators") {
  MarkedTrails stage;
  app::Session& session = stage.session();
  const bool isHidden = GENERATE(true, false);
  for (const Mark kind : {Mark::sphere, Mark::axis, Mark::tangent}) {
    CAPTURE(isHidden, kind);
    stage.mark(kind);
    const app::Document before = session.document();
    if (isHidden) {
      app::Document hidden = before;
      app::findTrail(hidden, session.view().selection.trail())->visible = false;
      CHECK(session.edit(hidden, "Hide the trail"));
    } else {
      session.view().showLocators = true;
      app::Document located = before;
      located.locators.list.push_back({.name = "spine", .position = {9.0, 9.0, 9.0}});
      CHECK(session.edit(located, "Fit"));
      REQUIRE(app::showsLocators(session));
    }
    stage.frame();
    stage.frame();
    CHECK_FALSE(stage.viewport.hoveredSphere);
    CHECK_FALSE(stage.viewport.hoveredAxis);
    CHECK_FALSE(stage.viewport.hoveredTangent);
    CHECK(stage.viewport.tangents.handles.empty()); // which are drawn
    CHECK((isHidden ? stage.viewport.hoveredTrail != session.view().selection.trail()
                    : stage.viewport.hoveredTrail == 0));
    session.undo();
    session.view().showLocators = false;
    stage.frame();
  }
}
