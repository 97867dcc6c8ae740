#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/weight_edits.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/picture_baseline.h"

using namespace stretch;
using namespace stretch::ui;
using test::GuiPainter;
using test::GuiStage;

namespace {

using Prepare = void (*)(GuiStage&);

/// The bundled character; its left arm is selected and has an exaggerated trail.
void withTrail(GuiStage& stage) {
  const app::Document document =
      test::withNewTrail(test::PanelDriver::bundledCharacter(), {.startFrame = 4.0, .endFrame = 24.0});
  stage.open.open(document);
  app::selectTrail(*stage.open.character(), document.trails.front().id);
  stage.open.character()->view().frame = 12.0;
}

void withLimb(GuiStage& stage) {
  stage.open.open(test::PanelDriver::bundledCharacter());
  app::selectLimb(*stage.open.character(), "left-arm", false);
}

void withWeight(GuiStage& stage) {
  withLimb(stage);
  stage.open.character()->edit(*app::switchWeight(stage.open.character()->document(), {"left-arm"}, 0, true),
                               "Give weight");
}

void withSequence(GuiStage& stage) {
  app::SequenceDocument document;
  document.paths = {"tube"};
  document.mesh = std::make_shared<const MeshSequence>(test::shorteningTube(12, 2.0, 0.06, 0.1));
  document.analysis = std::make_shared<const app::SequenceAnalysis>(app::analyseSequence(*document.mesh));
  document.settings.bones = 8;
  stage.open.open(std::move(document));
  stage.open.sequence()->view().frame = 5.0;
}

void withCompression(GuiStage& stage) {
  withSequence(stage);
  app::SequenceDocument document = stage.open.sequence()->document();
  auto made = app::makeCompression(*document.mesh, document.settings);
  REQUIRE(made);
  document.result = std::make_shared<const app::Compression>(std::move(made).value());
  stage.open.sequence()->edit(std::move(document), "Compress");
}

void withNothing(GuiStage&) {}

struct Panel {
  const char* name;
  void (*draw)(PanelContext&);
  Prepare prepare;
  float width = 304.0F;
  float height = 0.0F; ///< 0: as high as what it shows.
};

const Panel panels[] = {
    {"rig", drawRigPanel, withLimb},
    {"rig-reasons", drawRigPanel,
     [](GuiStage& stage) {
       withLimb(stage);
       stage.ui.body.expandedLimb = "left-arm";
     }},
    {"rig-empty", drawRigPanel, withNothing},
    {"limb", drawLimbPanel, withLimb},
    {"trails", drawTrailsPanel, withTrail},
    {"trails-none", drawTrailsPanel, withLimb},
    {"trail-settings", drawTrailSettingsPanel, withTrail},
    {"weight", drawTrailSettingsPanel, withWeight},
    {"timeline", drawBottomPanel, withTrail, 960.0F, 192.0F},
    {"graph", drawBottomPanel,
     [](GuiStage& stage) {
       withTrail(stage);
       stage.ui.time.tab = BottomTab::graph;
     },
     960.0F, 192.0F},
    {"dope-sheet", drawBottomPanel,
     [](GuiStage& stage) {
       withTrail(stage);
       stage.ui.time.tab = BottomTab::dopeSheet;
     },
     960.0F, 192.0F},
    {"sequence-facts", drawSequenceFacts, withSequence, 264.0F},
    {"sequence", drawSequencePanel, withSequence},
    {"sequence-result", drawSequencePanel, withCompression},
    {"sequence-timeline", drawSequenceTimeline, withSequence, 960.0F, 192.0F},
    {"sequence-bar", drawSequenceBar, withCompression, 640.0F, 42.0F},
    {"viewport-bar", drawViewportBar, withTrail, 712.0F, 42.0F},
    {"status-bar", drawStatusBar, withTrail, 712.0F, 42.0F},
    {"status-bar-tool", drawStatusBar,
     [](GuiStage& stage) {
       withTrail(stage);
       stage.status.modalText = "left arm x3.00, axes X Z";
       stage.status.keyHints = {{"X Y Z", "axes"}, {"Enter", "keep"}, {"Esc", "back"}};
     },
     712.0F, 42.0F},
};

struct Dialog {
  const char* name;
  float width;
  float height;
  void (*open)(UiState&);
  Prepare prepare = withNothing;
};

const Dialog dialogs[] = {
    {"files", 720.0F, 560.0F,
     [](UiState& ui) {
       FileDialogState& files = ui.dialogs.file;
       setenv("HOME", "/characters", 1); // Whose folders are listed as places.
       files.open = true;
       files.wasOpen = true; // as listed below
       files.folder = files.listedFolder = "/characters";
       files.entries = {{"clips", true, 0}, {"boxer.glb", false, 2'400'000}, {"walk.gltf", false, 18'000}};
       files.highlighted = 1;
     }},
    {"palette", 680.0F, 470.0F, [](UiState& ui) { ui.dialogs.palette = {.open = true, .typed = "trail"}; },
     withTrail},
    {"keys", 760.0F, 620.0F, [](UiState& ui) { ui.dialogs.keys.open = true; }, withTrail},
    {"settings", 560.0F, 540.0F, [](UiState& ui) { ui.dialogs.settingsOpen = true; }},
    {"about", 520.0F, 340.0F, [](UiState& ui) { ui.dialogs.aboutOpen = true; }},
    {"joints", 560.0F, 620.0F,
     [](UiState& ui) {
       ui.body.jointPick.open = true;
       ui.body.jointPick.limbId = "left-arm";
     },
     withLimb},
    {"unsaved", 560.0F, 240.0F, [](UiState&) {},
     [](GuiStage& stage) {
       withTrail(stage);
       stage.status.question.kind = app::FileQuestion::Kind::unsaved;
     }},
    {"first-start", 620.0F, 320.0F, [](UiState& ui) { ui.dialogs.navigationChoiceOpen = true; }},
    {"restore", 560.0F, 240.0F, [](UiState&) {},
     [](GuiStage& stage) {
       stage.status.question = {app::FileQuestion::Kind::restore, "boxer.glb"};
     }},
    {"toasts", 520.0F, 200.0F,
     [](UiState& ui) {
       ui.toasts = {{ToastKind::success, "Saved boxer-exaggerated.glb", 4.0F},
                    {ToastKind::error, "The file cannot be read: boxer.glb. Check that it is there.", 8.0F}};
     }},
};

void drawMenus(PanelContext& context) {
  if (ImGui::BeginMainMenuBar()) {
    drawMenuBar(context);
    ImGui::EndMainMenuBar();
  }
}

/// Fails with where to look when the picture is another than its baseline.
void compare(const std::string& name, ThemeKind kind, const Image& picture) {
  const std::string difference = test::differenceFromBaseline(
      name + (kind == ThemeKind::dark ? "-dark" : "-light"), picture, test::PictureKind::panel);
  INFO(difference);
  CHECK(difference.empty());
}

constexpr ThemeKind bothThemes[] = {ThemeKind::dark, ThemeKind::light};

} // namespace

TEST_CASE("Picture: every panel in both themes") {
  GuiPainter painter;
  for (const Panel& panel : panels) {
    for (const ThemeKind kind : bothThemes) {
      GuiStage stage(painter, kind, panel.width, panel.height > 0.0F ? panel.height : 1800.0F);
      panel.prepare(stage);
      const float height = stage.showPanel(panel.draw, panel.height);
      compare(std::string("panel-") + panel.name, kind, stage.picture(height));
    }
  }
}

TEST_CASE("Picture: every dialog in both themes") {
  GuiPainter painter;
  for (const Dialog& dialog : dialogs) {
    for (const ThemeKind kind : bothThemes) {
      GuiStage stage(painter, kind, dialog.width, dialog.height);
      dialog.prepare(stage);
      dialog.open(stage.ui);
      stage.showDialogs();
      compare(std::string("dialog-") + dialog.name, kind, stage.picture());
    }
  }
}

TEST_CASE("Picture: the menus in both themes") {
  GuiPainter painter;
  for (const ThemeKind kind : bothThemes) {
    GuiStage stage(painter, kind, 480.0F, 360.0F);
    withTrail(stage);
    stage.show(drawMenus);
    compare("menu-bar", kind, stage.picture(32.0F));
    stage.click("menu/Trail", drawMenus);
    compare("menu-open", kind, stage.picture());
  }
}

TEST_CASE("Picture: a tooltip beside its panel in both themes") {
  GuiPainter painter;
  for (const ThemeKind kind : bothThemes) {
    GuiStage stage(painter, kind, 660.0F, 140.0F);
    withTrail(stage);
    const auto draw = [](PanelContext& context) {
      ImGui::SetNextWindowPos({0.0F, 0.0F});
      ImGui::SetNextWindowSize({304.0F, 640.0F});
      ImGui::Begin("pane", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
      drawTrailSettingsPanel(context);
      ImGui::End();
    };
    stage.show(draw);
    stage.pointAt("trail/scale");
    for (int i = 0; i < 10; ++i) {
      stage.show(draw);
    }
    compare("tooltip", kind, stage.picture());
  }
}
