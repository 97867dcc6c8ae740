#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/files/save.h"
#include "tests/support/app/camera_file.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/render/picking/picking.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// Where a place of the world is seen, pixels.
Vec2 seen(const test::GuiStage& stage, const Vec3& world) {
  const auto place = projectToPixels(stage.viewport.view, world);
  REQUIRE(place);
  return place->pixels;
}

} // namespace

TEST_CASE("The space View of a trail is right, up and towards the viewer, as the picture shows it") {
  test::GuiPainter painter;
  test::GuiStage stage(painter, ThemeKind::dark, 320.0F, 240.0F);
  stage.open.open(test::PanelDriver::bundledCharacter());
  for (const double yaw : {0.0, 0.7, 2.0, -1.4}) {
    for (const double pitch : {0.0, 0.5, -0.6}) {
      CAPTURE(yaw, pitch);
      stage.viewport.camera.yawRadians = yaw;
      stage.viewport.camera.pitchRadians = pitch;
      stage.showViewport();
      const Mat3& axes = stage.open.character()->view().cameraAxes;
      const Vec3 middle = stage.viewport.camera.target;
      const Vec2 from = seen(stage, middle);
      const Vec2 right = seen(stage, middle + 0.1 * axes[0]) - from;
      const Vec2 up = seen(stage, middle + 0.1 * axes[1]) - from;
      CHECK(right.x > 5.0);
      CHECK(std::abs(right.y) < 0.01 * right.x);
      CHECK(up.y < -5.0); // Pixels count downwards.
      CHECK(std::abs(up.x) < -0.01 * up.y);
      CHECK(glm::distance(glm::cross(axes[0], axes[1]), axes[2]) < 1e-9);
      // What comes nearer looks larger.
      const Vec3 nearer = middle + 0.3 * axes[2];
      CHECK(glm::distance(seen(stage, nearer + 0.1 * axes[0]), seen(stage, nearer)) > 1.02 * right.x);
      const CameraPlace& told = stage.open.character()->view().camera;
      CHECK(told.kind == CameraKind::perspective);
      CHECK(glm::distance(told.right, axes[0]) < 1e-9);
      CHECK(glm::distance(told.up, axes[1]) < 1e-9);
      CHECK(glm::distance(told.forward, -axes[2]) < 1e-9);
      const Vec3 eye = middle + stage.viewport.camera.distance * axes[2];
      CHECK(glm::distance(told.position, eye) < 1e-6);
    }
  }
}

TEST_CASE("A point of the overlays is as many pixels as the theme's scale says") {
  test::GuiPainter painter;
  test::GuiStage stage(painter, ThemeKind::dark, 320.0F, 240.0F);
  stage.open.open(test::PanelDriver::bundledCharacter());
  for (const float scale : {1.0F, 2.0F, 1.5F}) {
    stage.theme.scale = scale;
    stage.showViewport();
    CHECK(stage.viewport.view.viewport.pixelsPerPoint == Approx(scale));
    CHECK(stage.viewport.view.viewport.widthPixels == Approx(stage.viewport.box.width()));
    CHECK(stage.viewport.view.viewport.heightPixels == Approx(stage.viewport.box.height()));
  }
}

TEST_CASE("The colours of a stretch are explained at length, in one row where the picture is narrow, and not "
          "at all in "
          "a narrower one") {
  test::GuiPainter painter;
  const auto legendAt = [&](float width) {
    test::GuiStage stage(painter, ThemeKind::dark, width, 240.0F);
    stage.open.open(test::PanelDriver::bundledCharacter());
    stage.ui.overlays.heatMap = true;
    stage.showViewport();
    const Item* const legend = stage.items.find("viewport/stretch-legend");
    return legend == nullptr ? ImVec2(0.0F, 0.0F)
                             : ImVec2(legend->max.x - legend->min.x, legend->max.y - legend->min.y);
  };
  const ImVec2 whole = legendAt(640.0F);
  const ImVec2 row = legendAt(std::floor(1.5F * whole.x) - 2.0F);
  REQUIRE(row.x > 0.0F);
  CHECK(legendAt(std::ceil(1.5F * whole.x) + 2.0F).y == whole.y);
  CHECK(row.y < whole.y);
  CHECK(row.x < whole.x);
  CHECK(legendAt(std::ceil(1.5F * row.x) + 2.0F).y == row.y);
  CHECK(legendAt(std::floor(1.5F * row.x) - 2.0F).x == 0.0F);
}

TEST_CASE(
    "A camera of the file is looked through where it stands at the playhead, one that is gone no longer") {
  const test::TemporaryFolder folder;
  Result<app::Document> document = app::openDocument(test::boxerWithCameras(folder));
  REQUIRE(document);
  test::GuiPainter painter;
  test::GuiStage stage(painter, ThemeKind::dark, 320.0F, 240.0F);
  stage.open.open(std::move(document).value());
  stage.viewport.look.name = "Front"; // which comes from the side to the front until frame 27
  const auto eyeAt = [&](double frame) {
    stage.open.character()->view().frame = frame;
    stage.showViewport();
    REQUIRE(stage.viewport.look.through);
    CHECK(glm::distance(stage.open.character()->view().camera.position, stage.viewport.view.eye) < 1e-9);
    return stage.viewport.view.eye;
  };
  CHECK(glm::distance(eyeAt(0.0), Vec3(4.0, 1.2, 0.5)) < 1e-5);
  CHECK(glm::distance(eyeAt(27.0), Vec3(0.0, 1.2, 5.0)) < 1e-5);
  stage.viewport.framePending = true; // Framing is done by the view's own camera.
  stage.showViewport();
  CHECK(stage.viewport.look.name.empty());
  CHECK_FALSE(stage.viewport.look.through);
  stage.viewport.look.name = "Shot";
  stage.showViewport();
  CHECK(stage.viewport.look.name.empty());
}

TEST_CASE(
    "What a camera of the file looks at is as far as the hips, or half the character's height near them") {
  const test::TemporaryFolder folder;
  const Result<app::Document> document = app::openDocument(test::boxerWithCameras(folder));
  REQUIRE(document);
  app::Session session(*document);
  const FrameState& frame = session.shownAt(0.0);
  SceneCamera camera = *cameraNamed(*document->scene, "Side");
  const auto side = throughCamera(*document, camera, frame);
  REQUIRE(side);
  const Vec3 hips = positionOf(frame.worlds[at(document->body.hips)]);
  CHECK(side->reach == Approx(glm::distance(hips, Vec3(4.0, 1.2, 0.5))).epsilon(1e-4));
  camera.node = document->body.hips;
  const auto inside = throughCamera(*document, camera, frame);
  REQUIRE(inside);
  CHECK(inside->reach == Approx(0.5 * document->body.height));
}
