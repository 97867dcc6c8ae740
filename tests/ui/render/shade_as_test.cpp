// What engines shade that turn normals by the joints' own matrices: the graphics card, the CPU and the
// forecast say the same.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "app/files/save.h"
#include "app/forecast/forecast.h"
#include "app/forecast/shading.h"
#include "rig/motion/evaluate.h"
#include "skinning/linear_blend_skinning.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/render_frame.h"
#include "tests/support/ui/render_scenes.h"
#include "ui/render/gl/offscreen_context.h"
#include "ui/render/picture/picture.h"
#include "ui/render/scene/scene_renderer.h"

using namespace stretch;
using namespace stretch::ui;
using skinning::NormalMatrix;

namespace {

constexpr const char* dummyGlb = STRETCH_SOURCE_DIR "/assets/dummy.glb";

SceneStyle shadedAs(NormalMatrix normals, bool newStretchTurns = true) {
  SceneStyle style;
  style.normals = normals;
  style.newStretchTurns = newStretchTurns;
  return style;
}

/// Of all drawn vertices, as the graphics card turns them.
std::vector<Vec3> drawnNormals(SceneRenderer& renderer, const Scene& scene, const FrameState& frame,
                               const SceneStyle& style) {
  std::size_t primitives = 0;
  for (const NodeIndex node : skinning::drawnMeshNodes(scene)) {
    primitives += scene.meshes[at(scene.nodes[at(node)].mesh)].primitives.size();
  }
  std::vector<Vec3> normals;
  for (std::size_t primitive = 0; primitive < primitives; ++primitive) {
    for (const glm::vec3& normal : renderer.posedNormals(frame, primitive, style)) {
      normals.emplace_back(normal);
    }
  }
  return normals;
}

double mostTurned(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, glm::length(a[i] - b[i]));
  }
  return most;
}

std::string punchIn(const test::TemporaryFolder& folder, app::StretchForm form) {
  const Result<app::Document> source = app::openDocument(dummyGlb);
  REQUIRE(source);
  const app::Document document =
      test::withNewTrail(*source, {.limb = "left-arm", .startFrame = 21.0, .endFrame = 27.0, .scale = 3.0});
  std::string file = (folder / "punch.glb").string();
  REQUIRE(app::saveDocument(document, file, {.clean = true, .form = {form, 8}}));
  return file;
}

double meanDifference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  REQUIRE(a.size() == b.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
  }
  return sum / static_cast<double>(a.size());
}

} // namespace

TEST_CASE("A body at rest looks the same by either shading, a forearm that is stretched does not") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  const Scene scene = test::bipedScene();
  FrameState frame = frameOf(scene, restPose(scene), 0.0);
  const auto differenceAt = [&](const FrameState& pose) {
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const NormalMatrix normals : {NormalMatrix::inverseTranspose, NormalMatrix::plain}) {
      PictureContent content;
      content.frame = pose;
      content.style = shadedAs(normals);
      PictureOptions options;
      options.widthPixels = 160;
      options.heightPixels = 120;
      pictures.push_back(test::renderFrame(scene, {content, ""}, options).value().rgba);
    }
    return meanDifference(pictures[0], pictures[1]);
  };
  CHECK(differenceAt(frame) < 1e-3);
  frame.stretch.assign(scene.nodes.size(), Mat3(1.0));
  frame.stretch[at(test::BipedNodes{}.leftForearm)] = Mat3(glm::rotate(Mat4(1.0), 0.7, Vec3(0.0, 0.0, 1.0))) *
                                                      Mat3(3.0, 0.0, 0.0, 0.0, 0.6, 0.0, 0.0, 0.0, 0.6);
  CHECK(differenceAt(frame) > 0.02);
}

