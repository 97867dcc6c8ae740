#include "core/gltf/accessor.h"
#include "core/gltf/import.h"
#include "core/gltf/read.h"
#include "core/gltf/source.h"
#include "core/gltf/structure.h"

namespace stretch::gltf {

namespace {

// Every stage relies on the ones before it.
void validate(Source& source, Problems& problems) {
  validateStructure(source.json, problems);
  if (!problems.hasErrors()) {
    validateGraph(source.json, problems);
    readBuffers(source, problems);
  }
  if (!problems.hasErrors()) {
    validateAccessors(source, problems);
  }
}

} // namespace

Result<Loaded> load(const std::filesystem::path& path) {
  Problems problems;
  std::optional<Source> source = readSource(path, problems);
  if (source) {
    validate(*source, problems);
  }
  if (problems.hasErrors()) {
    return problems.firstError();
  }
  Loaded loaded;
  auto scene = std::make_shared<Scene>(importScene(*source, problems));
  if (problems.hasErrors()) {
    return problems.firstError();
  }
  loaded.clips = importClips(*source, *scene, problems);
  if (problems.hasErrors()) {
    return problems.firstError();
  }
  loaded.source = std::make_shared<const Source>(*std::move(source));
  loaded.scene = std::move(scene);
  loaded.warnings = problems.warningLines();
  return loaded;
}

} // namespace stretch::gltf
