// `render` of mesh sequences, from the command line.
#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>
#include <fstream>

#include "core/base/file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/temporary_folder.h"
#include "ui/batch/render_verb.h"
#include "ui/batch/sequence_pictures.h"
#include "ui/render/picture/image_edits.h"

using namespace stretch;

namespace {

/// A folder of OBJ frames "tube", and the same as "run.pc2", which moves "tube/tube-1.obj".
class TubeFiles {
public:
  TubeFiles() : tube_(test::shorteningTube(4, 2.0, 0.06, 0.1)) {
    test::writeObjFrames(tube_, folder_ / "tube", "tube");
    std::ofstream cache(folder_ / "run.pc2", std::ios::binary);
    const auto put = [&](auto number) {
      cache.write(reinterpret_cast<const char*>(&number), sizeof(number)); // NOLINT: bytes of a file
    };
    cache.write("POINTCACHE2\0", 12);
    put(std::int32_t{1});
    put(static_cast<std::int32_t>(tube_.vertexCount));
    put(0.0F);
    put(1.0F);
    put(static_cast<std::int32_t>(tube_.frameCount()));
    for (const glm::vec3& p : tube_.positions) {
      put(p.x);
      put(p.y);
      put(p.z);
    }
  }

  [[nodiscard]] std::string frames() const { return (folder_ / "tube").string(); }
  [[nodiscard]] std::string mesh() const { return (folder_ / "tube" / "tube-1.obj").string(); }
  [[nodiscard]] std::string cache() const { return (folder_ / "run.pc2").string(); }
  [[nodiscard]] std::string picture() const { return (folder_ / "out.png").string(); }

  /// The picture that `render` writes for these words, as bytes of the file.
  [[nodiscard]] Bytes drawn(const std::vector<std::string>& words) const {
    const test::VerbAnswer answer = answerTo(words);
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
    return readFile(picture()).value();
  }

  [[nodiscard]] test::VerbAnswer answerTo(std::vector<std::string> words,
                                          const std::string& size = "96x64") const {
    words.insert(words.begin(), "render");
    for (const std::string& word : {std::string("-o"), picture(), std::string("--size"), size}) {
      words.push_back(word);
    }
    return test::runVerb(words, {ui::renderVerb()});
  }

private:
  test::TemporaryFolder folder_;
  MeshSequence tube_;
};

} // namespace

TEST_CASE("render draws a mesh with its cache as it draws the folder of the same frames") {
  const TubeFiles files;
  const Bytes folder = files.drawn({files.frames(), "--frame", "3"});
  CHECK(files.drawn({files.mesh(), files.cache(), "--frame", "3"}) == folder);
  CHECK(files.drawn({files.cache(), files.mesh(), "--frame", "3"}) == folder);
  CHECK(files.drawn({files.frames(), "--frame", "0"}) != folder);
}

TEST_CASE("render draws each look, bones and legend, what it needs is compressed first") {
  const TubeFiles files;
  std::vector<Bytes> pictures;
  for (const char* const look : {"material", "compare", "error", "thickness", "segments", "cylinders"}) {
    pictures.push_back(files.drawn({files.frames(), "--look", look, "--bones", "5", "--frame", "2"}));
  }
  pictures.push_back(files.drawn({files.frames(), "--skeleton", "--frame", "2"}));
  for (std::size_t a = 0; a < pictures.size(); ++a) {
    for (std::size_t b = a + 1; b < pictures.size(); ++b) {
      CAPTURE(a, b);
      CHECK(pictures[a] != pictures[b]);
    }
  }
}

