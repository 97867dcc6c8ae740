#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.h"
#include "tests/support/ui/render_scenes.h"
#include "ui/batch/film.h"

using namespace stretch;
using namespace stretch::ui;

TEST_CASE(
    "A film tells how far it is before each picture and at its end, and leaves nothing when it is stopped") {
  const Scene scene = test::triangleScene();
  const PictureFrame picture{{.frame = frameOf(scene, restPose(scene), 0.0)}};
  const Film film{{{&scene, {picture, picture, picture, picture}}}, {0.0, 1.0, 2.0, 3.0}, 24.0};
  PictureOptions options;
  options.widthPixels = options.heightPixels = 32;
  const test::TemporaryFolder whole;
  std::vector<double> shares;
  CHECK(writeFilm(film, options, whole / "s.png", [&](double share) {
    shares.push_back(share);
    return true;
  }));
  CHECK(shares == std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0});
  CHECK(whole.fileCount() == 4);
  const test::TemporaryFolder stopped;
  const Status done = writeFilm(film, options, stopped / "s.png", [](double share) { return share < 0.5; });
  REQUIRE_FALSE(done);
  CHECK_THAT(done.error().line(), Catch::Contains("s.png: was stopped"));
  CHECK(stopped.fileCount() == 0);
}
