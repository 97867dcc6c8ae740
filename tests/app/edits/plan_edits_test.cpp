#include <catch2/catch.hpp>

#include "app/commands/document_commands.h"
#include "app/commands/selection.h"
#include "app/edits/limb_edits.h"
#include "app/files/saved_work.h"
#include "core/gltf/json.h"
#include "tests/support/rig/creatures.h"

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
  CHECK_FALSE(changePlan(document, "centaur"));
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
