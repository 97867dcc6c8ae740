// Limbs that have a key, and trails that are asked for without one of them.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/session.h"
#include "rig/body/reading/planned_body.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("Limbs that a plan has and not every body of it are listed where the body has them") {
  Document document = test::boxer();
  const rig::BodyPlan& plan = rig::planOf(document.body);
  const auto places = [&](const std::string& id) {
    const std::vector<std::string> listed = limbsByKey(document);
    return std::ranges::count(listed, id);
  };
  std::size_t rare = 0;
  for (const rig::PlannedLimb& limb : plan.limbs) {
    CAPTURE(limb.id);
    const bool isThere = findLimb(document, limb.id) != nullptr;
    CHECK(places(limb.id) == (limb.usual || isThere ? 1 : 0));
    if (!limb.usual && !isThere) {
      rig::Limb grown = document.body.limbs.front();
      grown.id = limb.id;
      document.body.limbs.push_back(grown);
      CHECK(places(limb.id) == 1);
      ++rare;
    }
  }
  CHECK(rare > 0);
  rig::Limb own = document.body.limbs.front();
  own.id = "third-arm";
  document.body.limbs.push_back(own);
  CHECK(limbsByKey(document).back() == "third-arm");
}

TEST_CASE("A trail is refused where no limb is selected, and where there is no clip") {
  Session session(test::boxer());
  for (const bool exaggerated : {true, false}) {
    CHECK_THAT(test::refusal(newTrails(session, exaggerated)), Catch::Contains("no limb is selected"));
  }
  Document without = test::boxer();
  without.clips = std::make_shared<const std::vector<Clip>>();
  Session still(without);
  selectLimb(still, "left-arm", false);
  CHECK_THAT(test::refusal(newTrails(still, true)), Catch::Contains("the file has no animation"));
}
