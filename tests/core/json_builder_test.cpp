#include <random>
#include <string>

#include <catch2/catch.hpp>

#include "core/gltf/json/json_builder.h"

using namespace stretch;
using namespace stretch::gltf;

namespace {

Json built(std::string_view text) {
  Json tree;
  REQUIRE_FALSE(buildJson(text, tree));
  return tree;
}

// A tree of all kinds of values, objects of up to 40 members among them.
Json randomTree(std::mt19937& random, int depth) {
  const auto upTo = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most + 1)); };
  switch (depth == 0 ? upTo(4) : upTo(6)) {
  case 0:
    return nullptr;
  case 1:
    return upTo(1) == 1;
  case 2:
    return upTo(1000) - 500;
  case 3:
    return upTo(1000) / 7.0;
  case 4:
    return std::string(static_cast<std::size_t>(upTo(20)), 'a') + "\"\\\n\u00e9";
  case 5: {
    Json list = Json::array();
    for (int left = upTo(9); left > 0; --left) {
      list.push_back(randomTree(random, depth - 1));
    }
    return list;
  }
  default: {
    Json object = Json::object();
    for (int left = upTo(40); left > 0; --left) {
      object["key " + std::to_string(upTo(60))] = randomTree(random, depth - 1);
    }
    return object;
  }
  }
}

} // namespace

TEST_CASE("A tree is built as the library parses it, order of keys included") {
  std::mt19937 random(20);
  for (int i = 0; i < 300; ++i) {
    const std::string text = randomTree(random, 4).dump(i % 3 - 1);
    CHECK(built(text).dump() == Json::parse(text).dump());
  }
}

TEST_CASE(
    "Data that stand in a text as long strings are built as any other string, and so are errors after them") {
  const std::string data = "data:application/octet-stream;base64," + std::string((1 << 20) + 5, 'A');
  const std::string escaped = "say \"" + data + "\" or";
  const std::string mark = GENERATE("", "data:taken-out", "data:taken-out by hand");
  const Json tree = {{"a", {data, 1, escaped}}, {"b", mark}, {"c", data + "end"}, {data, "data:short"}};
  const std::string text = tree.dump(GENERATE(-1, 2));
  const Json read = built(text);
  CHECK((read == tree)); // too long to be shown
  CHECK((read.dump() == Json::parse(text).dump()));
  Json broken;
  const std::string cut = text.substr(0, text.size() - 1);
  const auto failure = buildJson(cut, broken);
  REQUIRE(failure);
  CHECK(failure->byte == cut.size() + 1);
}

TEST_CASE("A string that says what a mark says, in other letters, takes nothing from data beside it") {
  const std::string data = "data:application/octet-stream;base64," + std::string((1 << 20) + 5, 'A');
  const std::string text = R"({"a":"\u0064ata:taken-out","b":")" + data + "\"}";
  const Json read = built(text);
  CHECK(read.at("a") == "data:taken-out");
  CHECK((read.at("b") == data));
}

TEST_CASE("Of two members with one key stay the first place and the last value") {
  CHECK(built(R"({"a":1,"b":2,"a":{"c":3}})").dump() == R"({"a":{"c":3},"b":2})");
}

TEST_CASE("An object of very many members is read in the time of its length") {
  std::string text = "{";
  constexpr int members = 300000; // looking through all of them for each would take a minute
  for (int i = 0; i < members; ++i) {
    text += "\"key " + std::to_string(i) + "\":" + std::to_string(i) + ",";
  }
  const Json tree = built(text + R"("key 100":"again"})");
  REQUIRE(tree.size() == members);
  const Json::object_t::Container& object = tree.get_ref<const Json::object_t&>();
  CHECK(object[100].second == "again");
  CHECK(object[members - 1].second == members - 1);
}

TEST_CASE("What the library refuses is refused at the same byte") {
  for (const char* text :
       {"", "{", "[1,", "{\"a\":1}}", "{\"a\" 1}", "[1 2]", "nul", "{\"a\":\"\xFF\"}", "[1,]", "\"a"}) {
    CAPTURE(text);
    Json tree;
    const auto failure = buildJson(text, tree);
    REQUIRE(failure);
    CHECK_FALSE(failure->isOutOfRange);
    try {
      const Json taken = Json::parse(text);
      FAIL("the library takes it: " << taken);
    } catch (const Json::parse_error& expected) {
      CHECK(failure->byte == expected.byte);
    }
  }
}

TEST_CASE("A number beyond double precision is told as such") {
  Json tree;
  const auto failure = buildJson("[1, 1e999]", tree);
  REQUIRE(failure);
  CHECK(failure->isOutOfRange);
}

TEST_CASE("Room for members keeps them") {
  Json object = {{"a", {1, 2}}, {"b", "text"}};
  const std::string before = object.dump();
  reserveMembers(object.get_ref<Json::object_t&>(), 20);
  CHECK(object.dump() == before);
  CHECK(object.get_ref<const Json::object_t&>().capacity() >= 20);
}
