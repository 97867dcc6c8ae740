// Where a key stands that JSON text has twice, and long texts that stand beside short ones.
#include <string>

#include <catch2/catch.hpp>

#include "core/gltf/json/json_builder.h"

using namespace stretch;
using namespace stretch::gltf;

namespace {

Json built(const std::string& text) {
  Json tree;
  REQUIRE_FALSE(buildJson(text, tree));
  return tree;
}

std::string manyMembers(int count, const std::string& last) {
  std::string text = "{";
  for (int i = 0; i < count; ++i) {
    text += "\"key" + std::to_string(i) + "\":" + std::to_string(i) + ",";
  }
  return text + last + "}";
}

const std::string longData = "data:application/octet-stream;base64," + std::string((1 << 20) + 5, 'B');

} // namespace

TEST_CASE("A key that comes twice is told by its place, the first of several") {
  CHECK_FALSE(repeatedKey(R"({"a": 1, "b": {"a": 1}, "c": [{"a": 1}, {"a": 1}]})"));
  CHECK(repeatedKey(R"({"a": 1, "a": 2})") == "a");
  CHECK(repeatedKey(R"({"a": {"b": 1, "c": 2, "b": 3}})") == "a.b");
  CHECK(repeatedKey(R"({"trails": [{"scale": 1}, {"scale": 1, "scale": 2}]})") == "trails[1].scale");
  CHECK(repeatedKey(R"({"trails": [{"scale": 1, "scale": 2}, {}]})") == "trails[0].scale");
  CHECK(repeatedKey(R"([[1, 2], [3, {"x": 1, "y": [], "x": 4}]])") == "[1][1].x");
  CHECK(repeatedKey(R"({"a": 1, "b": 2, "b": 3, "a": 4})") == "b");
  CHECK(repeatedKey(R"({"a": {"x": 1, "x": 2}, "b": {"y": 1, "y": 2}})") == "a.x");
  CHECK(repeatedKey(R"({"a": 1, "a": 2, no)") == "a");
  CHECK_FALSE(repeatedKey(R"({"a": 1, no)"));
}

TEST_CASE("In an object of any number of members the second value of a key takes the first one's place") {
  for (const int count : {3, 63, 64, 65, 66, 300}) {
    for (const int which : {0, 1, count / 2, count - 1}) {
      CAPTURE(count, which);
      const std::string key = "key" + std::to_string(which);
      const std::string text =
          manyMembers(count, "\"" + key + "\":\"again\",\"end\":true,\"" + key + "\":-1");
      const Json tree = built(text);
      CHECK(tree.size() == static_cast<std::size_t>(count) + 1);
      CHECK(tree.dump() == Json::parse(text).dump());
      CHECK(tree[key] == -1);
      CHECK(repeatedKey(text) == key);
    }
    CHECK_FALSE(repeatedKey(manyMembers(count, "\"end\":0")));
  }
}

TEST_CASE("Long texts of data are built letter for letter, whatever stands in them or before them") {
  const auto check = [](const std::string& text) {
    CHECK(built(text) == Json::parse(text));
    CHECK(built(text).dump() == Json::parse(text).dump());
  };
  check("[\"" + longData + "\",\"" + longData + "C\",\"data:,short\"]");
  check("{\"" + longData + "\":1,\"b\":\"" + longData + "\"}"); // as a key, too
  check("[\"" + longData + "\\n\"]");
  check("[\"" + longData + "\\u0041\\\\\"]");
  check("[\"" + longData + "\xC3\xA9\"]");
  check("[\"\\\"" + longData + "\"]"); // the quote is one of the text
  check("[\"a\\\"data:" + longData + "\",\"" + longData + "\"]");
  check("[\"" + longData + "\",\"data:taken\\u002dout\"]");
  check("[\"data:taken\\u002dout\",\"" + longData + "\",\"" + longData + "D\"]");
  check("[\"" + longData + "\",\"data:taken-out\"]");
  check("\"" + longData + "\"");
  // Where such a text does not end, or what follows is wrong, the place in the whole text is told.
  for (const std::string& text : {"[\"" + longData, "[\"" + longData + "\"", "[\"" + longData + "\",]"}) {
    Json tree;
    const auto failure = buildJson(text, tree);
    REQUIRE(failure);
    CHECK(failure->byte > longData.size());
    CHECK_FALSE(failure->isOutOfRange);
  }
}
