#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/keys/import_clip.h"
#include "app/files/autosave.h"
#include "app/files/imported_clips.h"
#include "app/files/save.h"
#include "app/session.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/nodes.h"
#include "tests/support/refusal.h"
#include "tests/support/rig/character_file.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/naming_schemes.h"
#include "tests/support/rig/synthetic_biped.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::openedFile;
using test::posedCharacter;
using test::TemporaryFolder;

namespace {

std::string written(const TemporaryFolder& folder, const std::string& name, const test::MovingBiped& moving,
                    const std::vector<Clip>& clips) {
  test::characterFile(moving.scene, clips).write(folder / name);
  return (folder / name).string();
}

std::string punchFile(const TemporaryFolder& folder) {
  const test::MovingBiped moving = test::punchingBiped();
  Clip clip = moving.clip;
  clip.name = "jab";
  return written(folder, "jab.glb", moving, {clip});
}

test::VerbAnswer import(const std::string& output, const std::string& from,
                        const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"import-clip", posedCharacter, "-o", output, "--from", from, "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return test::runVerb(words);
}

Document imported(const Document& document, const std::string& file) {
  const Result<NewClips> brought = clipsFromFile(document, {file, {}, {}});
  INFO((brought ? std::string() : brought.error().line()));
  REQUIRE(brought);
  Result<Document> changed = withNewClips(document, {brought->clips.front().clip});
  REQUIRE(changed);
  return *changed;
}

/// Two bodies side by side whose nodes have the same names, without a clip.
test::MovingBiped twoOfEqualNames() {
  test::SyntheticBiped two = test::namedBody();
  test::addOther(two, test::namedBody(), Vec3(3.0, 0.0, 0.0));
  test::MovingBiped both = test::still(two);
  for (const auto& [key, node] : both.node) {
    if (key.starts_with("other ")) {
      both.scene.nodes[at(node)].name = both.scene.nodes[at(both.node.at(key.substr(6)))].name;
    }
  }
  return both;
}

} // namespace

TEST_CASE("import-clip adds the clip of another skeleton behind the file's own and changes nothing else") {
  const TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const test::VerbAnswer answer = import(output, punchFile(folder));
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  const Json report = Json::parse(answer.output);
  CHECK(report["clips"][0]["name"] == "jab");
  CHECK(report["clips"][0]["way"] == "retargeted");
  const Document before = openedFile(posedCharacter);
  const Document after = openedFile(output);
  REQUIRE(after.clips->size() == before.clips->size() + 1);
  CHECK(after.clips->back().name == "jab");
  CHECK(std::equal(before.clips->begin(), before.clips->end(), after.clips->begin()));
  for (const char* key : {"nodes", "meshes", "materials", "skins"}) {
    CHECK(before.source->json->at(key) == after.source->json->at(key));
  }
}

TEST_CASE(
    "import-clip tells how the clip moves on the character beside the source and as it is only mapped") {
  const TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const std::string from = punchFile(folder);
  const test::VerbAnswer answer = import(output, from);
  REQUIRE(answer.exitCode == 0);
  const Json clip = Json::parse(answer.output)["clips"][0];
  for (const char* whose : {"source", "mapped", "result"}) {
    for (const char* figure : {"slide_percent", "slide_cm", "contact_cm", "inside_percent", "deepest_percent",
                               "floor_percent", "hands_widths"}) {
      CHECK(clip["report"][whose].contains(figure));
    }
  }
  CHECK(clip["report"]["result"]["inside_percent"].is_number());
  CHECK(clip["report"]["result"]["floor_percent"].is_number());
  const test::VerbAnswer told =
      test::runVerb({"import-clip", posedCharacter, "-o", (folder / "told.glb").string(), "--from", from});
  CHECK_THAT(told.output, Catch::Contains("inside trunk and head") && Catch::Contains("(as mapped ") &&
                              Catch::Contains(", source "));
  const Json copied = Json::parse(import((folder / "copied.glb").string(), posedCharacter).output);
  CHECK_FALSE(copied["clips"][0].contains("report"));
}

