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
#include "tests/support/recorded.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/picture_baseline.h"
#include "tests/support/ui/work.h"
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

using Prepare = void (*)(const test::Work&);

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
    {"trails-group", drawTrailsPanel, test::withGroup},
    {"trails-group-folded", drawTrailsPanel, test::withGroup, 304.0F, 0.0F, {"trails/group-1/fold"}},
    {"trails-group-hidden", drawTrailsPanel, test::withGroup, 304.0F, 0.0F, {"trails/group-1/visible"}},
    {"trails-two-selected", drawTrailsPanel,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       const std::vector<rig::Trail>& trails = work.session().document().trails;
       app::selectTrailInList(work.session(), trails[0].id, false);
       app::selectTrailInList(work.session(), trails[1].id, true);
     }},
    {"trails-holds", drawTrailsPanel, test::withEverything},
    {"trail-settings-group", drawTrailSettingsPanel, test::withGroup},
    {"trail-settings-slow", drawTrailSettingsPanel,
     [](const test::Work& work) {
       test::withGroup(work);
       app::selectTrail(work.session(), work.session().document().trails.back().id);
     }},
    {"controllers", drawRightPanels, test::withControllers},
    {"controller-of-body", drawRightPanels,
     [](const test::Work& work) {
       work.open.open(test::PanelDriver::bundledCharacter());
       app::selectController(work.session(), "body", false);
     }},
    {"limb-controllers", drawLimbPanel, test::withControllers},
    {"limb-controller", drawLimbPanel,
     [](const test::Work& work) {
       test::withControllers(work);
       app::selectController(work.session(), "left-foot", false);
     }},
    {"limb-trails", drawLimbPanel, test::withGroup},
    {"rig-boxer", drawRigPanel, test::withEverything},
    {"skin", drawSkinPanel,
     [](const test::Work& work) {
       test::withControllers(work);
       work.ui.overlays.weights = true;
     }},
    {"timeline-everything", drawBottomPanel, test::withEverything, 960.0F, 192.0F},
    {"timeline-controllers", drawBottomPanel, test::withControllers, 960.0F, 192.0F},
    {"timeline-range", drawBottomPanel,
     [](const test::Work& work) {
       test::withGroup(work);
       work.session().view().rangeStart = 10.0;
       work.session().view().rangeEnd = 20.0;
       work.ui.time.timeline.viewStart = 6.0;
       work.ui.time.timeline.viewEnd = 30.0;
     },
     960.0F, 192.0F},
    {"timeline-playing", drawBottomPanel,
     [](const test::Work& work) {
       test::withGroup(work);
       work.ui.time.timeline.playing = true;
       work.ui.time.timeline.speed = 0.5;
       work.ui.time.timeline.snapToFrames = false;
     },
     960.0F, 192.0F},
    {"graph-keys-picked", drawBottomPanel,
     [](const test::Work& work) {
       test::withArmsGraph(work);
       test::pickAll(work);
     },
     960.0F, 240.0F},
    {"dope-sheet-keys-picked", drawBottomPanel,
     [](const test::Work& work) {
       test::withArmsGraph(work);
       work.ui.time.tab = BottomTab::dopeSheet;
       test::pickAll(work);
     },
     960.0F, 240.0F},
    {"graph-translation", drawBottomPanel,
     [](const test::Work& work) {
       test::withArmsGraph(work);
       work.ui.time.graph.channels = GraphChannels::translation;
     },
     960.0F, 240.0F},
    {"graph-stretch", drawBottomPanel,
     [](const test::Work& work) {
       test::withGroup(work);
       work.ui.time.tab = BottomTab::graph;
       work.ui.time.graph.channels = GraphChannels::stretch;
     },
     960.0F, 240.0F},
    {"graph-controllers", drawBottomPanel,
     [](const test::Work& work) {
       test::withControllers(work);
       work.ui.time.tab = BottomTab::graph;
     },
     960.0F, 240.0F},
    {"dope-sheet-everything", drawBottomPanel,
     [](const test::Work& work) {
       test::withEverything(work);
       work.ui.time.tab = BottomTab::dopeSheet;
     },
     960.0F, 240.0F},
    {"dope-sheet-controllers", drawBottomPanel,
     [](const test::Work& work) {
       test::withControllers(work);
       work.ui.time.tab = BottomTab::dopeSheet;
     },
     960.0F, 240.0F},
    {"status-controllers", drawStatusBar, test::withControllers, 960.0F, 42.0F},
    {"status-nothing-selected", drawStatusBar,
     [](const test::Work& work) { work.open.open(test::PanelDriver::bundledCharacter()); }, 960.0F, 42.0F},
    {"status-limb", drawStatusBar,
     [](const test::Work& work) {
       work.open.open(test::PanelDriver::bundledCharacter());
       app::selectLimb(work.session(), "left-arm", false);
     },
     960.0F, 42.0F},
    {"status-no-file", drawStatusBar, test::withNothing, 960.0F, 42.0F},
    {"status-busy", drawStatusBar,
     [](const test::Work& work) {
       test::withGroup(work);
       work.status.busyText = "Opening punch.glb";
       work.status.busyFraction = 0.6F;
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
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.session().undo();
       work.ui.dialogs.history.open = true;
     }},
    {"rename-trail", 480.0F, 200.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.trails.rename = {.open = true, .trail = 1, .present = "Left arm", .typed = "Left arm"};
     }},
    {"rename-group", 480.0F, 200.0F,
     [](const test::Work& work) {
       test::withGroup(work);
       work.ui.trails.rename = {.open = true, .trail = 1, .ofGroup = true, .present = "Both", .typed = ""};
     }},
    {"retime", 480.0F, 360.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.time.retime = {.open = true, .firstFrame = 4.0, .lastFrame = 24.0, .newFrames = 10.0};
     }},
    {"retime-past-end", 480.0F, 420.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.time.retime = {
           .open = true, .firstFrame = 0.0, .lastFrame = 24.0, .newFrames = 4.0, .movesAfter = false};
     }},
    {"range-clash", 600.0F, 240.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.dialogs.rangeClash =
           app::RangeClash{"left-arm", Vec2(4.0, 24.0), Vec2(10.0, 40.0), Vec2(25.0, 40.0)};
     }},
    {"range-clash-no-room", 600.0F, 240.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.dialogs.rangeClash =
           app::RangeClash{"left-arm", Vec2(4.0, 24.0), Vec2(6.0, 20.0), std::nullopt};
     }},
    {"dropped", 600.0F, 240.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.dialogs.dropped = {"/props/bat.glb", true, true};
     }},
    {"dropped-thing", 600.0F, 240.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.dialogs.dropped = {"/props/bat.glb", true, false};
     }},
    {"clips-of-a-file", 560.0F, 360.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.dialogs.clipPick = {
           "/clips/moves.glb", {{"Walk", 1.2}, {"", 0.5}, {"Jump over", 2.25}}, "", 2};
     }},
    {"clips-none-found", 560.0F, 360.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.dialogs.clipPick = {"/clips/moves.glb", {{"Walk", 1.2}, {"Jump", 0.5}}, "swim"};
     }},
    {"palette-nothing-found", 680.0F, 470.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.dialogs.palette = {.open = true, .typed = "zzzz"};
     }},
    {"keys-waiting", 760.0F, 620.0F,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.dialogs.keys = {.open = true,
                               .filter = "undo",
                               .waitingFor = app::command::undo,
                               .clash = "Ctrl+Z belonged to Undo."};
     }},
    {"overwrite", 560.0F, 260.0F,
     [](const test::Work& work) {
       work.status.question = {app::FileQuestion::Kind::overwrite, "boxer.glb"};
     }},
    {"files-save", 720.0F, 560.0F,
     [](const test::Work& work) {
       FileDialogState& files = work.ui.dialogs.file;
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
     [](const test::Work& work) {
       FileDialogState& files = work.ui.dialogs.file;
       setenv("HOME", "/characters", 1);
       files.open = files.wasOpen = true;
       files.purpose = FilePurpose::saveFilm;
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
     [](const test::Work& work) {
       test::withTwoTrails(work);
       app::selectLimb(work.session(), "left-arm", false);
     }},
    {"trail", MenuTarget::trail, test::withTwoTrails},
    {"group", MenuTarget::group, test::withGroup},
    {"sphere", MenuTarget::sphere,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.session().view().selection.editTrails().spheres = {4.0, 24.0};
     }},
    {"controller", MenuTarget::controller, test::withControllers},
    {"hold", MenuTarget::hold,
     [](const test::Work& work) {
       test::withEverything(work);
       const auto holds = shownHolds(work.session().document(), 0);
       work.ui.menu.hold = barOfHold(holds.at(1).place);
     }},
    {"key", MenuTarget::key,
     [](const test::Work& work) {
       test::withTwoTrails(work);
       work.ui.menu.frame = 7.0;
     }},
    {"range", MenuTarget::range, test::withTwoTrails},
    {"time", MenuTarget::time, test::withTwoTrails},
    {"viewport", MenuTarget::viewport, test::withControllers},
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
  std::string drawn;
  for (const State& state : panelStates) {
    INFO(state.name);
    GuiStage stage(painter, ThemeKind::dark, state.width, state.height > 0.0F ? state.height : 1800.0F);
    state.prepare({stage.open, stage.ui, stage.status});
    float height = stage.showPanel(state.draw, state.height);
    for (const std::string& widget : state.clicks) {
      height = stage.clickInPanel(widget, state.draw, state.height);
    }
    drawn += state.name + ("\n" + test::drawnText());
    compareState(state.name, stage.picture(height));
  }
  test::compareWithRecord("drawn-panels-in-work", drawn);
}

TEST_CASE("Picture: dialogs in the states that work brings them to") {
  GuiPainter painter;
  std::string drawn;
  for (const StateOfDialogs& state : dialogStates) {
    INFO(state.name);
    GuiStage stage(painter, ThemeKind::dark, state.width, state.height);
    state.prepare({stage.open, stage.ui, stage.status});
    stage.showDialogs();
    drawn += state.name + ("\n" + test::drawnText());
    compareState(std::string("dialog-") + state.name, stage.picture());
  }
  test::compareWithRecord("drawn-dialogs-in-work", drawn);
}

TEST_CASE("Picture: the menu of each thing under the mouse") {
  GuiPainter painter;
  std::string drawn;
  for (const StateOfMenu& state : menuStates) {
    INFO(state.name);
    GuiStage stage(painter, ThemeKind::dark, 360.0F, 620.0F);
    state.prepare({stage.open, stage.ui, stage.status});
    askForMenu(stage.ui, state.target, MenuPlace{10.0F, 4.0F, 8.0F});
    stage.show(drawContextMenu);
    drawn += state.name + ("\n" + test::drawnText());
    compareState(std::string("menu-") + state.name, stage.picture());
  }
  test::compareWithRecord("drawn-menus-in-work", drawn);
}
