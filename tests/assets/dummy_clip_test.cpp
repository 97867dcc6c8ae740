#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "tests/support/assets/dummy_fixture.h"

using namespace stretch;
using namespace stretch::assets;

namespace {

constexpr double framesPerSecond = 24.0;
constexpr int lastFrame = 60;

struct Played {
  gltf::Loaded loaded = loadedDummy();
  const Scene& scene = *loaded.scene;
  const Clip& clip = loaded.clips.front();

  [[nodiscard]] std::vector<Mat4> worlds(double frame) const {
    return worldMatrices(scene, samplePose(scene, clip, frame / framesPerSecond));
  }
  [[nodiscard]] Vec3 at(const std::string& name, double frame) const {
    return positionOf(worlds(frame)[stretch::at(nodeNamed(scene, name))]);
  }
};

} // namespace

TEST_CASE("The one-two punch runs from frame 0 to 60, keyed on whole frames and not on every one") {
  const Played played;
  CHECK(played.loaded.warnings.empty());
  CHECK(played.clip.startSeconds == 0.0);
  CHECK(frameCount(played.clip) == lastFrame + 1);
  CHECK(played.clip.framesPerSecond == Approx(framesPerSecond));
  for (const auto& track : played.clip.tracks) {
    CHECK(track->times.size() <= 33);
    for (const float time : track->times) {
      REQUIRE(time * framesPerSecond == Approx(std::round(time * framesPerSecond)).margin(1e-4));
    }
  }
}

TEST_CASE("The balls of the dummy's feet neither slide nor sink while it boxes") {
  const Played played;
  for (const std::string name : {"LeftToeBase", "RightToeBase"}) {
    const Vec3 planted = played.at(name, 0.0);
    for (int quarter = 0; quarter <= 4 * lastFrame; ++quarter) {
      CAPTURE(name, quarter / 4.0);
      REQUIRE(glm::length(played.at(name, quarter / 4.0) - planted) < 0.005);
    }
  }
}

TEST_CASE("The clip loops: the last pose is the first") {
  const Played played;
  const std::vector<Mat4> first = played.worlds(0.0);
  const std::vector<Mat4> last = played.worlds(lastFrame);
  for (std::size_t node = 0; node < first.size(); ++node) {
    for (std::size_t column = 0; column < 4; ++column) {
      REQUIRE(glm::length(first[node][column] - last[node][column]) < 1e-6);
    }
  }
}

TEST_CASE("The guard is a second clip, baked on every frame of its loop") {
  const Played played;
  REQUIRE(played.loaded.clips.size() == 2);
  const Clip& guard = played.loaded.clips[1];
  CHECK(guard.name == "Guard");
  for (const auto& track : guard.tracks) {
    CHECK(track->interpolation == Interpolation::linear);
    CHECK(track->times.size() == 17);
  }
}

TEST_CASE("The jab carries the left fist half a metre, and nothing else takes it further from the shoulder") {
  const Played played;
  const auto reach = [&](double frame) { return played.at("LeftHand", frame) - played.at("LeftArm", frame); };
  double farthest = 0.0;
  int farthestFrame = 0;
  for (int frame = 0; frame <= lastFrame; ++frame) {
    const double distance = glm::length(reach(frame) - reach(0.0));
    if (distance > farthest) {
      farthest = distance;
      farthestFrame = frame;
    }
  }
  CHECK(farthestFrame >= 26);
  CHECK(farthestFrame <= 30);
  CHECK(glm::length(played.at("LeftHand", farthestFrame) - played.at("LeftHand", 0.0)) > 0.5);
}