TEST_CASE("A stretch that is told by translations turns no normal, one that is told by scale does") {
  const test::TemporaryFolder folder;
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = SceneRenderer::create();
  REQUIRE(renderer);
  for (const app::StretchForm form : {app::StretchForm::scale, app::StretchForm::volume}) {
    const Result<app::Document> punch = app::openDocument(punchIn(folder, form));
    REQUIRE(punch);
    const FrameState frame = rig::sampledFrame(*punch->scene, app::clipOf(*punch, 0), 27.0 / 24.0);
    FrameState joints = frame;
    std::ranges::fill(joints.stretch, Mat3(1.0));
    renderer->setScene(*punch->scene);
    const std::vector<Vec3> drawn =
        drawnNormals(*renderer, *punch->scene, frame, shadedAs(NormalMatrix::plain));
    const double apart =
        mostTurned(drawn, skinning::skinnedNormals(*punch->scene, joints, NormalMatrix::plain));
    CHECK((apart <= 2e-3) == (form == app::StretchForm::volume));
  }
}

TEST_CASE("As many vertices are shaded more than 20 degrees off as the forecast of three.js says") {
  const test::TemporaryFolder folder;
  const Result<app::Document> punch = app::openAsItStands(punchIn(folder, app::StretchForm::scale));
  REQUIRE(punch);
  const app::ClipLooks looks = app::clipLooks(*punch, 0);
  REQUIRE(looks.share() > 0.2);
  const Scene& scene = *punch->scene;
  const Clip& clip = app::clipOf(*punch, 0);
  const FrameState frame = rig::sampledFrame(scene, clip, looks.frame / clip.framesPerSecond);
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = SceneRenderer::create();
  REQUIRE(renderer);
  renderer->setScene(scene);
  const std::vector<Vec3> exact = drawnNormals(*renderer, scene, frame, {});
  const std::vector<Vec3> plain = drawnNormals(*renderer, scene, frame, shadedAs(NormalMatrix::plain));
  // Of those that the stretch moves: others bend as much in the source.
  const Result<app::Document> source = app::openAsItStands(dummyGlb);
  REQUIRE(source);
  const std::vector<Vec3> places = skinning::skinnedPositions(scene, frame);
  const std::vector<Vec3> before =
      skinning::skinnedPositions(*source->scene, rig::sampledFrame(*source->scene, app::clipOf(*source, 0),
                                                                   looks.frame / clip.framesPerSecond));
  REQUIRE(places.size() == before.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const bool isMoved = glm::length(places[i] - before[i]) > 1e-5;
    wrong += isMoved && glm::dot(exact[i], plain[i]) < std::cos(20.0 * pi / 180.0) ? 1 : 0;
  }
  CHECK(std::abs(static_cast<double>(wrong) - static_cast<double>(looks.wronglyShaded)) <= 2.0);
}

TEST_CASE("The status line says all the time that the shading is that of an engine") {
  test::PanelDriver driver(test::PanelDriver::bundledCharacter());
  driver.frames(2);
  CHECK(driver.find("status/shade-as") == nullptr);
  for (const ShadeAs engine : {ShadeAs::three, ShadeAs::godot}) {
    driver.ui.overlays.shadeAs = engine;
    driver.frames(2);
    CHECK(driver.find("status/shade-as") != nullptr);
  }
}

TEST_CASE("The viewport is drawn anew when the shading or the form of what is saved changes") {
  test::GuiPainter painter;
  test::GuiStage stage(painter, ThemeKind::dark, 264.0F, 240.0F);
  stage.open.open(
      test::withNewTrail(test::PanelDriver::bundledCharacter(),
                         {.limb = "left-arm", .startFrame = 18.0, .endFrame = 30.0, .scale = 3.0}));
  stage.open.character()->view().frame = 26.0;
  stage.viewport.framePending = true;
  const auto shown = [&](ShadeAs engine, app::StretchForm form) {
    stage.ui.overlays.shadeAs = engine;
    stage.ui.savedForm.form = form;
    stage.showViewport();
    return stage.picture().rgba;
  };
  const std::vector<std::uint8_t> exact = shown(ShadeAs::exact, app::StretchForm::scale);
  const std::vector<std::uint8_t> scale = shown(ShadeAs::three, app::StretchForm::scale);
  const std::vector<std::uint8_t> volume = shown(ShadeAs::three, app::StretchForm::volume);
  CHECK(meanDifference(exact, scale) > 0.01);
  CHECK(meanDifference(scale, volume) > 0.01);
  CHECK(meanDifference(volume, shown(ShadeAs::exact, app::StretchForm::scale)) > 0.001);
}
