#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/bind/bind_mesh.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/edits/keys/import_clip.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "app/locators/build_rig.h"
#include "app/locators/locator_edits.h"
#include "app/open_document.h"
#include "core/anim/sampling.h"
#include "core/gltf/json/json.h"
#include "core/math/rotation.h"
#include "skinning/linear_blend_skinning.h"
#include "tests/support/app/mesh_file.h"
#include "tests/support/refusal.h"
#include "tests/support/skinning/tube_person.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Session personSession() {
  const test::TemporaryFolder folder;
  const test::TubePerson person = test::tubePerson();
  const auto path = folder.path() / "person.gltf";
  test::writeMeshFile(path, person.positions, person.triangles);
  Result<Document> document = openDocument(path);
  REQUIRE(document);
  return Session(std::move(*document));
}

Status runCommand(Session& session, const char* id) {
  for (const DocumentCommand& command : documentCommands()) {
    if (command.id == id) {
      REQUIRE(command.enabled(session));
      return command.run(session);
    }
  }
  throw std::runtime_error("no such command");
}

Vec3 placeOf(const Session& session, const char* name) {
  return rig::findLocator(session.document().locators, name)->position;
}

} // namespace

TEST_CASE("A moved locator takes its counterpart along as the mirror image", "[locators]") {
  Session session = personSession();
  REQUIRE(runCommand(session, command::locatorsFit));
  const Vec3 left = placeOf(session, "leftHand");
  const Vec3 right = placeOf(session, "rightHand");
  const Document both = moveLocators(session.document(), {"leftHand"}, {0.1, 0.2, 0.05}, true);
  CHECK(glm::distance(rig::findLocator(both.locators, "leftHand")->position, left + Vec3(0.1, 0.2, 0.05)) <
        1e-9);
  CHECK(glm::distance(rig::findLocator(both.locators, "rightHand")->position, right + Vec3(-0.1, 0.2, 0.05)) <
        0.01);
  CHECK(rig::findLocator(both.locators, "rightHand")->confidence == 1.0);
  const Document one = moveLocators(session.document(), {"leftHand"}, {0.1, 0.2, 0.05}, false);
  CHECK(rig::findLocator(one.locators, "rightHand")->position == right);
  const Document middle = moveLocators(session.document(), {"spine"}, {0.1, 0.2, 0.0}, true);
  CHECK(std::abs(rig::findLocator(middle.locators, "spine")->position.x - placeOf(session, "spine").x) <
        0.01);
}

TEST_CASE("A locator whose counterpart is gone moves alone, and across the body as the others tell",
          "[locators]") {
  Session session = personSession();
  REQUIRE(runCommand(session, command::locatorsFit));
  Document document = session.document();
  std::erase_if(document.locators.list,
                [](const rig::Locator& locator) { return locator.name == "rightHand"; });
  const std::size_t count = document.locators.list.size();
  const Vec3 step(0.1, 0.2, 0.05);
  const Document moved = moveLocators(document, {"leftHand", "leftFoot"}, step, true);
  REQUIRE(moved.locators.list.size() == count);
  for (const rig::Locator& locator : moved.locators.list) {
    const Vec3 before = rig::findLocator(document.locators, locator.name)->position;
    CAPTURE(locator.name);
    if (locator.name == "leftHand" || locator.name == "leftFoot") {
      CHECK(glm::distance(locator.position, before + step) < 1e-9);
    } else if (locator.name == "rightFoot") {
      CHECK(glm::distance(locator.position, before + Vec3(-0.1, 0.2, 0.05)) < 0.01);
    } else {
      CHECK(locator.position == before);
    }
  }
}

