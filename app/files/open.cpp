#include "app/files/open.h"

#include "app/files/saved_work.h"

namespace stretch::app {

Result<Document> openDocument(const std::filesystem::path& path, gltf::Tolerance tolerance) {
  Result<gltf::Loaded> loaded = gltf::load(path, tolerance);
  if (!loaded) {
    return loaded.error();
  }
  Document document;
  document.source = loaded->source;
  document.scene = loaded->scene;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(loaded->clips));
  document.warnings = std::move(loaded->warnings);
  document.biped = rig::detectBiped(*document.scene);
  if (!loaded->savedWork.isNull()) {
    if (const Status restored = restoreWork(loaded->savedWork, document); !restored) {
      document.warnings.push_back("the work kept in the file could not be taken up: " +
                                  restored.error().line());
    } else {
      document.carriedWork = true;
    }
  }
  return document;
}

} // namespace stretch::app
