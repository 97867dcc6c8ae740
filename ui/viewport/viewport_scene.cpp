#include "ui/viewport/viewport_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "app/commands/frames.h"
#include "app/commands/selection.h"
#include "app/edits/mirror_edits.h"
#include "rig/limb_points.h"
#include "ui/render/handle_drawing.h"
#include "ui/render/skeleton_drawing.h"
#include "ui/render/trail_drawing.h"
#include "ui/widgets/theme.h"

namespace stretch::ui {

namespace {

constexpr std::size_t samplesPerFrame = 2; ///< Of a drawn path.
constexpr float hoveredHighlight = 0.45F;

ShownTrail showTrail(const rig::SolvedTrail& solved, const app::TrailPaths& paths) {
  ShownTrail shown;
  shown.id = solved.trail.id;
  shown.colour = solved.trail.colour;
  shown.exaggerated = solved.trail.exaggerated;
  shown.startFrame = solved.settings.startFrame;
  shown.endFrame = solved.settings.endFrame;
  shown.pivot = solved.settings.pivot;
  shown.drawn = paths.drawn;
  const rig::DrawnTrail& spheres = paths.spheres;
  for (std::size_t i = 0; i < spheres.frames.size(); ++i) {
    shown.spheres.push_back(
        {spheres.frames[i], shown.exaggerated ? spheres.exaggerated[i] : spheres.original[i]});
  }
  return shown;
}

/// The paths, and where the playhead is on them.
TrailPicture pathsOf(const ShownTrail& trail, double frame) {
  TrailPicture picture;
  picture.original = trail.drawn.original;
  if (trail.exaggerated) {
    picture.exaggerated = trail.drawn.exaggerated;
  }
  const double first = trail.drawn.frames.empty() ? 0.0 : trail.drawn.frames.front();
  const double sample = (frame - first) * static_cast<double>(samplesPerFrame);
  if (sample >= 0.0 && sample <= static_cast<double>(picture.original.size()) - 1.0) {
    picture.currentSample = sample;
  }
  return picture;
}

TrailPicture pictureOf(const app::Session& session, const UiState& ui, const ViewportState& viewport,
                       const ShownTrail& trail) {
  TrailPicture picture = pathsOf(trail, session.view().frame);
  const double ticks =
      std::max(1.0, std::round(ui.overlays.trailIncrement * static_cast<double>(samplesPerFrame)));
  picture.samplesPerFrame = ui.overlays.trailTicks ? static_cast<std::size_t>(ticks) : 0;
  if (ui.overlays.trailWindow) {
    picture.windowSamples =
        static_cast<double>(ui.overlays.trailWindowFrames) * static_cast<double>(samplesPerFrame);
  }
  const bool selected = trail.id == session.view().selectedTrail;
  if (selected) {
    const auto& chosen = session.view().selectedSpheres;
    for (const app::PlacedSphere& sphere : trail.spheres) {
      const bool isChosen = std::any_of(chosen.begin(), chosen.end(),
                                        [&](double frame) { return app::sameFrame(frame, sphere.frame); });
      const bool hovered = viewport.hoveredSphere && app::sameFrame(*viewport.hoveredSphere, sphere.frame);
      picture.spheres.push_back({sphere.positionWorld, isChosen, hovered});
    }
  }
  if (trail.exaggerated) {
    const bool fromStart = trail.pivot == rig::Pivot::start;
    picture.pivot = pointOnTrail(trail, fromStart ? trail.startFrame : trail.endFrame, true);
    picture.tip = pointOnTrail(trail, fromStart ? trail.endFrame : trail.startFrame, true);
  }
  return picture;
}

TrailStyle styleOf(const app::Session& session, const UiState& ui, const ViewportState& viewport,
                   const ShownTrail& trail, const Palette& palette) {
  TrailStyle style;
  style.originalColor = toColour(originalTrailColour);
  style.exaggeratedColor = toColour(trailColour(trail.colour));
  style.currentColor = palette.label;
  style.exaggeratedWidthPoints = ui.overlays.trailThickness;
  style.originalWidthPoints = std::max(1.0F, 0.5F * ui.overlays.trailThickness);
  style.sphereRadiusPoints = ui.overlays.sphereSize;
  style.emphasised = trail.id == session.view().selectedTrail || trail.id == viewport.hoveredTrail;
  return style;
}

void addGhost(app::Session& session, double frame, const glm::vec4& tint, std::vector<Ghost>& ghosts) {
  const app::Document& document = session.document();
  const int clip = session.view().clip;
  if (frame < 0.0 || frame > app::lastFrame(document, clip)) {
    return;
  }
  const double seconds = frame / app::clipOf(document, clip).framesPerSecond;
  ghosts.push_back({app::evaluate(document, session.motion(), seconds), tint});
}

} // namespace

void updateShownTrails(app::Session& session, ShownTrails& shown) {
  std::shared_ptr<const rig::MotionState> motion = session.sharedMotion();
  if (shown.madeFrom == motion) {
    return;
  }
  shown = {{}, std::move(motion)};
  if (!app::hasClip(session.document(), session.view().clip)) {
    return;
  }
  const std::vector<app::TrailPaths>& paths = session.paths(samplesPerFrame);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    shown.trails.push_back(showTrail(shown.madeFrom->trails[i], paths[i]));
  }
}