TEST_CASE("A turned locator turns its counterpart the other way, and one in the middle forwards alone",
          "[locators]") {
  Document document;
  document.scene = std::make_shared<const Scene>();
  document.locators.list = {{.name = "hips"},
                            {.name = "leftHand", .position = {0.7, 1.4, 0.0}, .confidence = 0.25},
                            {.name = "rightHand", .position = {-0.7, 1.4, 0.0}}};
  CHECK(showsLocators(document, false));
  CHECK(showsLocators(document, true));
  CHECK_FALSE(showsLocators(Document(), true));
  const Vec3 turn(0.1, 0.2, 0.3);
  const auto turnOf = [](const Document& of, const char* name) {
    const Quat made = rig::findLocator(of.locators, name)->orientation;
    return glm::angle(made) * glm::axis(made);
  };
  const Document both = turnLocators(document, {"leftHand", "hips", "tail"}, turn, true);
  CHECK(glm::distance(turnOf(both, "leftHand"), turn) < 1e-9);
  CHECK(glm::distance(turnOf(both, "rightHand"), Vec3(0.1, -0.2, -0.3)) < 1e-9);
  CHECK(glm::distance(turnOf(both, "hips"), Vec3(0.1, 0.0, 0.0)) < 1e-9);
  CHECK(rig::findLocator(both.locators, "leftHand")->position == Vec3(0.7, 1.4, 0.0));
  CHECK(rig::findLocator(both.locators, "leftHand")->confidence == 0.25); // its place is as sure as before
  const Document named = turnLocators(document, {"leftHand", "rightHand"}, turn, true);
  CHECK(glm::distance(turnOf(named, "rightHand"), turn) < 1e-9); // both as they are asked to
  const Document one = turnLocators(document, {"leftHand", "hips"}, turn, false);
  CHECK(rig::findLocator(one.locators, "rightHand")->orientation == Quat(1.0, 0.0, 0.0, 0.0));
  CHECK(glm::distance(turnOf(one, "hips"), turn) < 1e-9);
  const Document twice = turnLocators(turnLocators(document, {"hips"}, {0.0, 0.0, 0.5 * pi}, false), {"hips"},
                                      {0.5 * pi, 0.0, 0.0}, false);
  // About the world's axes, one after the other.
  CHECK(glm::distance(rig::findLocator(twice.locators, "hips")->orientation * Vec3(1.0, 0.0, 0.0),
                      Vec3(0.0, 0.0, 1.0)) < 1e-9);
}

TEST_CASE("Reset puts moved locators back to where they were fitted, as one step") {
  Session session = personSession();
  REQUIRE(runCommand(session, command::locatorsFit));
  const rig::Locators fitted = session.document().locators;
  session.edit(moveLocators(session.document(), {"leftHand", "spine"}, {0.1, 0.2, 0.05}, true), "Move");
  const rig::Locators moved = session.document().locators;
  REQUIRE(moved != fitted);
  REQUIRE(runCommand(session, command::locatorsReset));
  CHECK(session.document().locators == fitted);
  session.undo();
  CHECK(session.document().locators == moved);
}

TEST_CASE("A locator that is off goes to the middle of the limb around it", "[locators]") {
  Session session = personSession();
  REQUIRE(runCommand(session, command::locatorsFit));
  Document off = moveLocators(session.document(), {"leftLowerArm"}, {0.0, 0.02, 0.015}, false);
  const Document snapped = snapLocators(off, {"leftLowerArm"}, false);
  const Vec3 place = rig::findLocator(snapped.locators, "leftLowerArm")->position;
  CHECK(std::abs(place.y - 1.43) < 0.006);
  CHECK(std::abs(place.z) < 0.006);
  off = moveLocators(session.document(), {"leftLowerArm"}, {0.0, 0.5, 0.0}, false); // outside
  CHECK(snapLocators(off, {"leftLowerArm"}, false).locators.list == off.locators.list);
}

namespace {

/// The person bound at its locators, saved, and opened again.
Document boundPerson(const test::TemporaryFolder& folder) {
  Session session = personSession();
  REQUIRE(runCommand(session, command::locatorsFit));
  const Result<BoundMeshes> bound = bindMeshes(session.document(), {.locators = session.document().locators});
  REQUIRE(bound);
  const Result<Document> made = withBoundMeshes(session.document(), *bound);
  REQUIRE(made);
  REQUIRE(saveDocument(*made, folder / "bound.glb", {}));
  Result<Document> reopened = openDocument(folder / "bound.glb");
  REQUIRE(reopened);
  return std::move(*reopened);
}

/// With a clip that bends the left elbow and carries the hips, by keys of every kind.
Document bent(Document document) {
  const auto node = [&](const char* name) {
    const auto found = std::ranges::find(document.scene->nodes, name, &Node::name);
    return NodeIndex(static_cast<std::size_t>(found - document.scene->nodes.begin()));
  };
  const auto track = [](NodeIndex of, Channel channel, const std::vector<float>& values) {
    Track made;
    made.node = of;
    made.channel = channel;
    made.width = channel == Channel::rotation ? 4 : 3;
    made.times = {0.0F, 1.0F};
    made.values = values;
    return made;
  };
  const NodeIndex elbow = node("leftLowerArm");
  const NodeIndex hips = node("hips");
  const Quat rest = document.scene->nodes[at(elbow)].rest.rotation;
  const Quat bend = glm::normalize(rest * axisAngle(Vec3(1.0, 0.0, 0.0), 1.0));
  const Vec3 place = document.scene->nodes[at(hips)].rest.translation;
  const auto f = [](double x) { return static_cast<float>(x); };
  Clip clip;
  clip.name = "Bend";
  clip.tracks.emplace_back(
      track(elbow, Channel::rotation,
            {f(rest.x), f(rest.y), f(rest.z), f(rest.w), f(bend.x), f(bend.y), f(bend.z), f(bend.w)}));
  clip.tracks.emplace_back(
      track(hips, Channel::translation,
            {f(place.x), f(place.y), f(place.z), f(place.x), f(place.y + 0.25), f(place.z)}));
  Result<Document> with = withNewClips(document, {clip});
  REQUIRE(with);
  return std::move(*with);
}

/// World turns and places of a joint at the end of the clip.
Mat4 atEnd(const Document& document, const char* joint) {
  const FrameState frame = evaluateOriginal(document, 0, 1.0);
  const auto found = std::ranges::find(document.scene->nodes, joint, &Node::name);
  return frame.worlds[static_cast<std::size_t>(found - document.scene->nodes.begin())];
}

Mat4 atRest(const Document& document, const char* joint) {
  const auto found = std::ranges::find(document.scene->nodes, joint, &Node::name);
  return worldMatrices(
      *document.scene,
      restPose(*document.scene))[static_cast<std::size_t>(found - document.scene->nodes.begin())];
}

} // namespace

