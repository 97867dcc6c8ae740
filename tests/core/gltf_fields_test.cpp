#include <limits>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/json/json_builder.h"
#include "core/gltf/source/animation_target.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/problems.h"
#include "core/gltf/source/uri.h"

using namespace stretch;
using namespace stretch::gltf;

namespace {

Bytes bytesOf(std::string_view text) {
  return {text.begin(), text.end()};
}

} // namespace

TEST_CASE("A whole number is one that a file may count by: not negative, no fraction, exact") {
  CHECK(wholeNumber(Json(3)) == 3U);
  CHECK(wholeNumber(Json(3.0)) == 3U);
  CHECK(wholeNumber(Json(0)) == 0U);
  CHECK(wholeNumber(Json(9007199254740992.0)) == 9007199254740992U);
  for (const Json& other : {Json(-1), Json(2.5), Json(9007199254740994.0), Json("3"), Json(true),
                            Json(nullptr), Json::array({3})}) {
    CAPTURE(other.dump());
    CHECK_FALSE(wholeNumber(other));
  }
}

TEST_CASE("A property that is missing or of another kind reads as what stands in for it") {
  const Json object = Json::parse(R"({"count": 4, "share": 0.5, "name": "arm", "isLoop": true, "low": -2,
      "numbers": [1, 2.5, -3], "mixed": [1, "2"], "indices": [0, 7, -1, 4294967296], "nested": {"deep": {"x": 8}},
      "large": 2147483648, "texts": ["KHR_a", 3, "KHR_b"]})");
  CHECK(wholeOr(object, "count", 9) == 4);
  CHECK(wholeOr(object, "share", 9) == 9);
  CHECK(wholeOr(object, "gone", 9) == 9);
  CHECK(indexOr(object, "count") == 4);
  CHECK(indexOr(object, "low") == -1);
  CHECK(indexOr(object, "low", 5) == 5);
  CHECK(indexOr(object, "large") == -1);
  CHECK(indexOr(object, "gone") == -1);
  CHECK(numberOr(object, "share", 2.0) == 0.5);
  CHECK(numberOr(object, "name", 2.0) == 2.0);
  CHECK(textOr(object, "name") == "arm");
  CHECK(textOr(object, "count", "other") == "other");
  CHECK(flagOr(object, "isLoop", false));
  CHECK(flagOr(object, "count", true));
  CHECK_FALSE(flagOr(object, "count", false));
  CHECK(numbersOf(object, "numbers") == std::vector<double>{1.0, 2.5, -3.0});
  CHECK(numbersOf(object, "mixed").empty());
  CHECK(numbersOf(object, "count").empty());
  CHECK(indicesOf(object, "indices") == std::vector<int>{0, 7, -1, -1});
  CHECK(sizeOf(object, "numbers") == 3);
  CHECK(sizeOf(object, "name") == 0);
  CHECK(element(object, "numbers", 1) == 2.5);
  CHECK(listsText(object, "texts", "KHR_b"));
  CHECK_FALSE(listsText(object, "texts", "KHR"));
  CHECK_FALSE(listsText(object, "name", "arm"));
  REQUIRE(findPath(object, {"nested", "deep", "x"}) != nullptr);
  CHECK(*findPath(object, {"nested", "deep", "x"}) == 8);
  CHECK(findPath(object, {"nested", "x"}) == nullptr);
  CHECK(findPath(object, {"count", "x"}) == nullptr);
  CHECK(find(Json(3), "x") == nullptr);
}

