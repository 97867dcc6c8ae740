#include "ui/viewport/assemble_picture.h"

#include <algorithm>
#include <cmath>

#include "app/evaluate/evaluate.h"
#include "core/anim/frames.h"
#include "rig/limb_nodes.h"
#include "ui/panels/body/weight_view.h"
#include "ui/widgets/theme.h"

namespace stretch::ui {

namespace {

constexpr float hoveredHighlight = 0.7F;
constexpr float nearestGhostOpacity = 0.34F;
constexpr float tipGhostOpacity = 0.45F;

/// Of every node: 1 where it carries flesh of a selected limb, less on the hovered one.
std::vector<float> highlightOf(const app::Document& document, const PictureSelection& selection) {
  std::vector<float> highlight(document.scene->nodes.size(), 0.0F);
  const auto mark = [&](const std::string& limbId, float amount) {
    const rig::Limb* const wanted = app::findLimb(document, limbId);
    if (wanted == nullptr) {
      return;
    }
    std::vector<rig::Limb> limbs{*wanted}; // Before all others: a chain of one's own may lie on a limb.
    for (rig::Limb& limb : app::allLimbs(document)) {
      limbs.push_back(std::move(limb));
    }
    const std::vector<int> owners = rig::limbOfNodes(*document.scene, limbs, document.body.hips);
    for (std::size_t node = 0; node < owners.size(); ++node) {
      const bool isIts = owners[node] >= 0 && limbs[static_cast<std::size_t>(owners[node])].id == limbId;
      highlight[node] = isIts ? std::max(highlight[node], amount) : highlight[node];
    }
  };
  if (!selection.hoveredLimb.empty()) {
    mark(selection.hoveredLimb, hoveredHighlight);
  }
  for (const std::string& limbId : selection.limbs) {
    mark(limbId, 1.0F);
  }
  return highlight;
}

SceneStyle sceneStyleOf(const PictureSubject& subject, const PictureSelection& selection,
                        const ViewportOverlays& overlays, const Palette& palette) {
  SceneStyle style;
  style.palette = palette;
  style.shading = overlays.heatMap ? SurfaceShading::stretchHeat : SurfaceShading::material;
  style.normals = overlays.shadeAs == ShadeAs::exact ? skinning::NormalMatrix::inverseTranspose
                                                     : skinning::NormalMatrix::plain;
  style.wireframe = overlays.wire;
  style.floor = overlays.grid;
  style.measures = subject.measures;
  style.highlight = highlightOf(subject.document, selection);
  if (selection.weightsOf.exists()) {
    style.shading = SurfaceShading::jointWeights;
    style.highlight = sharesOf(*subject.document.scene, selection.weightsOf);
  }
  return style;
}

bool isPickedOut(const PictureSelection& selection, int trailId) {
  return selection.everyTrail || selection.trail == trailId;
}

/// Spheres within this many frames of the playhead are drawn in full size, the others smaller.
constexpr double nearSphereFrames = 2.5;

std::vector<TrailSphere> spheresOf(const ShownTrail& trail, double playhead,
                                   const PictureSelection& selection) {
  std::vector<TrailSphere> spheres;
  for (const app::PlacedSphere& sphere : trail.spheres) {
    const auto isIt = [&](double frame) { return sameFrame(frame, sphere.frame); };
    const bool chosen = std::any_of(selection.spheres.begin(), selection.spheres.end(), isIt);
    spheres.push_back({sphere.positionWorld, chosen,
                       selection.hoveredSphere && isIt(*selection.hoveredSphere),
                       std::abs(sphere.frame - playhead) <= nearSphereFrames});
  }
  return spheres;
}

/// Every so many of the path's samples, and the last one.
std::vector<Vec3> everySo(const std::vector<Vec3>& path, std::size_t stride) {
  std::vector<Vec3> drawn;
  for (std::size_t i = 0; i < path.size(); i += stride) {
    drawn.push_back(path[i]);
  }
  if (!path.empty() && (path.size() - 1) % stride != 0) {
    drawn.push_back(path.back());
  }
  return drawn;
}

/// Where a sample of a path of `count` stands among those that everySo() leaves.
double placeAmong(double sample, std::size_t count, std::size_t stride) {
  const std::size_t wholeSteps = (count - 1) / stride;
  const auto whole = static_cast<double>(wholeSteps);
  const auto step = static_cast<double>(stride);
  const double rest = static_cast<double>(count - 1) - whole * step;
  return sample <= whole * step ? sample / step : whole + (sample - whole * step) / rest;
}

TrailPicture pathOf(const ShownTrail& trail, double frame, const PictureSelection& selection,
                    const ViewportOverlays& overlays) {
  constexpr auto samples = static_cast<double>(pathSamplesPerFrame);
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(overlays.trailIncrement * samples)));
  const std::size_t count = trail.drawn.original.size();
  TrailPicture picture;
  picture.original = everySo(trail.drawn.original, stride);
  const double first = trail.drawn.frames.empty() ? 0.0 : trail.drawn.frames.front();
  const double sample = (frame - first) * samples;
  if (count > 0 && sample >= 0.0 && sample <= static_cast<double>(count) - 1.0) {
    picture.currentSample = placeAmong(sample, count, stride);
  }
  // A tick at every frame, or at every sample where those lie farther apart.
  picture.samplesPerFrame = overlays.trailTicks ? std::max<std::size_t>(1, pathSamplesPerFrame / stride) : 0;
  if (overlays.trailWindow) {
    picture.windowSamples =
        static_cast<double>(overlays.trailWindowFrames) * samples / static_cast<double>(stride);
  }
  if (isPickedOut(selection, trail.id)) {
    picture.spheres = spheresOf(trail, frame, selection);
  }
  if (trail.exaggerated) {
    const bool fromStart = trail.pivot == rig::Pivot::start;
    picture.exaggerated = everySo(trail.drawn.exaggerated, stride);
    picture.pivot = pointOnTrail(trail, fromStart ? trail.startFrame : trail.endFrame, true);
    picture.tip = pointOnTrail(trail, fromStart ? trail.endFrame : trail.startFrame, true);
  }
  return picture;
}

