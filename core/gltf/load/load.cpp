#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "core/gltf/patch/saved_work.h"
#include "core/gltf/read/read.h"
#include "core/gltf/read/structure.h"
#include "core/gltf/source/added_file.h"
#include "core/gltf/source/plain_source.h"
#include "core/gltf/source/source.h"

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
Json takeSavedWork(Source& source, std::vector<AddedFile>& added, Problems& problems) {
  if (problems.hasErrors()) {
    return nullptr;
  }
  std::optional<Restored> restored = restoreSource(source, problems);
  if (!restored) {
    return nullptr;
  }
  source = std::move(restored->source);
  added = std::move(restored->added);
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

void importParts(const Source& readable, Pictures pictures, Loaded& loaded, Problems& problems) {
  auto scene = std::make_shared<Scene>(importScene(readable, problems, pictures));
  if (!problems.hasErrors()) {
    loaded.clips = importClips(readable, *scene, problems);
  }
  loaded.scene = std::move(scene);
}

void readContent(const Source& source, Pictures pictures, Loaded& loaded, Problems& problems) {
  const std::optional<PlainSource> plain = readableContent(source, problems);
  if (!problems.hasErrors()) {
    importParts(plain ? plain->source : source, pictures, loaded, problems);
  }
}

Result<Loaded> loadFile(const std::filesystem::path& path, bool takesWork, Tolerance tolerance,
                        Pictures pictures) {
  Problems problems;
  Loaded loaded;
  std::optional<Source> source = readSource(path, problems);
  if (source) {
    readParts(*source, problems);
    loaded.savedWork = takesWork ? takeSavedWork(*source, loaded.added, problems) : Json(nullptr);
    std::optional<Source> shown;
    if (!problems.hasErrors() && !loaded.added.empty()) {
      Result<Source> with = withAddedFiles(*source, loaded.added);
      if (!with) {
        return with.error();
      }
      shown = std::move(with).value();
    }
    readContent(shown ? *shown : *source, pictures, loaded, problems);
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
  return load(path, tolerance, Pictures::decoded);
}

Result<Loaded> load(const std::filesystem::path& path, Tolerance tolerance, Pictures pictures) {
  return loadFile(path, true, tolerance, pictures);
}

Result<std::shared_ptr<const Scene>> sceneWith(const Source& source, const std::vector<AddedFile>& files) {
  const Result<Source> with = withAddedFiles(source, files);
  if (!with) {
    return with.error();
  }
  Problems problems;
  Loaded loaded;
  readContent(*with, Pictures::decoded, loaded, problems);
  return problems.hasErrors() ? Result<std::shared_ptr<const Scene>>(problems.firstError())
                              : Result<std::shared_ptr<const Scene>>(loaded.scene);
}

Result<Loaded> loadAsItStands(const std::filesystem::path& path, Pictures pictures) {
  Result<Loaded> loaded = loadFile(path, false, Tolerance::warn, pictures);
  return loaded ? std::move(loaded) : inFile(path.string(), loaded.error());
}

} // namespace stretch::gltf
