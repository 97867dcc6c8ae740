// The recipes of the thesis's three evaluations (docs/recipes) on the bundled clips.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/batch/trail_report.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "app/recipe/recipe.h"
#include "app/recipe/replay.h"
#include "core/gltf/json/json.h"
#include "core/math/bounds.h"
#include "skinning/linear_blend_skinning.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double batLength = 0.88;
constexpr double rightLetsGo = 44.0; ///< Frame of the swing.
constexpr int clip = 0;

Document bundled(const std::string& file) {
  Result<Document> opened = openDocument(std::string(STRETCH_SOURCE_DIR "/assets/") + file);
  REQUIRE(opened);
  return std::move(opened).value();
}

Document played(Document document, const std::string& recipe) {
  const Result<Recipe> read =
      loadRecipe(std::string(STRETCH_SOURCE_DIR "/docs/recipes/") + recipe + ".json", document);
  REQUIRE(read);
  Result<PlacedTrails> placed = withRecipe(document, *read);
  REQUIRE(placed);
  return std::move(placed->document);
}

/// A document's clip as it is seen, frame by frame.
class Seen {
public:
  explicit Seen(const Document& document) : document_(document), motion_(prepareMotion(document, clip)) {}

  [[nodiscard]] FrameState at(double frame) const {
    return evaluate(document_, motion_, frame / clipOf(document_, clip).framesPerSecond);
  }
  [[nodiscard]] const Scene& scene() const { return *document_.scene; }

private:
  const Document& document_;
  rig::MotionState motion_;
};

std::size_t nodeNamed(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.nodes, name, &Node::name);
  REQUIRE(found != scene.nodes.end());
  return static_cast<std::size_t>(found - scene.nodes.begin());
}

Vec3 placeOf(const Scene& scene, const FrameState& frame, const std::string& node) {
  return positionOf(frame.worlds[nodeNamed(scene, node)]);
}

/// Where a hand is, seen from the bat.
Vec3 onBat(const Scene& scene, const FrameState& frame, const std::string& hand) {
  const Mat4 bat = frame.worlds[nodeNamed(scene, "Bat")];
  return transformPoint(glm::inverse(bat), placeOf(scene, frame, hand));
}

struct Block {
  Bounds box;

  /// How deep a point lies in it, by the nearest of its top, front and back.
  [[nodiscard]] double depth(const Vec3& p) const {
    const bool isInside = glm::all(glm::greaterThan(p, box.low)) && glm::all(glm::lessThan(p, box.high));
    return isInside ? std::min({box.high.y - p.y, p.z - box.low.z, box.high.z - p.z}) : 0.0;
  }
};

/// How deep any vertex of the body lies in the floor or in a block.
double depthIn(const std::vector<Block>& blocks, const Scene& scene, const FrameState& frame) {
  double deepest = 0.0;
  const std::vector<Vec3> vertices = skinning::skinnedPositions(scene, frame);
  const std::size_t ofBody = scene.meshes[0].primitives[0].positions.size();
  for (std::size_t i = 0; i < ofBody; ++i) {
    deepest = std::max(deepest, -vertices[i].y);
    for (const Block& block : blocks) {
      deepest = std::max(deepest, block.depth(vertices[i]));
    }
  }
  return deepest;
}

Bounds boxBetween(const Vec3& low, const Vec3& high) {
  Bounds box;
  box.add(low);
  box.add(high);
  return box;
}

/// As assets/dummy/leap.cpp builds them.
std::vector<Block> leapBlocks() {
  return {{boxBetween({-0.6, 0.0, 1.8}, {0.6, 0.42, 2.1})},
          {boxBetween({-0.6, 0.0, 3.2}, {0.6, 0.85, 3.75})},
          {boxBetween({-0.8, 0.0, 4.6}, {0.8, 0.30, 6.4})}};
}

/// By how much a node stands elsewhere than in the source.
double strayOf(const Seen& before, const Seen& after, const std::string& node, double frame) {
  return glm::length(placeOf(after.scene(), after.at(frame), node) -
                     placeOf(before.scene(), before.at(frame), node));
}

