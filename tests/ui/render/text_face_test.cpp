#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include "ui/render/picture/image_edits.h"
#include "ui/render/picture/text.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The largest and the least value of each channel.
struct Channels {
  std::array<int, 4> most{0, 0, 0, 0};
  std::array<int, 4> least{255, 255, 255, 255};
};

Channels channelsOf(const Image& image) {
  Channels found;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    found.most[i % 4] = std::max<int>(found.most[i % 4], image.rgba[i]);
    found.least[i % 4] = std::min<int>(found.least[i % 4], image.rgba[i]);
  }
  return found;
}

} // namespace

TEST_CASE(
    "A letter of two bytes is one letter, and a byte that makes none is drawn as one that is not known") {
  const TextFace face(64);
  const int unknown = face.widthOf("\xEF\xBF\xBD");
  if (unknown == 0) {
    return; // A system without any font writes nothing.
  }
  CHECK(face.widthOf("\xC3\xA9") == face.widthOf("e")); // an e with an accent
  CHECK(face.widthOf("I\xC3") == face.widthOf("I") + unknown);
  CHECK(face.widthOf("\xA9I") == unknown + face.widthOf("I"));
  CHECK(face.widthOf("\xF0\x9F\x98") == 3 * unknown);
}

TEST_CASE("Letters have the colour that they are asked for, over whatever lies under them") {
  const TextFace face(64);
  if (face.widthOf("I") == 0) {
    return; // A system without any font writes nothing.
  }
  for (const glm::vec4& colour : {glm::vec4(1.0F, 0.5F, 0.25F, 1.0F),
                                  {0.2F, 1.0F, 0.6F, 1.0F},
                                  {0.0F, 0.3F, 1.0F, 1.0F},
                                  {1.0F, 0.6F, 0.2F, 0.5F}}) {
    for (const float ground : {0.0F, 1.0F}) {
      CAPTURE(colour.r, colour.g, colour.b, colour.a, ground);
      Image image = filled(120, 100, glm::vec3(ground));
      const Channels before = channelsOf(image);
      face.write(image, 10, 80, "III", colour);
      const Channels after = channelsOf(image);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double wanted =
            255.0 * std::lerp(double(ground), double(colour[static_cast<int>(channel)]), double(colour.a));
        CAPTURE(channel);
        CHECK((ground == 0.0F ? after.most : after.least)[channel] == Approx(wanted).margin(1.0));
        CHECK((ground == 0.0F ? after.least : after.most)[channel] == before.least[channel]);
      }
      CHECK(after.least[3] == before.least[3]);
      CHECK(after.most[3] == before.most[3]);
    }
  }
}
