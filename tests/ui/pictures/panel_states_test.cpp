#include <algorithm>

#include <catch2/catch.hpp>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/things/place.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/picture_baseline.h"
#include "ui/panels/menus/context_menu.h"
#include "ui/panels/rows/shown_holds.h"
#include "ui/panels/rows/timeline_model.h"

using namespace stretch;
using namespace stretch::ui;
using test::GuiPainter;
using test::GuiStage;

// Panels, dialogs and menus in the states that work brings them to, beside those of a first look in
// panel_pictures_test.cpp. What a theme does is seen there; here each state is drawn once.

namespace {

using Prepare = void (*)(GuiStage&);

app::Session& session(GuiStage& stage) {
  return *stage.open.character();
}

/// As the user would, by its key or its button.
void run(GuiStage& stage, const char* id) {
  const auto& commands = app::documentCommands();
  const auto found = std::ranges::find(commands, std::string(id), &app::DocumentCommand::id);
  REQUIRE(found != commands.end());
  INFO(id);
  REQUIRE(app::isEnabled(*found, stage.open));
  REQUIRE(app::run(*found, stage.open));
}

/// The bundled character with two trails that are one group, and a third of another time by itself.
void withGroup(GuiStage& stage) {
  app::Document document = test::PanelDriver::bundledCharacter();
  document = test::withNewTrail(document, {.startFrame = 4.0, .endFrame = 24.0, .scale = 3.0});
  document = test::withNewTrail(document, {"right-arm", 4.0, 24.0, 3.0, true});
  const std::vector<int> both{document.trails[0].id, document.trails[1].id};
  Result<app::Document> grouped = app::groupTrails(document, both);
  REQUIRE(grouped);
  stage.open.open(test::withNewTrail(*grouped, {"left-leg", 30.0, 44.0, 1.5, false}));
  app::selectGroup(session(stage), both.front());
  session(stage).view().frame = 12.0;
}

/// The boxer with a pin, a grip, a prop, weight, offsets and a trail.
void withEverything(GuiStage& stage) {
  const auto made = app::place(test::twoPunches(), test::oneOfEach(0, 0.5), app::Entry::request);
  REQUIRE(made);
  stage.open.open(made->document);
  session(stage).view().frame = 8.0;
}

void withControllers(GuiStage& stage) {
  stage.open.open(test::PanelDriver::bundledCharacter());
  session(stage).view().frame = 12.0;
  app::selectControllers(session(stage), {"left-hand", "right-hand"});
  run(stage, app::command::poseKey);
}

void withArmsGraph(GuiStage& stage) {
  stage.open.open(test::PanelDriver::bundledCharacter());
  app::selectLimb(session(stage), "left-arm", false);
  stage.ui.time.tab = BottomTab::graph;
}

void pickAll(app::Session& session) {
  const std::vector<app::KeyRow> rows = app::rowsOfSelection(session);
  app::pickKeys(session, app::allKeys(session.document(), session.view().clip, rows), false);
  REQUIRE(app::hasPickedKeys(session));
}

void withTwoTrails(GuiStage& stage) {
  const app::Document one =
      test::withNewTrail(test::PanelDriver::bundledCharacter(), {.startFrame = 4.0, .endFrame = 24.0});
  stage.open.open(one);
  session(stage).edit(test::withNewTrail(one, {"right-arm", 30.0, 40.0, 2.0, true}), "Exaggerate right arm");
  app::selectTrail(session(stage), one.trails.front().id);
}

void drawRightPanels(PanelContext& context) {
  panelSetOf(context).right(context);
}

struct State {
  const char* name;
  void (*draw)(PanelContext&);
  Prepare prepare;
  float width = 304.0F;
  float height = 0.0F;                  ///< 0: as high as what it shows.
  std::vector<std::string> clicks = {}; ///< Widgets, one after the other.
};

const State panelStates[] = {
    {"trails-group", drawTrailsPanel, withGroup},
    {"trails-group-folded", drawTrailsPanel, withGroup, 304.0F, 0.0F, {"trails/group-1/fold"}},
    {"trails-group-hidden", drawTrailsPanel, withGroup, 304.0F, 0.0F, {"trails/group-1/visible"}},
    {"trails-holds", drawTrailsPanel, withEverything},
    {"trail-settings-group", drawTrailSettingsPanel, withGroup},
    {"trail-settings-slow", drawTrailSettingsPanel,
     [](GuiStage& stage) {
       withGroup(stage);
       app::selectTrail(session(stage), session(stage).document().trails.back().id);
     }},
    {"controllers", drawRightPanels, withControllers},
    {"controller-of-body", drawRightPanels,
     [](GuiStage& stage) {
       stage.open.open(test::PanelDriver::bundledCharacter());
       app::selectController(session(stage), "body", false);
     }},
    {"limb-controllers", drawLimbPanel, withControllers},
    {"limb-controller", drawLimbPanel,
     [](GuiStage& stage) {
       withControllers(stage);
       app::selectController(session(stage), "left-foot", false);
     }},
    {"limb-trails", drawLimbPanel, withGroup},
    {"rig-boxer", drawRigPanel, withEverything},
    {"skin", drawSkinPanel,
     [](GuiStage& stage) {
       withControllers(stage);
       stage.ui.overlays.weights = true;
     }},
    {"timeline-everything", drawBottomPanel, withEverything, 960.0F, 192.0F},
    {"timeline-controllers", drawBottomPanel, withControllers, 960.0F, 192.0F},
    {"timeline-range", drawBottomPanel,
     [](GuiStage& stage) {
       withGroup(stage);
       session(stage).view().rangeStart = 10.0;
       session(stage).view().rangeEnd = 20.0;
       stage.ui.time.timeline.viewStart = 6.0;
       stage.ui.time.timeline.viewEnd = 30.0;
     },
     960.0F, 192.0F},
    {"timeline-playing", drawBottomPanel,
     [](GuiStage& stage) {
       withGroup(stage);
       stage.ui.time.timeline.playing = true;
       stage.ui.time.timeline.speed = 0.5;
       stage.ui.time.timeline.snapToFrames = false;
     },
     960.0F, 192.0F},
    {"graph-keys-picked", drawBottomPanel,
     [](GuiStage& stage) {
       withArmsGraph(stage);
       pickAll(session(stage));
     },
     960.0F, 240.0F},
    {"dope-sheet-keys-picked", drawBottomPanel,
     [](GuiStage& stage) {
       withArmsGraph(stage);
       stage.ui.time.tab = BottomTab::dopeSheet;
       pickAll(session(stage));
     },
     960.0F, 240.0F},
    {"graph-translation", drawBottomPanel,
     [](GuiStage& stage) {
       withArmsGraph(stage);
       stage.ui.time.graph.channels = GraphChannels::translation;
     },
     960.0F, 240.0F},
    {"graph-stretch", drawBottomPanel,
     [](GuiStage& stage) {
       withGroup(stage);
       stage.ui.time.tab = BottomTab::graph;
       stage.ui.time.graph.channels = GraphChannels::stretch;
     },
     960.0F, 240.0F},
    {"graph-controllers", drawBottomPanel,
     [](GuiStage& stage) {
       withControllers(stage);
       stage.ui.time.tab = BottomTab::graph;
     },
     960.0F, 240.0F},
    {"dope-sheet-everything", drawBottomPanel,
     [](GuiStage& stage) {
       withEverything(stage);
       stage.ui.time.tab = BottomTab::dopeSheet;
     },
     960.0F, 240.0F},
    {"dope-sheet-controllers", drawBottomPanel,
     [](GuiStage& stage) {
       withControllers(stage);
       stage.ui.time.tab = BottomTab::dopeSheet;
     },
     960.0F, 240.0F},
    {"status-controllers", drawStatusBar, withControllers, 960.0F, 42.0F},
    {"status-nothing-selected", drawStatusBar,
     [](GuiStage& stage) { stage.open.open(test::PanelDriver::bundledCharacter()); }, 960.0F, 42.0F},
    {"status-limb", drawStatusBar,
     [](GuiStage& stage) {
       stage.open.open(test::PanelDriver::bundledCharacter());
       app::selectLimb(session(stage), "left-arm", false);
     },
     960.0F, 42.0F},
    {"status-no-file", drawStatusBar, [](GuiStage&) {}, 960.0F, 42.0F},
    {"status-busy", drawStatusBar,
     [](GuiStage& stage) {
       withGroup(stage);
       stage.status.busyText = "Opening punch.glb";
       stage.status.busyFraction = 0.6F;
     },
     960.0F, 42.0F},
};

struct StateOfDialogs {
  const char* name;
  float width;
  float height;
  Prepare prepare;
};

const StateOfDialogs dialogStates[] = {
    {"history", 560.0F, 300.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       session(stage).undo();
       stage.ui.dialogs.history.open = true;
     }},
    {"rename-trail", 480.0F, 200.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.trails.rename = {.open = true, .trail = 1, .present = "Left arm", .typed = "Left arm"};
     }},
    {"rename-group", 480.0F, 200.0F,
     [](GuiStage& stage) {
       withGroup(stage);
       stage.ui.trails.rename = {.open = true, .trail = 1, .ofGroup = true, .present = "Both", .typed = ""};
     }},
    {"retime", 480.0F, 360.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.time.retime = {.open = true, .firstFrame = 4.0, .lastFrame = 24.0, .newFrames = 10.0};
     }},
    {"retime-past-end", 480.0F, 420.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.time.retime = {
           .open = true, .firstFrame = 0.0, .lastFrame = 24.0, .newFrames = 4.0, .movesAfter = false};
     }},
    {"range-clash", 600.0F, 240.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.dialogs.rangeClash =
           app::RangeClash{"left-arm", Vec2(4.0, 24.0), Vec2(10.0, 40.0), Vec2(25.0, 40.0)};
     }},
    {"range-clash-no-room", 600.0F, 240.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.dialogs.rangeClash =
           app::RangeClash{"left-arm", Vec2(4.0, 24.0), Vec2(6.0, 20.0), std::nullopt};
     }},
    {"dropped", 600.0F, 240.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.dialogs.dropped = {"/props/bat.glb", true, true};
     }},
    {"dropped-thing", 600.0F, 240.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.dialogs.dropped = {"/props/bat.glb", true, false};
     }},
    {"clips-of-a-file", 560.0F, 360.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.dialogs.clipPick = {
           "/clips/moves.glb", {{"Walk", 1.2}, {"", 0.5}, {"Jump over", 2.25}}, "", 2};
     }},
    {"clips-none-found", 560.0F, 360.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.dialogs.clipPick = {"/clips/moves.glb", {{"Walk", 1.2}, {"Jump", 0.5}}, "swim"};
     }},
    {"palette-nothing-found", 680.0F, 470.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.dialogs.palette = {.open = true, .typed = "zzzz"};
     }},
    {"keys-waiting", 760.0F, 620.0F,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.dialogs.keys = {.open = true,
                                .filter = "undo",
                                .waitingFor = app::command::undo,
                                .clash = "Ctrl+Z belonged to Undo."};
     }},
    {"overwrite", 560.0F, 260.0F,
     [](GuiStage& stage) {
       stage.status.question = {app::FileQuestion::Kind::overwrite, "boxer.glb"};
     }},
    {"files-save", 720.0F, 560.0F,
     [](GuiStage& stage) {
       FileDialogState& files = stage.ui.dialogs.file;
       setenv("HOME", "/characters", 1);
       files.open = files.wasOpen = true;
       files.purpose = FilePurpose::saveModel;
       files.typed = "boxer.glb";
       files.folder = files.listedFolder = "/characters";
       files.entries = {{"clips", true, 0}, {"boxer.glb", false, 2'400'000}};
       files.message = "boxer.glb is there already. Save once more to replace it.";
       files.confirmOverwrite = true;
     }},
    {"files-new-folder", 720.0F, 560.0F,
     [](GuiStage& stage) {
       FileDialogState& files = stage.ui.dialogs.file;
       setenv("HOME", "/characters", 1);
       files.open = files.wasOpen = true;
       files.purpose = FilePurpose::saveFrames;
       files.folder = files.listedFolder = "/characters";
       files.newFolder = "shots";
     }},
};

