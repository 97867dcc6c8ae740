#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/edits/trail/trail_edits.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/editor_stage.h"

using namespace stretch;

namespace {

ui::ClipStyleState& openedDialog(test::EditorStage& stage) {
  test::withLimb(stage.work());
  stage.run(app::command::clipExaggerate);
  stage.settle();
  return stage.shell.ui.trails.clipStyle;
}

void setStrength(test::EditorStage& stage, double strength) {
  ui::ClipStyleState& state = stage.shell.ui.trails.clipStyle;
  state.strength = strength;
  state.changed = true;
  stage.frames(2);
  stage.settle();
  stage.frames(2);
}

} // namespace

TEST_CASE(
    "A clip that is to be kept before it is known that nothing of it is exaggerated stays in its dialog",
    "[jobs]") {
  test::EditorStage stage;
  ui::ClipStyleState& state = openedDialog(stage);
  const auto keep = [&](double strength) {
    state.accepted = true;
    setStrength(stage, strength);
    return !state.open;
  };
  CHECK_FALSE(keep(0.0));
  CHECK_FALSE(state.accepted);
  CHECK(ui::whyNothing(state) == "the strength is 0");
  CHECK(stage.session().document().trails.empty());
  CHECK(keep(1.0));
  CHECK_FALSE(stage.session().document().trails.empty());
}

TEST_CASE("Left and Right go through the styles, Page up and down change the strength, within their ends") {
  test::EditorStage stage;
  ui::ClipStyleState& state = openedDialog(stage);
  state.style = 0;
  state.strength = 1.0;
  stage.pressWidgetKey(ImGuiKey_LeftArrow);
  CHECK(state.style == 0);
  stage.pressWidgetKey(ImGuiKey_RightArrow);
  stage.pressWidgetKey(ImGuiKey_RightArrow);
  CHECK(state.style == 2);
  stage.pressWidgetKey(ImGuiKey_LeftArrow);
  CHECK(state.style == 1);
  stage.pressWidgetKey(ImGuiKey_PageUp);
  CHECK(state.strength == Approx(1.1));
  for (int i = 0; i < 15; ++i) {
    stage.pressWidgetKey(ImGuiKey_PageDown);
  }
  CHECK(state.strength == 0.0);
  CHECK(stage.shell.ui.trails.clipStyle.open);
}

TEST_CASE("The switch of a moment that is left out takes no click, and works again once the moment is not") {
  test::EditorStage stage;
  ui::ClipStyleState& state = openedDialog(stage);
  const auto withStrength = [&](double strength) {
    setStrength(stage, strength);
    REQUIRE(stage.shell.items.find("clip-style/moment-0") != nullptr);
    return stage.shell.items.find("clip-style/moment-0")->enabled;
  };
  CHECK_FALSE(withStrength(0.0));
  stage.click("clip-style/moment-0");
  CHECK(state.on[0]);
  CHECK(withStrength(1.0));
  stage.click("clip-style/moment-0");
  CHECK_FALSE(state.on[0]);
  CHECK(withStrength(0.0));
}

TEST_CASE("Another file ends the dialog of a clip, and nothing of what it showed is left in either",
          "[jobs]") {
  test::EditorStage stage;
  ui::ClipStyleState& state = openedDialog(stage);
  REQUIRE(state.open);
  REQUIRE_FALSE(stage.session().document().trails.empty()); // shown, not kept
  stage.openBoxer();
  stage.settle();
  CHECK_FALSE(state.open);
  CHECK(stage.session().document().trails.empty());
  CHECK_FALSE(stage.session().history().canUndo());
  // And the next one begins by itself.
  stage.run(app::command::clipExaggerate);
  stage.settle();
  CHECK(state.open);
  CHECK_FALSE(stage.session().document().trails.empty());
}

