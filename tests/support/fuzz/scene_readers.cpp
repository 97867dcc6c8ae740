#include "tests/support/fuzz/scene_readers.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/file_facts.h"
#include "app/files/save.h"
#include "app/files/saved_work.h"
#include "app/recipe/recipe.h"
#include "app/recipe/replay.h"
#include "core/base/check.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/report.h"
#include "core/gltf/packed/draco_mesh.h"
#include "core/gltf/packed/meshopt_view.h"
#include "rig/motion/solve.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/temporary_folder.h"

namespace stretch::test {

namespace {

using app::Document;
using gltf::Json;

constexpr std::string_view refusal = "what is refused is refused with a reason";

std::string_view asText(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

const Document& bundledCharacter() {
  static const Result<Document> document = app::openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  return *document;
}

void lookAt(const Document& document, int clip) {
  const rig::MotionState motion = app::prepareMotion(document, clip);
  const Clip& played = app::clipOf(document, clip);
  for (const double share : {0.0, 0.4, 1.0}) {
    const double seconds = played.startSeconds + share * (played.endSeconds - played.startSeconds);
    const FrameState frame = app::evaluate(document, motion, seconds);
    check(frame.worlds.size() == document.scene->nodes.size(), "every node has a place");
  }
}

// The first limb three times as long, where its stroke is.
Document exaggerated(const Document& document) {
  if (document.body.limbs.empty() || document.clips->empty()) {
    return document;
  }
  app::NewTrail wanted{document.body.limbs.front().id, 0, {}, true, true};
  const Vec2 range =
      rig::defaultRange(*document.scene, app::clipOf(document, 0), document.body.limbs.front());
  wanted.settings.startFrame = range.x;
  wanted.settings.endFrame = range.y;
  wanted.settings.scale = 3.0;
  Result<app::CreatedTrail> created = app::createTrail(document, wanted);
  if (!created) {
    return document;
  }
  const Result<Document> applied = app::applyTrail(created->document, created->trailId);
  return applied ? *applied : created->document;
}

void checkSaved(const Document& document, const TemporaryFolder& folder) {
  if (const Status saved = app::saveDocument(document, folder / "saved.glb", {}); saved) {
    check(app::openDocument(folder / "saved.glb", gltf::Tolerance::warn).ok(), "what was saved opens again");
  } else {
    check(!saved.error().line().empty(), refusal);
  }
}

} // namespace

void readGltfAnyhow(std::span<const std::uint8_t> bytes) {
  const TemporaryFolder folder;
  const auto path = folder.write("model.glb", asText(bytes));
  static_cast<void>(gltf::diagnose(path));
  static_cast<void>(app::factsOf(path));
  const Result<Document> document = app::openDocument(path, gltf::Tolerance::warn);
  if (!document) {
    check(!document.error().line().empty(), refusal);
    return;
  }
  const int clips = std::min(2, static_cast<int>(document->clips->size()));
  for (int clip = 0; clip < clips; ++clip) {
    lookAt(*document, clip);
  }
  const Document longer = exaggerated(*document);
  if (clips > 0) {
    lookAt(longer, 0);
  }
  checkSaved(longer, folder);
  static_cast<void>(skinning::readSequence({path}));
}

void readImageAnyhow(std::span<const std::uint8_t> bytes) {
  gltf::Source source;
  source.json = Json{{"buffers", {{{"byteLength", bytes.size()}}}},
                     {"bufferViews", {{{"buffer", 0}, {"byteLength", bytes.size()}}}},
                     {"images", {{{"bufferView", 0}}}}};
  source.buffers = {gltf::Bytes(bytes.begin(), bytes.end())};
  Material material;
  material.baseColorTexture.image = 0;
  gltf::Problems problems;
  for (const Image& image : gltf::importImages(source, {material}, problems)) {
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    check(image.rgba.size() == pixels * 4, "a picture is as large as it says");
  }
}

void readRecipeAnyhow(std::span<const std::uint8_t> bytes) {
  const TemporaryFolder folder;
  Document document = bundledCharacter();
  const Result<app::Recipe> recipe = app::loadRecipe(folder.write("recipe.json", asText(bytes)), document);
  if (!recipe) {
    check(!recipe.error().line().empty(), refusal);
    return;
  }
  const Result<app::PlacedTrails> placed = app::withRecipe(document, *recipe);
  if (!placed) {
    check(!placed.error().line().empty(), refusal);
    return;
  }
  lookAt(placed->document, recipe->clip);
  Document again = placed->document;
  check(app::recipeFromJson(app::recipeToJson(again, recipe->clip), again).ok(), "a recipe of ours is one");
}

void readWorkAnyhow(std::span<const std::uint8_t> bytes) {
  const Json work = Json::parse(asText(bytes), nullptr, false);
  Document document = bundledCharacter();
  if (work.is_discarded() || !app::restoreWork(work, document)) {
    return;
  }
  for (int clip = 0; clip < static_cast<int>(document.clips->size()); ++clip) {
    lookAt(document, clip);
  }
  Document again = bundledCharacter();
  const Json kept = app::workOf(document);
  check(kept.is_null() || app::restoreWork(kept, again).ok(), "work of ours is taken up again");
}

void readMeshoptAnyhow(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t headSize = 5;
  if (bytes.size() < headSize) {
    return;
  }
  const std::array<const char*, 4> modes{"ATTRIBUTES", "TRIANGLES", "INDICES", "OTHER"};
  const std::array<const char*, 4> filters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
  const std::uint64_t count = bytes[3] + 256U * bytes[4];
  const gltf::MeshoptView view{bytes.subspan(headSize), count, bytes[2], modes.at(bytes[0] % 4U),
                               filters.at(bytes[1] % 4U)};
  const Result<gltf::Bytes> decoded = gltf::decodeMeshopt(view);
  check(!decoded || decoded->size() == view.count * view.stride, "what is decoded is whole");
}

void readDracoAnyhow(std::span<const std::uint8_t> bytes) {
  using gltf::ComponentType;
  const std::array<gltf::DracoAttribute, 3> wanted{
      {{0, 3, ComponentType::float32}, {1, 3, ComponentType::int8}, {2, 2, ComponentType::float32}}};
  constexpr std::size_t mostBytes = std::size_t{1} << 26U;
  for (std::size_t count = 0; count <= wanted.size(); ++count) {
    const Result<gltf::DracoMesh> mesh =
        gltf::decodeDraco(bytes, std::span(wanted).subspan(0, count), mostBytes);
    check(!mesh || mesh->attributes.size() == count, "each attribute is there");
  }
}

} // namespace stretch::test