struct StateOfMenu {
  const char* name;
  MenuTarget target;
  Prepare prepare;
};

const StateOfMenu menuStates[] = {
    {"limb", MenuTarget::limb,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       app::selectLimb(session(stage), "left-arm", false);
     }},
    {"trail", MenuTarget::trail, withTwoTrails},
    {"group", MenuTarget::group, withGroup},
    {"sphere", MenuTarget::sphere,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       session(stage).view().selection.editTrails().spheres = {4.0, 24.0};
     }},
    {"controller", MenuTarget::controller, withControllers},
    {"hold", MenuTarget::hold,
     [](GuiStage& stage) {
       withEverything(stage);
       const auto holds = shownHolds(session(stage).document(), 0);
       stage.ui.menu.hold = barOfHold(holds.at(1).place);
     }},
    {"key", MenuTarget::key,
     [](GuiStage& stage) {
       withTwoTrails(stage);
       stage.ui.menu.frame = 7.0;
     }},
    {"range", MenuTarget::range, withTwoTrails},
    {"time", MenuTarget::time, withTwoTrails},
    {"viewport", MenuTarget::viewport, withControllers},
};

/// Fails with where to look when the picture is another than its baseline.
void compareState(const std::string& name, const Image& picture) {
  const std::string difference =
      test::differenceFromBaseline("state-" + name, picture, test::PictureKind::panel);
  INFO(difference);
  CHECK(difference.empty());
}

} // namespace

