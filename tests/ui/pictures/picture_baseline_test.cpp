#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/ui/picture_baseline.h"
#include "ui/render/picture/image_edits.h"
#include "ui/render/picture/text.h"

using namespace stretch;

namespace {

/// A panel of ten rows of text; the fifth one lies `moved` pixels lower.
Image panel(int moved) {
  Image image = ui::filled(300, 260, glm::vec3(0.12F));
  const ui::TextFace face(14);
  for (int row = 0; row < 10; ++row) {
    face.write(image, 12, 20 + 24 * row + (row == 5 ? moved : 0), "Release over frames", glm::vec4(0.85F));
  }
  return image;
}

} // namespace

TEST_CASE("A row of text that moves by two pixels is seen, in a picture of any height") {
  CHECK(test::isVisible(test::differenceBetween(panel(0), panel(2))));
  CHECK_FALSE(test::isVisible(test::differenceBetween(panel(0), panel(0))));
}

TEST_CASE("What drivers round differently is no difference, but another colour is") {
  const Image one = panel(0);
  Image other = one;
  for (std::size_t i = 0; i < other.rgba.size(); i += 40) {
    other.rgba[i] = static_cast<std::uint8_t>(std::min(255, other.rgba[i] + 6));
  }
  CHECK_FALSE(test::isVisible(test::differenceBetween(one, other)));
  CHECK(test::isVisible(test::differenceBetween(one, ui::filled(300, 260, glm::vec3(0.15F)))));
}
