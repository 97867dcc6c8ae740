#include "core/gltf/load/report.h"

#include <cmath>

#include <fmt/core.h>

#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/saved_work.h"
#include "core/gltf/read/read.h"
#include "core/gltf/read/structure.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/plain_source.h"

namespace stretch::gltf {

namespace {

constexpr std::size_t jointsThatEnginesHold = 128;

std::string momentOf(const Shear& shear, const std::vector<Clip>& clips) {
  if (shear.clip < 0) {
    return "at rest";
  }
  return fmt::format("in clip '{}' at {:.3f} s", clips[static_cast<std::size_t>(shear.clip)].name,
                     shear.timeSeconds);
}

void reportShear(const Scene& scene, const std::vector<Clip>& clips, Problems& problems) {
  for (const Shear& shear : residualShear(scene, clips)) {
    const auto node = at(shear.node);
    problems.warning(
        at("nodes", node),
        fmt::format("'{}' is sheared by up to {:.1f} degrees {}: an uneven scale above a rotation; other "
                    "programs may show something else",
                    scene.nodes[node].name, 90.0 - std::acos(shear.cosine) * 180.0 / pi,
                    momentOf(shear, clips)));
  }
}

void reportJointCounts(const Scene& scene, Problems& problems) {
  for (std::size_t i = 0; i < scene.skins.size(); ++i) {
    if (scene.skins[i].joints.size() > jointsThatEnginesHold) {
      problems.warning(at("skins", i), fmt::format("has {} joints; some engines hold {} at most",
                                                   scene.skins[i].joints.size(), jointsThatEnginesHold));
    }
  }
}

// Goes on after errors as far as the parts that were sound allow.
void reportContent(Source& source, Problems& problems) {
  validateGraph(source.json, problems);
  const bool isGraphSound = !problems.hasErrors();
  Problems bytes;
  readBuffers(source, bytes);
  std::optional<PlainSource> plain;
  if (!bytes.hasErrors()) {
    plain = plainSource(source, bytes);
  }
  const Source& readable = plain ? plain->source : source;
  if (!bytes.hasErrors()) {
    validateAccessors(readable, plain ? plain->roundedAccessors : std::set<std::size_t>(), bytes);
  }
  problems.add(bytes);
  if (!isGraphSound || bytes.hasErrors()) {
    return;
  }
  const Scene scene = importScene(readable, problems);
  if (scene.meshes.size() != sizeOf(source.json, "meshes")) {
    return;
  }
  const std::vector<Clip> clips = importClips(readable, scene, problems);
  reportShear(scene, clips, problems);
  reportJointCounts(scene, problems);
  (void)restoreSource(source, problems);
}

} // namespace

Diagnosis diagnose(const std::filesystem::path& path) {
  Problems problems;
  std::vector<ExtensionUse> extensions;
  std::optional<Source> source = readSource(path, problems);
  if (source) {
    validateStructure(source->json, problems);
    extensions = extensionsOf(source->json);
  }
  if (source && !problems.hasErrors()) {
    reportContent(*source, problems);
  }
  return {problems.list(), std::move(extensions)};
}

} // namespace stretch::gltf