TEST_CASE("Picture: panels in the states that work brings them to") {
  GuiPainter painter;
  for (const State& state : panelStates) {
    INFO(state.name);
    GuiStage stage(painter, ThemeKind::dark, state.width, state.height > 0.0F ? state.height : 1800.0F);
    state.prepare(stage);
    float height = stage.showPanel(state.draw, state.height);
    for (const std::string& widget : state.clicks) {
      height = stage.clickInPanel(widget, state.draw, state.height);
    }
    compareState(state.name, stage.picture(height));
  }
}

TEST_CASE("Picture: dialogs in the states that work brings them to") {
  GuiPainter painter;
  for (const StateOfDialogs& state : dialogStates) {
    INFO(state.name);
    GuiStage stage(painter, ThemeKind::dark, state.width, state.height);
    state.prepare(stage);
    stage.showDialogs();
    compareState(std::string("dialog-") + state.name, stage.picture());
  }
}

TEST_CASE("Picture: the menu of each thing under the mouse") {
  GuiPainter painter;
  for (const StateOfMenu& state : menuStates) {
    INFO(state.name);
    GuiStage stage(painter, ThemeKind::dark, 360.0F, 620.0F);
    state.prepare(stage);
    askForMenu(stage.ui, state.target, MenuPlace{10.0F, 4.0F, 8.0F});
    stage.show(drawContextMenu);
    compareState(std::string("menu-") + state.name, stage.picture());
  }
}
