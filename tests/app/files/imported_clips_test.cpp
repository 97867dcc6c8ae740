// Clips of an autosave that its file lacks: each part that may be broken.
#include "app/files/imported_clips.h"

#include <functional>
#include <string>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

const Document& fileWithClips() {
  const static Document document = test::openedFile(test::posedCharacter);
  return document;
}

Json soundClips() {
  const Json track{{"node", 1},  {"path", "translation"}, {"interpolation", "LINEAR"},
                   {"width", 3}, {"times", {0.0, 1.0}},   {"values", {0, 0, 0, 1, 0, 0}}};
  return Json::array({{{"clip", fileWithClips().clips->size()},
                       {"name", "hop"},
                       {"fps", 24.0},
                       {"tracks", Json::array({track})}}});
}

bool isTaken(const std::function<void(Json&)>& change) {
  Json list = soundClips();
  change(list[0]);
  const Result<Document> read = withImportedClips(fileWithClips(), list);
  if (!read) {
    CHECK(read.error().line().find('\n') == std::string::npos);
  }
  return read.ok();
}

} // namespace

TEST_CASE("A clip that the file lacks is read whole, after those that it has") {
  const Result<Document> read = withImportedClips(fileWithClips(), soundClips());
  REQUIRE(read);
  REQUIRE(read->clips->size() == fileWithClips().clips->size() + 1);
  const Clip& clip = read->clips->back();
  CHECK(clip.name == "hop");
  CHECK(clip.framesPerSecond == 24.0);
  CHECK(clip.endSeconds == 1.0);
  REQUIRE(clip.tracks.size() == 1);
  CHECK(clip.tracks[0]->node == NodeIndex(1));
  CHECK(clip.tracks[0]->values == std::vector<float>{0, 0, 0, 1, 0, 0});
}

TEST_CASE("A clip of an autosave is refused by any part that makes no sense") {
  const auto ofTrack = [](const char* key, const Json& value) {
    return isTaken([&](Json& clip) { clip["tracks"][0][key] = value; });
  };
  const std::size_t nodes = fileWithClips().scene->nodes.size();
  CHECK(ofTrack("node", nodes - 1));
  CHECK_FALSE(ofTrack("node", nodes));
  CHECK_FALSE(ofTrack("node", -1));
  CHECK_FALSE(ofTrack("path", "colour"));
  CHECK_FALSE(ofTrack("interpolation", "WAVY"));
  CHECK_FALSE(ofTrack("times", Json::array()));
  CHECK_FALSE(ofTrack("times", "soon"));
  const auto ofClip = [](const char* key, const Json& value) {
    return isTaken([&](Json& clip) { clip[key] = value; });
  };
  CHECK(ofClip("fps", 12.0));
  CHECK_FALSE(ofClip("fps", 0.0));
  CHECK_FALSE(ofClip("fps", -24.0));
  CHECK_FALSE(ofClip("tracks", Json::array()));
  CHECK_FALSE(ofClip("name", 7));
  CHECK_FALSE(ofClip("clip", fileWithClips().clips->size() + 1)); // One would be missing before it.
  CHECK_FALSE(ofClip("clip", 0));                                 // There stands another one.
  CHECK_FALSE(isTaken([](Json& clip) { clip.erase("tracks"); }));
}

TEST_CASE("Clips that came from other files are kept whole, and come back one after the other") {
  const std::size_t known = fileWithClips().clips->size();
  Json list = soundClips();
  list.push_back(list[0]);
  list[1]["clip"] = known + 1;
  list[1]["name"] = "skip";
  Json own = list[0]; // One that the file has by now.
  own["clip"] = 0;
  own["name"] = fileWithClips().clips->front().name;
  Json all = Json::array({own, list[0], list[1]});
  const Result<Document> read = withImportedClips(fileWithClips(), all);
  REQUIRE(read);
  REQUIRE(read->clips->size() == known + 2);
  CHECK((*read->clips)[known].name == "hop");
  CHECK((*read->clips)[known + 1].name == "skip");
  CHECK(importedClipsToJson(*read) == list);
  CHECK(importedClipsToJson(fileWithClips()) == Json::array());
  all[2]["clip"] = known; // Two in one place.
  CHECK_FALSE(withImportedClips(fileWithClips(), all));
}
