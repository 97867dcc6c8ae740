#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/picture_baseline.h"
#include "ui/viewport/viewport_scene.h"

using namespace stretch;
using namespace stretch::ui;
using test::GuiPainter;
using test::GuiStage;

namespace {

/// The bundled character in its punch, with an exaggerated trail of the left arm, seen as the window first
/// shows it.
void openCharacter(GuiStage& stage) {
  const app::Document document = test::withNewTrail(test::PanelDriver::bundledCharacter(),
                                                    {.startFrame = 18.0, .endFrame = 30.0, .scale = 1.8});
  stage.open.open(document);
  stage.open.character()->view().frame = 26.0;
  stage.viewport.facingYawRadians = facingYaw(document, 0);
  stage.viewport.camera = lookFrom(Camera{}, ViewDirection::threeQuarter, stage.viewport.facingYawRadians);
  stage.viewport.framePending = true;
}

int trailOf(const GuiStage& stage) {
  return stage.open.character()->document().trails.front().id;
}

void selectTrail(GuiStage& stage) {
  app::selectTrail(*stage.open.character(), trailOf(stage));
}

void openSequence(GuiStage& stage) {
  app::SequenceDocument document;
  document.paths = {"tube"};
  document.mesh = std::make_shared<const MeshSequence>(test::shorteningTube(12, 2.0, 0.06, 0.1));
  document.analysis = std::make_shared<const app::SequenceAnalysis>(app::analyseSequence(*document.mesh));
  document.settings.bones = 8;
  auto made = app::makeCompression(*document.mesh, document.settings);
  REQUIRE(made);
  document.result = std::make_shared<const app::Compression>(std::move(made).value());
  stage.open.open(std::move(document));
  stage.open.sequence()->view().frame = 8.0;
  stage.open.sequence()->view().look = app::SequenceLook::compare;
}

struct Overlays {
  const char* name;
  void (*set)(GuiStage&);
};

const Overlays overlays[] = {
    {"trails", [](GuiStage&) {}},
    {"skeleton", [](GuiStage& stage) { stage.ui.overlays.skeleton = true; }},
    {"wire", [](GuiStage& stage) { stage.ui.overlays.wire = true; }},
    {"joint-names", [](GuiStage& stage) { stage.ui.overlays.jointNames = true; }},
    {"heat-map", [](GuiStage& stage) { stage.ui.overlays.heatMap = true; }},
    {"weights",
     [](GuiStage& stage) {
       stage.ui.overlays.weights = true;
       app::selectLimb(*stage.open.character(), "right-leg", false);
     }},
    {"ghosts", [](GuiStage& stage) { stage.ui.overlays.ghosts = true; }},
    {"grid-off", [](GuiStage& stage) { stage.ui.overlays.grid = false; }},
    {"limb-selected", [](GuiStage& stage) { app::selectLimb(*stage.open.character(), "right-leg", false); }},
    {"trail-selected", selectTrail},
    {"frame-numbers",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.ui.overlays.trailFrameNumbers = true;
     }},
    {"ticks-off",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.ui.overlays.trailTicks = false;
     }},
    {"trail-window",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.ui.overlays.trailWindow = true;
       stage.ui.overlays.trailWindowFrames = 3;
     }},
    {"trail-thick",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.ui.overlays.trailThickness = 6.0F;
       stage.ui.overlays.sphereSize = 10.0F;
     }},
    {"trails-of-selection", [](GuiStage& stage) { stage.ui.overlays.trailsOnlyWhenSelected = true; }},
    {"handles",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.open.character()->view().selection.editTrails().spheres = {
           stage.open.character()->document().trails.front().settings.endFrame};
     }},
    {"side-by-side", [](GuiStage& stage) { stage.ui.overlays.sideBySide = true; }},
    {"original", [](GuiStage& stage) { stage.open.character()->view().showOriginal = true; }},
    {"front",
     [](GuiStage& stage) {
       stage.viewport.camera =
           lookFrom(stage.viewport.camera, ViewDirection::front, stage.viewport.facingYawRadians);
     }},
    {"sequence", openSequence},
    {"sequence-error",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::error;
     }},
    {"sequence-thickness",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::thickness;
       stage.ui.overlays.skeleton = true;
     }},
    {"sequence-segments",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::segments;
     }},
    {"sequence-cylinders",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::cylinders;
       stage.ui.overlays.skeleton = true;
     }},
    {"empty", [](GuiStage& stage) { stage.open = {}; }},
};

} // namespace

TEST_CASE("Picture: the viewport with each of its overlays in both themes") {
  GuiPainter painter;
  for (const Overlays& wanted : overlays) {
    for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
      GuiStage stage(painter, kind, 264.0F, 240.0F);
      openCharacter(stage);
      wanted.set(stage);
      stage.showViewport();
      const std::string difference = test::differenceFromBaseline(
          std::string("viewport-") + wanted.name + (kind == ThemeKind::dark ? "-dark" : "-light"),
          stage.picture());
      INFO(difference);
      CHECK(difference.empty());
    }
  }
}
