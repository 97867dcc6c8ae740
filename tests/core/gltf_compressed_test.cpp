#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <string>

#include <glm/geometric.hpp>

#include "core/gltf/import/texture_sets.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/report.h"
#include "core/gltf/packed/draco_mesh.h"
#include "core/gltf/patch/edits.h"
#include "tests/support/core/compressed_files.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;
using test::DracoMethod;
using test::Filters;
using test::GlbBuilder;
using test::packedByDraco;
using test::packedByMeshopt;
using test::tubeBuilder;

namespace {

gltf::Loaded opened(const GlbBuilder& glb) {
  Result<gltf::Loaded> result = test::loadBytes(glb.bytes());
  if (!result) {
    FAIL(result.error().line());
  }
  CHECK(result->warnings.empty());
  return std::move(result.value());
}

std::string refusalOf(const GlbBuilder& glb) {
  const Result<gltf::Loaded> result = test::loadBytes(glb.bytes());
  REQUIRE_FALSE(result.ok());
  return result.error().line();
}

const Primitive& tubeOf(const gltf::Loaded& file) {
  return file.scene->meshes[0].primitives[0];
}

// Largest distance of a vertex from the one in its place.
float worstMiss(const std::vector<glm::vec3>& found, const std::vector<glm::vec3>& expected) {
  REQUIRE(found.size() == expected.size());
  float worst = 0.0F;
  for (std::size_t i = 0; i < found.size(); ++i) {
    worst = std::max(worst, glm::distance(found[i], expected[i]));
  }
  return worst;
}

std::size_t nearest(const std::vector<glm::vec3>& points, const glm::vec3& place) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    best = glm::distance(points[i], place) < glm::distance(points[best], place) ? i : best;
  }
  return best;
}

void checkSameMotion(const gltf::Loaded& found, const gltf::Loaded& expected) {
  REQUIRE(found.clips.size() == expected.clips.size());
  for (std::size_t clip = 0; clip < found.clips.size(); ++clip) {
    REQUIRE(found.clips[clip].tracks.size() == expected.clips[clip].tracks.size());
    for (std::size_t i = 0; i < found.clips[clip].tracks.size(); ++i) {
      const Track& a = *found.clips[clip].tracks[i];
      const Track& b = *expected.clips[clip].tracks[i];
      CHECK(a.times == b.times);
      REQUIRE(a.values.size() == b.values.size());
      for (std::size_t k = 0; k < a.values.size(); ++k) {
        CHECK(a.values[k] == Approx(b.values[k]).margin(1e-4));
      }
    }
  }
}

Json& packedView(GlbBuilder& glb, std::size_t view) {
  return glb.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
}

std::size_t viewOf(const GlbBuilder& glb, const char* attribute) {
  const auto accessor = glb.json["meshes"][0]["primitives"][0]["attributes"][attribute].get<std::size_t>();
  return glb.json["accessors"][accessor]["bufferView"].get<std::size_t>();
}

// Draco data that claim these counts and hold nothing.
GlbBuilder claiming(DracoMethod method, std::uint64_t triangles, std::uint64_t vertices) {
  GlbBuilder glb = packedByDraco(tubeBuilder(), method);
  const bool isSequential = method == DracoMethod::sequential;
  gltf::Bytes packed{'D', 'R', 'A', 'C', 'O', 2, 2, 1, static_cast<std::uint8_t>(isSequential ? 0 : 1), 0, 0};
  if (!isSequential) {
    packed.push_back(0); // the traversal
  }
  for (std::uint64_t count :
       isSequential ? std::vector{triangles, vertices} : std::vector{vertices, triangles}) {
    for (; count >= 128; count /= 128) {
      packed.push_back(static_cast<std::uint8_t>(128 + count % 128));
    }
    packed.push_back(static_cast<std::uint8_t>(count));
  }
  packed.resize(packed.size() + 40, 1);
  Json& view = glb.json["bufferViews"].back();
  view["byteLength"] = packed.size();
  glb.binary.resize(view["byteOffset"].get<std::size_t>());
  glb.binary.insert(glb.binary.end(), packed.begin(), packed.end());
  return glb;
}

} // namespace

