#include <map>
#include <numeric>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/support/core/glb_builder.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/recorded.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;
using test::GlbBuilder;

namespace {

/// What a file is read as: its problems, and where it can be opened what it holds.
std::string readText(const GlbBuilder& glb) {
  const Result<gltf::Loaded> file = test::loadBytes(glb.bytes());
  if (!file) {
    return "   refused: " + test::refusal(file) + "\n";
  }
  std::string text;
  for (const std::string& warning : file->warnings) {
    text += "   warns: " + warning + "\n";
  }
  Vec3 places(0.0);
  std::size_t vertices = 0;
  for (const Mesh& mesh : file->scene->meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      vertices += primitive.positions.size();
      for (const auto& position : primitive.positions) {
        places += Vec3(position);
      }
      text += fmt::format(
          "   {} indices , {} normals , {} colours , {} {} texture places , {} targets , material {}\n",
          primitive.indices.size(), primitive.normals.size(), primitive.colors.size(),
          primitive.texCoords.size(), primitive.emissiveTexCoords.size(), primitive.morphTargets.size(),
          primitive.material);
    }
  }
  text += fmt::format("   {} nodes , {} skins , {} vertices at {:.4f} {:.4f} {:.4f} , {} images\n",
                      file->scene->nodes.size(), file->scene->skins.size(), vertices, places.x, places.y,
                      places.z, file->scene->images.size());
  for (const Clip& clip : file->clips) {
    text += fmt::format("   clip {} , {:.4f} to {:.4f} at {:.2f} , {} tracks\n", clip.name, clip.startSeconds,
                        clip.endSeconds, clip.framesPerSecond, clip.tracks.size());
  }
  for (const Material& material : file->scene->materials) {
    text += fmt::format("   material {:.3f} {:.3f} {:.3f} , emits {:.3f} , textures {} {} , alpha {} {:.2f} "
                        ", both sides {} , unlit {}\n",
                        material.baseColor.r, material.baseColor.g, material.baseColor.a, material.emissive.r,
                        material.baseColorTexture.image, material.emissiveTexture.image,
                        static_cast<int>(material.alphaMode), material.alphaCutoff, material.doubleSided,
                        material.unlit);
  }
  return text;
}

/// Each value of the file in turn is gone or another one.
std::string damagesText(const GlbBuilder& whole) {
  std::string text = "whole\n" + readText(whole);
  std::map<std::string, std::string> firstOf{{readText(whole), "whole"}};
  const Json flat = whole.json.flatten();
  for (const auto& [path, value] : flat.items()) {
    const Json::json_pointer at(path);
    for (const Json& other :
         {Json(nullptr), Json(-1), Json(1), Json(7), Json(0.5), Json("text"), Json::array()}) {
      GlbBuilder damaged = whole;
      damaged.json[at] = other;
      const std::string read = readText(damaged);
      const auto [known, isNew] = firstOf.try_emplace(read, path + " " + other.dump());
      text += isNew ? path + " " + other.dump() + "\n" + read : "";
    }
    GlbBuilder without = whole;
    Json& parent = without.json[at.parent_pointer()];
    if (parent.is_object()) {
      parent.erase(at.back());
    } else {
      parent.erase(static_cast<std::size_t>(std::stoul(at.back())));
    }
    const std::string read = readText(without);
    const bool isNew = firstOf.try_emplace(read, path + " gone").second;
    text += isNew ? path + " gone\n" + read : "";
  }
  return text;
}

void compareDamages(const std::string& name, const GlbBuilder& whole) {
  const std::string difference = test::differenceFromRecord(name, damagesText(whole));
  INFO(difference);
  CHECK(difference.empty());
}

} // namespace

TEST_CASE("What is told of a skinned file in which any value is gone or another one is as it was looked at") {
  compareDamages("damaged-arm", test::armBuilder());
}

TEST_CASE(
    "What is told of a textured file in which any value is gone or another one is as it was looked at") {
  compareDamages("damaged-sheets", test::twoSheets());
}

TEST_CASE("What is told of pictures of every kind, there and missing, is as it was looked at") {
  std::string text;
  const std::string red = test::onePixelUri;
  for (const std::string& uri :
       {red, red.substr(0, red.size() - 20), std::string("data:image/png;base64,AAAA"),
        std::string("data:image/png;base64,*"), std::string("data:text/plain,hello"), std::string("data:,"),
        std::string("missing.png"), std::string("../up.png"), std::string("/etc/hostname"),
        std::string("https://pictures.example/red.png"), std::string("a%20b.png"), std::string(),
        std::string("data:image/webp;base64,UklGRgAAAABXRUJQVlA4TAAAAAA="),
        std::string("data:image/jpeg;base64,/9j/4AAQSkZJRgABAQ==")}) {
    text += "picture " + uri + "\n" + readText(test::twoSheets(uri));
  }
  GlbBuilder packed = test::twoSheets();
  const int view = packed.accessor(
      std::vector<std::uint8_t>{'R', 'I', 'F', 'F', 0, 0, 0, 0, 'W', 'E', 'B', 'P', 0, 0, 0, 0}, 5121,
      "SCALAR", 1);
  const Json place = packed.json["accessors"][static_cast<std::size_t>(view)]["bufferView"];
  packed.json["accessors"].erase(static_cast<std::size_t>(view));
  for (const char* const type : {"image/webp", "image/png", "image/ktx2"}) {
    packed.json["images"][0] = {{"bufferView", place}, {"mimeType", type}};
    text += std::string("picture in the buffer, ") + type + "\n" + readText(packed);
  }
  packed.json["images"][0].erase("mimeType");
  text += "picture in the buffer, without a type\n" + readText(packed);
  const std::string difference = test::differenceFromRecord("told-of-pictures", text);
  INFO(difference);
  CHECK(difference.empty());
}
