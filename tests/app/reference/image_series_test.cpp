#include <catch2/catch.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "app/reference/image_series.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// Numbers of the images of the series that begins with this file.
std::vector<std::uint64_t> numbersFrom(const std::filesystem::path& first) {
  const Result<ImageSeries> series = imageSeriesFrom(first);
  REQUIRE(series);
  std::vector<std::uint64_t> numbers;
  for (const ImageSeries::Numbered& image : series->images) {
    numbers.push_back(image.number);
  }
  return numbers;
}

/// Name of the image at a frame; empty: none.
std::string nameAt(const ImageSeries& series, const ReferenceImages& settings, double frame,
                   double framesPerSecond = 24.0) {
  const std::filesystem::path* const file = imageAt(series, settings, frame, framesPerSecond);
  return file == nullptr ? std::string() : file->filename().string();
}

} // namespace

TEST_CASE("A series is all images of one name that follow by number, whatever else lies in the folder") {
  const test::TemporaryFolder folder;
  for (const char* const name : {"film-10.png", "film-9.png", "film-11.png", "film-2.png", "other-12.png",
                                 "film-13.jpg", "film-x.png", "film-.png", "film-12b.png"}) {
    folder.write(name, "");
  }
  std::filesystem::create_directory(folder / "film-14.png"); // a folder is no image
  folder.write("film-09.png", "");                           // another 9: the chosen one is meant
  CHECK(numbersFrom(folder / "film-9.png") == std::vector<std::uint64_t>{9, 10, 11});
  CHECK(numbersFrom(folder / "film-2.png") == std::vector<std::uint64_t>{2, 9, 9, 10, 11});
  CHECK(imageSeriesFrom(folder / "film-9.png")->images.front().file == folder / "film-9.png");
  CHECK(numbersFrom(folder / "film-11.png") == std::vector<std::uint64_t>{11});
  CHECK(numbersFrom(folder / "film-13.jpg") == std::vector<std::uint64_t>{13});
  CHECK(numbersFrom(folder / "film-x.png") == std::vector<std::uint64_t>{0});
}

TEST_CASE("Images are named by number alone, too, and a number that no computer holds is none") {
  const test::TemporaryFolder folder;
  folder.write("0007.png", "");
  folder.write("0008.png", "");
  folder.write("99999999999999999999999.png", "");
  CHECK(numbersFrom(folder / "0007.png") == std::vector<std::uint64_t>{7, 8});
  CHECK(numbersFrom(folder / "99999999999999999999999.png") == std::vector<std::uint64_t>{0});
}

TEST_CASE("Every kind of image that can be read is one, in capital letters too, and others say what to do") {
  for (const char* const name : {"a.png", "a.jpg", "a.jpeg", "a.bmp", "a.tga", "a.PNG", "a.Jpg"}) {
    INFO(name);
    CHECK(isImageName(name));
  }
  for (const char* const name : {"a.mp4", "a.webp", "a.gif", "a", "png"}) {
    INFO(name);
    CHECK_FALSE(isImageName(name));
  }
  const test::TemporaryFolder folder;
  const std::string film = folder.write("film.mp4", "").string();
  const Result<ImageSeries> noImage = imageSeriesFrom(film);
  REQUIRE_FALSE(noImage);
  CHECK(noImage.error().where == film);
  CHECK_THAT(noImage.error().remedy, Catch::Contains("ffmpeg -i film.mp4"));
  const Result<ImageSeries> missing = imageSeriesFrom(folder / "none-1.png");
  REQUIRE_FALSE(missing);
  CHECK(missing.error().what == "the image is not there");
  std::filesystem::create_directory(folder / "folder-1.png");
  CHECK_FALSE(imageSeriesFrom(folder / "folder-1.png"));
}

TEST_CASE("The first image stands at its frame, each frame has the next one, and beside them there is none") {
  const ImageSeries series{{{5, "f-5.png"}, {6, "f-6.png"}, {8, "f-8.png"}}};
  ReferenceImages settings{.startFrame = 10.0};
  CHECK(nameAt(series, settings, 9.99).empty());
  CHECK(nameAt(series, settings, 10.0) == "f-5.png");
  CHECK(nameAt(series, settings, 10.9) == "f-5.png");
  CHECK(nameAt(series, settings, 11.0 - 1e-9) == "f-6.png"); // counted in another rate and back
  CHECK(nameAt(series, settings, 12.0) == "f-6.png");        // 7 is missing
  CHECK(nameAt(series, settings, 13.0) == "f-8.png");
  CHECK(nameAt(series, settings, 13.99) == "f-8.png");
  CHECK(nameAt(series, settings, 14.0).empty());
  settings.startFrame = -1.0;
  CHECK(nameAt(series, settings, 0.0) == "f-6.png");
}

TEST_CASE("Images of another rate than the clip's stay as long as they lasted") {
  const ImageSeries series{{{0, "f-0.png"}, {1, "f-1.png"}, {2, "f-2.png"}}};
  const ReferenceImages settings{.startFrame = 4.0, .imagesPerSecond = 12.0};
  CHECK(nameAt(series, settings, 5.0) == "f-0.png");
  CHECK(nameAt(series, settings, 6.0) == "f-1.png");
  CHECK(nameAt(series, settings, 9.0) == "f-2.png");
  CHECK(nameAt(series, settings, 10.0).empty());
  CHECK(nameAt(series, settings, 5.0, 12.0) == "f-1.png");
}

TEST_CASE("A single image stands all the time, and no image never") {
  const ImageSeries single{{{3, "sheet.png"}}};
  CHECK(nameAt(single, {.startFrame = 10.0}, -50.0) == "sheet.png");
  CHECK(nameAt(single, {.startFrame = 10.0}, 500.0) == "sheet.png");
  CHECK(nameAt({}, {}, 0.0).empty());
}
