// A step that brings a clip is told, whatever the clips that were there are.
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/pose/step_text.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE(
    "A step after which there are more or fewer clips tells of a rate only where a clip has another one") {
  const Document one = test::boxer();
  Document two = one;
  std::vector<Clip> clips = *one.clips;
  clips.push_back(clips.front());
  clips.back().framesPerSecond = 12.0;
  two.clips = std::make_shared<const std::vector<Clip>>(clips);
  CHECK(stepText("Import the clip", one, two).find("fps") == std::string::npos);
  CHECK(stepText("Take the clip away", two, one).find("fps") == std::string::npos);
  clips.front().framesPerSecond = 60.0;
  Document faster = one;
  faster.clips = std::make_shared<const std::vector<Clip>>(clips);
  CHECK_THAT(stepText("Change the rate", one, faster), Catch::EndsWith("60 fps"));
}
