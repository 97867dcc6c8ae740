#include <algorithm>
#include <filesystem>
#include <optional>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/edits/body/limb_edits.h"
#include "app/edits/pose/prop_file_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/files/save.h"
#include "app/files/saved_work.h"
#include "app/named.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/refusal.h"
#include "tests/support/rig/character_file.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/moving_creatures.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;

namespace {

Document horse() {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  Document document;
  document.scene = std::make_shared<const Scene>(build(body).scene);
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>(1));
  document.body = rig::detectBody(*document.scene);
  return document;
}

/// A file of rigid parts that stand as a person does.
void writeFigure(const std::filesystem::path& path) {
  SyntheticBiped figure = makeBody();
  figure.withSkin = false;
  nameByKeys(figure);
  Scene scene = build(figure).scene;
  Primitive part;
  part.positions = {{0.0F, 0.0F, 0.0F}, {0.05F, 0.0F, 0.0F}, {0.0F, 0.05F, 0.05F}};
  scene.meshes = {{"part", {part}, {}}};
  for (Node& node : scene.nodes) {
    node.mesh = 0;
  }
  characterFile(scene, {}).write(path);
}

std::size_t countOf(const std::vector<rig::Limb>& limbs, const std::string& id) {
  return static_cast<std::size_t>(std::ranges::count(limbs, id, &rig::Limb::id));
}

const DocumentCommand& commandOf(const std::vector<DocumentCommand>& all, const std::string& id) {
  const auto found = std::ranges::find(all, id, &DocumentCommand::id);
  REQUIRE(found != all.end());
  return *found;
}

} // namespace

TEST_CASE("The keys go to a horse's limbs from front to back, the left one first") {
  const Document document = horse();
  CHECK(limbsByKey(document) == std::vector<std::string>{"front-left-leg", "front-right-leg", "hind-left-leg",
                                                         "hind-right-leg", "spine", "neck", "tail"});
  CHECK(limbTitle(document, "hind-left-leg") == "hind left leg");
}

TEST_CASE("Another body plan replaces the limbs, and takes along what was set up for those that are gone") {
  Document document = horse();
  document.weights.push_back({"tail", 0, true, {}});
  document.weights.push_back({"spine", 0, true, {}});
  const Result<Document> changed = changePlan(document, "spider");
  REQUIRE(changed);
  CHECK(changed->body.plan == "spider");
  CHECK(changed->limbsCorrected);
  CHECK(findLimb(*changed, "front-left-leg") == nullptr);
  CHECK(findLimb(*changed, "left-leg") != nullptr);
  const Result<Document> other = changePlan(document, "other");
  REQUIRE(other);
  CHECK(other->weights.empty());
  CHECK_THAT(test::refusal(changePlan(document, "centaur")),
             Catch::StartsWith("plan: there is no body plan 'centaur'"));
}

TEST_CASE("What holds a limb that another body plan lacks goes with it, as leader and as follower, and what "
          "holds the "
          "others stays") {
  Document document = horse();
  const Result<Document> bare = changePlan(document, "spider");
  REQUIRE(bare);
  std::vector<std::string> kept;
  std::vector<std::string> gone;
  for (const rig::Limb& limb : document.body.limbs) {
    (findLimb(*bare, limb.id) != nullptr ? kept : gone).push_back(limb.id);
  }
  REQUIRE(kept.size() >= 2);
  REQUIRE(gone.size() >= 2);
  const auto pinOf = [](const std::string& limb) {
    rig::Pin pin;
    pin.limb = limb;
    return pin;
  };
  const auto gripOf = [](const std::string& follower, const std::string& leader) {
    rig::Grip grip;
    grip.follower = follower;
    grip.leader = leader;
    return grip;
  };
  const auto propOf = [](const std::vector<std::string>& hands) {
    rig::Prop prop;
    for (const std::string& hand : hands) {
      prop.hands.push_back({.limb = hand, .keys = {{.frame = 0.0, .value = 1.0}}});
    }
    return prop;
  };
  document.holds.pins = {pinOf(gone[0]), pinOf(kept[0])};
  document.holds.grips = {gripOf(kept[0], gone[0]), gripOf(gone[0], kept[0]), gripOf(gone[0], gone[1]),
                          gripOf(kept[0], kept[1])};
  document.holds.props = {propOf({gone[0]}), propOf({kept[0], gone[0]}), propOf({kept[0], kept[1]})};
  const Result<Document> changed = changePlan(document, "spider");
  REQUIRE(changed);
  CHECK(changed->holds.pins == std::vector{pinOf(kept[0])});
  CHECK(changed->holds.grips == std::vector{gripOf(kept[0], kept[1])});
  REQUIRE(changed->holds.props.size() == 1);
  CHECK(changed->holds.props.front().hands == propOf({kept[0], kept[1]}).hands);
}

TEST_CASE("A file keeps the limbs of a horse, and a plan that was chosen by hand") {
  const Document document = horse();
  const Document chosen = *changePlan(document, "other");
  Document again = document;
  REQUIRE(restoreWork(workOf(chosen), again));
  CHECK(again.body.plan == "other");
  CHECK(again.body.limbs.size() == chosen.body.limbs.size());

  Document corrected = document;
  corrected.limbsCorrected = true;
  Document opened = document;
  opened.body = rig::Body();
  REQUIRE(restoreWork(workOf(corrected), opened));
  CHECK(opened.body.plan == "quadruped");
  REQUIRE(opened.body.limbs.size() == document.body.limbs.size());
  for (std::size_t i = 0; i < opened.body.limbs.size(); ++i) {
    CHECK(opened.body.limbs[i].id == document.body.limbs[i].id);
    CHECK(static_cast<const rig::LimbPlace&>(opened.body.limbs[i]) ==
          static_cast<const rig::LimbPlace&>(document.body.limbs[i]));
  }
}