TEST_CASE("Up to nine moments are seen whole, and what is more is scrolled to") {
  test::EditorStage stage;
  ui::ClipStyleState& state = openedDialog(stage);
  const rig::Moment moment = state.moments.at(0);
  for (const std::size_t count : {1U, 2U, 8U, 9U, 10U, 30U}) {
    state.moments.assign(count, moment);
    state.on.assign(count, false);
    state.made.clear();
    stage.frames(3);
    const auto heightOf = [&](std::size_t i) {
      const ui::Item* const row = stage.shell.items.find("clip-style/moment-" + std::to_string(i));
      return row == nullptr ? 0.0F : row->max.y - row->min.y;
    };
    CAPTURE(count);
    REQUIRE(heightOf(0) > 0.0F);
    std::size_t whole = 0;
    for (std::size_t i = 0; i < count; ++i) {
      whole += heightOf(i) == Approx(heightOf(0)) ? 1 : 0;
    }
    CHECK(whole == std::min<std::size_t>(count, 9));
  }
}

TEST_CASE("While the list of styles is open Enter keeps nothing, and the arrows leave the style") {
  test::EditorStage stage;
  ui::ClipStyleState& state = openedDialog(stage);
  stage.frames(2);
  stage.click("clip-style/style");
  const int style = state.style;
  stage.pressWidgetKey(ImGuiKey_RightArrow);
  stage.pressWidgetKey(ImGuiKey_Enter);
  CHECK(state.style == style);
  CHECK(state.open);
  CHECK(stage.session().history().position() == 0);
}

TEST_CASE(
    "A second style takes the place of the trails that the first one made, and of none that a hand changed") {
  test::EditorStage stage;
  test::withLimb(stage.work());
  ui::ClipStyleState& state = stage.shell.ui.trails.clipStyle;
  const auto exaggerate = [&](double strength) {
    stage.run(app::command::clipExaggerate);
    stage.settle();
    state.strength = strength;
    state.changed = true;
    state.accepted = true;
    stage.frames(2);
    stage.settle();
    stage.frames(2);
    REQUIRE_FALSE(state.open);
    return stage.session().document().trails;
  };
  const std::vector<rig::Trail> gentle = exaggerate(0.5);
  REQUIRE_FALSE(gentle.empty());
  const std::vector<rig::Trail> strong = exaggerate(1.0);
  CHECK(state.replaced.size() == gentle.size());
  REQUIRE(strong.size() == gentle.size());
  for (std::size_t i = 0; i < strong.size(); ++i) {
    CHECK(strong[i].limb == gentle[i].limb);
    CHECK(strong[i].settings.scale > gentle[i].settings.scale);
  }

  // One step back is the first style again, whose trails give way as well.
  stage.session().undo();
  CHECK(stage.session().document().trails == gentle);
  const std::vector<rig::Trail> restyled = exaggerate(1.0);
  REQUIRE(restyled.size() == strong.size());
  CHECK(std::ranges::equal(restyled, strong, {}, &rig::Trail::settings, &rig::Trail::settings));

  // A trail that a hand changed is the hand's.
  rig::TrailSettings settings = strong.front().settings;
  settings.scale += 0.3;
  const app::Document changed =
      *app::setTrailSettings(stage.session().document(), restyled.front().id, settings);
  REQUIRE(stage.session().edit(changed, "Scale"));
  const rig::Trail byHand = stage.session().document().trails.front();
  const std::vector<rig::Trail> again = exaggerate(0.5);
  CHECK(std::ranges::find(again, byHand) != again.end());
  CHECK(state.replaced.size() == strong.size() - 1);
}

TEST_CASE("A clip of years opens no dialog, and the reason is told") {
  test::EditorStage stage;
  test::withLimb(stage.work());
  app::Document document = stage.session().document();
  std::vector<Clip> clips = *document.clips;
  Clip& clip = clips[static_cast<std::size_t>(stage.session().view().clip)];
  clip.endSeconds = 100001.0 / clip.framesPerSecond;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  stage.session().edit(std::move(document), "Edit");
  stage.shell.ui.toasts.clear();
  stage.run(app::command::clipExaggerate);
  CHECK_FALSE(stage.shell.ui.trails.clipStyle.open);
  REQUIRE(stage.shell.ui.toasts.size() == 1);
  CHECK_THAT(stage.shell.ui.toasts[0].text, Catch::Contains("frames, more than 100000"));
}
