// Which pictures of a file are shown, and what is told of the others.
#include <algorithm>

#include <catch2/catch.hpp>

#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/uri.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Bytes;
using gltf::Json;

namespace {

void append(Bytes& to, const std::string& text) {
  to.insert(to.end(), text.begin(), text.end());
}

void appendBigEndian(Bytes& to, std::uint32_t number) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    to.push_back(static_cast<std::uint8_t>(number >> shift));
  }
}

/// A part of a PNG that says to be so long.
void appendPart(Bytes& to, const std::string& kind, const Bytes& content, std::uint32_t said) {
  appendBigEndian(to, said);
  append(to, kind);
  to.insert(to.end(), content.begin(), content.end());
  appendBigEndian(to, 0); // its checksum, which nobody looks at
}

/// A PNG that says to be so large, and holds no pixel; a part of text before its end.
Bytes pngOf(std::uint32_t width, std::uint32_t height, std::size_t text = 0, std::uint32_t longer = 0) {
  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  Bytes head;
  appendBigEndian(head, width);
  appendBigEndian(head, height);
  append(head, std::string("\x08\x06\0\0\0", 5));
  appendPart(png, "IHDR", head, 13);
  if (text > 0) {
    appendPart(png, "tEXt", Bytes(text, 'a'), static_cast<std::uint32_t>(text) + longer);
  }
  appendPart(png, "IEND", {}, 0);
  return png;
}

/// Two by two pixels, the last of them 1 2 3 4, with a part of text of a length before its pixels.
Bytes fourPixels(std::size_t text, std::uint32_t longer = 0) {
  const auto data = gltf::decodeDataUri(
      "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAF0lEQVR4nGP4z8DwHwgbGID0f0Ym"
      "ZhYAOvAFhmzG3xIAAAAASUVORK5CYII=");
  REQUIRE(data);
  Bytes part;
  appendPart(part, "tEXt", Bytes(text, 'a'), static_cast<std::uint32_t>(text) + longer);
  Bytes png = data->bytes;
  png.insert(png.begin() + 33, part.begin(), part.end());
  return png;
}

/// What is told of the pictures of a file of materials that show one each, looked at by their heads alone,
/// and of how many it is told that they cannot be shown.
struct Told {
  explicit Told(const std::vector<Bytes>& pictures) {
    gltf::Source source;
    source.json = Json{{"images", Json::array()}};
    std::vector<Material> materials(pictures.size());
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      (*source.json)["images"].push_back(
          {{"uri", "data:image/png;base64," + gltf::encodeBase64(pictures[i])}});
      materials[i].baseColorTexture.image = static_cast<int>(i);
    }
    gltf::Problems problems;
    images = gltf::importImages(source, materials, problems, gltf::Pictures::headers).size();
    for (const gltf::Problem& problem : problems.list()) {
      lines += problem.where + " " + problem.what + "\n";
    }
  }

  [[nodiscard]] bool isShown(std::size_t image) const {
    return lines.find("images[" + std::to_string(image) + "]") == std::string::npos;
  }

  std::size_t images = 0;
  std::string lines;
};

std::vector<std::uint8_t> pixelsOf(const Bytes& picture) {
  gltf::Source source;
  source.json = Json{{"images", {{{"uri", "data:image/png;base64," + gltf::encodeBase64(picture)}}}}};
  std::vector<Material> materials(1);
  materials[0].emissiveTexture.image = 0;
  gltf::Problems problems;
  return gltf::importImages(source, materials, problems).at(0).rgba;
}

} // namespace

TEST_CASE("Parts of a PNG may be of any length that is there, and a picture that says more is none") {
  for (const std::size_t length : {1, 127, 128, 255, 256, 300, 70000}) {
    INFO(length);
    const std::vector<std::uint8_t> pixels = pixelsOf(fourPixels(length));
    REQUIRE(pixels.size() == 16);
    CHECK(std::vector<std::uint8_t>(pixels.begin() + 12, pixels.end()) ==
          std::vector<std::uint8_t>{1, 2, 3, 4});
    CHECK(pixelsOf(fourPixels(length, 1000000)).empty());
  }
}

TEST_CASE("A small PNG may say to have 16 million pixels and 256 for each of its bytes, and not one more") {
  const std::size_t bytes = pngOf(2, 1).size();
  const auto most = static_cast<std::uint32_t>(16777216 + 256 * bytes);
  CHECK(Told({pngOf(2, most / 2)}).isShown(0));
  CHECK_FALSE(Told({pngOf(2, most / 2 + 1)}).isShown(0));
  CHECK(Told({pngOf(4096, 4096)}).isShown(0));
  CHECK_FALSE(Told({pngOf(0, 4096)}).isShown(0));
}

