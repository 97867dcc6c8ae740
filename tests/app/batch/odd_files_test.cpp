#include <cmath>

#include <catch2/catch.hpp>

#include "app/batch/verb.h"
#include "app/document.h"
#include "app/files/save.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/captured_stream.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/character_file.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/naming_schemes.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;

namespace {

// A punch of one second keyed at 120 frames per second, few keys of it on frames of a lower rate.
MovingBiped fastPunch() {
  MovingBiped moving = punchingBiped();
  for (CopyOnWrite<Track>& leaf : moving.clip.tracks) {
    leaf.edit([](Track& track) {
      track.times = {0.0F, 31.0F / 120.0F, 61.0F / 120.0F, 91.0F / 120.0F, 1.0F};
    });
  }
  return moving;
}

} // namespace

TEST_CASE("A rigid part of a limb is stretched in the saved file, and the file opens as it was saved") {
  MovingBiped moving = still(namedBody());
  const NodeIndex joint = moving.node.at("foreArm.l");
  const NodeIndex part = addNode(moving.scene, "part", joint, Vec3(0.125, 0.0, 0.0));
  Primitive box;
  box.positions = {{-0.12F, 0, 0}, {0.12F, 0.04F, 0}, {0.12F, -0.04F, 0.04F}};
  moving.scene.nodes[at(part)].mesh = static_cast<int>(moving.scene.meshes.size());
  moving.scene.meshes.push_back({"part", {box}, {}});
  addPunch(moving, Interpolation::linear);
  const TemporaryFolder folder;
  characterFile(moving.scene, {moving.clip}).write(folder / "in.glb");
  const std::string output = (folder / "out.glb").string();
  REQUIRE(runVerb({"exaggerate", (folder / "in.glb").string(), "-o", output, "--clean", "--limb", "left-arm",
                   "--range", "0:12", "--scale", "2"})
              .exitCode == 0);
  const Result<Document> before = openDocument(folder / "in.glb");
  const Result<Document> after = openDocument(output);
  REQUIRE(before);
  REQUIRE(after);
  const auto span = [&](const Document& document) {
    const Clip& clip = clipOf(document, 0);
    const FrameState frame = frameOf(*document.scene, samplePose(*document.scene, clip, 0.5), 0.5);
    const Mat4 world = meshMatrix(frame, part);
    return glm::distance(transformPoint(world, Vec3(box.positions[0])),
                         transformPoint(world, Vec3(0.12, 0, 0)));
  };
  CHECK(span(*after) == Approx(2.0 * span(*before)).epsilon(1e-3));
}

TEST_CASE("A clean file keeps the frame rate, whatever its keys tell") {
  const TemporaryFolder folder;
  const MovingBiped moving = fastPunch();
  characterFile(moving.scene, {moving.clip}).write(folder / "in.glb");
  const Result<Document> source = openDocument(folder / "in.glb");
  REQUIRE(source);
  REQUIRE(clipOf(*source, 0).framesPerSecond == 120.0);
  const std::string output = (folder / "out.glb").string();
  for (const std::string clean : {"--clean", "--key-every-frame"}) {
    REQUIRE(runVerb({"exaggerate", (folder / "in.glb").string(), "-o", output, clean, "--limb", "left-arm",
                     "--range", "0:61", "--scale", "2"})
                .exitCode == 0);
    const Result<Document> saved = openDocument(output);
    REQUIRE(saved);
    CHECK(clipOf(*saved, 0).framesPerSecond == 120.0);
  }
}

TEST_CASE("A clip that lasts for decades has a number of frames, and a limb of it is exaggerated") {
  const TemporaryFolder folder;
  MovingBiped moving = punchingBiped();
  for (CopyOnWrite<Track>& leaf : moving.clip.tracks) {
    leaf.edit([](Track& track) {
      const std::vector<float> last(track.values.end() - track.width, track.values.end());
      track.times.push_back(1e9F);
      track.values.insert(track.values.end(), last.begin(), last.end());
    });
  }
  characterFile(moving.scene, {moving.clip}).write(folder / "eon.glb");
  const Result<Document> document = openDocument(folder / "eon.glb");
  REQUIRE(document);
  CHECK(frameCount(clipOf(*document, 0)) > 1000000000);
  CHECK(runVerb({"exaggerate", (folder / "eon.glb").string(), "-o", (folder / "o.glb").string(), "--limb",
                 "left-arm", "--range", "0:12", "--scale", "2"})
            .exitCode == 0);
}