TEST_CASE("the four stages stand beside each other, a row for each frame, and differ") {
  const TubeFiles files;
  auto document = app::openSequence({files.frames()});
  REQUIRE(document);
  document->settings.bones = 5;
  auto made = app::makeCompression(*document->mesh, document->settings);
  REQUIRE(made);
  document->result = std::make_shared<const app::Compression>(std::move(made).value());
  ui::PictureOptions options;
  options.widthPixels = 96;
  options.heightPixels = 64;
  const auto sheet = ui::drawStages(ui::contentOf(*document), {0.0, 3.0}, options);
  REQUIRE(sheet);
  const ui::SheetLayout layout = ui::layOutSheet(8, 96, 64, 4);
  REQUIRE(sheet->width == layout.widthPixels);
  REQUIRE(sheet->height == layout.heightPixels);
  std::vector<std::vector<std::uint8_t>> cells;
  for (std::size_t cell = 0; cell < 8; ++cell) {
    Image picture = ui::filled(96, 64, {0.0F, 0.0F, 0.0F});
    ui::paste(picture, *sheet, -layout.left(cell), -layout.top(cell));
    for (const std::vector<std::uint8_t>& other : cells) {
      CAPTURE(cell);
      CHECK(picture.rgba != other);
    }
    cells.push_back(picture.rgba);
  }
  const auto rows = ui::drawStages(ui::contentOf(*document), {3.0, 3.0}, options);
  REQUIRE(rows);
  for (std::size_t stage = 0; stage < 4; ++stage) {
    Image first = ui::filled(96, 64, {0.0F, 0.0F, 0.0F});
    Image second = first;
    ui::paste(first, *rows, -layout.left(stage), -layout.top(stage));
    ui::paste(second, *rows, -layout.left(stage + 4), -layout.top(stage + 4));
    CAPTURE(stage);
    CHECK(first.rgba == second.rgba); // a column is one stage
  }
  CHECK_FALSE(files.drawn({files.frames(), "--stages", "--bones", "5"}).empty());
}

TEST_CASE("a contact sheet of a short sequence shows no frame twice") {
  const TubeFiles files;
  const Bytes sheet = files.drawn({files.frames(), "--sheet"});
  CHECK(sheet == files.drawn({files.frames(), "--sheet", "--frames", "0:3"}));
}

TEST_CASE("looks that a clip from a file cannot show are refused in one line") {
  const TubeFiles files;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--skeleton"}, {"--look", "cylinders"}, {"--stages"}}) {
    std::vector<std::string> all{files.frames(), "--over", "some.glb"};
    all.insert(all.end(), words.begin(), words.end());
    const test::VerbAnswer answer = files.answerTo(all);
    CHECK(answer.exitCode == 1);
    CHECK_THAT(answer.told, Catch::Contains("--over"));
  }
  CHECK(files.answerTo({files.frames(), "--look", "pretty"}).exitCode == 2);
  const test::VerbAnswer shaded = files.answerTo({files.frames(), "--shade-as", "three"});
  CHECK(shaded.exitCode == 1);
  CHECK_THAT(shaded.told, Catch::Contains("--shade-as: a mesh sequence has no joints"));
  CHECK(files.answerTo({files.frames(), "--clip", "walk"}).exitCode == 1);
}

TEST_CASE("a look that a surface has nothing for is refused, and nothing is drawn") {
  const test::TemporaryFolder folder;
  MeshSequence sheet = test::still(test::plane(4, 0.0)); // which encloses nothing that were thick
  const std::vector<glm::vec3> first = sheet.positions;
  sheet.positions.insert(sheet.positions.end(), first.begin(), first.end());
  test::writeObjFrames(sheet, folder / "sheet", "sheet");
  const auto drawnAs = [&](const std::string& look) {
    return test::runVerb({"render", (folder / "sheet").string(), "-o", (folder / (look + ".png")).string(),
                          "--size", "32x32", "--look", look},
                         {ui::renderVerb()});
  };
  CHECK(drawnAs("material").exitCode == 0);
  const test::VerbAnswer refused = drawnAs("thickness");
  CHECK(refused.exitCode == 1);
  CHECK_THAT(refused.told, Catch::Contains("sheet: there is nothing to show for this look"));
  CHECK_FALSE(std::filesystem::exists(folder / "thickness.png"));
}

TEST_CASE("what only characters have is refused to a mesh sequence, each by itself") {
  const TubeFiles files;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--clip", "walk"},
                                                {"--trails", "punch.json"},
                                                {"--ghosts", "1"},
                                                {"--camera", "Side"},
                                                {"--beside", "dummy.glb"},
                                                {"--view", "best"}}) {
    CAPTURE(words);
    const test::VerbAnswer answer = files.answerTo({files.frames(), words[0], words[1]});
    CHECK(answer.exitCode == 1);
    CHECK_THAT(answer.told, Catch::Contains("a mesh sequence has no clips"));
  }
}

TEST_CASE("a picture that is too small for its legend is drawn all the same") {
  const TubeFiles files;
  const test::VerbAnswer answer =
      files.answerTo({files.frames(), "--look", "error", "--bones", "5"}, "16x16");
  CHECK(answer.exitCode == 0);
}