TEST_CASE("A file packed by meshopt opens as the plain one, with and without filters") {
  const auto filters = GENERATE(Filters::none, Filters::all);
  const GlbBuilder plain = tubeBuilder();
  const gltf::Loaded expected = opened(plain);
  const gltf::Loaded found = opened(packedByMeshopt(plain, filters));
  const float allowed = filters == Filters::none ? 0.0F : 1e-4F;
  CHECK(worstMiss(tubeOf(found).positions, tubeOf(expected).positions) <= allowed);
  CHECK(worstMiss(tubeOf(found).normals, tubeOf(expected).normals) <= 200.0F * allowed);
  CHECK(tubeOf(found).texCoords == tubeOf(expected).texCoords);
  CHECK(found.scene->skins[0].inverseBind == expected.scene->skins[0].inverseBind);
  for (std::size_t i = 0; i < tubeOf(found).influences.size(); ++i) {
    CHECK(tubeOf(found).influences[i].joints == tubeOf(expected).influences[i].joints);
    CHECK(tubeOf(found).influences[i].weights == tubeOf(expected).influences[i].weights);
  }
  CHECK(tubeOf(found).indices.size() == tubeOf(expected).indices.size());
  checkSameMotion(found, expected);
}

TEST_CASE("A mesh packed by Draco opens within its quantisation, vertices in whatever order") {
  const auto method = GENERATE(DracoMethod::sequential, DracoMethod::edgebreaker);
  const GlbBuilder plain = tubeBuilder();
  const gltf::Loaded expected = opened(plain);
  const gltf::Loaded found = opened(packedByDraco(plain, method));
  const Primitive& tube = tubeOf(found);
  const float allowed = 2.0F / 16384.0F;
  if (method == DracoMethod::sequential) {
    CHECK(worstMiss(tube.positions, tubeOf(expected).positions) < allowed);
  }
  CHECK(tube.indices.size() == tubeOf(expected).indices.size());
  for (std::size_t i = 0; i < tube.positions.size(); ++i) {
    const std::size_t twin = nearest(tubeOf(expected).positions, tube.positions[i]);
    CHECK(glm::distance(tube.positions[i], tubeOf(expected).positions[twin]) < allowed);
    CHECK(glm::distance(tube.texCoords[i], tubeOf(expected).texCoords[twin]) < 1e-3F);
    CHECK(glm::distance(tube.normals[i], tubeOf(expected).normals[twin]) < 0.02F);
    CHECK(tube.influences[i].joints == tubeOf(expected).influences[twin].joints);
    CHECK(tube.influences[i].weights == tubeOf(expected).influences[twin].weights);
  }
  checkSameMotion(found, expected);
}

TEST_CASE("A mesh packed by Draco is a list of triangles, whatever its primitive calls it") {
  const GlbBuilder packed = packedByDraco(tubeBuilder(), DracoMethod::sequential);
  const gltf::Loaded expected = opened(packed);
  GlbBuilder glb = packed;
  gltf::Json& primitive = glb.json["meshes"][0]["primitives"][0];
  SECTION("a strip") {
    primitive["mode"] = 5;
  }
  SECTION("without indices") {
    primitive.erase("indices");
  }
  CHECK(tubeOf(opened(glb)).indices == tubeOf(expected).indices);
}

TEST_CASE("Texture coordinates of a packed file are read with its packed parts opened") {
  const gltf::Loaded packed = opened(packedByDraco(tubeBuilder(), DracoMethod::sequential));
  const auto sets = gltf::TextureSets(packed).of(0, 0);
  REQUIRE(sets.size() == 1);
  CHECK(sets[0] == tubeOf(packed).texCoords);
}

TEST_CASE("Of a mesh with plain data for other readers the packed ones are read") {
  const GlbBuilder plain = tubeBuilder();
  GlbBuilder glb = packedByDraco(plain, DracoMethod::edgebreaker);
  glb.json["accessors"] = plain.json["accessors"];
  glb.json["extensionsRequired"] = plain.json["extensionsRequired"];
  const gltf::Loaded both = opened(glb);
  CHECK(tubeOf(both).positions == tubeOf(opened(packedByDraco(plain, DracoMethod::edgebreaker))).positions);
  CHECK(tubeOf(both).positions != tubeOf(opened(plain)).positions);
}

