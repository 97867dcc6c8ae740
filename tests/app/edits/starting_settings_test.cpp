#include <catch2/catch.hpp>

#include "app/commands/trail/exaggerate.h"
#include "app/edits/body/limb_edits.h"
#include "app/edits/trail/starting_settings.h"
#include "app/edits/trail/weight_edits.h"
#include "app/files/saved_work.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/rig/moving_creatures.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;
using gltf::Json;

namespace {

struct CreatureOnDisk {
  explicit CreatureOnDisk(const MovingBiped& creature) { creatureFile(creature).write(path); }

  TemporaryFolder folder;
  std::string path = (folder / "creature.glb").string();
};

const rig::Limb& limbNamed(const Document& document, const std::string& id) {
  const rig::Limb* const limb = findLimb(document, id);
  REQUIRE(limb != nullptr);
  return *limb;
}

} // namespace

TEST_CASE(
    "A tail swings and a hoof stands where nothing else is asked, and a biped keeps the program's own") {
  const CreatureOnDisk file(pawingHorse());
  const Document horse = openedFile(file.path);
  const rig::TrailSettings tail = startingTrail(horse, 0, limbNamed(horse, "tail"), {0, 12});
  CHECK(tail.overshoot > 0.0);
  CHECK(tail.turnEnd);
  CHECK_FALSE(tail.stopAt);
  const rig::TrailSettings hoof = startingTrail(horse, 0, limbNamed(horse, "hind-left-leg"), {0, 12});
  CHECK(hoof.overshoot == 0.0);
  CHECK(hoof.stopAt);
  CHECK(usualWeight(horse, "tail").damping < usualWeight(horse, "hind-left-leg").damping);
  CHECK(usualWeight(horse, "tail").stiffness < usualWeight(horse, "hind-left-leg").stiffness);

  const Document biped = openedFile(posedCharacter);
  for (const rig::Limb& limb : biped.body.limbs) {
    CAPTURE(limb.id);
    CHECK(usualTrail(biped, limb) == rig::TrailSettings{});
    CHECK(usualWeight(biped, limb.id) == WeightSettings{});
  }
}

TEST_CASE("Weight that is switched on, and given by a recipe or the command line, starts from the plan") {
  const CreatureOnDisk file(pawingHorse());
  const Document horse = openedFile(file.path);
  const WeightSettings usual = usualWeight(horse, "tail");
  const Result<Document> heavy = switchWeight(horse, {"tail"}, 0, true);
  REQUIRE(heavy);
  CHECK(heavy->weights.front().settings == usual);

  const std::string output = (file.folder / "out.glb").string();
  REQUIRE(runVerb({"elastic", file.path, "-o", output, "--limb", "tail", "--stiffness", "0.9"}).exitCode ==
          0);
  const WeightSettings asked = openedFile(output).weights.front().settings;
  CHECK(asked.stiffness == 0.9);
  CHECK(asked.damping == usual.damping);

  file.folder.write("recipe.json",
                    R"({"version": 1, "trails": [{"limb": "tail", "range": [0, 6], "scale": 1.5}],
                        "elastic": [{"limb": "tail", "damping": 0.9}]})");
  REQUIRE(runVerb({"exaggerate", file.path, "-o", output, "--recipe", (file.folder / "recipe.json").string()})
              .exitCode == 0);
  const Document made = openedFile(output);
  CHECK(made.weights.front().settings.damping == 0.9);
  CHECK(made.weights.front().settings.stiffness == usual.stiffness);
  CHECK(made.trails.front().settings.overshoot == usualTrail(horse, limbNamed(horse, "tail")).overshoot);
}

TEST_CASE("A trail that the command line gives to a hoof stops at the ground") {
  const CreatureOnDisk file(pawingHorse());
  const std::string output = (file.folder / "out.glb").string();
  REQUIRE(runVerb({"exaggerate", file.path, "-o", output, "--limb", "hind-left-leg", "--scale", "1.5"})
              .exitCode == 0);
  CHECK(openedFile(output).trails.front().settings.stopAt);
  const VerbAnswer down = runVerb({"exaggerate", file.path, "-o", output, "--limb", "hind-left-leg",
                                   "--range", "0:6", "--scale", "12", "--axes", "y", "--json"});
  CHECK_THAT(down.output, Catch::Contains(R"("stopped": true)"));
}

TEST_CASE("A hoof that misses its length for another reason than the ground is not told as stopped") {
  const CreatureOnDisk file(pawingHorse());
  const std::string output = (file.folder / "out.glb").string();
  const VerbAnswer answer = runVerb({"exaggerate", file.path, "-o", output, "--limb", "hind-left-leg",
                                     "--range", "0:6", "--scale", "0.3", "--no-pull", "--json"});
  REQUIRE(answer.exitCode == 0);
  CHECK_THAT(answer.output, Catch::Contains(R"("reached": false)"));
  CHECK_THAT(answer.output, !Catch::Contains("stopped"));
}

