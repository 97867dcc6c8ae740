#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "core/base/file.h"
#include "core/gltf/import/accessor.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "core/math/rotation.h"
#include "core/scene/bind_chains.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

namespace fs = std::filesystem;

constexpr const char* punchFile = STRETCH_SOURCE_DIR "/assets/dummy.glb";

Document openedPunch(const fs::path& path) {
  Result<Document> document = openDocument(path);
  REQUIRE(document);
  return std::move(*document);
}

Document punch(double volume = 1.0) {
  Document document =
      test::withNewTrail(openedPunch(punchFile), {.startFrame = 21.0, .endFrame = 27.0, .scale = 3.0});
  document.trails.front().settings.volume = volume;
  return document;
}

fs::path savedAs(const Document& document, const fs::path& path, const SavedForm& form, bool clean = true) {
  const Status saved = saveDocument(document, path, {.clean = clean, .form = form});
  INFO((saved ? std::string() : saved.error().line()));
  REQUIRE(saved);
  return path;
}

struct Vertex {
  Vec3 place{0.0};
  Vec3 normal{0.0}; // turned by the inverse transpose
};

// A viewer that knows nothing of leaves or corners: nodes by the clip, joints and matrices of the first skin
// and every set of influences as the file has them.
class Viewer {
public:
  explicit Viewer(const fs::path& path) {
    Result<gltf::Loaded> loaded = gltf::loadAsItStands(path);
    REQUIRE(loaded);
    file_ = std::move(*loaded);
    const Json& skin = (*file_.source->json)["skins"][0];
    const std::vector<float> numbers =
        gltf::readFloats(*file_.source, skin["inverseBindMatrices"].get<int>());
    for (std::size_t i = 0; i < skin["joints"].size(); ++i) {
      joints_.emplace_back(skin["joints"][i].get<int>());
      inverseBind_.emplace_back(glm::make_mat4(numbers.data() + 16 * i));
    }
  }

  [[nodiscard]] const Json& json() const { return *file_.source->json; }
  [[nodiscard]] const Scene& scene() const { return *file_.scene; }

  [[nodiscard]] std::vector<Vertex> at(double frame) const {
    const std::vector<Mat4> worlds =
        worldMatrices(scene(), samplePose(scene(), file_.clips[0], frame / 24.0));
    std::vector<Mat4> palette;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      palette.push_back(worlds[stretch::at(joints_[i])] * inverseBind_[i]);
    }
    std::vector<Vertex> all;
    for (const Json& node : json()["nodes"]) {
      for (const Json& primitive :
           node.contains("skin") ? json()["meshes"][node["mesh"].get<int>()]["primitives"] : Json::array()) {
        addSkinned(primitive["attributes"], palette, all);
      }
    }
    return all;
  }

private:
  void addSkinned(const Json& attributes, const std::vector<Mat4>& palette, std::vector<Vertex>& all) const {
    const auto numbers = [&](const std::string& name) {
      return attributes.contains(name) ? gltf::readFloats(*file_.source, attributes[name].get<int>())
                                       : std::vector<float>{};
    };
    const std::vector<float> positions = numbers("POSITION");
    const std::vector<float> normals = numbers("NORMAL");
    const std::array weights{&kept("WEIGHTS_0", attributes), &kept("WEIGHTS_1", attributes)};
    const std::array slots{&kept("JOINTS_0", attributes), &kept("JOINTS_1", attributes)};
    for (std::size_t v = 0; 3 * v < positions.size(); ++v) {
      Mat4 matrix(0.0);
      for (std::size_t set = 0; set < weights.size(); ++set) {
        for (std::size_t i = 4 * v; i < 4 * v + 4 && !weights[set]->empty(); ++i) {
          matrix +=
              static_cast<double>((*weights[set])[i]) * palette[static_cast<std::size_t>((*slots[set])[i])];
        }
      }
      const auto three = [&](const std::vector<float>& from) {
        return Vec3(from[3 * v], from[3 * v + 1], from[3 * v + 2]);
      };
      all.push_back({transformPoint(matrix, three(positions)),
                     glm::normalize(glm::transpose(glm::inverse(Mat3(matrix))) * three(normals))});
    }
  }

  const std::vector<float>& kept(const std::string& name, const Json& attributes) const {
    if (!attributes.contains(name)) {
      static const std::vector<float> none;
      return none;
    }
    const int accessor = attributes[name].get<int>();
    if (!read_.contains(accessor)) {
      const bool isJoints = name.starts_with("JOINTS");
      std::vector<float> numbers;
      if (isJoints) {
        for (const std::uint32_t slot : gltf::readIntegers(*file_.source, accessor)) {
          numbers.push_back(static_cast<float>(slot));
        }
      } else {
        numbers = gltf::readFloats(*file_.source, accessor);
      }
      read_[accessor] = std::move(numbers);
    }
    return read_.at(accessor);
  }

  gltf::Loaded file_;
  std::vector<NodeIndex> joints_;
  std::vector<Mat4> inverseBind_;
  mutable std::map<int, std::vector<float>> read_;
};

