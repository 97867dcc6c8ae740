#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/document.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/time/transport.h"
#include "ui/widgets/control.h"

using namespace stretch;
using test::PanelDriver;

namespace {

/// The bundled character with an exaggerated, connected trail of the left arm over frames 4 to 24, selected.
app::Document withTrail() {
  return test::withNewTrail(PanelDriver::bundledCharacter(), {.startFrame = 4.0, .endFrame = 24.0});
}

struct PanelsWithTrail {
  PanelsWithTrail() : driver(withTrail()) {
    app::selectTrail(*driver.open.character(), trailId());
    driver.frames(2);
  }
  [[nodiscard]] int trailId() const { return driver.open.character()->document().trails.front().id; }
  [[nodiscard]] const rig::TrailSettings& settings() const {
    return driver.open.character()->document().trails.front().settings;
  }

  PanelDriver driver;
};

} // namespace

TEST_CASE("An error calls a limb what people call it, and other places by their name") {
  const app::OpenDocument open{app::Opened(withTrail())};
  CHECK(ui::errorLine(open, {"has a trail already", "left-arm", "select it"}) ==
        "Left arm: has a trail already; select it");
  CHECK(ui::errorLine(open, {"is no number", "--scale", ""}) == "--scale: is no number");
}

TEST_CASE("A long name of a hold leaves the frames their room") {
  app::Document document = PanelDriver::bundledCharacter();
  rig::Holds holds;
  holds.grips.resize(1);
  holds.grips[0].leader = "left-arm";
  holds.grips[0].follower = "right-arm";
  holds.grips[0].time.rangeFrames = {4.0, 24.0};
  const Result<app::Document> held = app::placeHolds(document, holds);
  REQUIRE(held);
  PanelDriver driver(*held);
  driver.frames(2);
  const ui::Item* const name = driver.find("timeline/hold-2/name");
  REQUIRE(name != nullptr);
  CHECK(name->max.x - name->min.x <= driver.theme.px(150.0F) + 1.0F);
}

TEST_CASE("A click on the body picture selects a limb, Shift adds another") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.click("limb/left-arm");
  CHECK(driver.open.character()->view().selection.limbs() == std::vector<std::string>{"left-arm"});
  driver.shift = true;
  driver.click("limb/right-leg");
  CHECK(driver.open.character()->view().selection.limbs() ==
        std::vector<std::string>{"left-arm", "right-leg"});
  driver.shift = false;
  driver.click("limb/spine");
  CHECK(driver.open.character()->view().selection.limbs() == std::vector<std::string>{"spine"});
}

TEST_CASE("A click on a limb that was not found asks for its joints") {
  app::Document document = PanelDriver::bundledCharacter();
  std::erase_if(document.body.limbs, [](const rig::Limb& limb) { return limb.id == "neck"; });
  PanelDriver driver(document);
  driver.click("limb/neck");
  CHECK(driver.open.character()->view().selection.limbs().empty());
  CHECK(driver.ui.body.jointPick.open);
  CHECK(driver.ui.body.jointPick.limbId == "neck");
}

TEST_CASE("Dragging the scale is one undo step, however many frames it takes") {
  PanelsWithTrail panels;
  panels.driver.drag("trail/scale", 40.0F, 0.0F);
  CHECK(panels.settings().scale > 2.2);
  CHECK_FALSE(panels.driver.open.character()->isDragging());
  REQUIRE(panels.driver.open.character()->undo());
  CHECK(panels.settings().scale == 2.0);
  CHECK_FALSE(panels.driver.open.character()->history().canUndo());
}

TEST_CASE("Esc during a drag gives the value back and leaves no undo step") {
  PanelsWithTrail panels;
  panels.driver.moveTo("trail/scale");
  panels.driver.pressMouse();
  panels.driver.moveBy(30.0F, 0.0F);
  CHECK(panels.settings().scale > 2.0);
  panels.driver.pressKey(ImGuiKey_Escape);
  CHECK(panels.settings().scale == 2.0);
  panels.driver.releaseMouse();
  CHECK(panels.settings().scale == 2.0);
  CHECK_FALSE(panels.driver.open.character()->history().canUndo());
}

TEST_CASE("A scale is typed after a double click, with a comma as well") {
  PanelsWithTrail panels;
  panels.driver.doubleClick("trail/scale");
  panels.driver.type("3,25");
  panels.driver.pressKey(ImGuiKey_Enter);
  panels.driver.frames(3);
  CHECK(panels.settings().scale == Approx(3.25));
  CHECK_FALSE(panels.driver.open.character()->isDragging());
  CHECK(panels.driver.open.character()->undo());
  CHECK(panels.settings().scale == 2.0);
}