TEST_CASE("Problems are told once for each kind, errors first, and broken files cannot fill the memory") {
  Problems problems;
  CHECK_FALSE(problems.hasErrors());
  CHECK_FALSE(problems.hasViolations());
  problems.warning("nodes[0]", "is odd");
  problems.warning("nodes[3]", "is odd");
  problems.warning("", "stands for the whole");
  CHECK_FALSE(problems.hasViolations());
  problems.violation("meshes[1]", "breaks a rule", "it is mended");
  problems.violation("meshes[2]", "breaks another");
  CHECK(problems.hasViolations());
  CHECK_FALSE(problems.hasErrors());
  CHECK(problems.warningLines() ==
        std::vector<std::string>{"nodes[0] and 1 more: is odd", "stands for the whole",
                                 "meshes[1]: breaks a rule; it is mended", "meshes[2]: breaks another"});
  CHECK(problems.firstError().what == "breaks a rule");
  CHECK(problems.firstError().where == "meshes[1]");
  CHECK(problems.firstError().remedy.find("--tolerant") != std::string::npos);
  problems.error("skins[0]", "cannot be read");
  problems.error("skins[1]", "cannot either", "take another one");
  CHECK(problems.hasErrors());
  CHECK(problems.firstError().where == "skins[0]");
  CHECK(problems.firstError().remedy == "repair the file or export it again");
  CHECK(problems.warningLines().size() == 4); // errors are no warnings
  Problems all;
  all.error("files[0]", "was first", "look there");
  all.add(problems);
  CHECK(all.list().size() == 1 + problems.list().size());
  CHECK(all.list()[1] == problems.list()[0]);
  CHECK(all.list().back() == problems.list().back());
  CHECK(all.hasViolations());
  CHECK(all.firstError().remedy == "look there");
  Problems others;
  others.add(problems);
  CHECK(others.hasErrors());
  CHECK(at("nodes", 12) == "nodes[12]");
}

TEST_CASE("Of very many problems so many are kept as fit, the first error always") {
  Problems problems;
  for (std::size_t i = 0; i < Problems::capacity + 5; ++i) {
    problems.warning("nodes", "is odd");
    problems.violation("meshes", "breaks a rule");
  }
  CHECK(problems.list().size() == Problems::capacity);
  problems.error("skins[0]", "cannot be read");
  CHECK(problems.list().size() == Problems::capacity + 1);
  CHECK(problems.firstError().where == "skins[0]");
  problems.error("skins[1]", "cannot be read");
  CHECK(problems.list().size() == Problems::capacity + 1);
  Problems again;
  again.add(problems);
  again.add(problems);
  CHECK(again.list().size() == Problems::capacity + 1);
}

TEST_CASE("The first key that an object has twice is told by its place") {
  CHECK_FALSE(repeatedKey(R"({"a": 1, "b": {"a": 2}, "c": [{"a": 1}, {"a": 2}]})"));
  CHECK(repeatedKey(R"({"a": 1, "a": 2})") == "a");
  CHECK(repeatedKey(R"({"trails": [{"scale": 1}, {"scale": 1, "limb": {"x": 1, "x": 2}}]})") ==
        "trails[1].limb.x");
  CHECK(repeatedKey(R"({"a": 1, "a": 2, "b": 1, "b": 2})") == "a");
  CHECK(repeatedKey(R"([[1], [2, {"k": 0, "k": 1}]])") == "[1][1].k");
  CHECK_FALSE(repeatedKey("{\"a\""));
}

TEST_CASE("Two documents are the same where their values are, a copy stays when the other changes") {
  const JsonDocument one(Json::parse(R"({"a": [1, 2]})"));
  JsonDocument copy = one;
  CHECK(copy == one);
  *copy = Json::parse(R"({"a": [1, 3]})");
  CHECK_FALSE(copy == one);
  CHECK(one == Json::parse(R"({"a": [1, 2]})"));
  CHECK_FALSE(one == Json::parse("[]"));
  copy = one;
  CHECK(copy == one);
  CHECK(JsonDocument().isNull());
  CHECK_FALSE(one.isNull());
}

TEST_CASE("Base64 is that of its standard's examples, there and back, and nothing else is read as such") {
  for (const auto& [plain, encoded] : {std::pair("", ""),
                                       {"f", "Zg=="},
                                       {"fo", "Zm8="},
                                       {"foo", "Zm9v"},
                                       {"foob", "Zm9vYg=="},
                                       {"fooba", "Zm9vYmE="},
                                       {"foobar", "Zm9vYmFy"}}) {
    CAPTURE(plain);
    CHECK(encodeBase64(bytesOf(plain)) == encoded);
    const auto read = decodeDataUri(std::string("data:application/octet-stream;base64,") + encoded);
    REQUIRE(read);
    CHECK(read->bytes == bytesOf(plain));
    CHECK(read->mediaType == "application/octet-stream");
  }
  CHECK(encodeBase64(Bytes{0xFB, 0xFF, 0x3E}) == "+/8+");
  CHECK(decodeDataUri("data:;base64,+/8+")->bytes == Bytes{0xFB, 0xFF, 0x3E});
  CHECK(decodeDataUri("data:;base64,Zg")->bytes == bytesOf("f")); // without its padding
  CHECK_FALSE(decodeDataUri("data:;base64,Zm9vY"));
  CHECK_FALSE(decodeDataUri("data:;base64,Zm9-"));
  CHECK_FALSE(decodeDataUri("data:;base64"));
  CHECK_FALSE(decodeDataUri("file.bin"));
  CHECK(decodeDataUri("data:text/plain,a%20b")->bytes == bytesOf("a b"));
  CHECK(isDataUri("data:,"));
  CHECK_FALSE(isDataUri("dat:,"));
}