struct Difference {
  double place = 0.0;   // largest, world units
  double degrees = 0.0; // of normals, largest
};

Difference between(const Viewer& a, const Viewer& b) {
  Difference worst;
  for (double frame = 18.0; frame <= 36.0; frame += 0.5) {
    const std::vector<Vertex> first = a.at(frame);
    const std::vector<Vertex> second = b.at(frame);
    REQUIRE(first.size() == second.size());
    for (std::size_t v = 0; v < first.size(); ++v) {
      worst.place = std::max(worst.place, glm::length(first[v].place - second[v].place));
      worst.degrees = std::max(worst.degrees, angleBetween(first[v].normal, second[v].normal) * 180.0 / pi);
    }
  }
  return worst;
}

std::ptrdiff_t corners(const Scene& scene) {
  return std::ranges::count_if(scene.nodes, &Node::isBindCorner);
}

} // namespace

TEST_CASE("Corners put every vertex where the scale of leaves puts it, and shade it as translations do") {
  const test::TemporaryFolder folder;
  const double volume = GENERATE(1.0, 0.0);
  const Document document = punch(volume);
  const Viewer scale(savedAs(document, folder / "scale.glb", {StretchForm::scale, 8}));
  const Viewer translation(savedAs(document, folder / "translation.glb", {StretchForm::translation, 8}));
  const Viewer corner(savedAs(document, folder / "volume.glb", {StretchForm::volume, 8}));
  CHECK(between(scale, corner).place <= 1e-5 * document.body.height);
  CHECK(between(translation, corner).degrees <= 1.0);
  CHECK(between(scale, translation).place > 0.01 * document.body.height);
  CHECK(corners(translation.scene()) == 0);
  CHECK(corners(scale.scene()) == 0);
  CHECK(corners(corner.scene()) > 0);
  for (const Json& animation : corner.json()["animations"]) {
    CHECK(std::ranges::none_of(animation["channels"],
                               [](const Json& channel) { return channel["target"]["path"] == "scale"; }));
  }
}

TEST_CASE("The same stretch in two clips is written into each of them alike, in every form") {
  Document document = punch();
  document.clips = std::make_shared<const std::vector<Clip>>(2, document.clips->front());
  document.trails.push_back(document.trails.front());
  document.trails.back().id = document.trails.front().id + 1;
  document.trails.back().clip = 1;
  for (const StretchForm form : {StretchForm::volume, StretchForm::scale, StretchForm::translation}) {
    const SavedEdits saved = editsOf(document, {.clean = true, .form = {form, 8}});
    std::array<std::vector<Track>, 2> tracks;
    for (const gltf::ClipTracks& clip : saved.edits.clips) {
      std::vector<Track>& all = tracks.at(static_cast<std::size_t>(clip.clip));
      all.insert(all.end(), clip.tracks.begin(), clip.tracks.end());
    }
    CHECK(tracks[0].size() >= 4);
    CHECK(tracks[0] == tracks[1]);
  }
}

TEST_CASE("Four influences are kept as the limit, and the miss that is told is the one that a viewer sees") {
  const test::TemporaryFolder folder;
  const Document document = punch();
  const Viewer scale(savedAs(document, folder / "scale.glb", {StretchForm::scale, 8}));
  const SavedEdits saved = editsOf(document, {.clean = true, .form = {StretchForm::volume, 4}});
  REQUIRE(saveEdits(document, saved.edits, folder / "four.glb"));
  const Viewer four(folder / "four.glb");
  for (const Json& mesh : four.json()["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) {
      CHECK_FALSE(primitive["attributes"].contains("JOINTS_1"));
    }
  }
  const double seen = between(scale, four).place / document.body.height;
  CHECK(saved.fit.fitted > 0);
  CHECK(saved.fit.percentile99 < 0.005);
  CHECK(seen == Approx(saved.fit.worst).epsilon(0.1));
}