TEST_CASE("A click that does not move changes nothing") {
  PanelsWithTrail panels;
  panels.driver.click("trail/scale");
  CHECK(panels.settings().scale == 2.0);
  CHECK_FALSE(panels.driver.open.character()->history().canUndo());
}

TEST_CASE("Axes are switched one by one, or Shift leaves only one on") {
  PanelsWithTrail panels;
  panels.driver.click("trail/axes/Y");
  CHECK(panels.settings().axes == std::array<bool, 3>{true, false, true});
  panels.driver.shift = true;
  panels.driver.click("trail/axes/Y");
  CHECK(panels.settings().axes == std::array<bool, 3>{false, true, false});
}

TEST_CASE("Choices and switches of the trail settings reach the document") {
  PanelsWithTrail panels;
  panels.driver.click("trail/pivot/End");
  CHECK(panels.settings().pivot == rig::Pivot::end);
  panels.driver.click("trail/space/Root");
  CHECK(panels.settings().space == rig::TrailSpace::root);
  panels.driver.click("trail/reference/Rest");
  CHECK(panels.settings().reference == rig::Reference::rest);
  panels.driver.click("trail/bend/Straighten");
  CHECK(panels.settings().bend == rig::Bend::straighten);
  panels.driver.click("trail/remap/Linear");
  CHECK(panels.settings().remap == rig::RemapKind::linear);
  panels.driver.click("trail/pull");
  CHECK_FALSE(panels.settings().pull);
  panels.driver.click("trail/stay_in_world");
  CHECK(panels.settings().stayInWorld);
}

TEST_CASE("The space of the view takes the camera's axes") {
  PanelsWithTrail panels;
  const Mat3 fromTheSide = Mat3(Vec3(0.0, 0.0, -1.0), Vec3(0.0, 1.0, 0.0), Vec3(1.0, 0.0, 0.0));
  panels.driver.open.character()->view().cameraAxes = fromTheSide;
  panels.driver.click("trail/space/View");
  CHECK(panels.settings().space == rig::TrailSpace::view);
  CHECK(panels.settings().viewAxes == fromTheSide);
}

TEST_CASE("An ease point is dragged out of its corner") {
  PanelsWithTrail panels;
  panels.driver.drag("trail/remap-curve/ease-in", 60.0F, -30.0F);
  CHECK(panels.settings().easeIn.percent > 0.1);
  CHECK(panels.settings().easeIn.value > 0.05);
  CHECK(panels.settings().easeOut.percent == 0.0);
  CHECK(panels.driver.open.character()->undo());
  CHECK(panels.settings().easeIn.percent == 0.0);
}

TEST_CASE("The ends of a trail are dragged in the timeline") {
  PanelsWithTrail panels;
  const std::string bar = "timeline/trail-" + std::to_string(panels.trailId());
  const double pixelsPerFrame =
      static_cast<double>(panels.driver.centreOf(bar + "/end").x - panels.driver.centreOf(bar + "/start").x) /
      20.0;
  panels.driver.drag(bar + "/end", static_cast<float>(pixelsPerFrame * 6.0), 0.0F);
  CHECK(panels.settings().endFrame == 30.0);
  CHECK(panels.settings().startFrame == 4.0);
  panels.driver.drag(bar + "/body", static_cast<float>(pixelsPerFrame * 2.0), 0.0F);
  CHECK(panels.settings().startFrame == 6.0);
  CHECK(panels.settings().endFrame == 32.0);
  CHECK(panels.driver.open.character()->undo());
  CHECK(panels.driver.open.character()->undo());
  CHECK(panels.settings().endFrame == 24.0);
}

TEST_CASE("The working range and the playhead are set in the ruler, outside of undo") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.click("limb/left-arm");
  driver.drag("timeline/range-start", 100.0F, 0.0F);
  CHECK(driver.open.character()->view().rangeStart > 0.0);
  CHECK(driver.open.character()->view().rangeEnd > driver.open.character()->view().rangeStart);
  driver.click("timeline");
  CHECK(driver.open.character()->view().frame > 0.0);
  CHECK(driver.open.character()->view().frame == std::round(driver.open.character()->view().frame));
  CHECK_FALSE(driver.open.character()->history().canUndo());
}

TEST_CASE("Buttons ask for commands and do not run them") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.click("limb/left-arm");
  driver.click(ui::command::trailExaggerate);
  CHECK(driver.requested == std::vector<std::string>{ui::command::trailExaggerate});
  CHECK(driver.open.character()->document().trails.empty());
}

TEST_CASE("A trail is hidden, pinned and deleted from its row") {
  PanelsWithTrail panels;
  const std::string row = "trails/" + std::to_string(panels.trailId());
  panels.driver.click(row + "/visible");
  CHECK_FALSE(panels.driver.open.character()->document().trails.front().visible);
  panels.driver.click(row + "/pinned");
  CHECK(panels.driver.open.character()->document().trails.front().pinned);
  panels.driver.click(row + "/delete");
  CHECK(panels.driver.open.character()->document().trails.empty());
}