TEST_CASE("Binding takes along what was set up for limbs that the bound body has not", "[locators]") {
  Session session = personSession();
  REQUIRE(runCommand(session, command::locatorsFit));
  Document before = session.document();
  before.weights = {{"left-arm", 0, true, {}}, {"tail", 0, true, {}}};
  const Result<BoundMeshes> bound = bindMeshes(before, {.locators = before.locators});
  REQUIRE(bound);
  const Result<Document> made = withBoundMeshes(before, *bound);
  REQUIRE(made);
  REQUIRE(made->weights.size() == 1);
  CHECK(made->weights.front().limb == "left-arm");
}

TEST_CASE(
    "Locators of a bound file that was opened again are shown, moved, and bound again at their new places") {
  const test::TemporaryFolder folder;
  Session session(boundPerson(folder));
  const std::size_t nodes = session.document().scene->nodes.size();
  CHECK(isRigBuilt(session.document()));
  CHECK_FALSE(showsLocators(session));
  REQUIRE(runCommand(session, command::rigBack));
  CHECK(showsLocators(session));
  CHECK(session.document().scene->nodes.size() == nodes); // the mesh follows the joints: they stay
  CHECK_FALSE(areLocatorsMoved(session.document()));
  session.edit(moveLocators(session.document(), {"leftLowerArm"}, {-0.05, 0.0, 0.02}, true), "Move");
  CHECK(areLocatorsMoved(session.document()));
  const Document before = session.document();
  const Result<BoundMeshes> bound = bindMeshes(before, {.locators = before.locators});
  REQUIRE(bound);
  const Result<Document> again = withBoundMeshes(before, *bound);
  REQUIRE(again);
  CHECK(again->scene->nodes.size() == nodes);
  CHECK(again->scene->skins.size() == before.scene->skins.size());
  CHECK_FALSE(areLocatorsMoved(*again));
  for (const char* joint : {"leftLowerArm", "rightLowerArm", "leftHand", "hips"}) {
    const Vec3 wanted = rig::findLocator(before.locators, joint)->position;
    CHECK(glm::distance(positionOf(atRest(*again, joint)), wanted) < 1e-6);
  }
  const std::vector<Vec3> stood =
      skinning::skinnedPositions(*before.scene, frameOf(*before.scene, restPose(*before.scene), 0.0));
  const std::vector<Vec3> stands =
      skinning::skinnedPositions(*again->scene, frameOf(*again->scene, restPose(*again->scene), 0.0));
  REQUIRE(stood.size() == stands.size());
  for (std::size_t v = 0; v < stood.size(); ++v) {
    REQUIRE(glm::distance(stood[v], stands[v]) < 1e-5);
  }
}

