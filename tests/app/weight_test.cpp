#include "app/weight/weight_motion.h"
#include "rig/limb.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include <unistd.h>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/batch/verb.h"
#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "app/history.h"
#include "app/recipe/recipe.h"
#include "app/recipe/replay.h"
#include "app/schema/weight_schema.h"
#include "core/gltf/json/json.h"
#include "core/math/rotation.h"
#include "skinning/linear_blend_skinning.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/nodes.h"
#include "tests/support/refusal.h"

namespace fs = std::filesystem;
using namespace stretch;
using namespace stretch::app;

namespace {

const char* const dummyFile = STRETCH_SOURCE_DIR "/assets/dummy.glb";
const std::vector<std::string> armsAndLegs{"left-arm", "right-arm", "left-leg", "right-leg"};

class Folder {
public:
  Folder() : path_(fs::temp_directory_path() / ("stretch-elastic-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }
  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

private:
  fs::path path_;
};

Document loadedDocument(const std::string& path) {
  Result<Document> document = openDocument(path);
  REQUIRE(document.ok());
  return std::move(document).value();
}

Document heavy(const WeightSettings& settings = {}, const std::vector<std::string>& limbs = armsAndLegs) {
  Document document = loadedDocument(dummyFile);
  for (const std::string& limb : limbs) {
    Result<Document> changed = setWeight(document, {limb, 0, true, settings});
    REQUIRE(changed.ok());
    document = *changed;
  }
  return document;
}

/// Largest distance of any vertex at every frame and half frame of the second one, in heights of the
/// character. (A written clip may be keyed on half frames, and its rate is guessed from its keys.)
double worstSkinDifference(const Document& a, const Document& b) {
  const rig::MotionState motionA = prepareMotion(a, 0);
  const rig::MotionState motionB = prepareMotion(b, 0);
  const Clip& clip = clipOf(b, 0);
  double worst = 0.0;
  for (double frame = 0.0; frame <= clip.endSeconds * clip.framesPerSecond + 1e-6; frame += 0.5) {
    const double seconds = frame / clip.framesPerSecond;
    const std::vector<Vec3> left = skinning::skinnedPositions(*a.scene, evaluate(a, motionA, seconds));
    const std::vector<Vec3> right = skinning::skinnedPositions(*b.scene, evaluate(b, motionB, seconds));
    REQUIRE(left.size() == right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      worst = std::max(worst, glm::length(left[i] - right[i]));
    }
  }
  return worst / a.body.height;
}

double lengthAlong(const rig::Limb& limb, const FrameState& frame) {
  const std::vector<Vec3> points = rig::limbPoints(limb, frame);
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += glm::length(points[i] - points[i - 1]);
  }
  return length;
}

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace

TEST_CASE("a file saved with weight plays as the editor shows it, and opens as it was left") {
  const Folder folder;
  Document document = heavy();
  NewTrail punch{"left-arm", 0, {}, true, true};
  punch.settings.startFrame = 21.0;
  punch.settings.endFrame = 27.0;
  punch.settings.scale = 2.0;
  const Result<CreatedTrail> created = createTrail(document, punch);
  REQUIRE(created.ok());
  document = *applyTrail(created->document, created->trailId);
  REQUIRE(saveDocument(document, folder.file("clean.glb"), {.clean = true}));
  CHECK(worstSkinDifference(loadedDocument(folder.file("clean.glb")), document) < 1e-4);
  REQUIRE(saveDocument(document, folder.file("work.glb"), {}));
  const Document again = loadedDocument(folder.file("work.glb"));
  CHECK(again.weights == document.weights);
  CHECK(worstSkinDifference(again, document) < 1e-6);
}

TEST_CASE("weight that is taken away again gives the source back, after saving and opening too") {
  const Folder folder;
  REQUIRE(saveDocument(heavy(), folder.file("heavy.glb"), {}));
  Document again = loadedDocument(folder.file("heavy.glb"));
  for (const std::string& limb : armsAndLegs) {
    again = removeWeight(again, limb, 0);
  }
  CHECK(worstSkinDifference(again, loadedDocument(dummyFile)) < 1e-9);
  REQUIRE(saveDocument(again, folder.file("light.glb"), {.clean = true}));
  CHECK(worstSkinDifference(loadedDocument(folder.file("light.glb")), loadedDocument(dummyFile)) < 1e-6);
}

TEST_CASE("with amount zero, or off, nothing moves at all") {
  WeightSettings none;
  none.amount = 0.0;
  CHECK(worstSkinDifference(heavy(none), loadedDocument(dummyFile)) == 0.0);
  const Result<Document> off = switchWeight(heavy(), armsAndLegs, 0, false);
  REQUIRE(off.ok());
  CHECK(worstSkinDifference(*off, loadedDocument(dummyFile)) == 0.0);
}

TEST_CASE("a standing pose sags by a percent or two, its feet stay on the ground") {
  const Document document = heavy();
  const FrameState source = evaluateOriginal(document, 0, 0.0);
  const FrameState soft = evaluate(document, prepareMotion(document, 0), 0.0);
  const double height = document.body.height;
  for (const char* const id : {"left-leg", "right-leg"}) {
    const rig::Limb& leg = *findLimb(document, id);
    CHECK(glm::length(rig::endPosition(leg, soft) - rig::endPosition(leg, source)) < 1e-3 * height);
  }
  const auto hips = at(document.body.hips);
  const double drop = source.worlds[hips][3].y - soft.worlds[hips][3].y;
  CHECK(drop > 0.001 * height);
  CHECK(drop < 0.02 * height);
}

TEST_CASE("a punch stretches the arm visibly, and stiffness holds it back") {
  const auto longest = [](double stiffness) {
    WeightSettings settings;
    settings.stiffness = stiffness;
    return weightReports(heavy(settings, {"right-arm"}), 0).front().longest;
  };
  CHECK(longest(1.0) > 1.05);
  CHECK(longest(1.0) < 1.6);
  CHECK(longest(20.0) < 1.0 + 0.25 * (longest(1.0) - 1.0));
}

TEST_CASE("the unit of the file does not matter") {
  const Document metres = heavy();
  Document hundredths = metres;
  Scene scene = *metres.scene;
  Node larger;
  larger.rest.scale = Vec3(100.0);
  larger.children = scene.roots;
  for (const NodeIndex root : scene.roots) {
    scene.nodes[at(root)].parent = NodeIndex(scene.nodes.size());
  }
  scene.roots = {NodeIndex(scene.nodes.size())};
  scene.nodes.push_back(larger);
  hundredths.scene = std::make_shared<const Scene>(scene);
  hundredths.body = rig::detectBody(scene, &metres.clips->front());
  REQUIRE(hundredths.body.height == Approx(100.0 * metres.body.height));
  const std::vector<WeightReport> one = weightReports(metres, 0);
  const std::vector<WeightReport> other = weightReports(hundredths, 0);
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(other[i].youngModulus == Approx(one[i].youngModulus));
    CHECK(other[i].longest == Approx(one[i].longest));
    CHECK(other[i].shortest == Approx(one[i].shortest));
  }
}

TEST_CASE("a range changes nothing outside and begins and ends without a jump") {
  WeightSettings settings;
  settings.rangeFrames = Vec2(15.0, 35.0);
  const Document document = heavy(settings);
  const rig::MotionState motion = prepareMotion(document, 0);
  const double fps = clipOf(document, 0).framesPerSecond;
  for (const double frame : {0.0, 14.5, 15.0, 35.0, 40.0}) {
    CHECK(evaluate(document, motion, frame / fps).worlds ==
          evaluateOriginal(document, 0, frame / fps).worlds);
  }
  CHECK_FALSE(evaluate(document, motion, 25.0 / fps).stretch.empty());
}

TEST_CASE("a leg without weight knows where its foot stands while the other one gives way") {
  for (const auto& [limb, other] : {std::pair("left-leg", "right-leg"), std::pair("right-leg", "left-leg")}) {
    CAPTURE(limb);
    const Document document = heavy({}, {limb});
    const rig::MotionState motion = prepareMotion(document, 0);
    REQUIRE(motion.weights.size() == 2);
    const auto stiff = std::ranges::find(motion.weights, other, [](const auto& one) { return one.limb.id; });
    REQUIRE(stiff != motion.weights.end());
    double mostKept = 0.0;
    REQUIRE(stiff->weight.samples.size() > 10);
    for (const rig::WeightSample& sample : stiff->weight.samples) {
      CHECK(sample.strains == std::vector<Mat3>(2, Mat3(0.0)));
      mostKept = std::max(mostKept, sample.kept);
    }
    CHECK(mostKept == Approx(1.0));
  }
  CHECK(prepareMotion(heavy({}, {"left-arm"}), 0).weights.size() == 1);
}

TEST_CASE("what stands, stands against the gravity that is given") {
  const Document upright = heavy({}, {"left-leg"});
  const Quat turn = axisAngle(Vec3(0.0, 0.0, 1.0), 0.5 * pi);
  WeightSettings sideways;
  sideways.gravity = turn * sideways.gravity;
  Document lying = heavy(sideways, {"left-leg"});
  Scene scene = *lying.scene;
  const std::vector<NodeIndex> roots = std::exchange(scene.roots, {});
  const NodeIndex top = test::addNode(scene, "turned", NodeIndex::none, Vec3(0.0));
  scene.nodes[at(top)].rest.rotation = turn;
  scene.nodes[at(top)].children = roots;
  for (const NodeIndex root : roots) {
    scene.nodes[at(root)].parent = top;
  }
  lying.scene = std::make_shared<const Scene>(std::move(scene));
  const rig::MotionState wanted = prepareMotion(upright, 0);
  const rig::MotionState motion = prepareMotion(lying, 0);
  REQUIRE(motion.weights.size() == 2);
  for (std::size_t leg = 0; leg < 2; ++leg) {
    const std::vector<rig::WeightSample>& samples = motion.weights[leg].weight.samples;
    REQUIRE(samples.size() == wanted.weights[leg].weight.samples.size());
    for (std::size_t k = 0; k < samples.size(); ++k) {
      CHECK(samples[k].kept == Approx(wanted.weights[leg].weight.samples[k].kept).margin(1e-4));
      CHECK(samples[k].planted == Approx(wanted.weights[leg].weight.samples[k].planted).margin(1e-4));
    }
  }
  Result<Document> both = setWeight(lying, {"right-leg", 0, true, {}});
  REQUIRE(both);
  const std::vector<WeightReport> reports = weightReports(*both, 0);
  REQUIRE(reports.size() == 2);
  CHECK(reports[0].warnings.empty());
  CHECK(std::ranges::any_of(reports[1].warnings, [](const std::string& line) {
    return line.starts_with("right-leg: its gravity is not along");
  }));
}

TEST_CASE("a model that is too soft says at which frame it no longer holds") {
  WeightSettings jelly;
  jelly.youngModulus = 1000.0;
  const std::vector<WeightReport> reports = weightReports(heavy(jelly, {"left-arm"}), 0);
  REQUIRE(reports.size() == 1);
  REQUIRE_FALSE(reports.front().warnings.empty());
  CHECK_THAT(reports.front().warnings.front(), Catch::Contains("frame"));
}

TEST_CASE("the report tells the lengths that the saved file shows, feet in their places") {
  const Folder folder;
  const Document document = heavy();
  REQUIRE(saveDocument(document, folder.file("clean.glb"), {.clean = true}));
  const Document saved = loadedDocument(folder.file("clean.glb"));
  const Clip& clip = clipOf(document, 0);
  for (const WeightReport& report : weightReports(document, 0)) {
    const rig::Limb& limb = *findLimb(document, report.limb);
    double shortest = 10.0;
    double longest = 0.0;
    for (double frame = 0.0; frame <= clip.endSeconds * clip.framesPerSecond + 1e-6; frame += 1.0) {
      const double seconds = frame / clip.framesPerSecond;
      const double ratio = lengthAlong(limb, evaluateOriginal(saved, 0, seconds)) /
                           lengthAlong(limb, evaluateOriginal(document, 0, seconds));
      shortest = std::min(shortest, ratio);
      longest = std::max(longest, ratio);
    }
    CAPTURE(report.limb);
    CHECK(report.shortest == Approx(shortest).margin(1e-3));
    CHECK(report.longest == Approx(longest).margin(1e-3));
  }
}

TEST_CASE("a bone that changes its length by more than the model is made for is told with its frame") {
  WeightSettings soft;
  soft.stiffness = 0.2;
  const std::vector<WeightReport> reports = weightReports(heavy(soft, {"right-arm"}), 0);
  REQUIRE(reports.front().longest > 1.2);
  REQUIRE(reports.front().longest < 2.0);
  const std::vector<std::string>& warnings = reports.front().warnings;
  CHECK(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("times its length at frame") != std::string::npos;
  }));
}

