#include <random>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;
using test::endOf;
using test::openedFile;
using test::Posed;

namespace {

// What a player sees that shows more pictures than the clip has frames: 60 or 144 of them a second, or at any
// time at all.

constexpr double heldAtAnyTime = 1e-3; // of the height, at any time

std::vector<double> anyFrames(double first, double last, double framesPerSecond) {
  std::vector<double> frames;
  for (const double pictures : {60.0, 144.0}) {
    for (double frame = first; frame < last; frame += framesPerSecond / pictures) {
      frames.push_back(frame);
    }
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> within(first, last);
  for (int i = 0; i < 400; ++i) {
    frames.push_back(within(random));
  }
  return frames;
}

std::string bundled(const char* name) {
  return std::string(STRETCH_SOURCE_DIR "/assets/") + name;
}

Json movedHips(double first, double last, double down) {
  return Json::array({{{"controller", "hips"},
                       {"keys",
                        {{{"frame", first}, {"move", {0, 0, 0}}},
                         {{"frame", 0.5 * (first + last)}, {"move", {0.05, -down, 0.03}}},
                         {{"frame", last}, {"move", {0, 0, 0}}}}}}});
}

// The frame at which an end is farthest from a place, with how far that is.
std::pair<double, double> worstFrom(const app::Document& file, const char* limb, const Vec3& place,
                                    const std::vector<double>& frames) {
  std::pair<double, double> worst{0.0, 0.0};
  for (const double frame : frames) {
    worst = std::max(worst, std::pair(glm::length(endOf(file, limb, frame) - place), frame));
  }
  return worst;
}

} // namespace

TEST_CASE("pinned feet and hands stay at any time, and not at frames and halves alone") {
  struct Case {
    const char* file;
    double first;
    double last;
  };
  for (const Case& c :
       {Case{"dummy.glb", 8, 40}, Case{"dummy_leap.glb", 8, 30}, Case{"dummy_swing.glb", 8, 30}}) {
    for (const double down : {0.0, 0.1, -0.05}) {
      const test::TemporaryFolder folder;
      Json recipe{{"version", 1}, {"units", "metres"}, {"pins", Json::array()}};
      for (const char* limb : {"left-leg", "right-leg", "right-arm"}) {
        recipe["pins"].push_back({{"limb", limb}, {"range", {c.first, c.last}}, {"at", c.first}});
      }
      recipe["adjustments"] = movedHips(c.first, c.last, down);
      const Posed posed = test::pose(folder, recipe, {"--clean"}, bundled(c.file));
      INFO(c.file << ", hips lower by " << down << ": " << posed.answer.told);
      REQUIRE(posed.answer.exitCode == 0);
      const app::Document source = openedFile(bundled(c.file));
      const app::Document file = openedFile(posed.path);
      for (const char* limb : {"left-leg", "right-leg", "right-arm"}) {
        const auto [miss, frame] =
            worstFrom(file, limb, endOf(file, limb, c.first), anyFrames(c.first, c.last, 24.0));
        INFO(limb << " at frame " << frame);
        CHECK(miss < heldAtAnyTime * source.body.height);
      }
    }
  }
}

TEST_CASE("a hand that holds the other stays in it at any time") {
  const test::TemporaryFolder folder;
  const Json recipe{
      {"version", 1},
      {"units", "metres"},
      {"grips",
       Json::array(
           {{{"leader", "right-arm"}, {"follower", "left-arm"}, {"range", {10, 50}}, {"relation", 10}}})}};
  const Posed posed = test::pose(folder, recipe, {"--clean"});
  REQUIRE(posed.answer.exitCode == 0);
  const app::Document file = openedFile(posed.path);
  const auto seenFromHand = [&](double frame) {
    const Mat4 hand = test::worldOf(file, app::findLimb(file, "right-arm")->endNode, frame);
    return Vec3(glm::inverse(hand) * Vec4(endOf(file, "left-arm", frame), 1.0));
  };
  const Vec3 held = seenFromHand(10.0);
  for (const double frame : anyFrames(10.0, 50.0, 24.0)) {
    INFO("frame " << frame);
    CHECK(glm::length(seenFromHand(frame) - held) < heldAtAnyTime * file.body.height);
  }
}

TEST_CASE("feet stay planted at any time while the hips move over them") {
  const test::TemporaryFolder folder;
  const std::string leap = bundled("dummy_leap.glb");
  const Json recipe{{"version", 1}, {"units", "metres"}, {"adjustments", movedHips(4, 30, 0.12)}};
  const Posed posed = test::pose(folder, recipe, {"--clean"}, leap);
  REQUIRE(posed.answer.exitCode == 0);
  const app::Document source = openedFile(leap);
  const app::Document file = openedFile(posed.path);
  for (const double frame : anyFrames(4.0, 30.0, 24.0)) {
    for (const char* leg : {"left-leg", "right-leg"}) {
      CHECK(glm::length(endOf(file, leg, frame) - endOf(source, leg, frame)) <
            heldAtAnyTime * source.body.height);
    }
  }
}

TEST_CASE("a step of a controller is taken at its frame, and the frame before it is as it was") {
  const test::TemporaryFolder folder;
  Json keys = Json::array();
  for (const int frame : {0, 8, 16, 20, 31, 40, 47}) {
    keys.push_back(
        {{"frame", frame}, {"move", {0.0, 0.01 * (frame % 3), 0.0}}, {"interpolation", "stepped"}});
  }
  const Json recipe{{"version", 1},
                    {"units", "metres"},
                    {"adjustments", Json::array({{{"controller", "body"}, {"keys", keys}}})}};
  const Posed posed = test::pose(folder, recipe, {"--clean"});
  REQUIRE(posed.answer.exitCode == 0);
  const app::Document source = openedFile(test::posedCharacter);
  const app::Document file = openedFile(posed.path);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double first = keys[i]["frame"].get<double>();
    const double last = i + 1 < keys.size() ? keys[i + 1]["frame"].get<double>() : 60.0;
    for (const double frame : {first, first + 0.01, last - 0.01}) {
      const double up = endOf(file, "left-arm", frame).y - endOf(source, "left-arm", frame).y;
      INFO("frame " << frame);
      CHECK(up == Approx(keys[i]["move"][1].get<double>()).margin(1e-5));
    }
  }
}