TEST_CASE("A name of a file stands for a path beside the file alone, its escapes taken back") {
  CHECK(relativePath("a%20b.bin") == std::filesystem::path("a b.bin"));
  CHECK(relativePath("a%2Fb.bin") == std::filesystem::path("a/b.bin"));
  CHECK(relativePath("a%4a%4A.bin") == std::filesystem::path("aJJ.bin"));
  CHECK(relativePath("100%.bin") == std::filesystem::path("100%.bin"));
  CHECK(relativePath("a%2") == std::filesystem::path("a%2"));
  CHECK(relativePath("a%g0b") == std::filesystem::path("a%g0b"));
  CHECK(relativePath("folder/a:b.bin") == std::filesystem::path("folder/a:b.bin"));
  for (const char* const other : {"", "http://host/a.bin", "c:a.bin", "/a.bin", "folder/", "a%00b"}) {
    CAPTURE(other);
    CHECK_FALSE(relativePath(other));
  }
  CHECK(percentEncoded("a b#%.bin") == "a%20b%23%25.bin");
  CHECK(percentEncoded("-._~()!@+,Az09") == "-._~()!@+,Az09");
  CHECK(percentEncoded("\xC3\xA9") == "%C3%A9");
  CHECK(escapesFolder("../a.bin"));
  CHECK(escapesFolder("folder/../../a.bin"));
  CHECK(escapesFolder("/a.bin"));
  CHECK_FALSE(escapesFolder("folder/../a.bin"));
  CHECK_FALSE(escapesFolder("..a.bin"));
}

TEST_CASE("A channel drives a part of a node, by its names or by a pointer, and a pointer elsewhere none") {
  const auto pointed = [](const char* pointer) {
    return animationTarget(
        {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}});
  };
  const AnimationTarget plain = animationTarget({{"node", 3}, {"path", "rotation"}});
  CHECK(plain.node == NodeIndex(3));
  CHECK(plain.path == "rotation");
  CHECK_FALSE(plain.isPointer);
  for (const std::string property : {"translation", "rotation", "scale", "weights"}) {
    for (const int node : {0, 7}) {
      const AnimationTarget target = pointed(("/nodes/" + std::to_string(node) + "/" + property).c_str());
      CHECK(target.node == NodeIndex(node));
      CHECK(target.path == property);
      CHECK(target.isPointer);
    }
  }
  for (const char* const other : {"/nodes/3", "/nodes/3/", "/nodes/3/mesh", "/nodes/-1/scale",
                                  "/nodes/x/scale", "/nodes//scale", "/materials/0/alphaCutoff",
                                  "/meshes/0/weights", "nodes/3/scale", "", "/materials", "/x/3/rotation"}) {
    CAPTURE(other);
    CHECK_FALSE(pointed(other).node.exists());
    CHECK(pointed(other).path == other);
    CHECK(pointed(other).isPointer);
  }
  const AnimationTarget without = animationTarget({{"path", "pointer"}, {"node", 2}});
  CHECK(without.path == "pointer");
  CHECK_FALSE(without.isPointer);
}

TEST_CASE("A name is shown in one line, whatever stands in it") {
  const auto shown = [](const std::string& name) { return gltf::shownName({{"name", name}}); };
  CHECK(shown("Left\nArm\x1b[2J\t\x7f") == "Left Arm [2J  ");
  CHECK(shown("a\xC2\x9B"
              "b\xC2") == "a b\xC2"); // U+009B, and a character that is cut short
  CHECK(shown("Бедро\xC2\xA0腕") == "Бедро\xC2\xA0腕");
  CHECK(gltf::shownName({{"name", 3}}).empty());
}