TEST_CASE("recipes hold weight and give it to another document") {
  WeightSettings settings;
  settings.stiffness = 0.5;
  settings.youngModulus = 2e5;
  settings.gravity = Vec3(0.0, -1.62, 0.0);
  settings.moduli = {{0, 0, 3e5}};
  settings.rangeFrames = Vec2(3.0, 30.0);
  const Document document = heavy(settings, {"right-arm"});
  Document plain = loadedDocument(dummyFile);
  const Result<Recipe> recipe = recipeFromJson(recipeToJson(document, 0), plain);
  REQUIRE(recipe.ok());
  const Result<PlacedTrails> taken = withRecipe(plain, *recipe);
  REQUIRE(taken.ok());
  CHECK(taken->document.weights == document.weights);
  gltf::Json wrong = recipeToJson(document, 0);
  wrong["elastic"][0]["stifness"] = 2.0;
  const Result<Recipe> refused = recipeFromJson(wrong, plain);
  REQUIRE_FALSE(refused.ok());
  CHECK_THAT(refused.error().line(), Catch::Contains("stifness"));
}

TEST_CASE("edits of weight are undone, and wrong ones refused with a line") {
  History<Document> history(loadedDocument(dummyFile));
  const Document start = history.current();
  history.push(*switchWeight(start, {"left-arm"}, 0, true), "Weight");
  CHECK(history.current().weights.size() == 1);
  history.undo();
  CHECK(sameDocument(history.current(), start));
  history.redo();
  CHECK(history.current().weights.front().on);
  CHECK_THAT(test::refusal(setWeight(start, {"tail", 0, true, {}})),
             Catch::StartsWith("tail: the character has no such limb"));
  CHECK_THAT(test::refusal(setWeight(start, {"left-arm", 7, true, {}})),
             Catch::StartsWith("clip 7: the file has no such clip"));
  WeightSettings wrong;
  wrong.amount = 1.5;
  CHECK_THAT(test::refusal(setWeight(start, {"left-arm", 0, true, wrong})), Catch::Contains("amount"));
  wrong = {};
  wrong.rangeFrames = Vec2(9.0, 9.0);
  CHECK_THAT(test::refusal(setWeight(start, {"left-arm", 0, true, wrong})),
             Catch::StartsWith("range: the range has no length"));
}

