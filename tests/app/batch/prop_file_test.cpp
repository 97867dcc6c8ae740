#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/keys/track_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/hand_place.h"
#include "app/files/autosave.h"
#include "app/files/save.h"
#include "app/files/saved_work.h"
#include "app/recipe/recipe.h"
#include "app/recipe/replay.h"
#include "app/session.h"
#include "app/standing_floor.h"
#include "core/anim/frames.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "rig/motion/solve_holds.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/core/two_sheets.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::endOf;
using test::openedFile;
using test::pose;
using test::Posed;
using test::posedCharacter;
using test::TemporaryFolder;

namespace {

// A thing of a file of its own in the hands of the character: command line, recipe, saved file.

constexpr double inHandShare = 1e-4; // of the height

std::string sheetsIn(const TemporaryFolder& folder, const std::string& name = "sheets.glb") {
  test::twoSheets().write(folder / name);
  return (folder / name).string();
}

Json heldBy(const std::string& limb) {
  return {{limb, Json::array({{{"frame", 0}, {"value", 1}}})}};
}

Json propRecipe(const Json& prop) {
  return {{"version", 1}, {"units", "metres"}, {"props", Json::array({prop})}};
}

Json movedHand(const std::string& hand, double frame) {
  return {{"controller", hand}, {"keys", Json::array({{{"frame", frame}, {"move", {0.0, 0.25, 0.1}}}})}};
}

NodeIndex nodeNamed(const Document& document, const std::string& name) {
  const NodeIndex node = rig::propNode(*document.scene, name);
  REQUIRE(node.exists());
  return node;
}

// The node as the hand sees it in the file's own keys.
Mat4 inHand(const Document& document, const char* arm, const std::string& node, double frame) {
  const NodeIndex hand = findLimb(document, arm)->endNode;
  return glm::inverse(test::worldOf(document, hand, frame)) *
         test::worldOf(document, nodeNamed(document, node), frame);
}

// How far the thing moves in the hand, over the clip.
double slip(const Document& document, const char* arm, const std::string& node) {
  const Mat4 bound = inHand(document, arm, node, 0.0);
  double most = 0.0;
  for (double frame = 0.0; frame <= 60.0; frame += 0.5) {
    const Mat4 now = inHand(document, arm, node, frame);
    for (const Vec4& point : {Vec4(0, 0, 0, 1), Vec4(1, 0, 0, 1), Vec4(0, 1, 0, 1)}) {
      most = std::max(most, glm::length(Vec3(now * point) - Vec3(bound * point)));
    }
  }
  return most;
}

double distanceToHand(const Document& document, const char* arm, const std::string& node, double frame) {
  return glm::length(test::nodeOf(document, nodeNamed(document, node), frame) - endOf(document, arm, frame));
}

// The file as any player has it: its motion in its keys.
Document played(const TemporaryFolder& folder, const std::string& path) {
  REQUIRE(saveDocument(openedFile(path), folder / "played.glb", {.clean = true}));
  return openedFile((folder / "played.glb").string());
}

std::vector<std::vector<NodeIndex>> jointsOf(const Document& document) {
  std::vector<std::vector<NodeIndex>> joints;
  for (const rig::Limb& limb : document.body.limbs) {
    joints.push_back(limb.joints);
  }
  return joints;
}

test::VerbAnswer poseWithProp(const std::string& output, const std::string& prop,
                              const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"pose", posedCharacter, "-o", output, "--prop", prop, "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return test::runVerb(words);
}

Document held(const Document& document, const std::string& path, const std::vector<std::string>& hands,
              double frame = 0.0) {
  Result<AddedProp> added = putIntoHands(document, {path, hands, 0, frame, {}});
  INFO((added ? std::string() : added.error().line()));
  REQUIRE(added);
  return added->document;
}

} // namespace

