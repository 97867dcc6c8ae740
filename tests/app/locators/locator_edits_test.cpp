#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/command_ids.h"
#include "app/commands/document_commands.h"
#include "app/files/save.h"
#include "app/locators/build_rig.h"
#include "app/locators/locator_edits.h"
#include "app/open_document.h"
#include "core/gltf/json.h"
#include "tests/support/app/mesh_file.h"
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

TEST_CASE("A rig is built, taken apart to its locators, and built again", "[locators]") {
  Session session = personSession();
  const std::size_t nodes = session.document().scene->nodes.size();
  const gltf::Json before = *session.document().source->json;
  REQUIRE(runCommand(session, command::locatorsFit));
  CHECK(showsLocators(session.document()));
  REQUIRE(runCommand(session, command::rigBuild));
  CHECK(session.document().biped.limbs.size() == 6);
  CHECK_FALSE(showsLocators(session.document()));
  CHECK(session.document().scene->nodes.size() == nodes + 22);
  REQUIRE(runCommand(session, command::rigBack));
  CHECK(showsLocators(session.document()));
  CHECK(session.document().scene->nodes.size() == nodes);
  CHECK(session.document().biped.limbs.empty());
  CHECK((*session.document().source->json)["nodes"] == before["nodes"]);
  REQUIRE(runCommand(session, command::rigBuild));
  CHECK(session.document().biped.limbs.size() == 6);
  for (int i = 0; i < 4; ++i) {
    session.undo();
  }
  CHECK(session.document().locators.empty());
  CHECK(session.document().scene->nodes.size() == nodes);
}
