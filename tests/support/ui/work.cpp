#include "tests/support/ui/work.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/things/place.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/ui/panel_driver.h"

namespace stretch::test {

using namespace ui;

namespace {

app::Document characterOf(const Work& work) {
  app::Document document = PanelDriver::bundledCharacter();
  if (!work.place.empty()) {
    auto source = std::make_shared<std::remove_cvref_t<decltype(*document.source)>>(*document.source);
    source->path = work.place;
    document.source = std::move(source);
  }
  return document;
}

} // namespace

void run(const Work& work, const char* command) {
  const auto& commands = app::documentCommands();
  const auto found = std::ranges::find(commands, std::string(command), &app::DocumentCommand::id);
  REQUIRE(found != commands.end());
  INFO(command);
  REQUIRE(app::isEnabled(*found, work.open));
  REQUIRE(app::run(*found, work.open));
}

void withNothing(const Work&) {}

void withLimb(const Work& work) {
  work.open.open(characterOf(work));
  app::selectLimb(work.session(), "left-arm", false);
}

void withTrail(const Work& work) {
  const app::Document document = withNewTrail(characterOf(work), {.startFrame = 4.0, .endFrame = 24.0});
  work.open.open(document);
  app::selectTrail(work.session(), document.trails.front().id);
  work.session().view().frame = 12.0;
}

void withWeight(const Work& work) {
  withLimb(work);
  work.session().edit(*app::switchWeight(work.session().document(), {"left-arm"}, 0, true), "Give weight");
}

void withSequence(const Work& work) {
  app::SequenceDocument document;
  document.paths = {"tube"};
  document.mesh = std::make_shared<const MeshSequence>(shorteningTube(12, 2.0, 0.06, 0.1));
  document.analysis = std::make_shared<const app::SequenceAnalysis>(app::analyseSequence(*document.mesh));
  document.settings.bones = 8;
  work.open.open(std::move(document));
  work.open.sequence()->view().frame = 5.0;
}

void withCompression(const Work& work) {
  withSequence(work);
  app::SequenceDocument document = work.open.sequence()->document();
  auto made = app::makeCompression(*document.mesh, document.settings);
  REQUIRE(made);
  document.result = std::make_shared<const app::Compression>(std::move(made).value());
  work.open.sequence()->edit(std::move(document), "Compress");
}

void withGroup(const Work& work) {
  app::Document document = characterOf(work);
  document = withNewTrail(document, {.startFrame = 4.0, .endFrame = 24.0, .scale = 3.0});
  document = withNewTrail(document, {"right-arm", 4.0, 24.0, 3.0, true});
  const std::vector<int> both{document.trails[0].id, document.trails[1].id};
  Result<app::Document> grouped = app::groupTrails(document, both);
  REQUIRE(grouped);
  work.open.open(withNewTrail(*grouped, {"left-leg", 30.0, 44.0, 1.5, false}));
  app::selectGroup(work.session(), both.front());
  work.session().view().frame = 12.0;
}

void withEverything(const Work& work) {
  const auto made = app::place(twoPunches(), oneOfEach(0, 0.5), app::Entry::request);
  REQUIRE(made);
  work.open.open(made->document);
  work.session().view().frame = 8.0;
}

void withControllers(const Work& work) {
  work.open.open(characterOf(work));
  work.session().view().frame = 12.0;
  app::selectControllers(work.session(), {"left-hand", "right-hand"});
  run(work, app::command::poseKey);
}

void withArmsGraph(const Work& work) {
  work.open.open(characterOf(work));
  app::selectLimb(work.session(), "left-arm", false);
  work.ui.time.tab = BottomTab::graph;
}

void withTwoTrails(const Work& work) {
  const app::Document one = withNewTrail(characterOf(work), {.startFrame = 4.0, .endFrame = 24.0});
  work.open.open(one);
  work.session().edit(withNewTrail(one, {"right-arm", 30.0, 40.0, 2.0, true}), "Exaggerate right arm");
  app::selectTrail(work.session(), one.trails.front().id);
}

void pickAll(const Work& work) {
  app::Session& session = work.session();
  const std::vector<app::KeyRow> rows = app::rowsOfSelection(session);
  app::pickKeys(session, app::allKeys(session.document(), session.view().clip, rows), false);
  REQUIRE(app::hasPickedKeys(session));
}

} // namespace stretch::test