TEST_CASE("the verb elastic writes a file that check accepts, the same bytes each time") {
  const Folder folder;
  const std::string first = folder.file("a.glb");
  const std::string second = folder.file("b.glb");
  REQUIRE(test::exitCodeOf({"elastic", dummyFile, "-o", first, "--stiffness", "0.7", "--json"}) == 0);
  REQUIRE(test::exitCodeOf({"elastic", dummyFile, "-o", second, "--stiffness", "0.7"}) == 0);
  CHECK(bytesOf(first) == bytesOf(second));
  CHECK(test::exitCodeOf({"check", first}) == 0);
  CHECK(loadedDocument(first).weights.size() == 4);
  CHECK(loadedDocument(first).weights.front().settings.stiffness == 0.7);
  const std::string translated = folder.file("c.glb");
  REQUIRE(test::exitCodeOf({"elastic", dummyFile, "-o", translated, "--limb", "left-arm", "--range", "20:30",
                            "--keep-skeleton", "--clean"}) == 0);
  CHECK(loadedDocument(translated).scene->nodes.size() == loadedDocument(dummyFile).scene->nodes.size());
}

TEST_CASE("wrong arguments of the verb elastic are told before anything is written") {
  const Folder folder;
  const std::string out = folder.file("out.glb");
  CHECK(test::exitCodeOf({"elastic", dummyFile, "-o", out, "--amount", "2"}) == 2);
  CHECK(test::exitCodeOf({"elastic", dummyFile, "-o", out, "--gravity", "down"}) == 2);
  CHECK(test::exitCodeOf({"elastic", dummyFile, "-o", out, "--range", "9:9"}) == 2);
  CHECK(test::exitCodeOf({"elastic", dummyFile, "-o", out, "--limb", "tail"}) == 1);
  CHECK(test::exitCodeOf({"elastic", dummyFile, "-o", out, "--moduli", out}) == 1);
  CHECK_FALSE(fs::exists(out));
}