TEST_CASE("What has no memory ends in one line") {
  Verb hungry{"hungry", "Asks for too much.", [](CommandLine&) {
                return [] {
                  throw std::bad_alloc();
                  return Status(Success{});
                };
              }};
  const std::vector<const char*> arguments{"stretch-engine", "hungry"};
  const CapturedStream errors(stderr);
  CHECK(runVerbs({hungry}, "stretch-engine under test", 2, arguments.data()) == 1);
  CHECK_THAT(errors.text(), Catch::Contains("not enough memory"));
}

TEST_CASE("A folder of meshes and a file that moves morph targets alone point to compress") {
  const TemporaryFolder folder;
  for (const std::string name : {"a1.obj", "a2.obj"}) {
    folder.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  }
  const std::string path = (folder / "").string();
  CHECK(runVerb({"info", path}).exitCode == 0);
  const VerbAnswer asCharacter =
      runVerb({"exaggerate", path, "-o", (folder / "o.glb").string(), "--limb", "left-arm", "--scale", "2"});
  CHECK(asCharacter.exitCode == 1);
  CHECK_THAT(asCharacter.told, Catch::Contains("compress"));

  Scene scene;
  const NodeIndex node = addNode(scene, "blob", NodeIndex::none, Vec3(0.0));
  scene.nodes[at(node)].mesh = 0;
  scene.meshes.push_back({"blob", {}, {0.0F}});
  const rig::Body biped = rig::detectBody(scene);
  REQUIRE(biped.warnings.size() == 1);
  CHECK_THAT(biped.warnings.front(), Catch::Contains("compress"));
}

TEST_CASE(
    "What is of no plan is stretched by name, and what is doubtful is told by every verb that stretches") {
  const TemporaryFolder folder;
  armBuilder().write(folder / "arm.glb");
  SyntheticBiped body = namedBody();
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    return joint.key.ends_with(".r") && (joint.key.find("Arm") != std::string::npos ||
                                         joint.key.starts_with("hand") || joint.key.starts_with("clavicle"));
  });
  MovingBiped oneArmed = still(body);
  addPunch(oneArmed, Interpolation::linear);
  characterFile(oneArmed.scene, {oneArmed.clip}).write(folder / "one-armed.glb");
  const std::string arm = (folder / "arm.glb").string();
  const std::string biped = (folder / "one-armed.glb").string();
  const std::string output = (folder / "out.glb").string();
  CHECK_THAT(runVerb({"info", arm, "--json"}).output, Catch::Contains(R"("plan": "other")"));
  CHECK(runVerb({"exaggerate", arm, "-o", output, "--limb", "root..lower", "--scale", "2"}).exitCode == 0);
  CHECK(runVerb({"elastic", arm, "-o", output, "--limb", "root..lower"}).exitCode == 0);
  const std::vector<std::vector<std::string>> verbs = {
      {"elastic", biped, "-o", output, "--limb", "left-arm"},
      {"exaggerate", biped, "-o", output, "--limb", "left-arm", "--scale", "2"}};
  for (const std::vector<std::string>& words : verbs) {
    CAPTURE(words.front());
    const VerbAnswer answer = runVerb(words);
    CHECK(answer.exitCode == 0);
    CHECK_THAT(answer.told, Catch::Contains("no right-arm found"));
    std::vector<std::string> json = words;
    json.emplace_back("--json");
    CHECK_THAT(runVerb(json).output, Catch::Contains("no right-arm found"));
  }
}

TEST_CASE("A key long before 0 costs no more than one at 0: what is keyed anew begins with the clip") {
  MovingBiped moving = punchingBiped();
  for (CopyOnWrite<Track>& track : moving.clip.tracks) {
    track.edit([](Track& keys) { keys.times.front() = -1e9F; });
  }
  const TemporaryFolder folder;
  characterFile(moving.scene, {moving.clip}).write(folder / "early.glb");
  const std::string output = (folder / "out.glb").string();
  REQUIRE(
      runVerb({"elastic", "--tolerant", (folder / "early.glb").string(), "-o", output, "--clean"}).exitCode ==
      0);
  const Result<Document> written = openDocument(output, gltf::Tolerance::warn);
  REQUIRE(written);
  for (const CopyOnWrite<Track>& track : clipOf(*written, 0).tracks) {
    CHECK(std::ranges::count_if(track->times, [](float seconds) { return seconds < 0.0F; }) <= 1);
  }
}