TEST_CASE("A clean file with corners keeps its limbs and its stretch, and uses the corners again") {
  const test::TemporaryFolder folder;
  const Document source = openedPunch(punchFile);
  const Document before = punch();
  const fs::path once = savedAs(before, folder / "once.glb", {StretchForm::volume, 8});
  const Document clean = openedPunch(once);
  REQUIRE_FALSE(clean.scene->bindChains.empty());
  CHECK(clean.scene->skins.front().joints == source.scene->skins.front().joints);
  CHECK(clean.body.limbs.size() == source.body.limbs.size());
  for (std::size_t i = 0; i < std::min(clean.body.limbs.size(), source.body.limbs.size()); ++i) {
    CHECK(clean.body.limbs[i].joints == source.body.limbs[i].joints);
    CHECK(clean.body.limbs[i].endNode == source.body.limbs[i].endNode);
  }
  const SavedForm form = GENERATE(SavedForm{StretchForm::volume, 8}, SavedForm{StretchForm::scale, 8});
  const Document live = test::withNewTrail(clean, {.startFrame = 40.0, .endFrame = 50.0, .scale = 1.5});
  const Document twice = openedPunch(savedAs(live, folder / "twice.glb", form));
  CHECK(corners(*twice.scene) == corners(*clean.scene));
  CHECK(twice.scene->bindChains.size() == clean.scene->bindChains.size());
  CHECK(between(Viewer(once), Viewer(folder / "twice.glb")).place < 1e-5 * source.body.height);
}

TEST_CASE(
    "Another limb that is stretched in a clean file leaves the corners of the first as they were, but for "
    "the miss that is told") {
  const test::TemporaryFolder folder;
  const auto [before, after] = GENERATE(table<int, int>({{8, 8}, {4, 4}, {8, 4}}));
  const SavedForm form{StretchForm::volume, after};
  const double volume = GENERATE(1.0, 0.0);
  const std::string limb = GENERATE("left-leg", "neck");
  const Document source = test::withNewTrail(
      punch(volume), {.limb = "spine", .startFrame = 20.0, .endFrame = 30.0, .scale = 1.5});
  const Document once = openedPunch(savedAs(source, folder / "once.glb", {StretchForm::volume, before}));
  CHECK(std::ranges::any_of(once.scene->bindChains,
                            [](const BindChain& chain) { return chain.corners.size() > 4; }));
  const Document more =
      test::withNewTrail(once, {.limb = limb, .startFrame = 22.0, .endFrame = 34.0, .scale = 2.0});
  // A file with corners keeps them in the form of scale, so that nothing but what is new differs.
  const Viewer scale(savedAs(more, folder / "scale.glb", {StretchForm::scale, 8}));
  const SavedEdits saved = editsOf(more, {.clean = true, .form = form});
  REQUIRE(saveEdits(more, saved.edits, folder / "volume.glb"));
  const Viewer corner(folder / "volume.glb");
  for (const Json& mesh : corner.json()["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) {
      CHECK((form.influences == 8 || !primitive["attributes"].contains("JOINTS_1")));
    }
  }
  INFO(before << " " << form.influences << " " << volume << " " << limb);
  CHECK(saved.fit.vertices > 0);
  const double seen = between(scale, corner).place / once.body.height;
  CHECK(seen <= std::max(1e-5, 1.1 * saved.fit.worst));
  CHECK(seen >= 0.8 * saved.fit.worst);
}

TEST_CASE("A file with corners and the work gives the source back, in whatever form it is saved next") {
  const test::TemporaryFolder folder;
  const Document before = punch();
  const Document again = openedPunch(savedAs(before, folder / "work.glb", {StretchForm::volume, 8}, false));
  CHECK(again.scene->bindChains.empty());
  CHECK(corners(*again.scene) == 0);
  savedAs(again, folder / "again.glb", {StretchForm::scale, 8});
  savedAs(before, folder / "scale.glb", {StretchForm::scale, 8});
  CHECK(*readFile(folder / "again.glb") == *readFile(folder / "scale.glb"));
}

namespace {

/// The boxer, opened from a file whose JSON was changed.
template <typename Change>
Document changedPunch(const fs::path& path, const Change& change) {
  const Document boxer = openedPunch(punchFile);
  gltf::Source source = *boxer.source;
  Json json = *source.json;
  change(json);
  source.json = json;
  REQUIRE(gltf::save(source, path));
  return test::withNewTrail(openedPunch(path), {.startFrame = 21.0, .endFrame = 27.0, .scale = 3.0});
}

std::string refusalOf(const Document& document, const fs::path& path, StretchForm form) {
  const Status saved = saveDocument(document, path, {.clean = true, .form = {form, 8}});
  return saved ? std::string() : saved.error().line();
}

} // namespace

