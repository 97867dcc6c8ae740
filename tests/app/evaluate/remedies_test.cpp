// What is advised against an arm that points away from where it did, by what carries it off.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/evaluate/evaluate.h"
#include "app/evaluate/quality.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// The boxer whose punch is stretched while a node of the trunk flies off to the right.
Document punchingFrom(const char* flying) {
  Document document = test::boxer();
  const Scene& scene = *document.scene;
  const auto node = std::ranges::find(scene.nodes, flying, &Node::name) - scene.nodes.begin();
  const auto& rest = scene.nodes[static_cast<std::size_t>(node)].rest.translation;
  Track track;
  track.node = NodeIndex(static_cast<std::size_t>(node));
  track.times = {0.0F, 20.0F / 30.0F};
  for (const double way : {0.0, -3.0}) {
    for (const double value : {rest.x + way, rest.y, rest.z}) {
      track.values.push_back(static_cast<float>(value));
    }
  }
  std::vector<Clip> clips = *document.clips;
  clips.front().tracks.emplace_back(std::move(track));
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  rig::Trail trail;
  trail.id = 1;
  trail.limb = "left-arm";
  trail.settings.endFrame = 20.0;
  trail.settings.scale = 2.0;
  trail.exaggerated = trail.connected = true;
  document.trails.push_back(trail);
  return document;
}

std::string adviceFor(const Document& document) {
  const rig::MotionState motion = prepareMotion(document, 0);
  for (const std::string& warning : motionWarnings(document, motion, motion.trails.front())) {
    if (warning.find("degrees away from where it did") != std::string::npos) {
      return warning.substr(warning.find("; "));
    }
  }
  return {};
}

} // namespace

TEST_CASE(
    "Where the chest carries an arm off, the space of its base is advised, where the body does its root") {
  CHECK_THAT(adviceFor(punchingFrom("Hips")), Catch::Contains("set the space to root"));
  Document document = punchingFrom("Chest");
  const std::string advice = adviceFor(document);
  CHECK_THAT(advice, Catch::Contains("set the space to base"));
  CHECK_THAT(advice, !Catch::Contains("set the space to root"));
  document.trails.front().settings.space = rig::TrailSpace::base;
  CHECK(adviceFor(document).empty());
}