TEST_CASE("A horse whose limbs were left as they were found is a horse again when its work is read") {
  const Document document = setLooping(horse(), 0, true);
  REQUIRE_FALSE(document.limbsCorrected);
  Document again = horse();
  REQUIRE(restoreWork(workOf(document), again));
  CHECK(again.body.plan == "quadruped");
  CHECK(again.body.limbs.size() == document.body.limbs.size());
}

TEST_CASE("A plan that was chosen by hand is read from the character alone when its file opens with a prop") {
  const TemporaryFolder folder;
  creatureFile(strikingSnake()).write(folder / "snake.glb");
  writeFigure(folder / "figure.glb");
  const Result<AddedProp> added =
      withPropFile(openedFile((folder / "snake.glb").string()), {folder / "figure.glb", {}, 0, 0.0, {}});
  REQUIRE(added);
  const Document chosen = *changePlan(added->document, "other");
  Document again = added->document;
  REQUIRE(restoreWork(workOf(chosen), again));
  CHECK(again.body.hips == chosen.body.hips);
  CHECK(again.body.head == chosen.body.head);
}

TEST_CASE("Two bodies of the same limbs and of different plans are two documents") {
  const Document document = horse();
  Document other = document;
  other.body.plan = "other";
  CHECK_FALSE(sameDocument(document, other));
}

TEST_CASE("A picked chain that is a limb of the new body stands once under its id") {
  const Document before = horse();
  const Document other = *changePlan(before, "other");
  Document picked = before;
  picked.chains = {other.body.limbs.front(), before.body.limbs.front()};
  picked.chains.back().id = "tail0..tail1";
  picked.weights.push_back({picked.chains.front().id, 0, true, {}});
  const Document changed = *changePlan(picked, "other");
  CHECK(countOf(allLimbs(changed), picked.chains.front().id) == 1);
  CHECK(countOf(changed.chains, "tail0..tail1") == 1);
  CHECK(changed.weights.size() == 1);
}

TEST_CASE(
    "Finding the limbs again takes along what was set up for limbs that are gone, and undo brings it back") {
  Document wrong = *changePlan(horse(), "spider");
  rig::Trail trail;
  trail.id = 1;
  trail.limb = "left-leg";
  wrong.trails = {trail};
  wrong.weights = {{"left-leg", 0, true, {}}, {"spine", 0, true, {}}};
  rig::Adjustment lifted;
  lifted.controller = "left-foot";
  lifted.keys.resize(1);
  wrong.adjustments = {lifted};
  Session session(wrong);
  const std::vector<DocumentCommand> commands = documentCommands();
  REQUIRE(commandOf(commands, command::detectAgain).run(session));
  const Document& found = session.document();
  CHECK(found.body.plan == "quadruped");
  CHECK_FALSE(found.limbsCorrected);
  CHECK(found.trails.empty());
  CHECK(found.adjustments.empty());
  REQUIRE(found.weights.size() == 1);
  CHECK(found.weights.front().limb == "spine");
  REQUIRE(commandOf(commands, command::undo).run(session));
  CHECK(sameDocument(session.document(), wrong));
}

TEST_CASE("The keys of the limbs say what they mean for a horse, and what a horse lacks") {
  const Session session(horse());
  const std::vector<DocumentCommand> commands = documentCommands();
  const DocumentCommand& first = commandOf(commands, command::limbSlots[0]);
  CHECK(first.labelNow(session) == "Select front left leg");
  CHECK(first.helpNow(session) == "Selects the front left leg, with its trail at the playhead.");
  CHECK(commandOf(commands, command::limbSlots[8]).needsNow(session) == "this character has no ninth limb");
  const DocumentCommand& hoof = commandOf(commands, command::controllerSlots[0]);
  CHECK(hoof.helpNow(session) ==
        "Selects the first controller of the front left leg; again goes on to its next one.");
  CHECK(commandOf(commands, command::controllerSlots[7]).labelNow(session) == "Controllers: hips");

  Document lame = horse();
  std::erase_if(lame.body.limbs, [](const rig::Limb& limb) { return limb.id == "front-left-leg"; });
  CHECK(first.needsNow(Session(lame)) == "this character has no front left leg");
}

TEST_CASE("The body plan that is chosen already is no change") {
  Session session(horse());
  const std::vector<DocumentCommand> commands = documentCommands();
  REQUIRE(commandOf(commands, command::planPrefix + std::string("quadruped")).run(session));
  CHECK_FALSE(session.history().canUndo());
  CHECK_FALSE(session.document().limbsCorrected);
}

TEST_CASE("Finding the limbs again leaves what is keyed of the limbs that are found, values as well") {
  Document document = detectLimbsAgain(horse());
  const rig::ControllerList list = controllersOf(document);
  const auto keyed = [](const std::string& id) {
    return rig::Adjustment{id, 0, std::nullopt, {rig::OffsetKey{}}};
  };
  for (const rig::Controller& controller : list.controllers) {
    document.adjustments.push_back(keyed(controller.id));
  }
  for (const rig::Attribute& attribute : list.attributes) {
    document.adjustments.push_back(keyed(attribute.id));
  }
  REQUIRE_FALSE(list.attributes.empty());
  const std::vector<rig::Adjustment> before = document.adjustments;
  document.adjustments.push_back(keyed("no such thing"));
  CHECK(detectLimbsAgain(document).adjustments == before);
}
