#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/weight_edits.h"
#include "app/weight/standing.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/run_command.h"

using namespace stretch;
using namespace stretch::app;
using test::run;

namespace {

const DocumentCommand& weightCommand(const std::string& id) {
  static const std::vector<DocumentCommand> commands = documentCommands();
  const auto command = std::ranges::find(commands, id, &DocumentCommand::id);
  REQUIRE(command != commands.end());
  return *command;
}

/// The limbs with weight in the clip that is shown, "off" behind those whose weight is off.
std::vector<std::string> weighted(const Session& session) {
  std::vector<std::string> limbs;
  for (const WeightedLimb& entry : session.document().weights) {
    CHECK(entry.clip == 0);
    limbs.push_back(entry.limb + (entry.on ? "" : " off"));
  }
  std::ranges::sort(limbs);
  return limbs;
}

using Limbs = std::vector<std::string>;

Document boxerWith(const Limbs& limbs) {
  Document document = test::boxer();
  std::erase_if(document.body.limbs,
                [&](const rig::Limb& limb) { return std::ranges::find(limbs, limb.id) == limbs.end(); });
  return document;
}

} // namespace

TEST_CASE("Weight for all goes to every limb but the trunk's, and to those whose weight was off") {
  Session session(test::boxer());
  REQUIRE(run(session, command::weightAll).empty());
  CHECK(weighted(session) == Limbs{"left-arm", "right-arm"});
  selectLimb(session, "left-arm", false);
  REQUIRE(run(session, command::weightToggle).empty());
  CHECK(weighted(session) == Limbs{"left-arm off", "right-arm"});
  REQUIRE(run(session, command::weightAll).empty());
  CHECK(weighted(session) == Limbs{"left-arm", "right-arm"});
}

TEST_CASE("Weight for all is called by the limbs that there are, and refused where there are none") {
  const auto called = [](const Limbs& limbs) {
    const Session session(boxerWith(limbs));
    return weightCommand(command::weightAll).labelNow(session);
  };
  CHECK(called({"left-arm", "right-arm", "spine"}) == "Weight for arms");
  CHECK(called({"left-arm", "spine"}) == "Weight for arm");
  CHECK(called({"spine"}) == "Weight for arms and legs");
  Session trunk(boxerWith({"spine"}));
  CHECK(run(trunk, command::weightAll) ==
        "there is no clip, or no limb beside the trunk; open a character with an animation");
  CHECK(trunk.document().weights.empty());
  Document still = test::boxer();
  still.clips = std::make_shared<const std::vector<Clip>>();
  Session without{std::move(still)};
  CHECK_FALSE(run(without, command::weightAll).empty());
  CHECK(without.document().weights.empty());
}

TEST_CASE("The weight of the selected limbs is switched as one, off where all have it and else on") {
  Session session(test::boxer());
  const DocumentCommand& toggle = weightCommand(command::weightToggle);
  CHECK(run(session, command::weightToggle) == "select a limb first");
  CHECK_FALSE(toggle.checked(session));
  selectLimb(session, "left-arm", false);
  CHECK_FALSE(toggle.checked(session));
  REQUIRE(run(session, command::weightToggle).empty());
  CHECK(session.history().undoLabel() == "Give weight");
  CHECK(toggle.checked(session));
  selectLimb(session, "right-arm", true);
  CHECK_FALSE(toggle.checked(session));
  REQUIRE(run(session, command::weightToggle).empty());
  CHECK(weighted(session) == Limbs{"left-arm", "right-arm"});
  CHECK(toggle.checked(session));
  REQUIRE(run(session, command::weightToggle).empty());
  CHECK(session.history().undoLabel() == "Switch weight off");
  CHECK(weighted(session) == Limbs{"left-arm off", "right-arm off"});
}

TEST_CASE("Weight is taken away from the selected limbs alone, also where it is off") {
  Session session(test::boxer());
  REQUIRE(run(session, command::weightAll).empty());
  CHECK(run(session, command::weightRemove) == "select a limb that has weight");
  selectLimb(session, "spine", false);
  CHECK(run(session, command::weightRemove) == "select a limb that has weight");
  selectLimb(session, "right-arm", false);
  REQUIRE(run(session, command::weightToggle).empty());
  selectLimb(session, "spine", true);
  REQUIRE(run(session, command::weightRemove).empty());
  CHECK(session.history().undoLabel() == "Take the weight away");
  CHECK(weighted(session) == Limbs{"left-arm"});
}

TEST_CASE("A leg stands as much whatever unit its character is made in") {
  const auto standing = [](double restLength, double metresPerUnit) {
    SampledClip sampled;
    sampled.samplesPerSecond = 10.0;
    for (const char* const id : {"left-leg", "right-leg"}) {
      SampledClip::OfLimb one;
      one.limb.id = id;
      one.limb.kind = rig::LimbKind::leg;
      one.limb.restLength = restLength;
      one.lowest = std::string(id) == "left-leg" ? std::vector<double>{0.0, 0.0, 0.0, 0.02, 0.05, 0.3, 0.6}
                                                 : std::vector<double>{0.6, 0.3, 0.05, 0.02, 0.0, 0.0, 0.0};
      sampled.limbs.push_back(one);
    }
    return standingOf(sampled, metresPerUnit);
  };
  const Standing metres = standing(0.8, 1.0);
  CHECK(metres.legs == std::vector<std::string>{"left-leg", "right-leg"});
  CHECK(metres.planted[0].front() == Approx(1.0));
  CHECK(metres.planted[0].back() == Approx(0.0).margin(1e-9));
  CHECK(metres.planted[1].front() == Approx(0.0).margin(1e-9));
  CHECK(metres.planted[1].back() == Approx(1.0));
  for (const Standing& other : {standing(80.0, 0.01), standing(0.0008, 1000.0)}) {
    for (std::size_t leg = 0; leg < 2; ++leg) {
      for (std::size_t sample = 0; sample < 7; ++sample) {
        CHECK(other.planted[leg][sample] == Approx(metres.planted[leg][sample]).margin(1e-9));
        CHECK(other.kept[leg][sample] == Approx(metres.kept[leg][sample]).margin(1e-9));
        CHECK(other.shares[leg][sample] == Approx(metres.shares[leg][sample]).margin(1e-9));
      }
    }
  }
}
