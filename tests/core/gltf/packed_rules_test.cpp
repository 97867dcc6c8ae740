// What data packed by meshopt may say of themselves: every mode with every stride and every filter.
#include <algorithm>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/packed/meshopt_view.h"
#include "core/gltf/source/plain_source.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;

namespace {

const std::vector<std::uint8_t> noise(200, 0x5A); // nothing that decodes

std::string complaintOf(const std::string& mode, std::uint64_t stride, const std::string& filter,
                        std::uint64_t count = 6) {
  const std::string line = test::refusal(gltf::decodeMeshopt({noise, count, stride, mode, filter}));
  CHECK(line.ends_with("; export it again"));
  return line.substr(0, line.find(';'));
}

bool isIn(std::uint64_t stride, std::initializer_list<std::uint64_t> allowed) {
  return std::ranges::find(allowed, stride) != allowed.end();
}

const std::string broken = "holds compressed data that cannot be decoded";

} // namespace

TEST_CASE("Each mode has its strides, and each filter those that its elements can have") {
  for (const std::string mode : {"ATTRIBUTES", "TRIANGLES", "INDICES"}) {
    for (const std::string filter : {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "BLUR"}) {
      for (const std::uint64_t stride : {0U, 1U, 2U, 3U, 4U, 6U, 8U, 12U, 16U, 252U, 256U, 260U}) {
        const bool areAttributes = mode == "ATTRIBUTES";
        const bool hasStride =
            areAttributes ? stride > 0 && stride % 4 == 0 && stride <= 256 : isIn(stride, {2, 4});
        const bool hasFilter =
            filter == "NONE" ||
            (areAttributes && ((filter == "OCTAHEDRAL" && isIn(stride, {4, 8})) ||
                               (filter == "QUATERNION" && stride == 8) || filter == "EXPONENTIAL"));
        CAPTURE(mode, filter, stride);
        CHECK(complaintOf(mode, stride, filter) ==
              (!hasStride ? "has a stride of " + std::to_string(stride) + " bytes, which its mode cannot have"
               : !hasFilter ? "has the filter '" + filter + "', which its elements cannot have"
                            : broken));
      }
    }
  }
  CHECK(complaintOf("WAVELETS", 4, "NONE") == "has the mode 'WAVELETS', which is not known");
  CHECK(complaintOf(std::string(60, 'M'), 4, "NONE") ==
        "has the mode '" + std::string(40, 'M') + "', which is not known");
  CHECK(complaintOf("ATTRIBUTES", 4, std::string(60, 'F')) ==
        "has the filter '" + std::string(40, 'F') + "', which its elements cannot have");
}

TEST_CASE("Triangles are whole, and of each byte come no more than 64") {
  CHECK(complaintOf("TRIANGLES", 4, "NONE", 7) == "has 7 indices, which are no whole triangles");
  CHECK(complaintOf("INDICES", 4, "NONE", 7) == broken);
  const auto tooMany = [](std::uint64_t count) {
    return "says " + std::to_string(count) + " elements, which its 200 bytes cannot hold";
  };
  CHECK(complaintOf("ATTRIBUTES", 4, "NONE", 0) == tooMany(0));
  CHECK(complaintOf("ATTRIBUTES", 4, "NONE", 3200) == broken); // 200 bytes of 64
  CHECK(complaintOf("ATTRIBUTES", 4, "NONE", 3201) == tooMany(3201));
  CHECK(complaintOf("ATTRIBUTES", 256, "NONE", 50) == broken);
  CHECK(complaintOf("ATTRIBUTES", 256, "NONE", 51) == tooMany(51));
  CHECK(complaintOf("ATTRIBUTES", 4, "NONE", std::uint64_t{1} << 62U) == tooMany(std::uint64_t{1} << 62U));
}

TEST_CASE("What other readers are given in the place of packed data lies within its buffer") {
  const auto toldOf = [](std::size_t offset, std::size_t length) {
    gltf::Source source;
    Json json = Json::parse(R"({"buffers": [{"byteLength": 20}, {"byteLength": 200}], "bufferViews": [
        {"buffer": 0, "extensions": {"EXT_meshopt_compression": {
            "buffer": 1, "byteLength": 200, "count": 2, "byteStride": 4, "mode": "ATTRIBUTES"}}}]})");
    json["bufferViews"][0]["byteOffset"] = offset;
    json["bufferViews"][0]["byteLength"] = length;
    source.json = json;
    source.buffers = {std::vector<std::uint8_t>(20), noise};
    gltf::Problems problems;
    (void)gltf::plainSource(source, problems);
    return problems.firstError().line();
  };
  const std::string past =
      "bufferViews[0]: reaches past the end of its buffer; repair the file or export it again";
  const std::string undecoded =
      "bufferViews[0].extensions.EXT_meshopt_compression: " + broken + "; export it again";
  CHECK(toldOf(12, 8) == undecoded);
  CHECK(toldOf(13, 8) == past);
  CHECK(toldOf(12, 9) == past);
  CHECK(toldOf(0, 21) == past);
  CHECK(toldOf(0, 20) == undecoded);
}