/// `look(before, after)` for both versions of an evaluation played on its clip.
template <typename Look>
void inBothVersions(const Document& source, const std::string& evaluation, const Look& look) {
  const Seen before(source);
  for (const char* const version : {"simple-", "refined-"}) {
    const std::string recipe = version + evaluation;
    CAPTURE(recipe);
    const Document document = played(source, recipe);
    look(before, Seen(document));
  }
}

} // namespace

TEST_CASE("The recipes of punch and swing apply without a word of warning") {
  for (const auto& [file, recipe] :
       {std::pair("dummy.glb", "simple-punch"), std::pair("dummy.glb", "refined-punch"),
        std::pair("dummy_swing.glb", "simple-swing"), std::pair("dummy_swing.glb", "refined-swing")}) {
    CAPTURE(recipe);
    const Document document = played(bundled(file), recipe);
    CHECK_FALSE(document.trails.empty());
    const gltf::Json warnings = documentWarnings(document);
    CHECK(warnings.dump() == "[]");
  }
}

TEST_CASE("In the exaggerated swing both hands stay on the bat, and the left one after the hit") {
  const Document source = bundled("dummy_swing.glb");
  inBothVersions(source, "swing", [&](const Seen& before, const Seen& after) {
    for (double frame = 0.0; frame <= 88.0; frame += 0.5) {
      CAPTURE(frame);
      for (const char* hand : {"LeftHand", "RightHand"}) {
        const bool holds = hand == std::string("LeftHand") || frame <= rightLetsGo;
        const Vec3 was = onBat(before.scene(), before.at(frame), hand);
        const double off = glm::length(onBat(after.scene(), after.at(frame), hand) - was);
        CHECK((!holds || off < 0.01 * batLength));
      }
    }
  });
}

TEST_CASE("The refined swing leaves the wind-up alone and is longest around the hit") {
  const Document source = bundled("dummy_swing.glb");
  const Document document = played(source, "refined-swing");
  const Seen before(source);
  const Seen after(document);
  const auto moved = [&](double frame) { return strayOf(before, after, "RightHand", frame); };
  CHECK(moved(33.0) < 0.01);
  CHECK(moved(36.0) < 0.05);
  CHECK(moved(42.0) > 0.25);
  CHECK(moved(60.0) < 0.01);
}

TEST_CASE("Feet that stand do not slide in the exaggerated swing") {
  const Document source = bundled("dummy_swing.glb");
  inBothVersions(source, "swing", [&](const Seen& before, const Seen& after) {
    for (double frame = 0.0; frame <= 88.0; frame += 0.5) {
      CAPTURE(frame);
      for (const char* foot : {"LeftFoot", "RightFoot", "LeftToeBase", "RightToeBase"}) {
        CHECK(strayOf(before, after, foot, frame) < 0.005 * source.body.height);
      }
    }
  });
}

TEST_CASE("The exaggerated leap goes neither into the floor nor into a block, beyond what the source does") {
  const Document source = bundled("dummy_leap.glb");
  inBothVersions(source, "leap", [&](const Seen& before, const Seen& after) {
    for (double frame = 28.0; frame <= 80.0; frame += 0.5) {
      CAPTURE(frame);
      const double was = depthIn(leapBlocks(), before.scene(), before.at(frame));
      const double is = depthIn(leapBlocks(), after.scene(), after.at(frame));
      CHECK(is < was + 0.005 * source.body.height);
    }
  });
}

TEST_CASE("The leap's hands stand on the ledge and its feet on the platform as in the source") {
  const Document source = bundled("dummy_leap.glb");
  inBothVersions(source, "leap", [&](const Seen& before, const Seen& after) {
    const auto strays = [&](const std::string& joint, double frame) {
      return strayOf(before, after, joint, frame);
    };
    for (double frame = 46.0; frame <= 50.0; frame += 0.5) {
      CAPTURE(frame);
      CHECK(strays("LeftHand", frame) < 0.005 * source.body.height);
      CHECK(strays("RightHand", frame) < 0.005 * source.body.height);
    }
    for (double frame = 64.0; frame <= 76.0; frame += 0.5) {
      CAPTURE(frame);
      CHECK(strays("LeftFoot", frame) < 0.005 * source.body.height);
      CHECK(strays("RightFoot", frame) < 0.005 * source.body.height);
    }
  });
}

