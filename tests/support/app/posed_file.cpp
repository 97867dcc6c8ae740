#include "tests/support/app/posed_file.h"

#include <catch2/catch.hpp>

#include "app/evaluate/evaluate.h"
#include "app/files/save.h"

namespace stretch::test {

namespace {

FrameState ownFrame(const app::Document& document, double frame) {
  return app::evaluateOriginal(document, 0, frame / app::clipOf(document, 0).framesPerSecond);
}

} // namespace

Posed pose(const TemporaryFolder& folder, const gltf::Json& recipe, const std::vector<std::string>& more,
           const std::string& file) {
  const std::string written = folder.write("recipe.json", recipe.dump()).string();
  Posed posed{{}, (folder / "posed.glb").string()};
  std::vector<std::string> words{"pose", file, "-o", posed.path, "--recipe", written, "--json"};
  words.insert(words.end(), more.begin(), more.end());
  posed.answer = runVerb(words);
  return posed;
}

app::Document openedFile(const std::string& path) {
  const Result<app::Document> document = app::openDocument(path);
  INFO((document ? std::string() : document.error().line()));
  REQUIRE(document);
  return *document;
}

Vec3 endOf(const app::Document& document, const std::string& limb, double frame) {
  return rig::endPosition(*app::findLimb(document, limb), ownFrame(document, frame));
}

Mat4 worldOf(const app::Document& document, NodeIndex node, double frame) {
  return ownFrame(document, frame).worlds[at(node)];
}

Vec3 nodeOf(const app::Document& document, NodeIndex node, double frame) {
  return positionOf(worldOf(document, node, frame));
}

} // namespace stretch::test
