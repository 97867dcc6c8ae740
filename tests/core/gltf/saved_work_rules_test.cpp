// What counts as a change of a file that holds work, and where the work finds its place in it.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/patch/saved_work.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;

namespace {

/// A source whose extras hold every kind of value.
gltf::Source sourceOf(const Json& extras = Json::parse(R"({"texts": ["ab", "c", ""], "numbers": [1, 2.5, 0],
                                                           "flags": [true, false, null],
                                                           "inner": {"a": {"b": 1}, "c": []}})")) {
  gltf::Source source = *test::loaded(test::armBuilder()).source;
  (*source.json)["extras"] = extras;
  return source;
}

gltf::Source withWork(const gltf::Source& source) {
  gltf::Edits edits;
  edits.work = Json{{"trails", 3}};
  const Result<gltf::Source> made = gltf::patched(source, edits);
  REQUIRE(made);
  return *made;
}

struct Given {
  std::optional<gltf::Restored> restored;
  std::string told;
};

Given givenBack(const gltf::Source& saved) {
  gltf::Problems problems;
  Given given{gltf::restoreSource(saved, problems), {}};
  for (const gltf::Problem& problem : problems.list()) {
    given.told += problem.where + ": " + problem.what;
  }
  return given;
}

Json reversed(const Json& json) {
  if (!json.is_object()) {
    return json;
  }
  std::vector<std::pair<std::string, Json>> members;
  for (const auto& [key, value] : json.items()) {
    members.insert(members.begin(), {key, reversed(value)});
  }
  Json other = Json::object();
  for (const auto& [key, value] : members) {
    other[key] = value;
  }
  return other;
}

constexpr const char* isChanged =
    "extras: another program changed the file since it was saved; opened as an ordinary file";

} // namespace

TEST_CASE(
    "A file with work gives its source and the work back, whatever order and spelling its values have") {
  const gltf::Source source = sourceOf();
  const gltf::Source saved = withWork(source);
  REQUIRE((*saved.json)["extras"]["stretch_engine"]["work"] == Json{{"trails", 3}});
  const auto check = [&](const gltf::Source& file, const Json& wanted) {
    const Given given = givenBack(file);
    CHECK(given.told.empty());
    REQUIRE(given.restored);
    CHECK(*given.restored->source.json == wanted);
    CHECK(given.restored->source.buffers == source.buffers);
    CHECK(given.restored->source.hasBinaryChunk == source.hasBinaryChunk);
    CHECK(given.restored->work == Json{{"trails", 3}});
    CHECK(given.restored->added.empty());
  };
  check(saved, source.json);
  gltf::Source other = saved;
  Json& extras = (*other.json)["extras"];
  for (const char* const key : {"inner", "texts"}) { // last ones first
    const Json value = extras[key];
    extras.erase(key);
    extras[key] = reversed(value);
  }
  extras["numbers"] = {1.0, 2.5, -0.0};
  Json wanted = source.json;
  wanted["extras"] = extras;
  wanted["extras"].erase("stretch_engine");
  check(other, wanted);
}