TEST_CASE("While another part of the program drags, panels leave the document alone") {
  PanelsWithTrail panels;
  panels.driver.open.character()->begin("a tool of the viewport");
  panels.driver.drag("trail/scale", 40.0F, 0.0F);
  panels.driver.click("trail/pivot/End");
  CHECK(panels.driver.open.character()->isDragging());
  CHECK(panels.settings().scale == 2.0);
  CHECK(panels.settings().pivot == rig::Pivot::start);
}

TEST_CASE("No two widgets have the same id") {
  PanelsWithTrail panels;
  for (const ui::BottomTab tab : {ui::BottomTab::timeline, ui::BottomTab::graph, ui::BottomTab::dopeSheet}) {
    panels.driver.ui.time.tab = tab;
    panels.driver.frames(2);
    std::set<std::string> seen;
    for (const ui::Item& item : panels.driver.items.items) {
      CAPTURE(item.id);
      CHECK(seen.insert(item.id).second);
    }
  }
}

TEST_CASE("Without a file the panels say what to do") {
  PanelDriver driver(std::nullopt);
  driver.frames(2);
  driver.click(ui::command::fileOpen);
  CHECK(driver.requested == std::vector<std::string>{ui::command::fileOpen});
}

TEST_CASE("The graph shows the curves of the selected limb, with the source beside them where a trail acts") {
  PanelsWithTrail panels;
  panels.driver.ui.time.tab = ui::BottomTab::graph;
  panels.driver.ui.time.graph.channels = ui::GraphChannels::stretch;
  panels.driver.frames(2);
  REQUIRE(panels.driver.ui.time.graph.curves.size() == 1);
  const ui::Curve& length = panels.driver.ui.time.graph.curves.front();
  CHECK(ui::curveValue(length.points, 24.0) ==
        Approx(2.0 * ui::curveValue(length.before, 24.0)).epsilon(1e-3));
  CHECK(ui::curveValue(length.points, 0.0) == Approx(ui::curveValue(length.before, 0.0)));
}

TEST_CASE("A warning of a trail is read in full where it was cut, and does not stay out of sight") {
  app::Document document = withTrail();
  document.trails.front().settings.axes = {false, false, false}; // Nothing to scale.
  PanelDriver driver(document);
  app::selectTrail(*driver.open.character(), document.trails.front().id);
  driver.frames(4);
  REQUIRE(driver.find("trail/messages") != nullptr);
  const ui::Item cut = *driver.find("trail/messages");
  CHECK(cut.explained);
  driver.rightPaneHeight = cut.max.y + 4.0F - 40.0F; // It is the last that the panel shows.
  driver.frames(2);
  driver.click("trail/messages");
  const ui::Item whole = *driver.find("trail/messages");
  const float line = driver.theme.px(12.0F);
  CHECK(whole.max.y - whole.min.y > cut.max.y - cut.min.y + line);
  driver.rightPaneHeight = 2200.0F;
  driver.frames(2);
  const ui::Item unclipped = *driver.find("trail/messages");
  CHECK(unclipped.max.y - unclipped.min.y == whole.max.y - whole.min.y); // All of it was in sight.
  driver.click("trail/messages");
  const ui::Item folded = *driver.find("trail/messages");
  CHECK(folded.max.y - folded.min.y == cut.max.y - cut.min.y);
}

TEST_CASE("The playhead's time is told apart from the working range") {
  CHECK(ui::timeWords(1.0, {"range 21-27"}) == "time 1 s  \xC2\xB7  range 21-27");
  CHECK(ui::timeWords(0.25, {"", "24 fps"}) == "time 0.25 s  \xC2\xB7  24 fps");
}

TEST_CASE("The menu of a key leaves trails alone") {
  PanelsWithTrail panels;
  PanelDriver& driver = panels.driver;
  driver.ui.menu.asked = ui::MenuTarget::key;
  driver.frames(3);
  CHECK(driver.find("context/trail.copy") != nullptr);
  CHECK(driver.find("context/trail.delete") == nullptr);
}

TEST_CASE("Every widget that can be used says what it does") {
  PanelsWithTrail panels;
  for (const ui::BottomTab tab : {ui::BottomTab::timeline, ui::BottomTab::graph}) {
    panels.driver.ui.time.tab = tab;
    panels.driver.frames(2);
    for (const ui::Item& item : panels.driver.items.items) {
      // Menus open on a click, and parts of pictures explain themselves under the mouse.
      const bool picture = item.id.rfind("menu/", 0) == 0 || item.id.rfind("limb", 0) == 0 ||
                           item.id.rfind("timeline", 0) == 0 || item.id == "graph" ||
                           item.id.rfind("graph-key/", 0) == 0 ||
                           item.id.rfind("trail/remap-curve", 0) == 0 || item.id.rfind("label:", 0) == 0;
      CAPTURE(item.id);
      CHECK((picture || !item.enabled || item.explained));
    }
  }
}