TEST_CASE("A mesh that shares plain data with a packed one keeps them") {
  const GlbBuilder plain = tubeBuilder();
  GlbBuilder glb = packedByDraco(plain, DracoMethod::edgebreaker);
  glb.json["accessors"] = plain.json["accessors"];
  gltf::Json& primitives = glb.json["meshes"][0]["primitives"];
  const gltf::Json& own = plain.json["meshes"][0]["primitives"][0];
  primitives.push_back(own);
  primitives.insert(primitives.begin(), own);
  const gltf::Loaded file = opened(glb);
  const auto& read = file.scene->meshes[0].primitives;
  REQUIRE(read.size() == 3);
  const Primitive expected = opened(plain).scene->meshes[0].primitives[0];
  for (const std::size_t shared : {0, 2}) {
    CHECK(read[shared].positions == expected.positions);
    CHECK(read[shared].normals == expected.normals);
    CHECK(read[shared].texCoords == expected.texCoords);
    CHECK(read[shared].indices == expected.indices);
  }
  CHECK(read[1].positions == tubeOf(opened(packedByDraco(plain, DracoMethod::edgebreaker))).positions);
}

TEST_CASE("Packed attributes may be those of any accessor, the first one among them") {
  const GlbBuilder packed = packedByDraco(tubeBuilder(), DracoMethod::sequential);
  const gltf::Loaded expected = opened(packed);
  const auto attributes = packed.json["meshes"][0]["primitives"][0]["attributes"];
  for (const auto& [name, accessor] : attributes.items()) {
    CAPTURE(name);
    GlbBuilder glb = packed;
    gltf::Json& accessors = glb.json["accessors"];
    const auto index = accessor.get<std::size_t>();
    // The two change places, and whatever names them.
    std::swap(accessors[0], accessors[index]);
    const std::function<void(gltf::Json&)> rename = [&](gltf::Json& number) {
      if (number == 0 || number == index) {
        number = number == 0 ? index : 0;
      }
    };
    for (gltf::Json& mesh : glb.json["meshes"]) {
      for (gltf::Json& primitive : mesh["primitives"]) {
        for (auto& attribute : primitive["attributes"]) {
          rename(attribute);
        }
        if (primitive.contains("indices")) {
          rename(primitive["indices"]);
        }
      }
    }
    for (gltf::Json& skin : glb.json["skins"]) {
      rename(skin["inverseBindMatrices"]);
    }
    for (gltf::Json& clip : glb.json["animations"]) {
      for (gltf::Json& sampler : clip["samplers"]) {
        rename(sampler["input"]);
        rename(sampler["output"]);
      }
    }
    const gltf::Loaded file = opened(glb);
    CHECK(tubeOf(file).positions == tubeOf(expected).positions);
    CHECK(tubeOf(file).normals == tubeOf(expected).normals);
    CHECK(tubeOf(file).texCoords == tubeOf(expected).texCoords);
  }
}

TEST_CASE("Edits go beside packed data, which stay as they are") {
  const auto pack = GENERATE(0, 1, 2);
  const GlbBuilder plain = tubeBuilder();
  const gltf::Loaded source = opened(pack == 0   ? packedByMeshopt(plain, Filters::all)
                                     : pack == 1 ? packedByDraco(plain, DracoMethod::edgebreaker)
                                                 : plain);
  gltf::Edits edits;
  edits.addedNodes.push_back({"upper_bind", NodeIndex(1), {}, NodeIndex::none});
  edits.skinSlots.push_back({0, 1, NodeIndex(6), Mat4(1.0)});
  Track track = *source.clips[0].tracks[0];
  track.values[0] = 0.5F;
  edits.clips.push_back({0, {track}});
  const Result<gltf::Source> patched = gltf::patched(*source.source, edits);
  REQUIRE(patched.ok());
  const test::TemporaryFolder folder;
  REQUIRE(gltf::save(*patched, folder / "out.glb").ok());
  const Result<gltf::Loaded> again = gltf::load(folder / "out.glb");
  REQUIRE(again.ok());
  const auto& before = source.source->buffers[0];
  const auto& after = again->source->buffers[0];
  CHECK(std::equal(before.begin(), before.end(), after.begin()));
  for (std::size_t i = 0; i < (*source.source->json)["bufferViews"].size(); ++i) {
    CHECK((*again->source->json)["bufferViews"][i] == (*source.source->json)["bufferViews"][i]);
  }
  CHECK((*again->source->json)["meshes"] == (*source.source->json)["meshes"]);
  CHECK(tubeOf(*again).positions == tubeOf(source).positions);
  CHECK(again->scene->skins[0].inverseBind[2] == source.scene->skins[0].inverseBind[2]);
  CHECK(again->clips[0].tracks[0]->values[0] == 0.5F);
}

