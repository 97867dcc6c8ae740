#include "ui/batch/sequence_pictures.h"

#include <cmath>

#include <fmt/core.h>

#include "app/evaluate/evaluate.h"
#include "ui/render/sequence_scene.h"
#include "ui/render/value_colors.h"
#include "ui/viewport/assemble_picture.h"
#include "ui/widgets/theme.h"

namespace stretch::ui {

namespace {

constexpr ImU32 clay = IM_COL32(0xB9, 0xB4, 0xAC, 255);

PlainMesh meshOf(const MeshSequence& sequence, std::size_t frame, ImU32 colour) {
  return {{sequence.frame(frame), sequence.vertexCount}, sequence.triangles, {linearLight(toColour(colour))}};
}

/// Makes the frames morph targets of the primitive, which is the first frame.
void addTargets(const MeshSequence& sequence, const std::vector<std::size_t>& frames, Primitive& primitive) {
  for (const std::size_t frame : frames) {
    const PlainMesh mesh = meshOf(sequence, frame, clay);
    const Primitive posed = sceneOfMeshes(std::span(&mesh, 1)).meshes[0].primitives[0];
    MorphTarget target;
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      target.positions.push_back(posed.positions[v] - primitive.positions[v]);
      target.normals.push_back(posed.normals[v] - primitive.normals[v]);
    }
    primitive.morphTargets.push_back(std::move(target));
  }
}

Result<std::vector<std::size_t>> wholeFrames(const MeshSequence& sequence,
                                             const std::vector<double>& frames) {
  std::vector<std::size_t> whole;
  for (const double frame : frames) {
    if (!(frame >= 0.0) || std::round(frame) >= static_cast<double>(sequence.frameCount())) {
      return Error{fmt::format("there is no frame {:g}", frame), sequence.name,
                   fmt::format("give frames from 0 to {}", sequence.frameCount() - 1)};
    }
    whole.push_back(static_cast<std::size_t>(std::round(frame)));
  }
  return whole;
}

Camera cameraOf(const MeshSequence& sequence, const std::vector<std::size_t>& frames,
                const PictureOptions& options) {
  Box box;
  for (const std::size_t frame : frames) {
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      box.add(Vec3(sequence.frame(frame)[v]));
    }
  }
  // A body that lies along z is looked at from its side.
  const double yaw = box.size().z > box.size().x ? 0.5 * pi : 0.0;
  const Viewport viewport{static_cast<double>(options.widthPixels), static_cast<double>(options.heightPixels),
                          1.0};
  return fitted(lookFrom(Camera{}, options.view, yaw), viewport, box, 0.06);
}

} // namespace

Result<SequencePictures> picturesOfSequence(const MeshSequence& sequence, const MeshSequence* over,
                                            const std::vector<double>& frames,
                                            const PictureOptions& options) {
  const Result<std::vector<std::size_t>> whole = wholeFrames(sequence, frames);
  if (!whole) {
    return whole.error();
  }
  if (over != nullptr &&
      (over->vertexCount != sequence.vertexCount || over->frameCount() != sequence.frameCount())) {
    return Error{fmt::format("the clip has {} vertices and {} frames, the sequence {} and {}",
                             over->vertexCount, over->frameCount(), sequence.vertexCount,
                             sequence.frameCount()),
                 over->name, "give what was compressed from this sequence"};
  }
  SequencePictures result;
  std::vector<PlainMesh> meshes{meshOf(sequence, 0, over != nullptr ? originalMeshColour : clay)};
  if (over != nullptr) {
    meshes.push_back(meshOf(*over, 0, skinnedMeshColour));
  }
  result.scene = sceneOfMeshes(meshes);
  addTargets(sequence, *whole, result.scene.meshes[0].primitives[0]);
  if (over != nullptr) {
    addTargets(*over, *whole, result.scene.meshes[1].primitives[0]);
  }
  for (std::size_t i = 0; i < whole->size(); ++i) {
    PictureFrame picture;
    picture.content.frame = restOf(result.scene);
    for (std::vector<float>& weights : picture.content.frame.pose.weights) {
      weights.assign(whole->size(), 0.0F);
      weights[i] = 1.0F;
    }
    picture.label = whole->size() > 1 ? fmt::format("frame {}", whole.value()[i]) : std::string();
    result.pictures.push_back(std::move(picture));
  }
  result.camera = cameraOf(sequence, *whole, options);
  return result;
}

std::vector<PictureFrame> picturesOfCharacter(const app::Document& document,
                                              const std::shared_ptr<const rig::MotionState>& motion,
                                              const std::vector<double>& frames, const CharacterLook& look) {
  ViewportOverlays overlays;
  overlays.skeleton = look.skeleton;
  overlays.ghosts = look.ghosts > 0;
  overlays.ghostsBefore = look.ghosts;
  overlays.ghostsAfter = look.ghosts;
  PictureSelection selection;
  selection.everyTrail = true;
  const ShownTrails trails =
      shownTrails(motion, motion->trails.empty() ? std::vector<app::TrailPaths>{}
                                                 : app::trailPaths(document, *motion, pathSamplesPerFrame));
  const SceneMeasures measures = measuresOf(*document.scene, BoundsSampler(*document.scene));
  std::vector<PictureFrame> pictures;
  for (const double frame : frames) {
    const FrameState pose = app::evaluate(document, *motion, frame / motion->framesPerSecond);
    pictures.push_back({assemblePicture({document, *motion, trails, frame, pose, measures}, selection,
                                        overlays, paletteOf(ThemeKind::dark)),
                        look.labelled ? fmt::format("frame {:g}", frame) : std::string()});
  }
  return pictures;
}

} // namespace stretch::ui
