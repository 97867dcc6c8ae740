#include <regex>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/support/core/compressed_files.h"
#include "tests/support/core/contents_text.h"
#include "tests/support/core/foreign_text.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/recorded.h"
#include "tests/support/row.h"

using namespace stretch;
using gltf::Json;
using test::contentsText;
using test::GlbBuilder;

namespace {

constexpr double recordTolerance = 1e-3;

// The packer rounds normals into bytes as the processor does: their sums are of one machine.
std::string withoutNormals(const std::string& text) {
  return std::regex_replace(text, std::regex("normals (\\d+) : [-0-9.]+"), "normals $1");
}

std::string foreignText(const std::string& title, const std::string& text) {
  const test::TemporaryFolder folder;
  return contentsText(title, gltf::load(folder.write("character.data", text), gltf::Tolerance::warn));
}

/// Some of the numbers in a text are others; numbers with a point, so that counts stay.
std::string withOtherNumbers(std::string text, test::Row& row) {
  std::vector<std::pair<std::size_t, std::size_t>> numbers;
  for (std::size_t at = text.find_first_of("0123456789"); at != std::string::npos;
       at = text.find_first_of("0123456789", at)) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", at), text.size());
    const std::string number = text.substr(at, end - at);
    const bool stands = at > 0 && (text[at - 1] == ' ' || text[at - 1] == ',' || text[at - 1] == '-');
    if (stands && number.find('.') != std::string::npos && number.back() != '.') {
      numbers.emplace_back(at, end - at);
    }
    at = end;
  }
  for (int changes = 0; changes < 3 && !numbers.empty(); ++changes) {
    const auto& [at, length] = row.oneOf(numbers);
    const std::string other =
        fmt::format("{:.{}f}", row.between(0.0, 9.0), std::max<std::size_t>(length, 3) - 2);
    text.replace(at, length, other.substr(0, length));
  }
  return text;
}

} // namespace

TEST_CASE("All that is read of files, packed and plain, is as it was looked at") {
  const GlbBuilder tube = test::tubeBuilder();
  std::string text = contentsText("arm", test::loadBytes(test::armBuilder().bytes()));
  text += contentsText("sheets", test::loadBytes(test::twoSheets().bytes()));
  text += contentsText("tube", test::loadBytes(tube.bytes()));
  for (const test::Filters filters : {test::Filters::none, test::Filters::all}) {
    text += withoutNormals(
        contentsText("tube, packed views", test::loadBytes(test::packedByMeshopt(tube, filters).bytes())));
  }
  for (const test::DracoMethod method : {test::DracoMethod::sequential, test::DracoMethod::edgebreaker}) {
    text += contentsText("tube, packed mesh", test::loadBytes(test::packedByDraco(tube, method).bytes()));
  }
  GlbBuilder materials = test::twoSheets();
  materials.json["materials"] = Json::parse(R"([{"name": "cloth", "pbrMetallicRoughness":
      {"baseColorFactor": [0.2, 0.4, 0.6, 0.8], "baseColorTexture": {"index": 0, "texCoord": 1, "extensions":
      {"KHR_texture_transform": {"offset": [0.1, 0.2], "rotation": 0.5, "scale": [2, 3]}}}},
      "emissiveFactor": [0.1, 0.2, 0.3], "emissiveTexture": {"index": 0}, "doubleSided": true,
      "alphaMode": "BLEND", "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}},
      {"name": "glass", "extensions": {"KHR_materials_pbrSpecularGlossiness":
      {"diffuseFactor": [0.9, 0.1, 0.2, 0.5], "diffuseTexture": {"index": 0}}}, "alphaMode": "MASK"}])");
  materials.json["samplers"] =
      Json::parse(R"([{"magFilter": 9728, "minFilter": 9728, "wrapS": 33071, "wrapT": 33648}])");
  materials.json["textures"] = Json::parse(R"([{"source": 0, "sampler": 0}])");
  text += contentsText("sheets of other cloth", test::loadBytes(materials.bytes(), gltf::Tolerance::warn));
  GlbBuilder posed = test::armBuilder();
  posed.json["nodes"][1]["rotation"] = {0.5, 0.5, 0.5, 0.5};
  posed.json["nodes"][1]["scale"] = {1, 2, -1};
  posed.json["nodes"][3]["matrix"] = {0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 3, 0, 1, 2, 3, 1};
  for (const char* const part : {"translation", "rotation", "scale"}) {
    posed.json["nodes"][3].erase(part);
  }
  text += contentsText("arm in a pose", test::loadBytes(posed.bytes(), gltf::Tolerance::warn));
  test::compareWithRecord("contents-of-files", text, recordTolerance);
}

TEST_CASE("All that is read of files of other programs is as it was looked at") {
  std::string text;
  for (const auto& [said, held, unit] :
       {std::tuple(3, 3, 1.0), {3, 5, 1.0}, {9, 9, 0.01}, {1, 1, 0.2}, {30, 30, 2.54}}) {
    text += foreignText(fmt::format("BVH {} {} {}", said, held, unit), test::personBvh(said, held, unit));
  }
  for (const int inherits : {0, 1, 2}) {
    for (const bool pivots : {false, true}) {
      test::FbxText bones;
      bones.childInherits = inherits;
      bones.upperPivots = pivots;
      bones.lowerPivots = inherits != 1;
      bones.upperScale = pivots ? 2.0 : 1.0;
      bones.upperStretch = inherits == 2 ? 1.5 : 1.0;
      bones.isZUp = inherits == 0;
      bones.centimetresOfUnit = pivots ? 1.0 : 2.54;
      text += foreignText(fmt::format("FBX {} {}", inherits, pivots), test::twoBonesFbx(bones));
    }
  }
  text += foreignText("Collada", test::postCollada());
  test::Row row(17);
  for (int i = 0; i < 12; ++i) {
    text +=
        foreignText(fmt::format("BVH of other numbers {}", i), withOtherNumbers(test::personBvh(4, 4), row));
    text += foreignText(fmt::format("FBX of other numbers {}", i),
                        withOtherNumbers(test::twoBonesFbx({.upperPivots = i % 2 == 0}), row));
    text += foreignText(fmt::format("Collada of other numbers {}", i),
                        withOtherNumbers(test::postCollada(), row));
  }
  test::compareWithRecord("contents-of-foreign-files", text, recordTolerance);
}