TEST_CASE("import-clip copies the keys of the same skeleton, under a name that is free") {
  const TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const Document before = openedFile(posedCharacter);
  const std::string name = before.clips->front().name;
  REQUIRE(import(output, std::string(posedCharacter) + "#" + name).exitCode == 0);
  const Document after = openedFile(output);
  CHECK(after.clips->back().name == name + " 2");
  REQUIRE(after.clips->back().tracks.size() == before.clips->front().tracks.size());
  for (const CopyOnWrite<Track>& track : before.clips->front().tracks) {
    const int copy = findTrack(after.clips->back(), track->node, track->channel);
    REQUIRE(copy >= 0);
    CHECK(after.clips->back().tracks[at(copy)]->values == track->values);
  }
}

TEST_CASE("import-clip tells what it does not bring over of the clips that are wanted") {
  const TemporaryFolder folder;
  const test::MovingBiped moving = test::punchingBiped();
  std::vector<Clip> clips(2, moving.clip);
  clips[0].name = "jab";
  clips[1].name = "hook";
  auto glb = test::characterFile(moving.scene, clips);
  const Json pointer{{"pointer", "/nodes/0/extensions/KHR_node_visibility/visible"}};
  glb.json["animations"][0]["channels"].push_back(
      {{"sampler", 0},
       {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", pointer}}}}}});
  glb.json["extensionsUsed"] = {"KHR_animation_pointer"};
  glb.write(folder / "hidden.glb");
  const auto told = [&](const char* clip) {
    const test::VerbAnswer answer =
        import((folder / "out.glb").string(), (folder / "hidden.glb").string() + "#" + clip);
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
    return Json::parse(answer.output)["warnings"].dump();
  };
  CHECK_THAT(told("jab"), Catch::Contains("hidden.glb: animations[0].channels[") &&
                              Catch::Contains("KHR_node_visibility/visible"));
  CHECK_THAT(told("hook"), !Catch::Contains("KHR_node_visibility"));
}

TEST_CASE("import-clip says in one line what it cannot do, and writes nothing") {
  const TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const auto refusal = [&](const std::string& from, const std::vector<std::string>& more = {}) {
    const test::VerbAnswer answer = import(output, from, more);
    CHECK(answer.exitCode == 1);
    CHECK(std::count(answer.told.begin(), answer.told.end(), '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(output));
    return answer.told;
  };
  const test::MovingBiped moving = test::punchingBiped();
  CHECK_THAT(refusal(written(folder, "still.glb", moving, {})), Catch::Contains("holds no clip"));
  CHECK_THAT(refusal((folder / "none.glb").string()), Catch::Contains("none.glb"));
  CHECK_THAT(refusal(punchFile(folder), {"--from-clip", "kick"}), Catch::Contains("no clip 'kick'"));
  REQUIRE(writeText(folder / "broken.glb", "not a file"));
  CHECK_THAT(refusal((folder / "broken.glb").string()), Catch::Contains("broken.glb"));
  Scene box;
  box.nodes.resize(1);
  box.nodes[0].name = "Box";
  box.roots = {NodeIndex(0)};
  Clip spin;
  spin.tracks.emplace_back(test::vectorTrack(NodeIndex(0), Channel::translation, Interpolation::linear,
                                             {{0.0, Vec3(0.0)}, {1.0, Vec3(1.0)}}));
  test::characterFile(box, {spin}).write(folder / "box.glb");
  CHECK_THAT(refusal((folder / "box.glb").string()), Catch::Contains("no skeleton"));
}

TEST_CASE("A biped's clip is refused by a character that is none and has none of its names, in one line") {
  const TemporaryFolder folder;
  Scene post;
  const NodeIndex foot = test::addNode(post, "Post", NodeIndex::none, Vec3(0.0));
  const NodeIndex lamp = test::addNode(post, "Lamp", foot, Vec3(0.0, 1.0, 0.0));
  Clip swing;
  swing.tracks.emplace_back(test::vectorTrack(lamp, Channel::translation, Interpolation::linear,
                                              {{0.0, Vec3(0.0, 1.0, 0.0)}, {1.0, Vec3(1.0)}}));
  test::characterFile(post, {swing}).write(folder / "post.glb");
  const Document document = openedFile((folder / "post.glb").string());
  REQUIRE_FALSE(document.body.isBiped);
  const Result<NewClips> brought = clipsFromFile(document, {punchFile(folder), {}, {}});
  CHECK_THAT(test::refusal(brought),
             Catch::Contains("this character is no biped, and 0 of the") && Catch::Contains("post.glb"));
}

TEST_CASE("A biped whose leg was not found is said to lack it, and not to be no biped") {
  const TemporaryFolder folder;
  Document document = openedFile(test::posedCharacter);
  REQUIRE(document.body.isBiped);
  std::erase_if(document.body.limbs, [](const rig::Limb& limb) { return limb.id == "left-leg"; });
  Scene scene = *document.scene;
  for (Node& node : scene.nodes) {
    node.name += "_other";
  }
  document.scene = std::make_shared<const Scene>(std::move(scene));
  CHECK_THAT(test::refusal(clipsFromFile(document, {punchFile(folder), {}, {}})),
             Catch::Contains("this character has not both legs of a biped, and 0 of the"));
}

TEST_CASE("Clips that lack the same are told in one line") {
  const TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const test::VerbAnswer answer =
      test::runVerb({"import-clip", punchFile(folder), "-o", output, "--from", posedCharacter, "--json"});
  REQUIRE(answer.exitCode == 0);
  const Json report = Json::parse(answer.output);
  REQUIRE(report["clips"].size() == 2);
  REQUIRE(report["clips"][0]["left_out"] == report["clips"][1]["left_out"]);
  REQUIRE(report["warnings"].size() == 1);
  const std::string names =
      report["clips"][0]["from"].get<std::string>() + ", " + report["clips"][1]["from"].get<std::string>();
  CHECK(report["warnings"][0].get<std::string>().starts_with(names + ": left out"));
}

TEST_CASE("An imported clip is undone, and comes back after a crash, also where the file was saved with it") {
  const TemporaryFolder folder;
  const Document before = openedFile(posedCharacter);
  Session session(before);
  session.edit(imported(before, punchFile(folder)), "Import a clip");
  const Document after = session.document();
  CHECK(after.clips->size() == before.clips->size() + 1);
  session.undo();
  CHECK(sameDocument(session.document(), before));
  session.redo();
  CHECK(sameDocument(session.document(), after));

  const std::filesystem::path aside = folder / "aside.json";
  REQUIRE(writeText(aside, autosaveText(after, {}, posedCharacter)));
  const Result<Document> restored = withAutosave(before, aside);
  REQUIRE(restored);
  CHECK(*restored->clips == *after.clips);
  const std::string saved = (folder / "saved.glb").string();
  REQUIRE(saveDocument(after, saved, {}));
  const Result<Document> again = withAutosave(openedFile(saved), aside);
  REQUIRE(again);
  CHECK(again->clips->size() == after.clips->size());
}

TEST_CASE("A clip that was kept aside stands right behind those of the file or is refused") {
  const TemporaryFolder folder;
  const Document before = openedFile(posedCharacter);
  const gltf::Json kept = importedClipsToJson(imported(before, punchFile(folder)));
  REQUIRE(kept.size() == 1);
  const auto count = static_cast<int>(before.clips->size());
  CHECK(kept[0]["clip"] == count);
  CHECK(withImportedClips(before, kept));
  for (const int elsewhere : {-1, 0, count - 1, count + 1}) {
    gltf::Json moved = kept;
    moved[0]["clip"] = elsewhere;
    CHECK_THAT(test::refusal(withImportedClips(before, moved)),
               Catch::StartsWith("imported_clips: is not what this program writes"));
  }
}

TEST_CASE("Undoing the import of the clip that is viewed shows one that is still there") {
  const TemporaryFolder folder;
  const Document before = openedFile(posedCharacter);
  Session session(before);
  session.edit(imported(before, punchFile(folder)), "Import a clip");
  session.view().clip = static_cast<int>(before.clips->size());
  session.view().frame = 20.0;
  session.undo();
  CHECK(session.view().clip == 0); // which was viewed before
  CHECK(session.view().frame == 0.0);
  CHECK(session.frameAt(0.0).worlds.size() == before.scene->nodes.size());
}

TEST_CASE("FILE#CLIP names one clip of a file, whatever of the two has a # in its name") {
  const TemporaryFolder folder;
  const test::MovingBiped moving = test::punchingBiped();
  Clip jab = moving.clip;
  jab.name = "jab";
  Clip numbered = moving.clip;
  numbered.name = "take#2";
  const std::string plain = written(folder, "moves.glb", moving, {jab, numbered});
  const std::string marked = written(folder, "moves#1.glb", moving, {jab, numbered});
  const std::string output = (folder / "out.glb").string();
  const auto namesFrom = [&](const std::string& from, const std::vector<std::string>& more = {}) {
    const test::VerbAnswer answer = import(output, from, more);
    INFO(from << ": " << answer.told);
    std::vector<std::string> names;
    CHECK(answer.exitCode == 0);
    if (answer.exitCode == 0) {
      const Json report = Json::parse(answer.output);
      for (const Json& clip : report["clips"]) {
        names.push_back(clip["name"].get<std::string>());
      }
    }
    return names;
  };
  using Names = std::vector<std::string>;
  for (const std::string& file : {plain, marked}) {
    CHECK(namesFrom(file) == Names{"jab", "take#2"});
    CHECK(namesFrom(file + "#jab") == Names{"jab"});
    CHECK(namesFrom(file + "#take#2") == Names{"take#2"});
    CHECK(namesFrom(file + "##1") == Names{"take#2"});
    CHECK(namesFrom(file, {"--from-clip", "take#2"}) == Names{"take#2"});
  }
  const test::VerbAnswer gone = import(output, (folder / "gone.glb").string() + "#jab");
  CHECK(gone.exitCode == 1);
  CHECK_THAT(gone.told, Catch::Contains("gone.glb") && !Catch::Contains("#jab"));
}

TEST_CASE(
    "A clip that comes in after keys were edited is among the sources as it came, and the edit stays one") {
  const TemporaryFolder folder;
  Document edited = openedFile(posedCharacter);
  const auto source = edited.clips;
  std::vector<Clip> clips = *edited.clips;
  clips.front().tracks.front().edit([](Track& track) { track.values.back() += 0.25F; });
  edited.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  edited.sourceClips = source;
  const Document changed = imported(edited, punchFile(folder));
  REQUIRE(changed.clips->size() == source->size() + 1);
  REQUIRE(sourceClipsOf(changed)->size() == changed.clips->size());
  CHECK(sourceClipsOf(changed)->back() == changed.clips->back());
  CHECK(sourceClipsOf(changed)->front() == source->front());
  CHECK_FALSE(changed.clips->front() == source->front());
}

TEST_CASE(
    "What sinks below the floor on the character, and not in the source, is told with its joint and time") {
  const TemporaryFolder folder;
  test::MovingBiped source = test::still(test::makeNamedBody("Mixamo"));
  test::addPunch(source, Interpolation::linear);
  test::MovingBiped target = test::still(test::makeNamedBody("Unreal"));
  const std::string clean = written(folder, "clean.glb", target, {});
  const NodeIndex hand = target.node.at("hand.l");
  Primitive flail; // hangs from the left hand far below the floor
  flail.positions = {{0.0F, 0.0F, 0.0F}, {0.05F, -2.5F, 0.0F}, {-0.05F, -2.5F, 0.0F}};
  const NodeIndex part = test::addNode(target.scene, "flail", hand, Vec3(0.0));
  target.scene.nodes[at(part)].mesh = static_cast<int>(target.scene.meshes.size());
  target.scene.meshes.push_back({"flail", {flail}, {}});
  source.clip.name = "punch";
  const std::string from = written(folder, "from.glb", source, {source.clip});
  const std::string to = written(folder, "to.glb", target, {});
  const auto told = [&](const std::string& own) {
    const Result<NewClips> brought = clipsFromFile(openedFile(own), {from, {}, {}});
    REQUIRE(brought);
    return brought->warnings;
  };
  const auto isOfFloor = [](const std::string& line) {
    return line.find("below the floor") != std::string::npos;
  };
  CHECK(std::ranges::none_of(told(clean), isOfFloor));
  const std::vector<std::string> warnings = told(to);
  const auto sinks = std::ranges::find_if(warnings, isOfFloor);
  REQUIRE(sinks != warnings.end());
  CHECK(sinks->starts_with("punch: what follows \"flail\" gets "));
}

TEST_CASE(
    "A clip is copied to the character that was found where another one has the same names, which is told") {
  const TemporaryFolder folder;
  const test::MovingBiped both = twoOfEqualNames();
  const std::string file = written(folder, "both.glb", both, {});
  const test::VerbAnswer answer = test::runVerb(
      {"import-clip", file, "-o", (folder / "out.glb").string(), "--from", punchFile(folder), "--json"});
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  const Json report = Json::parse(answer.output);
  CHECK(report["clips"][0]["way"] == "copied");
  CHECK(report["clips"][0]["left_out"].empty());
  CHECK_THAT(report["warnings"].dump(), Catch::Contains("at least 2 characters in the file"));
}

TEST_CASE("What moves another character of the file by the same names is left out of the clip, and told") {
  const TemporaryFolder folder;
  test::MovingBiped both = twoOfEqualNames();
  for (const char* const key : {"upperArm.l", "other upperArm.l"}) {
    both.clip.tracks.emplace_back(
        test::rotationTrack(both.node.at(key), Interpolation::linear,
                            {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {1.0, Quat(0.8, 0.0, 0.6, 0.0)}}));
  }
  const std::string from = written(folder, "both.glb", both, {both.clip});
  const std::string file = written(folder, "one.glb", test::still(test::namedBody()), {});
  const Result<NewClips> brought = clipsFromFile(openedFile(file), {from, {}, {}});
  INFO((brought ? std::string() : brought.error().line()));
  REQUIRE(brought);
  CHECK_FALSE(brought->clips.front().isRetargeted);
  CHECK(brought->clips.front().clip.tracks.size() == 1);
  REQUIRE(brought->warnings.size() == 1);
  CHECK_THAT(brought->warnings.front(), Catch::StartsWith("still: left out what moves another character") &&
                                            Catch::Contains(": 1 of them"));
}

TEST_CASE("Morph weights that a retargeted clip leaves out are counted, and that nothing moves is told") {
  const TemporaryFolder folder;
  const auto told = [&](bool punches) {
    test::MovingBiped moving = punches ? test::punchingBiped() : test::still(test::namedBody());
    const NodeIndex beside = test::addNode(moving.scene, "Lamp", NodeIndex::none, Vec3(2.0, 0.0, 0.0));
    moving.clip.tracks.emplace_back(test::vectorTrack(beside, Channel::translation, Interpolation::linear,
                                                      {{0.0, Vec3(2.0)}, {1.0, Vec3(3.0)}}));
    auto glb = test::characterFile(moving.scene, {moving.clip});
    Json& primitive = glb.json["meshes"][0]["primitives"][0];
    primitive["targets"] = Json::array({Json{{"POSITION", primitive["attributes"]["POSITION"]}}});
    const int times = glb.floats({0.0F, 1.0F}, "SCALAR", 1);
    glb.json["accessors"][at(times)]["min"] = {0.0};
    glb.json["accessors"][at(times)]["max"] = {1.0};
    Json& clip = glb.json["animations"][0];
    clip["samplers"].push_back({{"input", times}, {"output", glb.floats({0.0F, 1.0F}, "SCALAR", 1)}});
    const auto shown =
        std::ranges::find_if(moving.scene.nodes, [](const Node& node) { return node.mesh == 0; });
    clip["channels"].push_back(
        {{"sampler", clip["samplers"].size() - 1},
         {"target", {{"node", shown - moving.scene.nodes.begin()}, {"path", "weights"}}}});
    glb.write(folder / "from.glb");
    const Result<NewClips> brought =
        clipsFromFile(openedFile(posedCharacter), {(folder / "from.glb").string(), {}, {}});
    REQUIRE(brought);
    CHECK(brought->clips.front().isRetargeted);
    return Json(brought->warnings).dump();
  };
  CHECK_THAT(told(true), Catch::Contains("left out 1 channel of morph weights") &&
                             !Catch::Contains("nothing of it moves"));
  CHECK_THAT(told(false), Catch::Contains("nothing of it moves this character"));
}
