#include "core/gltf/import/material_library.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/core/two_sheets.h"

using namespace stretch;
using gltf::Bytes;
using gltf::Json;
using gltf::Source;

namespace {

// Each begins as a picture of its kind, and is as long as no other.
const Bytes png{0x89, 'P', 'N', 'G', 1};
const Bytes jpeg{0xFF, 0xD8, 0xFF, 7, 7, 7};
const Bytes webp{'R', 'I', 'F', 'F', 0, 0, 0, 0, 'W', 'E', 'B', 'P', 9};

Source sourceOf(const char* json) {
  Source source;
  source.json = Json::parse(json);
  source.buffers.emplace_back();
  for (const Bytes& image : {png, jpeg, webp}) {
    (*source.json)["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", source.buffers[0].size()}, {"byteLength", image.size()}});
    source.buffers[0].insert(source.buffers[0].end(), image.begin(), image.end());
  }
  (*source.json)["buffers"] = Json::array({Json{{"byteLength", source.buffers[0].size()}}});
  return source;
}

/// The library of materials, which has to warn of nothing unless asked.
struct Library {
  explicit Library(const Source& from) : source(gltf::materialsOf(from, warnings)), json(*source.json) {}

  Bytes imageAt(std::size_t index) const {
    const Json& view = json["bufferViews"][json["images"][index]["bufferView"].get<std::size_t>()];
    const auto start = source.buffers.front().begin() + view["byteOffset"].get<std::ptrdiff_t>();
    return {start, start + view["byteLength"].get<std::ptrdiff_t>()};
  }

  std::vector<std::string> warnings;
  Source source;
  const Json& json;
};

} // namespace

TEST_CASE("A file without materials has an empty library: a valid file of its own") {
  for (const char* const json : {"{}", R"({"materials": 3})", R"({"textures": [{"source": 0}]})"}) {
    const Library library(sourceOf(json));
    CHECK(library.json == Json::parse(R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 0}]})"));
    CHECK(library.source.buffers == std::vector<Bytes>{{}});
    CHECK(library.source.hasBinaryChunk);
    CHECK(library.warnings.empty());
  }
}

TEST_CASE(
    "Materials keep their indices and all that they say, and textures, samplers and images that none names "
    "stay behind") {
  const Library library(sourceOf(R"({
    "materials": [{"name": "bare", "doubleSided": true},
      {"name": "cloth", "normalTexture": {"index": 3, "scale": 0.5, "texCoord": 1}}],
    "textures": [{"source": 0}, {"source": 0, "sampler": 0}, {"source": 0},
                 {"name": "weave", "source": 1, "sampler": 1, "extras": 4}],
    "samplers": [{"wrapS": 33071}, {"magFilter": 9728}],
    "images": [{"bufferView": 0}, {"bufferView": 1, "mimeType": "image/jpeg", "name": "threads"}]})"));
  CHECK(library.warnings.empty());
  CHECK(library.json["materials"] == Json::parse(R"([{"name": "bare", "doubleSided": true},
      {"name": "cloth", "normalTexture": {"index": 0, "scale": 0.5, "texCoord": 1}}])"));
  CHECK(library.json["textures"] ==
        Json::parse(R"([{"name": "weave", "source": 0, "sampler": 0, "extras": 4}])"));
  CHECK(library.json["samplers"] == Json::parse(R"([{"magFilter": 9728}])"));
  CHECK(library.json["images"] ==
        Json::parse(R"([{"bufferView": 0, "mimeType": "image/jpeg", "name": "threads"}])"));
  CHECK(library.imageAt(0) == jpeg);
  CHECK(library.json["buffers"] == Json::parse(R"([{"byteLength": 6}])"));
  CHECK_FALSE(library.json.contains("extensionsUsed"));
}

TEST_CASE("A texture, a sampler and an image that several name are taken once") {
  const Library library(sourceOf(R"({
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}},
                   "emissiveTexture": {"index": 0}},
                  {"occlusionTexture": {"index": 2}}],
    "textures": [{"source": 2, "sampler": 0}, {"source": 2, "sampler": 1}, {"source": 0, "sampler": 0}],
    "samplers": [{"wrapS": 33071}, {"wrapT": 33071}],
    "images": [{"bufferView": 0}, {"bufferView": 1}, {"bufferView": 2}]})"));
  const Json& materials = library.json["materials"];
  const auto base = materials[0]["pbrMetallicRoughness"]["baseColorTexture"]["index"].get<std::size_t>();
  const auto metal =
      materials[0]["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"].get<std::size_t>();
  const auto shade = materials[1]["occlusionTexture"]["index"].get<std::size_t>();
  CHECK(materials[0]["emissiveTexture"]["index"] == base);
  REQUIRE(library.json["textures"].size() == 3);
  REQUIRE(library.json["images"].size() == 2);
  REQUIRE(library.json["samplers"].size() == 2);
  const auto imageOf = [&](std::size_t texture) {
    return library.json["textures"][texture]["source"].get<std::size_t>();
  };
  const auto samplerOf = [&](std::size_t texture) {
    return library.json["samplers"][library.json["textures"][texture]["sampler"].get<std::size_t>()];
  };
  CHECK(library.imageAt(imageOf(base)) == webp);
  CHECK(imageOf(metal) == imageOf(base));
  CHECK(library.imageAt(imageOf(shade)) == png);
  CHECK(samplerOf(base) == Json{{"wrapS", 33071}});
  CHECK(samplerOf(metal) == Json{{"wrapT", 33071}});
  CHECK(samplerOf(shade) == Json{{"wrapS", 33071}});
  // What an image does not say of its kind is told from its bytes, and each starts at a multiple of 4.
  CHECK(library.json["images"][imageOf(base)]["mimeType"] == "image/webp");
  CHECK(library.json["images"][imageOf(shade)]["mimeType"] == "image/png");
  for (const Json& view : library.json["bufferViews"]) {
    CHECK(view["byteOffset"].get<int>() % 4 == 0);
  }
  CHECK(library.json["buffers"][0]["byteLength"] == library.source.buffers[0].size());
}