TEST_CASE("Any other value in a file with work is a change, and so is any byte that its buffers have") {
  const gltf::Source saved = withWork(sourceOf());
  const std::vector<std::function<void(Json&)>> changes{
      [](Json& extras) {
        extras["texts"] = {"a", "bc", ""};
      },
      [](Json& extras) {
        extras["texts"] = {"ab", "", "c"};
      },
      [](Json& extras) {
        extras["texts"] = {"ab", "c"};
      },
      [](Json& extras) {
        extras["texts"] = {"ab", "c", "d"};
      },
      [](Json& extras) {
        extras["numbers"] = {2.5, 1, 0};
      },
      [](Json& extras) {
        extras["numbers"] = {1, 2.5, 1};
      },
      [](Json& extras) {
        extras["flags"] = {true, true, nullptr};
      },
      [](Json& extras) {
        extras["flags"] = {true, nullptr, false};
      },
      [](Json& extras) {
        extras["inner"]["a"] = {{"c", 1}};
      },
      [](Json& extras) { extras["inner"]["c"] = Json::object(); },
      [](Json& extras) {
        extras["inner"] = {{"a", {{"b", 1}, {"c", Json::array()}}}};
      },
      [](Json& extras) { extras.erase("flags"); },
      [](Json& extras) { extras["more"] = 1; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CAPTURE(i);
    gltf::Source other = saved;
    changes[i]((*other.json)["extras"]);
    const Given given = givenBack(other);
    CHECK_FALSE(given.restored);
    CHECK(given.told == isChanged);
  }
  const std::size_t last = saved.buffers[0].size() - 1;
  for (const std::size_t byte : {std::size_t{0}, std::size_t{1}, last / 2}) {
    gltf::Source other = saved;
    other.buffers[0][byte] ^= 1U;
    CHECK(givenBack(other).told == isChanged);
  }
  gltf::Source without = saved;
  without.buffers.clear();
  CHECK(givenBack(without).told == isChanged);
}

TEST_CASE("Without work in it, or with that of another version, a file is an ordinary one") {
  const gltf::Source plain = sourceOf();
  CHECK_FALSE(givenBack(plain).restored);
  CHECK(givenBack(plain).told.empty());
  for (const int version : {0, 2}) {
    gltf::Source saved = withWork(plain);
    (*saved.json)["extras"]["stretch_engine"]["version"] = version;
    CHECK_FALSE(givenBack(saved).restored);
    CHECK(givenBack(saved).told ==
          "extras: holds work of another version of this program; opened as an ordinary file");
  }
  gltf::Source saved = withWork(plain);
  (*saved.json)["extras"]["stretch_engine"].erase("restore"); // of another program by that name
  CHECK_FALSE(givenBack(saved).restored);
  CHECK(givenBack(saved).told.empty());
}

TEST_CASE(
    "Work stands in the extras of the root, in those of the asset where these are no object, or nowhere") {
  gltf::Source source = sourceOf(Json::array({1, 2}));
  const gltf::Source saved = withWork(source);
  CHECK((*saved.json)["extras"] == Json::array({1, 2}));
  CHECK((*saved.json)["asset"]["extras"].contains("stretch_engine"));
  const Given given = givenBack(saved);
  REQUIRE(given.restored);
  CHECK(given.restored->source.json == source.json);
  (*source.json)["asset"]["extras"] = "text";
  gltf::Edits edits;
  edits.work = Json{{"trails", 3}};
  CHECK_THAT(test::refusal(gltf::patched(source, edits)),
             Catch::Contains("its extras are no objects, so the work finds no place in it"));
}

TEST_CASE("A buffer that stands in the text of a file is kept once, and comes back in its own letters") {
  const test::TemporaryFolder folder;
  for (const char* const kind :
       {"data:application/octet-stream;base64,", "data:application/gltf-buffer;base64,"}) {
    test::armBuilder().write(folder / "arm.glb");
    const gltf::Loaded arm = gltf::load(folder / "arm.glb").value();
    gltf::Source source = *arm.source;
    const gltf::Bytes bytes = source.buffers[0];
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text(kind);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      const unsigned b0 = bytes[i];
      const unsigned b1 = i + 1 < bytes.size() ? bytes[i + 1] : 0;
      const unsigned b2 = i + 2 < bytes.size() ? bytes[i + 2] : 0;
      text += letters[b0 >> 2U];
      text += letters[((b0 & 3U) << 4U) | (b1 >> 4U)];
      text += i + 1 < bytes.size() ? letters[((b1 & 15U) << 2U) | (b2 >> 6U)] : '=';
      text += i + 2 < bytes.size() ? letters[b2 & 63U] : '=';
    }
    source.hasBinaryChunk = false;
    (*source.json)["buffers"][0]["uri"] = text;
    const gltf::Source saved = withWork(source);
    const Json& record = (*saved.json)["extras"]["stretch_engine"]["restore"]["buffers"];
    CHECK(record["first"]["embedded"] == true);
    CHECK(record["first"]["json"]["uri"] == kind);
    CHECK(record["first"]["bytes"] == bytes.size());
    CHECK(record["count"] == 1);
    const Given given = givenBack(saved);
    REQUIRE(given.restored);
    CHECK((*given.restored->source.json)["buffers"][0]["uri"] == text);
    CHECK(given.restored->source.buffers == source.buffers);
  }
}