const ShownTrail* findShown(const ShownTrails& shown, int trailId) {
  const auto found = std::find_if(shown.trails.begin(), shown.trails.end(),
                                  [&](const ShownTrail& trail) { return trail.id == trailId; });
  return found == shown.trails.end() ? nullptr : &*found;
}

bool isDrawn(const app::Session& session, const ViewportOverlays& overlays, const rig::Trail& trail) {
  const auto& limbs = session.view().selectedLimbs;
  const bool selected = std::find(limbs.begin(), limbs.end(), trail.limb) != limbs.end();
  return trail.visible && (trail.pinned || selected || !overlays.trailsOnlyWhenSelected);
}

Vec3 pointOnTrail(const ShownTrail& trail, double frame, bool exaggerated) {
  const std::vector<Vec3>& points = exaggerated ? trail.drawn.exaggerated : trail.drawn.original;
  const std::vector<double>& frames = trail.drawn.frames;
  if (points.empty()) {
    return Vec3(0.0);
  }
  const auto after = std::lower_bound(frames.begin(), frames.end(), frame - 1e-6);
  const auto index = static_cast<std::size_t>(after - frames.begin());
  if (index == 0 || index >= points.size()) {
    return index == 0 ? points.front() : points.back();
  }
  const double share = (frame - frames[index - 1]) / (frames[index] - frames[index - 1]);
  return glm::mix(points[index - 1], points[index], std::clamp(share, 0.0, 1.0));
}

std::optional<AxisHandles> handlesOf(const app::Session& session, const ShownTrails& shown) {
  const ShownTrail* trail = findShown(shown, session.view().selectedTrail);
  const std::vector<double>& selected = session.view().selectedSpheres;
  if (trail == nullptr || selected.empty()) {
    return std::nullopt;
  }
  for (const app::PlacedSphere& sphere : trail->spheres) {
    if (app::sameFrame(sphere.frame, selected.back())) {
      AxisHandles handles;
      handles.origin = sphere.positionWorld;
      return handles;
    }
  }
  return std::nullopt;
}

LimbBones limbBones(const app::Document& document, const FrameState& frame) {
  LimbBones result;
  for (const rig::Limb& limb : app::allLimbs(document)) {
    if (limb.joints.empty()) {
      continue;
    }
    const std::vector<Vec3> points = rig::limbPoints(limb, frame);
    for (std::size_t i = 0; i < limb.joints.size(); ++i) {
      result.bones.push_back({limb.joints[i], points[i], points[i + 1]});
      result.limbOf.push_back(limb.id);
    }
  }
  return result;
}

