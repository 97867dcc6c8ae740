#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/weight_edits.h"
#include "app/reference/reference_edits.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/recorded.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/picture_baseline.h"
#include "tests/support/ui/work.h"

using namespace stretch;
using namespace stretch::ui;
using test::GuiPainter;
using test::GuiStage;

namespace {

using Prepare = void (*)(const test::Work&);

struct Panel {
  const char* name;
  void (*draw)(PanelContext&);
  Prepare prepare;
  float width = 304.0F;
  float height = 0.0F; ///< 0: as high as what it shows.
};

/// A clip that is animated after a film and to a sound.
void withReference(const test::Work& work) {
  test::withLimb(work);
  const app::Reference reference{0,
                                 {.file = "/films/film-0001.png", .startFrame = 12.0, .opacity = 0.5},
                                 {.file = "/films/beat.wav", .startFrame = -6.0, .volume = 0.8}};
  work.session().edit(app::withReference(work.session().document(), reference), "Refer");
  auto sound = std::make_shared<app::Sound>();
  sound->samplesPerSecond = 25'600; // 100 peaks a second
  sound->samples.resize(76'800);    // a second and a half, left and right
  sound->loudest = 0.8F;
  for (int i = 0; i < 150; ++i) { // strong every half a second
    const float strength = i % 50 < 10 ? 0.8F : 0.2F;
    sound->peaks.push_back({-strength, 0.5F * strength});
  }
  work.ui.time.sound = {sound, 6.0, "beat.wav"};
  work.ui.dialogs.reference.imageCount = 48;
}

const Panel panels[] = {
    {"rig", drawRigPanel, test::withLimb},
    {"rig-reasons", drawRigPanel,
     [](const test::Work& work) {
       test::withLimb(work);
       work.ui.body.expandedLimb = "left-arm";
     }},
    {"rig-empty", drawRigPanel, test::withNothing},
    {"limb", drawLimbPanel, test::withLimb},
    {"trails", drawTrailsPanel, test::withTrail},
    {"trails-none", drawTrailsPanel, test::withLimb},
    {"trail-settings", drawTrailSettingsPanel, test::withTrail},
    {"weight", drawTrailSettingsPanel, test::withWeight},
    {"timeline", drawBottomPanel, test::withTrail, 960.0F, 192.0F},
    {"timeline-sound", drawBottomPanel, withReference, 960.0F, 192.0F},
    {"graph", drawBottomPanel,
     [](const test::Work& work) {
       test::withTrail(work);
       work.ui.time.tab = BottomTab::graph;
     },
     960.0F, 192.0F},
    {"dope-sheet", drawBottomPanel,
     [](const test::Work& work) {
       test::withTrail(work);
       work.ui.time.tab = BottomTab::dopeSheet;
     },
     960.0F, 192.0F},
    {"sequence-facts", drawSequenceFacts, test::withSequence, 264.0F},
    {"sequence", drawSequencePanel, test::withSequence},
    {"sequence-result", drawSequencePanel, test::withCompression},
    {"sequence-timeline", drawSequenceTimeline, test::withSequence, 960.0F, 192.0F},
    {"sequence-bar", drawSequenceBar, test::withCompression, 640.0F, 42.0F},
    {"viewport-bar", drawViewportBar, test::withTrail, 712.0F, 42.0F},
    {"status-bar", drawStatusBar, test::withTrail, 712.0F, 42.0F},
    {"status-bar-tool", drawStatusBar,
     [](const test::Work& work) {
       test::withTrail(work);
       work.status.modalText = "left arm x3.00, axes X Z";
       work.status.keyHints = {{"X Y Z", "axes"}, {"Enter", "keep"}, {"Esc", "back"}};
     },
     712.0F, 42.0F},
};

struct Dialog {
  const char* name;
  float width;
  float height;
  void (*open)(UiState&);
  Prepare prepare = test::withNothing;
};

/// Four poses without pictures, of which the second is taken by half and one hand is held elsewhere.
void openLibrary(UiState& ui) {
  PoseLibraryState& library = ui.body.library;
  library.open = true;
  for (const char* const name : {"Bow", "Guard", "Low guard", "Wave"}) {
    library.poses.push_back({name, {}});
  }
  library.chosen = 1;
  library.typedName = "Guard";
  library.amount = 0.5;
  library.reaches = true;
  library.remark = "the left hand is held elsewhere";
}

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
     test::withTrail},
    {"keys", 760.0F, 620.0F, [](UiState& ui) { ui.dialogs.keys.open = true; }, test::withTrail},
    {"settings", 560.0F, 540.0F, [](UiState& ui) { ui.dialogs.settingsOpen = true; }},
    {"about", 520.0F, 340.0F, [](UiState& ui) { ui.dialogs.aboutOpen = true; }},
    {"joints", 560.0F, 620.0F,
     [](UiState& ui) {
       ui.body.jointPick.open = true;
       ui.body.jointPick.limbId = "left-arm";
     },
     test::withLimb},
    {"pose-library", 420.0F, 620.0F, openLibrary, test::withControllers},
    {"pose-library-empty", 420.0F, 300.0F, [](UiState& ui) { ui.body.library.open = true; }, test::withLimb},
    {"reference", 420.0F, 560.0F, [](UiState& ui) { ui.dialogs.reference.open = true; }, withReference},
    {"reference-empty", 420.0F, 440.0F, [](UiState& ui) { ui.dialogs.reference.open = true; },
     test::withLimb},
    {"unsaved", 560.0F, 240.0F, [](UiState&) {},
     [](const test::Work& work) {
       test::withTrail(work);
       work.status.question.kind = app::FileQuestion::Kind::unsaved;
     }},
    {"first-start", 620.0F, 320.0F, [](UiState& ui) { ui.dialogs.navigationChoiceOpen = true; }},
    {"restore", 560.0F, 240.0F, [](UiState&) {},
     [](const test::Work& work) {
       work.status.question = {app::FileQuestion::Kind::restore, "boxer.glb"};
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

/// Adds what the last frame draws in the dark theme, which is compared number by number.
void tell(std::string& text, const std::string& name, ThemeKind kind) {
  if (kind == ThemeKind::dark) {
    text += name + "\n" + test::drawnText();
  }
}

constexpr ThemeKind bothThemes[] = {ThemeKind::dark, ThemeKind::light};

} // namespace

TEST_CASE("Picture: every panel in both themes") {
  GuiPainter painter;
  std::string drawn;
  for (const Panel& panel : panels) {
    for (const ThemeKind kind : bothThemes) {
      GuiStage stage(painter, kind, panel.width, panel.height > 0.0F ? panel.height : 1800.0F);
      panel.prepare({stage.open, stage.ui, stage.status});
      const float height = stage.showPanel(panel.draw, panel.height);
      tell(drawn, panel.name, kind);
      compare(std::string("panel-") + panel.name, kind, stage.picture(height));
    }
  }
  test::compareWithRecord("drawn-panels", drawn);
}

TEST_CASE("Picture: every dialog in both themes") {
  GuiPainter painter;
  std::string drawn;
  for (const Dialog& dialog : dialogs) {
    for (const ThemeKind kind : bothThemes) {
      GuiStage stage(painter, kind, dialog.width, dialog.height);
      dialog.prepare({stage.open, stage.ui, stage.status});
      dialog.open(stage.ui);
      stage.showDialogs();
      tell(drawn, dialog.name, kind);
      compare(std::string("dialog-") + dialog.name, kind, stage.picture());
    }
  }
  test::compareWithRecord("drawn-dialogs", drawn);
}

TEST_CASE("Picture: the menus in both themes") {
  GuiPainter painter;
  for (const ThemeKind kind : bothThemes) {
    GuiStage stage(painter, kind, 480.0F, 360.0F);
    test::withTrail({stage.open, stage.ui, stage.status});
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
    test::withTrail({stage.open, stage.ui, stage.status});
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
