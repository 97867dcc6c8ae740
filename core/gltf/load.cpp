#include "core/gltf/accessor.h"
#include "core/gltf/import.h"
#include "core/gltf/json.h"
#include "core/gltf/load_as_it_stands.h"
#include "core/gltf/plain_source.h"
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

// What is read: the source, or what stands in for one with compressed parts.
std::optional<PlainSource> readableContent(const Source& source, Problems& problems) {
  if (!problems.hasErrors()) {
    validateGraph(source.json, problems);
  }
  std::optional<PlainSource> plain;
  if (!problems.hasErrors()) {
    plain = plainSource(source, problems);
  }
  if (!problems.hasErrors()) {
    validateAccessors(plain ? plain->source : source,
                      plain ? plain->roundedAccessors : std::set<std::size_t>(), problems);
  }
  return plain;
}

void importParts(const Source& readable, Loaded& loaded, Problems& problems) {
  auto scene = std::make_shared<Scene>(importScene(readable, problems));
  if (!problems.hasErrors()) {
    loaded.clips = importClips(readable, *scene, problems);
  }
  loaded.scene = std::move(scene);
}

Result<Loaded> loadFile(const std::filesystem::path& path, bool takesWork, Tolerance tolerance) {
  Problems problems;
  Loaded loaded;
  std::optional<Source> source = readSource(path, problems);
  std::optional<PlainSource> plain;
  if (source) {
    readParts(*source, problems);
    loaded.savedWork = takesWork ? takeSavedWork(*source, problems) : Json(nullptr);
    plain = readableContent(*source, problems);
  }
  if (!problems.hasErrors()) {
    importParts(plain ? plain->source : *source, loaded, problems);
  }
  if (problems.hasErrors() || (tolerance == Tolerance::refuse && problems.hasViolations())) {
    return problems.firstError();
  }
  loaded.source = std::make_shared<const Source>(*std::move(source));
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
