// Limbs that pop in a clip that was exaggerated in a style.
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/auto/exaggerate_clip.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/evaluate/clip_moments.h"
#include "tests/support/app/posed_file.h"

using namespace stretch;
using namespace stretch::app;

namespace {

std::string notesOf(const Document& document) {
  std::string notes;
  for (const std::string& note : exaggerateClip(document, 0, momentsOf(document, 0), {}).notes) {
    notes += note + "\n";
  }
  return notes;
}

/// The left foot goes up to the hip within a frame.
Document withPop(const Document& document) {
  rig::Adjustment kicked{"left-foot", 0, std::nullopt, {}};
  for (const auto& [frame, up] : {std::pair(0.0, 0.0), {12.0, 0.0}, {13.0, 1.3}, {20.0, 1.3}}) {
    rig::OffsetKey key;
    key.frame = frame;
    key.move = Vec3(0.0, up, 0.0);
    kicked.keys.push_back(key);
  }
  const Result<Document> posed = placeAdjustments(document, std::vector{kicked});
  REQUIRE(posed);
  return *posed;
}

} // namespace

TEST_CASE("A limb that pops in what a style made is told, and nothing where none does") {
  const Document document = test::openedFile(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  CHECK_THAT(notesOf(document), !Catch::Contains("flips") && !Catch::Contains("pops"));
  CHECK_THAT(notesOf(withPop(document)), Catch::Contains("the left leg pops at frame"));
}
