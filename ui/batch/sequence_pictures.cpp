#include "ui/batch/sequence_pictures.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "app/evaluate/evaluate.h"
#include "ui/render/picture/image_edits.h"
#include "ui/render/scene/sequence_scene.h"
#include "ui/viewport/assemble_picture.h"
#include "ui/viewport/camera/look_through.h"

namespace stretch::ui {

namespace {

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

Status checkResult(const SequenceContent& content) {
  const MeshSequence& sequence = *content.original;
  const std::shared_ptr<const MeshSequence>& result = content.resultFrames;
  if (result != nullptr &&
      (result->vertexCount != sequence.vertexCount || result->frameCount() != sequence.frameCount())) {
    return Error{fmt::format("the clip has {} vertices and {} frames, the sequence {} and {}",
                             result->vertexCount, result->frameCount(), sequence.vertexCount,
                             sequence.frameCount()),
                 result->name, "give what was compressed from this sequence"};
  }
  return Success{};
}

std::string labelOf(const SequenceExtras& extras, std::size_t frame, bool several) {
  const std::string number = several ? fmt::format("frame {}", frame) : std::string();
  return extras.name + (extras.name.empty() || number.empty() ? "" : ", ") + number;
}

std::optional<PictureLegend> pictureLegend(const std::optional<SequenceLegend>& legend) {
  if (!legend) {
    return std::nullopt;
  }
  constexpr int steps = 256;
  PictureLegend drawn{legend->title, legend->low, legend->high, legend->detail, {}};
  for (int i = 0; i < steps; ++i) {
    drawn.colours.push_back(legend->colour((i + 0.5) / steps));
  }
  return drawn;
}

} // namespace

Result<SequencePictures> picturesOfSequence(const SequenceContent& content, const app::SequenceView& view,
                                            const SequenceExtras& extras, const std::vector<double>& frames,
                                            const PictureOptions& options) {
  const MeshSequence& sequence = *content.original;
  const Result<std::vector<std::size_t>> whole = wholeFrames(sequence, frames);
  if (!whole) {
    return whole.error();
  }
  if (const Status fits = checkResult(content); !fits) {
    return fits.error();
  }
  SequencePictures result;
  result.drawing = std::make_shared<const SequencePicture>(content, view);
  for (const std::size_t frame : *whole) {
    PictureFrame picture;
    picture.content.frame = restOf(result.drawing->scene());
    picture.content.shape = [drawing = result.drawing, frame] { return drawing->shapeAt(frame); };
    if (extras.bones) {
      picture.content.bones = drawBones(content, frame, picture.content.style.palette);
    }
    picture.label = labelOf(extras, frame, whole->size() > 1);
    picture.legend = pictureLegend(result.drawing->legend());
    result.pictures.push_back(std::move(picture));
  }
  result.camera = cameraOf(sequence, *whole, options);
  return result;
}

Result<Image> drawStages(const SequenceContent& content, const std::vector<double>& frames,
                         const PictureOptions& options) {
  using app::SequenceLook;
  struct Stage {
    const char* name;
    SequenceLook look;
    bool showsResult;
    bool bones;
  };
  constexpr std::array<Stage, 4> stages{{{"mesh", SequenceLook::material, false, false},
                                         {"skeleton", SequenceLook::material, false, true},
                                         {"segments", SequenceLook::segments, true, true},
                                         {"stretched", SequenceLook::material, true, false}}};
  const SheetLayout layout = layOutSheet(stages.size() * frames.size(), options.widthPixels,
                                         options.heightPixels, static_cast<int>(stages.size()));
  if (Status fits = checkSheet(layout, stages.size() * frames.size()); !fits) {
    return fits.error();
  }
  Image sheet = filled(layout.widthPixels, layout.heightPixels, SceneStyle{}.palette.backgroundBottom);
  for (std::size_t s = 0; s < stages.size(); ++s) {
    app::SequenceView view;
    view.look = stages[s].look;
    view.showSkinned = stages[s].showsResult;
    const Result<SequencePictures> drawn =
        picturesOfSequence(content, view, {stages[s].bones, stages[s].name}, frames, options);
    if (!drawn) {
      return drawn.error();
    }
    PictureOptions seen = options;
    seen.camera = drawn->camera;
    const Status made = renderSeries(drawn->drawing->scene(), drawn->pictures, seen,
                                     [&](std::size_t row, const Image& picture) {
                                       const std::size_t cell = row * stages.size() + s;
                                       paste(sheet, picture, layout.left(cell), layout.top(cell));
                                       return Status(Success{});
                                     });
    if (!made) {
      return made.error();
    }
  }
  return sheet;
}

std::vector<PictureFrame> picturesOfCharacter(const app::Document& document,
                                              const std::shared_ptr<const rig::MotionState>& motion,
                                              const std::vector<double>& frames, const CharacterLook& look) {
  ViewportOverlays overlays;
  overlays.skeleton = look.skeleton;
  overlays.shadeAs = look.shadeAs;
  overlays.ghosts = look.ghosts > 0;
  overlays.ghostsBefore = look.ghosts;
  overlays.ghostsAfter = look.ghosts;
  PictureSelection selection;
  selection.everyTrail = true;
  selection.weightsOf = look.weightsOf;
  const ShownTrails trails =
      !look.trails ? ShownTrails{}
                   : shownTrails(motion, motion->trails.empty()
                                             ? std::vector<app::TrailPaths>{}
                                             : app::trailPaths(document, *motion, pathSamplesPerFrame));
  const SceneMeasures measures = measuresOf(*document.scene, BoundsSampler(*document.scene));
  std::vector<PictureFrame> pictures;
  for (const double frame : frames) {
    const FrameState pose = app::evaluate(document, *motion, frame / motion->framesPerSecond);
    pictures.push_back({assemblePicture({document, *motion, trails, frame, pose, measures}, selection,
                                        overlays, paletteOf(ThemeKind::dark)),
                        look.labelled ? fmt::format("frame {:g}", frame) : std::string()});
    if (look.backdrops) {
      pictures.back().content.style.backdrop = look.backdrops(frame);
    }
    if (look.camera != nullptr) {
      pictures.back().through = throughCamera(document, *look.camera, pose);
    }
  }
  return pictures;
}

} // namespace stretch::ui