TEST_CASE("A file that is refused is named once, whichever verb refuses it") {
  const TemporaryFolder folder;
  const std::string missing = (folder / "none.glb").string();
  for (const std::string verb : {"info", "check", "compress", "compare"}) {
    std::vector<std::string> words{verb, missing};
    if (verb == "compress") {
      words.insert(words.end(), {"-o", (folder / "out.glb").string()});
    } else if (verb == "compare") {
      words.push_back(missing);
    }
    const VerbAnswer answer = runVerb(words);
    INFO(answer.told);
    CHECK(answer.exitCode == 1);
    CHECK(answer.told.find(missing) != std::string::npos);
    CHECK(answer.told.find(missing) == answer.told.rfind(missing));
  }
}

TEST_CASE(
    "A clip of years, as a key at an absurd time makes it, is refused at once by what counts its frames") {
  MovingBiped moving = punchingBiped();
  const auto lastAt = [&](float seconds) {
    for (CopyOnWrite<Track>& leaf : moving.clip.tracks) {
      leaf.edit([&](Track& track) { track.times.back() = seconds; });
    }
  };
  const TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  for (const float seconds : {1e30F, 1e6F}) {
    lastAt(seconds);
    characterFile(moving.scene, {moving.clip}).write(folder / "in.glb");
    for (const std::string verb : {"elastic", "pose", "exaggerate"}) {
      std::vector<std::string> line{verb, (folder / "in.glb").string(), "-o", output};
      if (verb != "elastic") {
        line.emplace_back(verb == "pose" ? "--pin-feet" : "--auto");
      }
      INFO(verb << " " << seconds);
      const VerbAnswer run = runVerb(line);
      CHECK(run.exitCode == 1);
      CHECK(run.told.find("frames, more than 100000") != std::string::npos);
      CHECK_FALSE(std::filesystem::exists(output));
    }
  }
  lastAt(2.0F); // and a clip that lasts as long as one may is not
  characterFile(moving.scene, {moving.clip}).write(folder / "in.glb");
  CHECK(runVerb({"pose", (folder / "in.glb").string(), "-o", output, "--pin-feet"}).exitCode == 0);
}

TEST_CASE("A picture that is broken behind its header is told by check, and no other verb decodes it") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.json["images"] = {
      {{"uri", "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42gf/"
               "+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="}}};
  glb.json["textures"] = {{{"source", 0}}};
  glb.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  glb.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
      glb.floats({0, 0, 1, 0, 0, 1, 1, 1, 0, 2, 1, 2}, "VEC2", 2);
  const std::string file = (folder / "broken.glb").string();
  glb.write(file);
  const auto isTold = [](const VerbAnswer& answer) {
    return (answer.output + answer.told).find("images[0]: is not a picture") != std::string::npos;
  };
  CHECK(isTold(runVerb({"check", file})));
  const VerbAnswer info = runVerb({"info", file});
  CHECK(info.exitCode == 0);
  CHECK_FALSE(isTold(info));
  const VerbAnswer saved = runVerb({"resave", file, "-o", (folder / "again.glb").string()});
  CHECK(saved.exitCode == 0);
  CHECK_FALSE(isTold(saved));
  CHECK(isTold(runVerb({"check", (folder / "again.glb").string()})));
}

TEST_CASE("A vertex that stands far from all others is told when its file is opened, and by bind") {
  const bool isStray = GENERATE(true, false);
  const TemporaryFolder folder;
  Scene scene = test::build(test::makeNamedBody("Mixamo")).scene;
  REQUIRE_FALSE(scene.meshes.empty());
  scene.meshes.front().primitives.front().positions.front().x += isStray ? 500.0F : 0.0F;
  const std::string file = (folder / "body.glb").string();
  test::characterFile(scene, {}).write(file);
  const auto tells = [&](const test::VerbAnswer& answer) {
    INFO(answer.told);
    CHECK(answer.exitCode == 0);
    return (answer.told + answer.output).find("1 of ") != std::string::npos &&
           (answer.told + answer.output).find("ten times as far out as the others") != std::string::npos;
  };
  CHECK(tells(test::runVerb({"info", file})) == isStray);
  CHECK(tells(test::runVerb({"bind", file, "-o", (folder / "bound.glb").string(), "--keep-joints"})) ==
        isStray);
}