TEST_CASE("pose --prop puts the thing of another file into the hand, where it stays in the saved file") {
  const TemporaryFolder folder;
  const std::string output = (folder / "armed.glb").string();
  const test::VerbAnswer answer = poseWithProp(output, sheetsIn(folder));
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  const Json report = Json::parse(answer.output);
  REQUIRE(report["added_files"].size() == 1);
  CHECK(report["added_files"][0] == Json{{"file", "sheets.glb"}, {"node", "sheets"}});
  const Document file = played(folder, output);
  CHECK(slip(file, "right-arm", "sheets") < inHandShare * file.body.height);
  CHECK(distanceToHand(file, "right-arm", "sheets", 0.0) < 0.1 * file.body.height);
  CHECK(jointsOf(openedFile(output)) == jointsOf(openedFile(posedCharacter)));
  CHECK(openedFile(output).body.height == openedFile(posedCharacter).body.height);
  const test::VerbAnswer info = test::runVerb({"info", output, "--json"});
  CHECK(Json::parse(info.output)["added_files"] == report["added_files"]);
  CHECK(Json::parse(info.output)["props"].size() == 1);
}

TEST_CASE("a thing in both hands stays in both") {
  const TemporaryFolder folder;
  const std::string output = (folder / "armed.glb").string();
  REQUIRE(poseWithProp(output, sheetsIn(folder), {"--prop-hand", "both", "--prop-frame", "5"}).exitCode == 0);
  const Document file = played(folder, output);
  CHECK(slip(file, "right-arm", "sheets") < inHandShare * file.body.height);
  CHECK(slip(file, "left-arm", "sheets") < inHandShare * file.body.height);
}

TEST_CASE("a clean file plays the thing in the hand and is an ordinary file") {
  const TemporaryFolder folder;
  const std::string output = (folder / "armed.glb").string();
  REQUIRE(poseWithProp(output, sheetsIn(folder), {"--clean"}).exitCode == 0);
  const Document file = openedFile(output);
  CHECK(file.addedFiles.empty());
  CHECK(file.holds.empty());
  CHECK(slip(file, "right-arm", "sheets") < inHandShare * file.body.height);
}

TEST_CASE("a saved file with an added thing gives back its source by bytes") {
  const TemporaryFolder folder;
  const std::string output = (folder / "armed.glb").string();
  REQUIRE(poseWithProp(output, sheetsIn(folder)).exitCode == 0);
  const Document file = openedFile(output);
  REQUIRE(file.addedFiles.size() == 1);
  const Document bare = withoutWork(file);
  CHECK(bare.addedFiles.empty());
  REQUIRE(saveDocument(bare, folder / "bare.glb", {}));
  CHECK(*readFile(folder / "bare.glb") == *readFile(posedCharacter));
  // What was opened saves to what was saved.
  REQUIRE(saveDocument(file, folder / "again.glb", {}));
  CHECK(*readFile(folder / "again.glb") == *readFile(output));
}

TEST_CASE("a recipe names the file of a prop, from its own folder, where its adjustments have the hand") {
  const TemporaryFolder folder;
  sheetsIn(folder);
  Json recipe = propRecipe({{"file", "sheets.glb"}, {"bound_at", 10}, {"hands", heldBy("right-arm")}});
  recipe["adjustments"] = Json::array({movedHand("right-hand", 10)});
  const Posed posed = pose(folder, recipe);
  INFO(posed.answer.told);
  REQUIRE(posed.answer.exitCode == 0);
  const Document file = played(folder, posed.path);
  CHECK(slip(file, "right-arm", "sheets") < inHandShare * file.body.height);
  CHECK(distanceToHand(file, "right-arm", "sheets", 10.0) < 0.1 * file.body.height);
  // Without the adjustment it is held at the same place of the hand.
  recipe.erase("adjustments");
  const Document plain = played(folder, pose(folder, recipe).path);
  const auto place = [&](const Document& document) {
    return Vec3(inHand(document, "right-arm", "sheets", 10.0)[3]);
  };
  CHECK(glm::length(place(plain) - place(file)) < 0.02 * file.body.height);
}

