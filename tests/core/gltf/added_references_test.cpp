// Everything that a thing of another file refers to by number, wherever it stands: whatever the file has
// already, each reference still finds what it found in the thing.
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/added_parts.h"
#include "core/gltf/source/added_file.h"

using namespace stretch;
using gltf::Json;

namespace {

/// Two entries of each list, each with a name; each kind of reference finds the second one.
Json thingJson() {
  return Json::parse(R"({
    "bufferViews": [{"name": "V0", "buffer": 0, "byteLength": 4},
                    {"name": "V1", "buffer": 0, "byteOffset": 4, "byteLength": 4}],
    "accessors": [{"name": "A0", "bufferView": 0},
                  {"name": "A1", "bufferView": 1,
                   "sparse": {"count": 1, "indices": {"bufferView": 1}, "values": {"bufferView": 0}}}],
    "images": [{"name": "I0", "uri": "data:,"}, {"name": "I1", "bufferView": 1}],
    "samplers": [{"name": "S0"}, {"name": "S1"}],
    "textures": [{"name": "T0", "source": 0},
                 {"name": "T1", "sampler": 1, "source": 1,
                  "extensions": {"EXT_texture_webp": {"source": 1}, "KHR_texture_basisu": {"source": 0}}}],
    "materials": [{"name": "M0"},
                  {"name": "M1", "normalTexture": {"index": 1}, "emissiveTexture": {"index": 0},
                   "pbrMetallicRoughness": {"baseColorTexture": {"index": 1},
                                            "metallicRoughnessTexture": {"index": 0}},
                   "extensions": {"KHR_materials_sheen": {"sheenColorTexture": {"index": 1}}}}],
    "meshes": [{"name": "E0", "primitives": [{"attributes": {"POSITION": 0}}]},
               {"name": "E1", "primitives": [{"attributes": {"POSITION": 0}},
                                             {"attributes": {"POSITION": 1, "NORMAL": 0}, "indices": 1,
                                              "material": 1,
                                              "targets": [{"POSITION": 0}, {"POSITION": 1, "NORMAL": 1}]}]}],
    "nodes": [{"name": "N0", "mesh": 0}, {"name": "N1", "mesh": 1, "children": [0]}, {"name": "N2"}],
    "scenes": [{"nodes": [1, 2]}],
    "extensionsUsed": ["EXT_texture_webp", "KHR_materials_sheen"],
    "extensionsRequired": ["KHR_materials_sheen"]
  })");
}

/// A file with entries of its own in each list, as many of each as of no other one.
Json fileJson() {
  Json json = Json::parse(R"({"scenes": [{"nodes": [0]}, {"nodes": [1]}], "scene": 1,
                              "extensionsUsed": ["KHR_materials_sheen"]})");
  std::size_t count = 1;
  for (const char* const list :
       {"bufferViews", "accessors", "images", "samplers", "textures", "materials", "meshes", "nodes"}) {
    for (std::size_t i = 0; i < count; ++i) {
      json[list].push_back({{"name", "own"}});
    }
    ++count;
  }
  return json;
}

/// Names of what is found along a place of a thing.
class Names {
public:
  explicit Names(const Json& json) : json_(json) {}

  void note(const Json& holder, const char* key, const char* list) {
    if (holder.contains(key)) {
      const auto index = holder[key].get<std::size_t>();
      const Json& entries = json_[list];
      names.push_back(std::string(key) + " " +
                      (index < entries.size() ? entries[index]["name"].get<std::string>() : "nothing"));
    }
  }
  void noteAll(const Json& members, const char* list) {
    for (const auto& [key, value] : members.items()) {
      const Json one = {{key, value}};
      note(one, key.c_str(), list);
    }
  }
  void noteTextures(const Json& json) {
    for (const auto& [key, value] : json.items()) {
      if (key.ends_with("Texture")) {
        note(value, "index", "textures");
      } else if (value.is_structured()) {
        noteTextures(value);
      }
    }
  }

  std::vector<std::string> names;

private:
  const Json& json_;
};