TEST_CASE("What packed views say is compared with their bytes before anything is decoded") {
  struct Lie {
    const char* key;
    Json value;
    const char* complaint;
  };
  const auto lie = GENERATE(values<Lie>({{"count", 100000, "cannot hold"},
                                         {"count", 2000000000, "memory"},
                                         {"count", 0, "cannot hold"},
                                         {"byteStride", 3, "stride"},
                                         {"byteStride", 260, "stride"},
                                         {"mode", "WAVELETS", "mode"},
                                         {"mode", "TRIANGLES", "stride"},
                                         {"filter", "QUATERNION", "filter"},
                                         {"filter", "BLUR", "filter"},
                                         {"byteLength", 9007199254740991, "not there"},
                                         {"byteOffset", 9007199254740991, "not there"},
                                         {"byteLength", 20, "cannot hold"},
                                         {"byteLength", 400, "cannot be decoded"},
                                         {"buffer", 7, "not there"},
                                         {"buffer", "none", "not there"}}));
  GlbBuilder glb = packedByMeshopt(tubeBuilder(), Filters::none);
  const std::size_t view = viewOf(glb, "POSITION");
  packedView(glb, view)[lie.key] = lie.value;
  const std::string line = refusalOf(glb);
  CHECK_THAT(line, Catch::StartsWith("bufferViews[" + std::to_string(view) +
                                     "].extensions.EXT_meshopt_compression: "));
  CHECK_THAT(line, Catch::Contains(lie.complaint));
}

TEST_CASE("Counts of Draco data are compared with their bytes before memory is taken") {
  const auto method = GENERATE(DracoMethod::sequential, DracoMethod::edgebreaker);
  const std::string line = refusalOf(claiming(method, 1400000000, 2000000000));
  CHECK_THAT(line, Catch::StartsWith("meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: says "
                                     "1400000000 triangles and 2000000000 vertices"));
  CHECK_THAT(refusalOf(claiming(method, 3000, 1000)), Catch::Contains("cannot be decoded"));
}

TEST_CASE("Broken Draco data are refused in one line with their place") {
  GlbBuilder glb = packedByDraco(tubeBuilder(), DracoMethod::edgebreaker);
  Json& extension = glb.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
  Json& view = glb.json["bufferViews"].back();
  const std::size_t start = view["byteOffset"].get<std::size_t>();
  std::string complaint;
  SECTION("cut short") {
    view["byteLength"] = view["byteLength"].get<std::size_t>() / 2;
    complaint = "cannot be decoded";
  }
  SECTION("no Draco data") {
    glb.binary[start] = 'd';
    complaint = "no Draco data";
  }
  SECTION("of another version") {
    glb.binary[start + 5] = 9;
    complaint = "of version 9.2";
  }
  SECTION("an attribute that is not there") {
    extension["attributes"]["POSITION"] = 17;
    complaint = "has no attribute 17";
  }
  SECTION("an attribute of another width") {
    extension["attributes"]["POSITION"] = extension["attributes"]["JOINTS_0"];
    complaint = "has 4 components";
  }
  SECTION("a view that is not there") {
    extension["bufferView"] = 1000;
    complaint = "not there";
  }
  const std::string line = refusalOf(glb);
  CHECK_THAT(line, Catch::StartsWith("meshes[0].primitives[0].extensions.KHR_draco_mesh_compression"));
  CHECK_THAT(line, Catch::Contains(complaint));
}

TEST_CASE("Packed data that name the same bytes over and over are refused before they fill the memory") {
  GlbBuilder glb = packedByMeshopt(tubeBuilder(), Filters::none);
  // Blocks of 32 vertices of 256 bytes, in which each byte is as in the vertex before; the first vertex last.
  constexpr std::size_t blocks = 1000;
  gltf::Bytes zeros(1 + blocks * 256 + 256, 0);
  zeros[0] = 0xa0; // the codec's mark
  const std::size_t offset = (glb.binary.size() + 3) / 4 * 4;
  glb.binary.resize(offset);
  glb.binary.insert(glb.binary.end(), zeros.begin(), zeros.end());
  glb.json["buffers"][1]["byteLength"] = 8192 * blocks;
  CHECK(test::loadBytes(glb.bytes()).ok());
  for (int i = 0; i < 100; ++i) {
    glb.json["bufferViews"].push_back({{"buffer", 1},
                                       {"byteLength", 8192 * blocks},
                                       {"extensions",
                                        {{"EXT_meshopt_compression",
                                          {{"buffer", 0},
                                           {"byteOffset", offset},
                                           {"byteLength", zeros.size()},
                                           {"mode", "ATTRIBUTES"},
                                           {"count", 32 * blocks},
                                           {"byteStride", 256}}}}}});
  }
  CHECK_THAT(refusalOf(glb), Catch::Contains("memory"));
}

