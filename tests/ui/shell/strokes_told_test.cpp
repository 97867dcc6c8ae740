// What E and N tell of the strokes that they take.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/shell/shell_commands.h"
#include "ui/shell/stroke_news.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The bundled character in the editor, with limbs selected.
struct Strokes {
  explicit Strokes(std::vector<std::string> limbs) {
    shell.open.open(app::Opened{test::PanelDriver::bundledCharacter()});
    shell.commands = editorCommands();
    shell.keymap = app::Keymap(app::keyedCommands(shell.commands));
    session().view().selection.editTrails().limbs = std::move(limbs);
  }
  [[nodiscard]] app::Session& session() { return *shell.open.character(); }
  [[nodiscard]] const ExaggerateTool& tool() const { return std::get<ExaggerateTool>(shell.tool); }
  void begin() {
    runCommand(shell, command::trailExaggerate);
    REQUIRE(isRunning(shell.tool));
  }
  [[nodiscard]] std::string told() const {
    std::string all;
    for (const Toast& toast : shell.ui.toasts) {
      all += toast.text + "\n";
    }
    return all;
  }

  Shell shell;
};

const std::string ownStrokes = "Each limb has its own stroke";

} // namespace

TEST_CASE("N tells which of the limb's strokes is taken, counted in time from the first to the last") {
  Strokes stage({"left-arm"});
  std::vector<rig::Moment> strokes = stage.session().momentsOf("left-arm");
  REQUIRE(strokes.size() > 1);
  stage.begin();
  for (std::size_t place = 0; place < strokes.size(); ++place) {
    app::Document document = stage.session().document();
    rig::TrailSettings& settings = document.trails.front().settings;
    settings.startFrame = strokes[place].startFrame;
    settings.endFrame = strokes[place].endFrame;
    stage.session().preview(document);
    CAPTURE(place);
    CHECK_THAT(strokeReached(stage.session(), stage.tool()),
               Catch::StartsWith(fmt::format("Frames {:.4g} to {:.4g}, stroke {} of {} of the left arm",
                                             strokes[place].startFrame, strokes[place].endFrame, place + 1,
                                             strokes.size())));
    settings.startFrame += 0.5;
    stage.session().preview(document);
    CHECK(strokeReached(stage.session(), stage.tool()).empty()); // That is none of them.
  }
}

TEST_CASE("E on limbs that strike at other times says that each has its own stroke") {
  Strokes stage({"left-arm", "right-arm"});
  stage.begin();
  REQUIRE(stage.session().document().trails.size() == 2);
  const auto& trails = stage.session().document().trails;
  REQUIRE(trails[0].settings.startFrame != trails[1].settings.startFrame);
  CHECK_THAT(stage.told(), Catch::Contains(ownStrokes));
}

TEST_CASE("Limbs of one range, one limb, and limbs of which one had its trail before have no such news") {
  SECTION("one range") {
    Strokes stage({"left-arm", "right-arm"});
    app::setRangeByHand(stage.session(), {20.0, 30.0});
    stage.begin();
    REQUIRE(stage.session().document().trails.size() == 2);
    CHECK_THAT(strokeNews(stage.session(), stage.tool()), !Catch::Contains(ownStrokes));
  }
  SECTION("one limb") {
    Strokes stage({"left-arm"});
    stage.begin();
    CHECK_THAT(stage.told(), !Catch::Contains(ownStrokes));
  }
  SECTION("a trail of before") {
    Strokes stage({"left-arm", "right-arm"});
    const rig::Moment strongest = *rig::strongestMoment(stage.session().momentsOf("left-arm"));
    stage.session().restore(test::withNewTrail(
        stage.session().document(), {"left-arm", strongest.startFrame, strongest.endFrame, 2.0, true}));
    stage.begin();
    REQUIRE(stage.tool().targets.trailIds.size() == 2);
    CHECK_THAT(strokeNews(stage.session(), stage.tool()), !Catch::Contains(ownStrokes));
  }
}

TEST_CASE("E at a weaker stroke says which is taken, where the strongest is, and that it is free") {
  Strokes stage({"left-arm"});
  const std::vector<rig::Moment> strokes = stage.session().momentsOf("left-arm");
  const rig::Moment strongest = *rig::strongestMoment(strokes);
  const auto weaker = std::ranges::find_if(strokes, [&](const rig::Moment& stroke) {
    return stroke.startFrame > 0.5 &&
           (stroke.endFrame < strongest.startFrame || stroke.startFrame > strongest.endFrame);
  });
  REQUIRE(weaker != strokes.end());
  stage.session().view().frame = std::round(0.5 * (weaker->startFrame + weaker->endFrame));
  stage.begin();
  CHECK_THAT(stage.told(),
             Catch::Contains(fmt::format("The left arm's stroke here is taken, frames {:.4g} to {:.4g}; the "
                                         "strongest, {:.4g} to {:.4g}, is free",
                                         weaker->startFrame, weaker->endFrame, strongest.startFrame,
                                         strongest.endFrame)));
}