TEST_CASE("The leap stretches arms and legs in the air, and the landing the trunk as well") {
  const Document source = bundled("dummy_leap.glb");
  const Seen before(source);
  for (const auto& [recipe, scale] : {std::pair("simple-leap", 1.9), std::pair("refined-leap", 1.4)}) {
    CAPTURE(recipe);
    const Document document = played(source, recipe);
    const Seen after(document);
    const auto longest = [&](const std::string& limb, double first, double last) {
      double most = 0.0;
      for (double frame = first; frame <= last; frame += 1.0) {
        const rig::Limb& one = *findLimb(source, limb);
        most = std::max(most, rig::limbLength(one, after.at(frame)) / rig::limbLength(one, before.at(frame)));
      }
      return most;
    };
    CHECK(longest("left-arm", 36.0, 42.0) > scale);
    CHECK(longest("left-leg", 36.0, 46.0) > scale);
    CHECK(longest("left-leg", 54.0, 62.0) > 1.25);
    CHECK(longest("right-arm", 54.0, 62.0) > scale);
    CHECK(longest("spine", 54.0, 62.0) > scale);
    CHECK(longest("neck", 54.0, 62.0) > scale);
  }
}

namespace {

constexpr std::array feet{"LeftFoot", "RightFoot"};

/// The farthest that a foot's way bends from one frame to the next.
double roughest(const Seen& seen, const std::string& foot, double first, double last) {
  double most = 0.0;
  for (double frame = first + 1.0; frame < last; frame += 1.0) {
    const auto at = [&](double other) { return placeOf(seen.scene(), seen.at(other), foot); };
    most = std::max(most, glm::length(at(frame - 1.0) - 2.0 * at(frame) + at(frame + 1.0)));
  }
  return most;
}

} // namespace

TEST_CASE("In the exaggerated leap the legs stay behind, no farther than where they leave the ground") {
  constexpr double leaves = 35.0;
  const Document source = bundled("dummy_leap.glb");
  inBothVersions(source, "leap", [&](const Seen& before, const Seen& after) {
    for (const char* const foot : feet) {
      CAPTURE(foot);
      const double back = placeOf(before.scene(), before.at(leaves), foot).z;
      double farthest = 0.0;
      for (double frame = leaves; frame <= 50.0; frame += 1.0) {
        CAPTURE(frame);
        const Vec3 place = placeOf(after.scene(), after.at(frame), foot);
        const Vec3 moved = place - placeOf(before.scene(), before.at(frame), foot);
        CHECK(place.z > back - 0.11);
        CHECK(std::abs(moved.y) < 0.02 - moved.z); // Back, and at most as much down.
        CHECK(moved.z < 0.001);
        farthest = std::max(farthest, -moved.z);
      }
      CHECK(farthest > 0.25);
    }
  });
}

TEST_CASE("The leap is longer at twice the length than at one and a half") {
  const Document source = bundled("dummy_leap.glb");
  const Document twice = played(source, "simple-leap");
  const Document less = played(source, "refined-leap");
  for (const double frame : {42.0, 44.0, 46.0}) {
    CAPTURE(frame);
    CHECK(placeOf(*source.scene, Seen(twice).at(frame), "LeftFoot").z <
          placeOf(*source.scene, Seen(less).at(frame), "LeftFoot").z - 0.05);
  }
}

TEST_CASE("Feet touch the platform no earlier than in the clip, and come down as smoothly") {
  constexpr double touches = 63.0;
  const Document source = bundled("dummy_leap.glb");
  inBothVersions(source, "leap", [&](const Seen& before, const Seen& after) {
    for (const char* const foot : feet) {
      CAPTURE(foot);
      const auto heightIn = [&](const Seen& seen, double frame) {
        return placeOf(seen.scene(), seen.at(frame), foot).y -
               placeOf(before.scene(), before.at(touches), foot).y;
      };
      for (double frame = 54.0; frame < touches - 1.0; frame += 0.5) {
        CAPTURE(frame);
        CHECK(heightIn(after, frame) > 0.2 * heightIn(before, frame));
        CHECK(heightIn(after, frame) > heightIn(after, frame + 0.5)); // On its way down all the time.
      }
      CHECK(roughest(after, foot, 51.0, 72.0) < 1.5 * roughest(before, foot, 51.0, 72.0));
    }
  });
}