TrailStyle trailStyleOf(const ShownTrail& trail, const PictureSelection& selection,
                        const ViewportOverlays& overlays, const Palette& palette) {
  TrailStyle style;
  style.originalColor = palette.original;
  style.exaggeratedColor = palette.trails[static_cast<std::size_t>(trail.colour) % palette.trails.size()];
  style.currentColor = palette.label;
  style.exaggeratedWidthPoints = overlays.trailThickness;
  style.originalWidthPoints = std::max(1.0F, 0.5F * overlays.trailThickness);
  style.sphereRadiusPoints = overlays.sphereSize;
  const bool done = trail.applied && !selection.everyTrail;
  style.emphasised = (isPickedOut(selection, trail.id) && !done) || trail.id == selection.hoveredTrail;
  return style;
}

/// As a trail that is looked at: nothing of it can be taken.
StyledTrail momentTrail(const std::vector<Vec3>& path, const Palette& palette) {
  TrailPicture picture;
  picture.original = path;
  picture.exaggerated = path;
  picture.samplesPerFrame = 2;
  picture.tip = path.back();
  TrailStyle style;
  style.originalColor = palette.original;
  style.exaggeratedColor = palette.label;
  return {picture, style};
}

void addGhost(const PictureSubject& subject, double frame, const glm::vec4& tint,
              std::vector<Ghost>& ghosts) {
  const rig::MotionState& motion = subject.motion;
  if (frame >= 0.0 && frame <= motion.endSeconds * motion.framesPerSecond) {
    ghosts.push_back({app::evaluate(subject.document, motion, frame / motion.framesPerSecond), tint});
  }
}