TEST_CASE("A file tells its extensions and which of them are not shown") {
  GlbBuilder glb = packedByMeshopt(tubeBuilder(), Filters::none);
  const test::TemporaryFolder folder;
  glb.write(folder / "model.glb");
  const std::vector<gltf::ExtensionUse> uses = gltf::diagnose(folder / "model.glb").extensions;
  REQUIRE(uses.size() == 3);
  CHECK(uses[0].name == "X_unknown");
  CHECK(uses[0].support == gltf::ExtensionSupport::ignored);
  CHECK_FALSE(uses[0].isRequired);
  CHECK(uses[2].name == "EXT_meshopt_compression");
  CHECK(uses[2].support == gltf::ExtensionSupport::read);
  CHECK(uses[2].isRequired);
}

TEST_CASE("A packed view that says another length than its data have breaks the rules, and its data count") {
  GlbBuilder glb = packedByMeshopt(tubeBuilder(), Filters::none);
  const std::size_t view = viewOf(glb, "POSITION");
  const auto said = glb.json["bufferViews"][view]["byteLength"].get<std::size_t>();
  glb.json["bufferViews"][view]["byteLength"] = said - 12;
  const std::string told = "bufferViews[" + std::to_string(view) + "]: says " + std::to_string(said - 12) +
                           " bytes, but its compressed data hold " + std::to_string(said);
  CHECK_THAT(refusalOf(glb), Catch::StartsWith(told));
  const Result<gltf::Loaded> file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  REQUIRE(file);
  CHECK(test::warnsOf(*file, told));
  CHECK(tubeOf(*file).positions == tubeOf(opened(packedByMeshopt(tubeBuilder(), Filters::none))).positions);
}

TEST_CASE("A packed mesh has the vertices that its data hold, whatever number its accessor says") {
  GlbBuilder glb = packedByDraco(tubeBuilder(), DracoMethod::sequential);
  const std::size_t vertices = tubeOf(opened(glb)).positions.size();
  const auto accessor = glb.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>();
  glb.json["accessors"][accessor]["count"] = vertices - 5;
  const Result<gltf::Loaded> file = test::loadBytes(glb.bytes());
  REQUIRE(file);
  CHECK(tubeOf(*file).positions.size() == vertices);
  CHECK(test::warnsOf(*file, "accessors[" + std::to_string(accessor) + "]: says " +
                                 std::to_string(vertices - 5) + " elements, but its compressed data hold " +
                                 std::to_string(vertices) + ", which are read"));
}

TEST_CASE("Attributes of Draco data are compared with the memory there may be before it is taken") {
  // The tube has five attributes. Its 288 vertices and 552 triangles alone take 168,000 bytes.
  const auto refusalWith = [](int own, std::size_t most) {
    GlbBuilder plain = tubeBuilder();
    const int zeros = plain.floats(std::vector<float>(4 * 288, 0.0F), "VEC4", 4);
    for (int i = 0; i < own; ++i) {
      plain.json["meshes"][0]["primitives"][0]["attributes"]["_OWN_" + std::to_string(i)] = zeros;
    }
    const GlbBuilder glb = packedByDraco(plain, DracoMethod::sequential);
    const Json& view = glb.json["bufferViews"].back();
    const auto bytes =
        std::span(glb.binary)
            .subspan(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>());
    return test::refusal(gltf::decodeDraco(bytes, {}, most));
  };
  const std::string told = " attributes of 288 vertices, more than the program takes into memory";
  CHECK_THAT(refusalWith(30, 250000), Catch::Contains("has 35" + told));
  CHECK(refusalWith(30, 400000) == "accepted");
  CHECK(refusalWith(59, 1U << 30U) == "accepted");
  CHECK_THAT(refusalWith(60, 1U << 30U), Catch::Contains("has 65" + told));
}
