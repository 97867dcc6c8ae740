#include <map>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/files/saved_work.h"
#include "app/things/place.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/recorded.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

/// Work of every kind on the two punches.
Document worked() {
  Result<Placed> made = place(test::twoPunches(), test::oneOfEach(0, 0.25), Entry::request);
  REQUIRE(made);
  made = place(made->document, test::oneOfEach(1, 0.75), Entry::request);
  REQUIRE(made);
  return made->document;
}

/// What the work becomes: why it is refused, or where it differs from what was asked for.
std::string restoredText(const Json& work) {
  Document document = test::twoPunches();
  const Status restored = restoreWork(work, document);
  if (!restored) {
    return "   refused: " + test::refusal(restored) + "\n";
  }
  const Json again = workOf(document).flatten();
  const Json asked = work.flatten();
  std::string text;
  for (const auto& [path, value] : again.items()) {
    const bool isSame = asked.contains(path) && asked[path] == value;
    text += isSame ? "" : "   is " + path + " " + value.dump() + "\n";
  }
  for (const auto& [path, value] : asked.items()) {
    text += again.contains(path) ? "" : "   lacks " + path + " " + value.dump() + "\n";
  }
  return text.empty() ? "   as asked\n" : text;
}

} // namespace

TEST_CASE("What becomes of saved work in which any value is gone or another one is as it was looked at") {
  const Json whole = workOf(worked());
  std::string text = "whole\n" + restoredText(whole);
  std::map<std::string, std::string> firstOf;
  const Json flat = whole.flatten();
  for (const auto& [path, value] : flat.items()) {
    if (path.starts_with("/limbs")) {
      continue;
    }
    const Json::json_pointer at(path);
    for (const Json& other :
         {Json(nullptr), Json(-1), Json(2), Json(1e9), Json(0.5), Json("text"), Json(true), Json::array()}) {
      Json damaged = whole;
      damaged[at] = other;
      const std::string restored = restoredText(damaged);
      const bool isNew = firstOf.try_emplace(restored, path).second;
      text += isNew ? path + " " + other.dump() + "\n" + restored : "";
    }
    Json without = whole;
    if (Json& parent = without[at.parent_pointer()]; parent.is_object()) {
      parent.erase(at.back());
      const std::string restored = restoredText(without);
      text += firstOf.try_emplace(restored, path).second ? path + " gone\n" + restored : "";
    }
  }
  const std::string difference = test::differenceFromRecord("damaged-work", text);
  INFO(difference);
  CHECK(difference.empty());
}