TEST_CASE("A clip turns the mesh as before about joints that were moved") {
  const test::TemporaryFolder folder;
  const Document before = bent(boundPerson(folder));
  Document moved = moveLocators(before, {"leftLowerArm", "hips"}, {0.03, 0.04, 0.02}, false);
  const Result<BoundMeshes> bound = bindMeshes(moved, {.locators = moved.locators});
  REQUIRE(bound);
  const Result<Document> again = withBoundMeshes(moved, *bound);
  REQUIRE(again);
  for (const char* joint : {"leftLowerArm", "leftHand", "hips", "head"}) {
    const Quat turnedBefore =
        rotationOf(atEnd(before, joint)) * glm::inverse(rotationOf(atRest(before, joint)));
    const Quat turnedAgain =
        rotationOf(atEnd(*again, joint)) * glm::inverse(rotationOf(atRest(*again, joint)));
    INFO(joint);
    CHECK(std::abs(glm::dot(turnedBefore, turnedAgain)) > 1.0 - 1e-9);
  }
  const Vec3 carried = positionOf(atEnd(*again, "hips")) - positionOf(atRest(*again, "hips"));
  CHECK(glm::distance(carried, positionOf(atEnd(before, "hips")) - positionOf(atRest(before, "hips"))) <
        1e-5);
  REQUIRE(saveDocument(*again, folder / "again.glb", {}));
  const Result<Document> reopened = openDocument(folder / "again.glb");
  REQUIRE(reopened);
  CHECK(glm::distance(positionOf(atEnd(*reopened, "leftHand")), positionOf(atEnd(*again, "leftHand"))) <
        1e-5);
}

TEST_CASE("Fitting locators to a bound file without its work takes them from its joints") {
  const test::TemporaryFolder folder;
  Document document = boundPerson(folder);
  const rig::Locators kept = std::exchange(document.locators, {});
  Session session(std::move(document));
  REQUIRE(runCommand(session, command::locatorsFit));
  CHECK(showsLocators(session));
  CHECK(isRigBuilt(session.document()));
  CHECK_FALSE(areLocatorsMoved(session.document()));
  CHECK(session.document().locators.list.size() == kept.list.size());
}

TEST_CASE("While locators are shown the character is looked at in its bind pose") {
  const test::TemporaryFolder folder;
  Session session(bent(boundPerson(folder)));
  const auto hand = std::ranges::find(session.document().scene->nodes, "leftHand", &Node::name);
  const auto index = static_cast<std::size_t>(hand - session.document().scene->nodes.begin());
  const double end = 30.0;
  const Vec3 bind = rig::findLocator(session.document().locators, "leftHand")->position;
  CHECK(glm::distance(positionOf(session.shownAt(end).worlds[index]), bind) > 0.1);
  REQUIRE(runCommand(session, command::rigBack));
  CHECK(glm::distance(positionOf(session.shownAt(end).worlds[index]), bind) < 1e-5);
  REQUIRE(runCommand(session, command::rigBack));
  CHECK(glm::distance(positionOf(session.shownAt(end).worlds[index]), bind) > 0.1);
}

TEST_CASE("A rig is built, taken apart to its locators, and built again", "[locators]") {
  Session session = personSession();
  const std::size_t nodes = session.document().scene->nodes.size();
  const gltf::Json before = *session.document().source->json;
  REQUIRE(runCommand(session, command::locatorsFit));
  CHECK(showsLocators(session));
  REQUIRE(runCommand(session, command::rigBuild));
  CHECK(session.document().body.limbs.size() == 6);
  CHECK_FALSE(showsLocators(session));
  CHECK(session.document().scene->nodes.size() == nodes + 22);
  const Document built = session.document();
  CHECK_FALSE(areLocatorsMoved(built));
  CHECK_FALSE(areLocatorsMoved(turnLocators(built, {"leftHand"}, {0.0, 1e-6, 0.0}, false)));
  CHECK(areLocatorsMoved(turnLocators(built, {"leftHand"}, {0.0, 0.01, 0.0}, false)));
  for (const auto& use : std::vector<std::function<void(Document&)>>{
           [](Document& used) { used.trails.resize(1); }, [](Document& used) { used.adjustments.resize(1); },
           [](Document& used) { used.holds.pins.resize(1); },
           [](Document& used) { used.weights.resize(1); }}) {
    Document used = built;
    use(used);
    CHECK_THAT(test::refusal(withoutRig(used)), Catch::StartsWith("something uses the rig"));
  }
  CHECK(withoutRig(built));
  REQUIRE(runCommand(session, command::rigBack));
  CHECK(showsLocators(session));
  CHECK(session.document().scene->nodes.size() == nodes);
  CHECK(session.document().body.limbs.empty());
  CHECK((*session.document().source->json)["nodes"] == before["nodes"]);
  REQUIRE(runCommand(session, command::rigBuild));
  CHECK(session.document().body.limbs.size() == 6);
  for (int i = 0; i < 4; ++i) {
    session.undo();
  }
  CHECK(session.document().locators.empty());
  CHECK(session.document().scene->nodes.size() == nodes);
}