/// All that the entries of a thing refer to, by name, where each list of the thing begins at a place.
std::vector<std::string> referencesIn(const Json& json, const std::map<std::string, std::size_t>& first) {
  Names names(json);
  const auto entry = [&](const char* list, std::size_t i) -> const Json& {
    return json[list][first.at(list) + i];
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& accessor = entry("accessors", i);
    names.note(accessor, "bufferView", "bufferViews");
    if (accessor.contains("sparse")) {
      names.note(accessor["sparse"]["indices"], "bufferView", "bufferViews");
      names.note(accessor["sparse"]["values"], "bufferView", "bufferViews");
    }
    names.note(entry("images", i), "bufferView", "bufferViews");
    const Json& texture = entry("textures", i);
    names.note(texture, "sampler", "samplers");
    names.note(texture, "source", "images");
    const Json extensions = texture.value("extensions", Json::object());
    for (const auto& [key, extension] : extensions.items()) {
      names.note(extension, "source", "images");
    }
    names.noteTextures(entry("materials", i));
    for (const Json& primitive : entry("meshes", i)["primitives"]) {
      names.note(primitive, "indices", "accessors");
      names.note(primitive, "material", "materials");
      names.noteAll(primitive["attributes"], "accessors");
      for (const Json& target : primitive.value("targets", Json::array())) {
        names.noteAll(target, "accessors");
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    names.note(entry("nodes", i), "mesh", "meshes");
    for (const Json& child : entry("nodes", i).value("children", Json::array())) {
      names.note({{"child", child}}, "child", "nodes");
    }
  }
  return names.names;
}

gltf::AddedFile fileOf(const std::string& name, const Json& json, const gltf::Bytes& bytes) {
  gltf::Source thing;
  thing.json = json;
  thing.buffers = {bytes};
  return {name + ".glb",
          name,
          {Vec3(1, 2, 3), Quat(0.8, 0.0, 0.36, 0.48), Vec3(2, 3, 4)},
          std::make_shared<const gltf::Source>(std::move(thing))};
}

std::map<std::string, std::size_t> countsOf(const Json& json) {
  std::map<std::string, std::size_t> counts;
  for (const char* const list :
       {"bufferViews", "accessors", "images", "samplers", "textures", "materials", "meshes", "nodes"}) {
    counts[list] = json.contains(list) ? json[list].size() : 0;
  }
  return counts;
}

} // namespace

TEST_CASE("Whatever a file has, each reference of a thing that is added finds what it found in the thing") {
  const Json thing = thingJson();
  const std::vector<std::string> wanted = referencesIn(thing, countsOf(Json::object()));
  REQUIRE(wanted.size() == 27);
  for (const Json& file : {fileJson(), Json(Json::object())}) {
    gltf::Journal journal(file);
    const std::vector<gltf::AddedFile> files{fileOf("one", thing, {1, 2, 3, 4, 5, 6, 7}),
                                             fileOf("two", thing, {8, 9, 10, 11, 12, 13, 14, 15})};
    const gltf::Bytes bytes = gltf::addFiles(files, 3, 40, journal);
    const Json& both = journal.json();
    std::map<std::string, std::size_t> first = countsOf(file);
    for (std::size_t place = 0; place < 2; ++place) {
      CAPTURE(place, file.size());
      CHECK(referencesIn(both, first) == wanted);
      // Bytes of each begin at whole words.
      for (std::size_t view = 0; view < 2; ++view) {
        const Json& added = both["bufferViews"][first["bufferViews"] + view];
        CHECK(added["buffer"] == 3);
        CHECK(added["byteOffset"] == 40 + 8 * place + 4 * view);
        CHECK(added["byteLength"] == 4);
      }
      const Json& carrier = both["nodes"][first["nodes"] + 3];
      CHECK(carrier["name"] == files[place].name);
      CHECK(carrier["children"] == Json{first["nodes"] + 1, first["nodes"] + 2});
      CHECK(carrier["translation"] == Json{1.0, 2.0, 3.0});
      CHECK(carrier["rotation"] == Json{0.0, 0.36, 0.48, 0.8});
      CHECK(carrier["scale"] == Json{2.0, 3.0, 4.0});
      if (file.contains("scenes")) { // the one that is shown, and no other
        CHECK(both["scenes"][1]["nodes"][1 + place] == first["nodes"] + 3);
        CHECK(both["scenes"][0] == file["scenes"][0]);
      } else {
        CHECK_FALSE(both.contains("scenes"));
      }
      for (auto& [list, begin] : first) {
        begin += list == "nodes" ? 4 : 2;
      }
    }
    CHECK(countsOf(both) == first);
    CHECK(bytes == gltf::Bytes{1, 2, 3, 4, 5, 6, 7, 0, 8, 9, 10, 11, 12, 13, 14, 15});
    CHECK(both["extensionsUsed"].size() == 2);
    CHECK(both["extensionsRequired"] == Json{"KHR_materials_sheen"});
    // All of it can be taken back.
    Json back = both;
    REQUIRE(gltf::takeBack(back, journal.undo()));
    CHECK(back.dump() == file.dump());
  }
}

TEST_CASE("Of several things each is given back with its own bytes, wherever they begin") {
  const Json thing = thingJson();
  const std::vector<gltf::AddedFile> files{fileOf("one", thing, {1, 2, 3, 4, 5, 6, 7, 8, 9}),
                                           fileOf("two", thing, {10, 11, 12, 13, 14, 15, 16, 17}),
                                           fileOf("three", thing, {18, 19, 20, 21, 22, 23, 24, 25, 26, 27})};
  gltf::Journal journal(fileJson());
  gltf::Source saved;
  saved.buffers = {{}, gltf::Bytes(8, 77)};
  const gltf::Bytes bytes = gltf::addFiles(files, 1, 8, journal);
  saved.buffers[1].insert(saved.buffers[1].end(), bytes.begin(), bytes.end());
  const Json record = gltf::addedRecord(files, 1, 8);
  REQUIRE(record.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(record[i]["file"] == files[i].file);
    CHECK(record[i]["byteLength"] == files[i].thing->buffers[0].size());
    CHECK(record[i]["json"] == thing);
    CHECK_FALSE(record[i].contains("children"));
    const auto begin = record[i]["byteOffset"].get<std::size_t>();
    CHECK(begin % 4 == 0);
    const gltf::Bytes& own = files[i].thing->buffers[0];
    CHECK(std::equal(own.begin(), own.end(), saved.buffers[1].begin() + static_cast<std::ptrdiff_t>(begin)));
  }
  // What would lie in a buffer that is not there is left out, and told.
  for (const std::size_t buffer : {2U, 7U}) {
    Json beyond = record;
    for (Json& entry : beyond) {
      entry["buffer"] = buffer;
    }
    gltf::Problems problems;
    CHECK(gltf::addedFromRecord(saved, beyond, problems).empty());
    CHECK(problems.list().size() == 3);
  }
}