TEST_CASE("A texture whose image cannot be read is left out wherever it is named, with one line") {
  const Library library(sourceOf(R"({
    "materials": [{"name": "a", "normalTexture": {"index": 0}, "emissiveTexture": {"index": 1}},
                  {"name": "b", "normalTexture": {"index": 0}, "occlusionTexture": {"index": 2}},
                  {"name": "c", "occlusionTexture": {"index": 9}, "normalTexture": {"index": 3}}],
    "textures": [{"source": 0}, {"source": 1}, {"source": 0}, {"sampler": 0}],
    "samplers": [{}],
    "images": [{"uri": "not-there.png"}, {"bufferView": 0, "uri": "forgotten.png"}]})"));
  CHECK(library.json["materials"] == Json::parse(R"([{"name": "a", "emissiveTexture": {"index": 0}},
      {"name": "b"}, {"name": "c"}])"));
  REQUIRE(library.json["textures"].size() == 1);
  REQUIRE(library.warnings.size() == 1);
  CHECK(library.warnings[0] == "images[0]: the image cannot be read and is left out");
  CHECK_FALSE(library.json["images"][0].contains("uri"));
}

TEST_CASE("A texture that an extension gives a second image keeps whichever can be read") {
  const char* const json = R"({
    "extensionsUsed": ["EXT_texture_webp", "KHR_texture_transform", "KHR_lights"],
    "extensionsRequired": ["EXT_texture_webp", "KHR_lights"],
    "materials": [{"normalTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 2]}}},
                   "extensions": {"KHR_materials_clearcoat": {"clearcoatTexture": {"index": 1}}}}],
    "textures": [{"source": 1, "extensions": {"EXT_texture_webp": {"source": 0}}},
                 {"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}}],
    "images": [{"bufferView": 2}, {"uri": "gone.png"}]})";
  const Library library(sourceOf(json));
  const Json& textures = library.json["textures"];
  REQUIRE(textures.size() == 2);
  const Json& normal = textures[library.json["materials"][0]["normalTexture"]["index"].get<std::size_t>()];
  CHECK_FALSE(normal.contains("source"));
  CHECK(normal["extensions"]["EXT_texture_webp"]["source"] == 0);
  const Json& coat =
      textures[library
                   .json["materials"][0]["extensions"]["KHR_materials_clearcoat"]["clearcoatTexture"]["index"]
                   .get<std::size_t>()];
  CHECK(coat["source"] == 0);
  CHECK_FALSE(coat["extensions"]["EXT_texture_webp"].contains("source"));
  // Extensions that the library uses are said, and those required that the file required.
  CHECK(library.json["extensionsUsed"] ==
        Json{"EXT_texture_webp", "KHR_materials_clearcoat", "KHR_texture_transform"});
  CHECK(library.json["extensionsRequired"] == Json{"EXT_texture_webp"});
}

TEST_CASE("The kind of an image shows in how it begins") {
  CHECK(gltf::mediaTypeOf(png) == "image/png");
  CHECK(gltf::mediaTypeOf(jpeg) == "image/jpeg");
  CHECK(gltf::mediaTypeOf(webp) == "image/webp");
  const auto kindOf = [](const std::string& text) {
    return gltf::mediaTypeOf(Bytes(text.begin(), text.end()));
  };
  CHECK_FALSE(kindOf(""));
  CHECK_FALSE(kindOf("RIFF1234WAVEfmt "));
  CHECK_FALSE(kindOf("JIFF1234WEBP"));
  CHECK_FALSE(kindOf("RIFF1234WEB"));
  CHECK_FALSE(kindOf("\xFF\xD8"));
  CHECK_FALSE(kindOf("\x89PN"));
  CHECK_FALSE(kindOf("BM"));
}

TEST_CASE(
    "Materials of a library are shown with their pictures and with the coordinates that each texture uses") {
  test::GlbBuilder sheets = test::twoSheets();
  Json& flag = sheets.json["materials"][0];
  Json& sail = sheets.json["materials"][1];
  sail["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}, {"texCoord", 1}};
  flag["emissiveTexture"] = {{"index", 0}, {"texCoord", 2}};
  const gltf::Loaded file = test::loaded(test::twoSheets());
  Source changed = *file.source;
  (*changed.json)["materials"] = sheets.json["materials"];
  std::vector<std::string> warnings;
  const gltf::ShownMaterials shown = gltf::shownMaterials(gltf::materialsOf(changed, warnings));
  CHECK(warnings.empty());
  REQUIRE(shown.materials.size() == 2);
  REQUIRE(shown.images.size() == 1);
  CHECK(shown.images[0].rgba.size() == 4);
  CHECK(shown.materials[0].material.baseColorTexture.image == -1);
  CHECK(shown.materials[0].baseColorSet == 0);
  CHECK(shown.materials[0].emissiveSet == 2);
  CHECK(shown.materials[1].material.baseColorTexture.image == 0);
  CHECK(shown.materials[1].baseColorSet == 1);
  CHECK(shown.materials[1].emissiveSet == 1); // where it has none, as the colour's
  CHECK(shown.materials[1].material.unlit);
  CHECK_FALSE(shown.materials[0].material.unlit);
}