TEST_CASE("A recipe of a biped says which limbs a horse lacks, and a wrong plan which ones there are") {
  const CreatureOnDisk file(pawingHorse());
  file.folder.write("recipe.json", R"({"version": 1, "trails": [{"limb": "left-arm", "scale": 2},
    {"limb": "right-leg", "scale": 2}, {"limb": "spine", "scale": 2}]})");
  const std::string output = (file.folder / "out.glb").string();
  const VerbAnswer lacking =
      runVerb({"exaggerate", file.path, "-o", output, "--recipe", (file.folder / "recipe.json").string()});
  CHECK(lacking.exitCode == 1);
  CHECK_THAT(lacking.told, Catch::Contains("a quadruped and lacks left-arm, right-leg"));
  file.folder.write("poses.json", R"({"version": 1, "adjustments": [{"controller": "left-hand", "keys": []},
    {"controller": "nothing that any plan has", "keys": []}]})");
  const VerbAnswer poses =
      runVerb({"exaggerate", file.path, "-o", output, "--recipe", (file.folder / "poses.json").string()});
  CHECK_THAT(poses.told, Catch::Contains("a quadruped and lacks left-arm;"));
  const VerbAnswer centaur = runVerb({"info", file.path, "--plan", "centaur"});
  CHECK(centaur.exitCode != 0);
  CHECK_THAT(centaur.told, Catch::Contains("biped, quadruped, bird, insect, spider, serpent, other"));
}

TEST_CASE("A recipe of a biped tells all limbs that a horse lacks, wherever it names them") {
  const CreatureOnDisk file(pawingHorse());
  file.folder.write("recipe.json", R"({"version": 1, "trails": [{"limb": "spine", "scale": 2}],
    "grips": [{"leader": "right-arm", "follower": "left-arm", "range": [0, 10]}],
    "props": [{"node": "Bat", "bound_at": 0, "hands": {"right-leg": [{"frame": 0, "value": 1}]}}],
    "adjustments": [{"controller": "left-knee", "keys": [{"frame": 3, "move": [0, 0.1, 0]}]},
                    {"attribute": "head.none", "keys": [{"frame": 3, "value": 1}]}]})");
  const std::string output = (file.folder / "out.glb").string();
  const VerbAnswer lacking =
      runVerb({"pose", file.path, "-o", output, "--recipe", (file.folder / "recipe.json").string()});
  CHECK(lacking.exitCode == 1);
  CHECK_THAT(lacking.told, Catch::Contains("a quadruped and lacks left-arm, left-leg, right-arm, right-leg"));
}

TEST_CASE("A limb that a horse lacks is told from each list of a recipe") {
  const CreatureOnDisk file(pawingHorse());
  const auto [list, lacked] = GENERATE(table<std::string, std::string>({
      {R"("trails": [{"limb": "left-arm", "scale": 2}])", "left-arm"},
      {R"("trails": [], "elastic": [{"limb": "right-arm"}])", "right-arm"},
      {R"("pins": [{"limb": "left-leg", "range": [0, 10], "at": 0}])", "left-leg"},
      {R"("grips": [{"leader": "right-leg", "follower": "front-left-leg", "range": [0, 10]}])", "right-leg"},
      {R"("grips": [{"leader": "front-left-leg", "follower": "left-leg", "range": [0, 10]}])", "left-leg"},
      {R"("props": [{"node": "Bat", "hands": {"left-arm": [{"frame": 0, "value": 1}]}}])", "left-arm"},
      {R"("adjustments": [{"controller": "right-knee", "keys": [{"frame": 3}]}])", "right-leg"},
      {R"("adjustments": [{"attribute": "left-arm.stretch", "keys": [{"frame": 3, "value": 1}]}])",
       "left-arm"},
  }));
  CAPTURE(list);
  file.folder.write("recipe.json", R"({"version": 1, )" + list + "}");
  const VerbAnswer lacking = runVerb({"pose", file.path, "-o", (file.folder / "out.glb").string(), "--recipe",
                                      (file.folder / "recipe.json").string()});
  CHECK(lacking.exitCode == 1);
  CHECK_THAT(lacking.told, Catch::Contains("a quadruped and lacks " + lacked + "; name limbs"));
}

TEST_CASE("A grip that names no foot of a horse says which limbs can be held") {
  const CreatureOnDisk file(pawingHorse());
  file.folder.write("recipe.json", R"({"version": 1,
    "grips": [{"leader": "tail", "follower": "front-left-leg", "range": [0, 10]}]})");
  const std::string output = (file.folder / "out.glb").string();
  const VerbAnswer refused =
      runVerb({"pose", file.path, "-o", output, "--recipe", (file.folder / "recipe.json").string()});
  CHECK(refused.exitCode == 1);
  CHECK_THAT(refused.told, Catch::Contains("front-left-leg, front-right-leg, hind-left-leg, hind-right-leg"));
  CHECK_THAT(refused.told, !Catch::Contains("left-arm"));
}

TEST_CASE("A file keeps which end of a serpent leads, also where its joints were chosen by hand") {
  const CreatureOnDisk file(strikingSnake());
  const Document snake = openedFile(file.path);
  CHECK(snake.body.plan == "serpent");
  rig::Limb spine = limbNamed(snake, "spine");
  REQUIRE(spine.ledByFirst);
  spine.ledByFirst = false;
  const Result<Document> corrected = correctLimb(snake, spine);
  REQUIRE(corrected);
  CHECK(limbNamed(*corrected, "spine").ledByFirst);
  Document again = snake;
  again.body.limbs.clear();
  REQUIRE(restoreWork(workOf(*corrected), again));
  CHECK(limbNamed(again, "spine").ledByFirst);
  CHECK_THAT(runVerb({"info", file.path, "--json"}).output, Catch::Contains(R"("led_by": "behindHead")"));
}