/// The character at the frames around, the farthest first.
std::vector<Ghost> ghostsOf(const PictureSubject& subject, const ViewportOverlays& overlays,
                            const Palette& palette) {
  std::vector<Ghost> ghosts;
  if (!overlays.ghosts || subject.motion.clip < 0) {
    return ghosts;
  }
  const double step = std::max(1, overlays.ghostStepFrames);
  const auto tint = [](const glm::vec4& colour, int i, int count) {
    const float share = static_cast<float>(count + 1 - i) / static_cast<float>(count);
    return glm::vec4(glm::vec3(colour), nearestGhostOpacity * share);
  };
  for (int i = overlays.ghostsBefore; i >= 1; --i) {
    addGhost(subject, subject.frame - step * i, tint(palette.ghostBefore, i, overlays.ghostsBefore), ghosts);
  }
  for (int i = overlays.ghostsAfter; i >= 1; --i) {
    addGhost(subject, subject.frame + step * i, tint(palette.ghostAfter, i, overlays.ghostsAfter), ghosts);
  }
  return ghosts;
}

} // namespace

std::optional<AxisHandles> handlesOf(const ShownTrails& trails, int selectedTrail,
                                     const std::vector<double>& selectedSpheres) {
  const ShownTrail* trail = findShown(trails, selectedTrail);
  if (trail == nullptr || selectedSpheres.empty()) {
    return std::nullopt;
  }
  for (const app::PlacedSphere& sphere : trail->spheres) {
    if (sameFrame(sphere.frame, selectedSpheres.back())) {
      AxisHandles handles;
      handles.origin = sphere.positionWorld;
      return handles;
    }
  }
  return std::nullopt;
}

PictureContent assembleBare(const PictureSubject& subject, const PictureSelection& selection,
                            const ViewportOverlays& overlays, const Palette& palette) {
  PictureContent content;
  content.frame = subject.pose;
  content.style = sceneStyleOf(subject, selection, overlays, palette);
  return content;
}

void addHandles(const PictureSelection& selection, PictureContent& content) {
  content.controllers = selection.controllers;
  content.controllerHandles = selection.controllerHandles;
  content.activeHandle = selection.activeHandle;
}

PictureContent assemblePicture(const PictureSubject& subject, const PictureSelection& selection,
                               const ViewportOverlays& overlays, const Palette& palette) {
  PictureContent content = assembleBare(subject, selection, overlays, palette);
  content.ghosts = ghostsOf(subject, overlays, palette);
  if (selection.tipFrame && subject.motion.clip >= 0) {
    addGhost(subject, *selection.tipFrame, glm::vec4(glm::vec3(palette.ghostTip), tipGhostOpacity),
             content.ghosts);
  }
  content.skeleton = overlays.skeleton || selection.weightsOf.exists();
  for (const ShownTrail& trail : subject.trails.trails) {
    const rig::Trail* source = app::findTrail(subject.document, trail.id);
    if (source != nullptr && isDrawn(*source, selection.limbs, overlays)) {
      content.trails.push_back({pathOf(trail, subject.frame, selection, overlays),
                                trailStyleOf(trail, selection, overlays, palette)});
      if (trail.id == selection.trail) {
        content.handles = handlesOf(subject.trails, trail.id, selection.spheres);
      }
    }
  }
  if (!subject.trails.momentPath.empty()) {
    content.trails.push_back(momentTrail(subject.trails.momentPath, palette));
  }
  addHandles(selection, content);
  content.activeAxis = selection.hoveredAxis;
  return content;
}

Palette paletteOf(ThemeKind theme) {
  Palette palette = theme == ThemeKind::light          ? lightPalette()
                    : theme == ThemeKind::highContrast ? highContrastPalette()
                                                       : darkPalette();
  palette.original = toColour(originalColour(theme));
  for (std::size_t i = 0; i < palette.trails.size(); ++i) {
    palette.trails[i] = toColour(trailColour(static_cast<int>(i), theme));
  }
  return palette;
}

glm::vec4 toColour(ImU32 colour) {
  const ImVec4 value = ImGui::ColorConvertU32ToFloat4(colour);
  return {value.x, value.y, value.z, value.w};
}

ImU32 packed(const glm::vec4& colour) {
  return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0F});
}

} // namespace stretch::ui