std::vector<float> highlightOf(const app::Session& session, const std::string& hoveredLimb) {
  const app::Document& document = session.document();
  std::vector<float> highlight(document.scene->nodes.size(), 0.0F);
  const auto mark = [&](const std::string& limbId, float amount) {
    const rig::Limb* limb = app::findLimb(document, limbId);
    for (const NodeIndex joint : limb == nullptr ? std::vector<NodeIndex>{} : limb->joints) {
      float& value = highlight[at(joint)];
      value = std::max(value, amount);
    }
  };
  mark(hoveredLimb, hoveredHighlight);
  for (const std::string& limbId : session.view().selectedLimbs) {
    mark(limbId, 1.0F);
  }
  return highlight;
}

Overlay overlayOf(app::Session& session, const UiState& ui, const ViewportState& viewport,
                  const FrameState& frame, const Palette& palette) {
  Overlay overlay;
  if (ui.overlays.skeleton) {
    overlay.add(drawSkeleton(*session.document().scene, frame, skeletonStyle(palette),
                             highlightOf(session, viewport.hoveredLimb)));
  }
  for (const ShownTrail& trail : viewport.shown.trails) {
    const rig::Trail* source = app::findTrail(session.document(), trail.id);
    if (source != nullptr && isDrawn(session, ui.overlays, *source)) {
      overlay.add(drawTrail(viewport.view, pictureOf(session, ui, viewport, trail),
                            styleOf(session, ui, viewport, trail, palette)));
    }
  }
  if (const auto handles = handlesOf(session, viewport.shown)) {
    overlay.add(drawAxisHandles(viewport.view, *handles, viewport.hoveredAxis));
  }
  return overlay;
}

std::vector<Ghost> ghostsOf(app::Session& session, const ViewportOverlays& overlays) {
  std::vector<Ghost> ghosts;
  if (!overlays.ghosts || !app::hasClip(session.document(), session.view().clip)) {
    return ghosts;
  }
  const double step = std::max(1, overlays.ghostStepFrames);
  const auto opacity = [](int i, int count) {
    return 0.34F * static_cast<float>(count + 1 - i) / static_cast<float>(count);
  };
  for (int i = overlays.ghostsBefore; i >= 1; --i) {
    addGhost(session, session.view().frame - step * i,
             rgba(okabe::skyBlue, opacity(i, overlays.ghostsBefore)), ghosts);
  }
  for (int i = overlays.ghostsAfter; i >= 1; --i) {
    addGhost(session, session.view().frame + step * i, rgba(okabe::orange, opacity(i, overlays.ghostsAfter)),
             ghosts);
  }
  return ghosts;
}

Box selectionBox(app::Session& session, const ShownTrails& shown) {
  Box box;
  const app::Document& document = session.document();
  const FrameState& frame = session.frameAt(session.view().frame);
  const LimbBones bones = limbBones(document, frame);
  const auto& limbs = session.view().selectedLimbs;
  for (std::size_t i = 0; i < bones.bones.size(); ++i) {
    if (std::find(limbs.begin(), limbs.end(), bones.limbOf[i]) != limbs.end()) {
      box.add(bones.bones[i].fromWorld);
      box.add(bones.bones[i].toWorld);
    }
  }
  if (const ShownTrail* trail = findShown(shown, session.view().selectedTrail)) {
    for (const Vec3& point : trail->drawn.original) {
      box.add(point);
    }
    for (const Vec3& point : trail->drawn.exaggerated) {
      box.add(point);
    }
  }
  return box;
}

double facingYaw(const app::Document& document, int clip) {
  const Vec3 left =
      app::hasClip(document, clip) ? app::sagittalNormal(document, clip, 0.0) : Vec3(1.0, 0.0, 0.0);
  const Vec3 forward = glm::cross(left, Vec3(0.0, 1.0, 0.0));
  // The view is the scene's own (front, side, top as animators know them) from the character's side of it: a
  // boxer who stands half turned is still seen along the axes.
  const double quarterTurn = 0.5 * pi;
  return quarterTurn * std::round(std::atan2(forward.x, forward.z) / quarterTurn);
}

glm::vec4 toColour(std::uint32_t colour) {
  const ImVec4 value = ImGui::ColorConvertU32ToFloat4(colour);
  return {value.x, value.y, value.z, value.w};
}

} // namespace stretch::ui