TEST_CASE("the recipe of a document makes the same of the character, also once the hand was posed anew") {
  const TemporaryFolder folder;
  const Document source = openedFile(posedCharacter);
  Document worked = held(source, sheetsIn(folder), {"left-arm", "right-arm"}, 5.0);
  if (GENERATE(false, true)) {
    Json moved = propRecipe({{"file", "unused"}});
    moved.erase("props");
    moved["adjustments"] = Json::array({movedHand("left-hand", 5)});
    const Result<Recipe> adjusted = recipeFromJson(moved, worked);
    REQUIRE(adjusted);
    worked = withRecipe(worked, *adjusted)->document;
  }
  folder.write("saved.json", recipeToJson(worked, 0).dump());
  Document replayed = source;
  const Result<Recipe> recipe = loadRecipe(folder / "saved.json", replayed);
  INFO((recipe ? std::string() : recipe.error().line()));
  REQUIRE(recipe);
  replayed = withRecipe(replayed, *recipe)->document;
  REQUIRE(saveDocument(worked, folder / "worked.glb", {.clean = true}));
  REQUIRE(saveDocument(replayed, folder / "replayed.glb", {.clean = true}));
  const Document first = openedFile((folder / "worked.glb").string());
  const Document second = openedFile((folder / "replayed.glb").string());
  for (double frame = 0.0; frame <= 60.0; frame += 1.0) {
    const Mat4 a = test::worldOf(first, nodeNamed(first, "sheets"), frame);
    const Mat4 b = test::worldOf(second, nodeNamed(second, "sheets"), frame);
    for (int column = 0; column < 4; ++column) {
      CHECK(glm::length(Vec3(a[column]) - Vec3(b[column])) < 1e-5);
    }
  }
}

TEST_CASE("a recipe that is replayed twice adds its file once, and two props of one file are two") {
  const TemporaryFolder folder;
  sheetsIn(folder);
  Json recipe = propRecipe({{"file", "sheets.glb"}, {"hands", heldBy("right-arm")}});
  recipe["props"].push_back({{"file", "sheets.glb"}, {"hands", heldBy("left-arm")}});
  folder.write("two.json", recipe.dump());
  Document document = openedFile(posedCharacter);
  for (int replay = 0; replay < 2; ++replay) {
    const Result<Recipe> read = loadRecipe(folder / "two.json", document);
    INFO((read ? std::string() : read.error().line()));
    REQUIRE(read);
    document = withRecipe(document, *read)->document;
  }
  REQUIRE(document.addedFiles.size() == 2);
  CHECK(document.holds.props.size() == 2);
  REQUIRE(saveDocument(document, folder / "two.glb", {.clean = true}));
  const Document file = openedFile((folder / "two.glb").string());
  const double height = file.body.height;
  CHECK(distanceToHand(file, "right-arm", "sheets", 30.0) < 0.1 * height);
  CHECK(distanceToHand(file, "left-arm", "sheets 2", 30.0) < 0.1 * height);
}