TEST_CASE(
    "after a full turn within its range a joint goes on as in the source, without a key of the other sign") {
  for (const char* name : {"dummy.glb", "dummy_leap.glb"}) {
    const test::TemporaryFolder folder;
    Json keys = Json::array();
    for (int i = 0; i <= 4; ++i) {
      keys.push_back({{"frame", 6 + 2 * i}, {"turn", {0.0, 90.0 * i, 0.0}}});
    }
    const Json recipe{
        {"version", 1},
        {"units", "metres"},
        {"adjustments", Json::array({{{"controller", "body"}, {"range", {6, 14.25}}, {"keys", keys}}})}};
    const Posed posed = test::pose(folder, recipe, {"--clean"}, bundled(name));
    REQUIRE(posed.answer.exitCode == 0);
    const app::Document source = openedFile(bundled(name));
    const app::Document file = openedFile(posed.path);
    const NodeIndex body = file.body.hips;
    int changed = 0;
    for (const CopyOnWrite<Track>& track : (*file.clips)[0].tracks) {
      if (track->channel != Channel::rotation) {
        continue;
      }
      const bool isCubic = track->interpolation == Interpolation::cubicSpline;
      const std::size_t perKey = isCubic ? 12 : 4;
      for (std::size_t i = 1; i < track->times.size(); ++i) {
        double dot = 0.0;
        for (std::size_t c = 0; c < 4; ++c) {
          const std::size_t value = i * perKey + (isCubic ? 4 : 0) + c;
          dot +=
              static_cast<double>(track->values[value]) * static_cast<double>(track->values[value - perKey]);
        }
        INFO(name << ", node " << at(track->node) << " after " << track->times[i - 1] << " s");
        CHECK(dot >= -1e-6);
        ++changed;
      }
    }
    CHECK(changed > 100);
    for (double frame = 14.5; frame < 30.0; frame += 0.25) {
      const double apart = glm::length(test::nodeOf(file, body, frame) - test::nodeOf(source, body, frame)) +
                           glm::length(endOf(file, "left-arm", frame) - endOf(source, "left-arm", frame));
      INFO(name << " at frame " << frame);
      CHECK(apart < 1e-4 * source.body.height);
    }
  }
}