TEST_CASE("A stretch as volume is refused where vertices would lose joints that they follow, or lines stay "
          "behind") {
  const test::TemporaryFolder folder;
  std::string refused;
  const auto made = [&](const auto& change) { return changedPunch(folder / "changed.glb", change); };
  Document document;
  SECTION("a third set of joints") {
    document = made([](Json& json) {
      Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
      for (const char* const set : {"JOINTS_", "WEIGHTS_"}) {
        attributes[set + std::string("1")] = attributes[set + std::string("0")];
        attributes[set + std::string("2")] = attributes[set + std::string("0")];
      }
    });
    refused = "meshes[0].primitives[0]: has vertices that follow more than 8 joints";
  }
  SECTION("lines at places of their own") {
    document = made([](Json& json) {
      Json line = json["meshes"][0]["primitives"][0];
      line["mode"] = 3;
      line.erase("indices");
      const auto places = line["attributes"]["POSITION"].get<std::size_t>();
      Json own = json["accessors"][places];
      json["bufferViews"].push_back(Json(json["bufferViews"][own["bufferView"].get<std::size_t>()]));
      own["bufferView"] = json["bufferViews"].size() - 1;
      json["accessors"].push_back(own);
      line["attributes"]["POSITION"] = json["accessors"].size() - 1;
      json["meshes"][0]["primitives"].push_back(line);
    });
    refused = "holds points or lines that would stay behind";
  }
  CHECK_THAT(refusalOf(document, folder / "out.glb", StretchForm::volume), Catch::Contains(refused));
  CHECK(refusalOf(document, folder / "out.glb", StretchForm::scale).empty());
}

TEST_CASE("An outline follows the triangles whose places it has, and what uses their weights keeps them") {
  const test::TemporaryFolder folder;
  const Document document = changedPunch(folder / "changed.glb", [](Json& json) {
    Json line = json["meshes"][0]["primitives"][0];
    line["mode"] = 3;
    line.erase("indices");
    json["meshes"][0]["primitives"].push_back(line);
    Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
    attributes["_PAINT"] = attributes["WEIGHTS_0"];
  });
  savedAs(document, folder / "out.glb", {StretchForm::volume, 8});
  const Json json = *gltf::loadAsItStands(folder / "out.glb")->source->json;
  const Json& primitives = json["meshes"][0]["primitives"];
  Json attributes = primitives.front()["attributes"];
  const auto paint = attributes["_PAINT"].get<std::size_t>();
  CHECK(paint != attributes["WEIGHTS_0"].get<std::size_t>());
  CHECK(json["accessors"][paint].contains("bufferView"));
  attributes.erase("_PAINT");
  CHECK(primitives.back()["attributes"] == attributes);
}

TEST_CASE("The form is an option of the verbs that write, with another word for translations") {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const auto run = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"exaggerate", punchFile, "-o",      out, "--limb",  "left-arm",
                                   "--range",    "21:27",   "--scale", "3", "--clean", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return test::runVerb(words);
  };
  REQUIRE(run({"--keep-skeleton"}).exitCode == 0);
  const Bytes kept = *readFile(out);
  REQUIRE(run({"--form", "translation"}).exitCode == 0);
  CHECK(*readFile(out) == kept);
  const test::VerbAnswer volume = run({"--form", "volume", "--influences", "4"});
  REQUIRE(volume.exitCode == 0);
  const Json told = Json::parse(volume.output)["form"];
  CHECK(told["form"] == "volume");
  CHECK(told["influences"] == 4);
  CHECK(told["miss_percent_of_height"]["percentile_99"] <= 0.5);
  CHECK(run({}).output.find("\"form\"") == std::string::npos);
  fs::remove(out);
  CHECK(run({"--form", "shape"}).exitCode == 2);
  CHECK(run({"--form", "volume", "--influences", "3"}).exitCode == 2);
  const test::VerbAnswer both = run({"--form", "volume", "--keep-skeleton"});
  CHECK(both.exitCode == 2);
  CHECK(both.told.find("--keep-skeleton") != std::string::npos);
  const test::VerbAnswer alone = run({"--influences", "4"});
  CHECK(alone.exitCode == 2);
  CHECK(alone.told.find("--form volume") != std::string::npos);
  CHECK_FALSE(fs::exists(out));
}