TEST_CASE("props that cannot be taken are told in one line, and nothing is written") {
  const TemporaryFolder folder;
  const std::string sheets = sheetsIn(folder);
  const std::string output = (folder / "posed.glb").string();
  const auto line = [&](const std::string& prop, const std::vector<std::string>& more = {}) {
    const test::VerbAnswer answer = poseWithProp(output, prop, more);
    CHECK(answer.exitCode != 0);
    CHECK(std::ranges::count(answer.told, '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(output));
    return answer.told;
  };
  CHECK_THAT(line((folder / "gone.glb").string()), Catch::Contains("gone.glb"));
  CHECK_THAT(line(posedCharacter), Catch::Contains("is the open file itself"));
  CHECK_THAT(line(sheets, {"--prop-frame", "1e9"}), Catch::Contains("1e+09"));
  CHECK_THAT(line(sheets, {"--prop-hand", "third-arm"}), Catch::Contains("--prop-hand"));
  const auto recipeLine = [&](const Json& prop) {
    const Posed posed = pose(folder, propRecipe(prop));
    CHECK(posed.answer.exitCode != 0);
    CHECK(std::ranges::count(posed.answer.told, '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(posed.path));
    return posed.answer.told;
  };
  const Json hands = heldBy("right-arm");
  CHECK_THAT(recipeLine({{"file", "gone.glb"}, {"hands", hands}}),
             Catch::Contains("props[0]") && Catch::Contains("gone.glb"));
  CHECK_THAT(recipeLine({{"file", 7}, {"hands", hands}}), Catch::Contains("is not a path"));
  CHECK_THAT(recipeLine({{"file", "sheets.glb"}, {"node", "x"}, {"hands", hands}}),
             Catch::Contains("is not a path"));
  CHECK_THAT(recipeLine({{"file", "sheets.glb"}, {"bound_at", "source"}, {"hands", hands}}),
             Catch::Contains("bound_at"));
  CHECK_THAT(recipeLine({{"file", "sheets.glb"}, {"hands", heldBy("tail")}}), Catch::Contains("tail"));
  CHECK_THAT(recipeLine({{"file", "sheets.glb"}, {"place", {1e9, 0, 0}}, {"hands", hands}}),
             Catch::Contains("out of proportion"));
}

TEST_CASE("taking the hold away takes the thing away, and undo brings both back") {
  const TemporaryFolder folder;
  const std::string sheets = sheetsIn(folder);
  const Document source = openedFile(posedCharacter);
  Session session(held(held(source, sheets, {"right-arm"}), sheets, {"left-arm"}));
  const Document two = session.document();
  Document oneHold = two;
  oneHold.holds.props.erase(oneHold.holds.props.begin());
  const Result<Document> one = withoutUnheldFiles(oneHold);
  REQUIRE(one);
  session.edit(*one, "Take holds away");
  REQUIRE(session.document().addedFiles.size() == 1);
  CHECK(session.document().addedFiles[0].name == "sheets 2");
  CHECK(session.document().scene->nodes.size() == source.scene->nodes.size() + 3);
  const FrameState& frame = session.frameAt(20.0);
  const Vec3 place = positionOf(frame.worlds[at(nodeNamed(session.document(), "sheets 2"))]);
  const Vec3 hand = rig::endPosition(*findLimb(session.document(), "left-arm"), frame);
  const Vec3 at0 = session.document().addedFiles[0].place.translation;
  CAPTURE(place.x, place.y, place.z, hand.x, hand.y, hand.z, at0.x, at0.y, at0.z, frame.worlds.size(),
          session.document().holds.props.size(), session.document().holds.props[0].node);
  CHECK(glm::length(place - hand) < 0.1 * source.body.height);
  session.undo();
  CHECK(sameDocument(session.document(), two));
  session.redo();
  CHECK(session.document().addedFiles.size() == 1);
  Document none = session.document();
  none.holds = {};
  CHECK(withoutUnheldFiles(none)->scene->nodes.size() == source.scene->nodes.size());
}

TEST_CASE("work that was kept aside holds the things that were added") {
  const TemporaryFolder folder;
  const Document source = openedFile(posedCharacter);
  const Document worked = held(source, sheetsIn(folder), {"right-arm"});
  const std::filesystem::path aside = folder.write("aside.json", autosaveText(worked, {}, posedCharacter));
  std::filesystem::remove(folder / "sheets.glb");
  const Result<Document> back = withAutosave(source, aside);
  INFO((back ? std::string() : back.error().line()));
  REQUIRE(back);
  CHECK(back->holds == worked.holds);
  REQUIRE(back->addedFiles.size() == 1);
  CHECK(back->addedFiles[0].name == "sheets");
  REQUIRE(saveDocument(worked, folder / "worked.glb", {}));
  REQUIRE(saveDocument(*back, folder / "back.glb", {}));
  CHECK(*readFile(folder / "worked.glb") == *readFile(folder / "back.glb"));
}

TEST_CASE("a thing in a hand is no block that a foot stands on") {
  const TemporaryFolder folder;
  Document document = held(openedFile(posedCharacter), sheetsIn(folder), {"right-arm"});
  CHECK(blocksOf(document, 0).empty());
  document.holds = {};
  CHECK(blocksOf(document, 0).size() == 2);
}

TEST_CASE("nodes of a thing that are named like limbs are no limbs of the character") {
  const TemporaryFolder folder;
  test::GlbBuilder sheets = test::twoSheets();
  sheets.json["nodes"][0]["name"] =
      openedFile(posedCharacter)
          .scene->nodes[at(findLimb(openedFile(posedCharacter), "left-arm")->joints[0])]
          .name;
  sheets.write(folder / "sheets.glb");
  const std::string output = (folder / "armed.glb").string();
  REQUIRE(poseWithProp(output, (folder / "sheets.glb").string()).exitCode == 0);
  CHECK(jointsOf(openedFile(output)) == jointsOf(openedFile(posedCharacter)));
}

TEST_CASE("a thing or a clip out of a file that is no glTF is refused by the name of that file") {
  const TemporaryFolder folder;
  const std::string mesh = (folder / "chair.obj").string();
  REQUIRE(writeText(folder / "chair.obj", "v 0 0 0\n"));
  const std::string output = (folder / "out.glb").string();
  for (const test::VerbAnswer& answer :
       {poseWithProp(output, mesh),
        test::runVerb({"import-clip", posedCharacter, "-o", output, "--from", mesh})}) {
    CHECK(answer.exitCode == 1);
    CHECK_THAT(answer.told, Catch::Contains("chair.obj: "));
  }
  CHECK_FALSE(std::filesystem::exists(output));
}

TEST_CASE("keys, numbers and chains of a thing go on with it when the thing before it is taken away") {
  const TemporaryFolder folder;
  const std::string sheets = sheetsIn(folder);
  const Document source = openedFile(posedCharacter);
  const std::size_t own = source.scene->nodes.size();
  Document two = held(held(source, sheets, {"right-arm"}), sheets, {"left-arm"});
  REQUIRE(two.scene->nodes.size() == own + 6);
  const KeyRow ofFirst{NodeIndex(own + 1), Channel::translation, {}};
  const KeyRow ofSecond{NodeIndex(own + 4), Channel::translation, {}};
  for (const auto& [row, frame] : {std::pair(ofFirst, 5.0), std::pair(ofSecond, 9.0)}) {
    const Result<EditedKeys> keyed = insertKeys(two, 0, std::vector{row}, frame);
    REQUIRE(keyed);
    two = keyed->document;
  }
  const FollowingKeys ofHips{0, two.body.hips, Channel::rotation, {{0.0F, 7U}}};
  two.followingKeys = {{0, ofFirst.node, Channel::translation, {{0.1F, 7U}}},
                       {0, ofSecond.node, Channel::translation, {{0.2F, 7U}}},
                       ofHips};
  const int second = nodeNamed(two, "sheets 2").value;
  two.holds.props[1].node = "#" + std::to_string(second);
  two.holds.props.erase(two.holds.props.begin());
  const Result<Document> one = withoutUnheldFiles(two);
  REQUIRE(one);
  REQUIRE(one->addedFiles.size() == 1);
  CHECK(one->holds.props[0].node == "#" + std::to_string(second - 3));
  CHECK(clipOf(*one, 0).tracks.size() == clipOf(source, 0).tracks.size() + 1);
  REQUIRE(keyFramesOf(*one, 0, ofFirst).size() == 1); // where the second one's node is now
  CHECK(keyFramesOf(*one, 0, ofFirst).front() == Approx(9.0));
  CHECK(one->followingKeys ==
        std::vector<FollowingKeys>{{0, ofFirst.node, Channel::translation, {{0.2F, 7U}}}, ofHips});
  // What a chain names would be other nodes then: both stay.
  const auto filesWith = [&](const std::vector<NodeIndex>& joints, NodeIndex end) {
    Document chained = two;
    chained.chains.resize(1);
    chained.chains.front().joints = joints;
    chained.chains.front().endNode = end;
    return withoutUnheldFiles(chained)->addedFiles.size();
  };
  CHECK(filesWith({two.body.hips, NodeIndex(own + 4)}, NodeIndex::none) == 2);
  CHECK(filesWith({two.body.hips}, NodeIndex(own)) == 2);
  CHECK(filesWith({two.body.hips}, NodeIndex(own - 1)) == 1);
}

TEST_CASE("a clip that keys of a thing made longer is as long as the file's without it, and edited no more") {
  const TemporaryFolder folder;
  const Document source = openedFile(posedCharacter);
  const KeyRow ofThing{NodeIndex(source.scene->nodes.size()), Channel::translation, {}};
  const double late = endInFrames(clipOf(source, 0)) + 40.0;
  const Result<EditedKeys> keyed =
      insertKeys(held(source, sheetsIn(folder), {"right-arm"}), 0, std::vector{ofThing}, late);
  REQUIRE(keyed);
  REQUIRE(endInFrames(clipOf(keyed->document, 0)) == Approx(late));
  Document unheld = keyed->document;
  unheld.holds = {};
  const Result<Document> without = withoutUnheldFiles(unheld);
  REQUIRE(without);
  CHECK(clipOf(*without, 0).endSeconds == clipOf(source, 0).endSeconds);
  CHECK_FALSE(hasEditedKeys(*without));
}