TEST_CASE("Pictures of a small file may say to have four times as many together, the first of them first") {
  // 4 x 16 million fit exactly, with 256 for each byte of all that was looked at.
  const Bytes large = pngOf(4096, 4096);
  const Told five({large, large, large, large, large, pngOf(2, 2)});
  CHECK(five.images == 6);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(five.isShown(i));
  }
  CHECK_FALSE(five.isShown(4));
  CHECK(five.isShown(5)); // a small one still fits
  CHECK(five.lines.find("is not a picture that can be shown (PNG, JPEG or WebP); its texture is not shown") !=
        std::string::npos);
}

TEST_CASE("Bytes that are no picture are told, and those that no material shows are not looked at") {
  CHECK_FALSE(Told({{'B', 'M', 1, 2, 3}}).isShown(0));
  CHECK_FALSE(Told({{0x89, 'P', 'N', 'G'}}).isShown(0));
  CHECK_FALSE(Told({{0xFF, 0xD8, 0xFF}}).isShown(0));
  gltf::Source source;
  source.json = Json::parse(R"({"images": [{"uri": "gone.png"}, {"uri": "gone, too.png"}]})");
  std::vector<Material> materials(1);
  materials[0].baseColorTexture.image = 1;
  gltf::Problems problems;
  CHECK(gltf::importImages(source, materials, problems).size() == 2);
  REQUIRE(problems.list().size() == 1);
  CHECK(problems.list()[0].what.find("'gone, too.png' cannot be read; its texture is not shown") !=
        std::string::npos);
}

TEST_CASE("A name of a picture that cannot be read is told up to its two hundredth letter") {
  gltf::Source source;
  source.json = Json{{"images", {{{"uri", std::string(199, 'a') + "bc.png"}}}}};
  std::vector<Material> materials(1);
  materials[0].baseColorTexture.image = 0;
  gltf::Problems problems;
  CHECK(gltf::importImages(source, materials, problems).at(0).rgba.empty());
  REQUIRE(problems.list().size() == 1);
  CHECK(problems.list()[0].what.find("'" + std::string(199, 'a') + "b'") != std::string::npos);
}

TEST_CASE(
    "An encoded picture lies in a view, in its URI or beside the file, and nowhere outside of its folder") {
  const test::TemporaryFolder folder;
  const std::filesystem::path inner = folder.path() / "inner";
  std::filesystem::create_directories(inner);
  test::writeBytes(inner / "a b.png", {1, 2});
  test::writeBytes(folder.path() / "out.png", {3});
  gltf::Source source;
  source.path = inner / "model.gltf";
  source.json = Json::parse(
      R"({"bufferViews": [{"buffer": 0, "byteLength": 2}, {"buffer": 0, "byteOffset": 1, "byteLength": 3},
      {"buffer": 0, "byteOffset": 2, "byteLength": 3}]})");
  source.buffers = {{5, 6, 7, 8}};
  const auto encoded = [&](const char* json) { return gltf::encodedImage(source, Json::parse(json)); };
  CHECK(encoded(R"({"bufferView": 0})") == Bytes{5, 6});
  CHECK(encoded(R"({"bufferView": 1, "uri": "a%20b.png"})") == Bytes{6, 7, 8});
  CHECK_FALSE(encoded(R"({"bufferView": 2})"));
  CHECK(encoded(R"({"uri": "a%20b.png"})") == Bytes{1, 2});
  CHECK(encoded(R"({"uri": "data:;base64,AQI="})") == Bytes{1, 2});
  CHECK_FALSE(encoded(R"({"uri": "data:;base64,A"})"));
  CHECK_FALSE(encoded(R"({"uri": "../out.png"})"));
  CHECK_FALSE(encoded(R"({"uri": "http://example.org/a.png"})"));
  CHECK_FALSE(encoded(R"({"uri": "c.png"})"));
  CHECK_FALSE(encoded("{}"));
}

TEST_CASE(
    "A picture has 67 million pixels at most however many bytes it has, a file's together have four times "
    "as many") {
  constexpr std::size_t text = 300000;
  CHECK(Told({pngOf(8192, 8192, text)}).isShown(0));
  CHECK_FALSE(Told({pngOf(8192, 8193, text)}).isShown(0));
  const Bytes largest = pngOf(8192, 8192, text);
  const Told six({largest, largest, largest, largest, largest, pngOf(2, 2, text)});
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(six.isShown(i));
  }
  CHECK_FALSE(six.isShown(4));
  CHECK_FALSE(six.isShown(5));
}