TEST_CASE("A style gives the limb the scale that was measured in its cartoon") {
  PanelsWithTrail panels;
  panels.driver.click("trail/style");
  panels.driver.click("trail/style/Tortoise Wins by a Hare (1943)");
  CHECK(panels.settings().scale == Approx(2.4));
}

TEST_CASE("Another clip starts at its first frame, with nothing selected in time") {
  PanelsWithTrail panels;
  REQUIRE(panels.driver.open.character()->document().clips->size() > 1);
  panels.driver.open.character()->view().frame = 8.0;
  panels.driver.click("rig/clip");
  const std::string name = panels.driver.open.character()->document().clips->at(1).name;
  panels.driver.click("rig/clip/" + name);
  CHECK(panels.driver.open.character()->view().clip == 1);
  CHECK(panels.driver.open.character()->view().frame == 0.0);
  CHECK(panels.driver.open.character()->view().selection.trail() == 0);
}

TEST_CASE("The weight of a limb is switched by a command and shaped by sliders, one undo step a drag") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.commands.push_back({ui::command::weightToggle, "Weight on or off", "Help.", "", true, false});
  driver.click("limb/left-arm");
  driver.click("weight/on");
  CHECK(driver.requested == std::vector<std::string>{ui::command::weightToggle});
  const Result<app::Document> heavy =
      app::switchWeight(driver.open.character()->document(), {"left-arm", "left-leg"}, 0, true);
  REQUIRE(heavy.ok());
  driver.open.character()->edit(*heavy, "Give weight");
  driver.frames(2);
  const auto settings = [&](const char* limb) -> const app::WeightSettings& {
    return app::findWeight(driver.open.character()->document(), limb, 0)->settings;
  };
  driver.drag("weight/stiffness", 30.0F, 0.0F);
  CHECK(settings("left-arm").stiffness > 1.05);
  CHECK(settings("left-leg").stiffness == 1.0);
  REQUIRE(driver.open.character()->undo());
  CHECK(settings("left-arm").stiffness == 1.0);
  driver.drag("weight/bone-1", 20.0F, 0.0F);
  REQUIRE(settings("left-arm").moduli.size() == 1);
  CHECK(settings("left-arm").moduli.front().first == 1);
  driver.click("weight/young-auto");
  CHECK(settings("left-arm").youngModulus.has_value());
  driver.click("weight/young-auto");
  CHECK_FALSE(settings("left-arm").youngModulus.has_value());
  driver.drag("weight/range-start", 20.0F, 0.0F);
  CHECK(settings("left-arm").rangeFrames.has_value());
}

TEST_CASE("Weight is shaped for all selected limbs that have it") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.open.character()->edit(
      *app::switchWeight(driver.open.character()->document(), {"left-arm", "right-arm"}, 0, true),
      "Give weight");
  driver.open.character()->view().selection.editTrails().limbs = {"left-arm", "right-arm", "spine"};
  driver.frames(2);
  driver.drag("weight/amount", -40.0F, 0.0F);
  CHECK(app::findWeight(driver.open.character()->document(), "left-arm", 0)->settings.amount < 1.0);
  CHECK(app::findWeight(driver.open.character()->document(), "right-arm", 0)->settings.amount ==
        app::findWeight(driver.open.character()->document(), "left-arm", 0)->settings.amount);
  CHECK(app::findWeight(driver.open.character()->document(), "spine", 0) == nullptr);
}

TEST_CASE("A clip of tens of thousands of frames shows its frame and the last number of its ruler whole") {
  app::Document document = PanelDriver::bundledCharacter();
  std::vector<Clip> clips = *document.clips;
  clips.front().endSeconds = 50000.0 / clips.front().framesPerSecond;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  PanelDriver driver(document);
  driver.open.character()->view().frame = 12345.0;
  driver.frames(3);
  const std::vector<std::string> words = test::shownWords();
  const auto shows = [&](const char* text) { return std::ranges::count(words, text); };
  CHECK(shows("12345") == 2); // The field, and the flag of the playhead.
  REQUIRE(shows("50000") == 1);
  const ImDrawData& drawn = *ImGui::GetDrawData();
  for (int i = 0; i < drawn.CmdListsCount; ++i) {
    for (const test::DrawnWords& one : test::wordsOf(*drawn.CmdLists[i])) {
      const float edge = drawn.CmdLists[i]->CmdBuffer.front().ClipRect.z;
      CHECK((one.text != "50000" ||
             one.at.x + ui::textSize(driver.theme.fonts.label, one.text).x <= edge + 1.0F));
    }
  }
}
