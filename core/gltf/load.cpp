#include "core/gltf/accessor.h"
#include "core/gltf/import.h"
#include "core/gltf/json.h"
#include "core/gltf/load_as_it_stands.h"
#include "core/gltf/read.h"
#include "core/gltf/saved_work.h"
#include "core/gltf/source.h"
#include "core/gltf/structure.h"

namespace stretch::gltf {

namespace {

// JSON and graph sound, bytes there.
void readParts(Source& source, Problems& problems) {
  validateStructure(source.json, problems);
  if (!problems.hasErrors()) {
    readBuffers(source, problems);
  }
}

// A file of ours gives back the source that it was made from.
Json takeSavedWork(Source& source, Problems& problems) {
  if (problems.hasErrors()) {
    return nullptr;
  }
  std::optional<Restored> restored = restoreSource(source, problems);
  if (!restored) {
    return nullptr;
  }
  source = std::move(restored->source);
  validateStructure(source.json, problems);
  return std::move(restored->work);
}

void validateContent(const Source& source, Problems& problems) {
  if (!problems.hasErrors()) {
    validateGraph(source.json, problems);
  }
  if (!problems.hasErrors()) {
    validateAccessors(source, problems);
  }
}

Result<Loaded> loadFile(const std::filesystem::path& path, bool takesWork, Tolerance tolerance) {
  Problems problems;
  Loaded loaded;
  std::optional<Source> source = readSource(path, problems);
  if (source) {
    readParts(*source, problems);
    loaded.savedWork = takesWork ? takeSavedWork(*source, problems) : Json(nullptr);
    validateContent(*source, problems);
  }
  if (problems.hasErrors()) {
    return problems.firstError();
  }
  auto scene = std::make_shared<Scene>(importScene(*source, problems));
  if (problems.hasErrors()) {
    return problems.firstError();
  }
  loaded.clips = importClips(*source, *scene, problems);
  if (problems.hasErrors() || (tolerance == Tolerance::refuse && problems.hasViolations())) {
    return problems.firstError();
  }
  loaded.source = std::make_shared<const Source>(*std::move(source));
  loaded.scene = std::move(scene);
  loaded.warnings = problems.warningLines();
  return loaded;
}

} // namespace

Result<Loaded> load(const std::filesystem::path& path, Tolerance tolerance) {
  return loadFile(path, true, tolerance);
}

Result<Loaded> loadAsItStands(const std::filesystem::path& path) {
  return loadFile(path, false, Tolerance::warn);
}

} // namespace stretch::gltf
