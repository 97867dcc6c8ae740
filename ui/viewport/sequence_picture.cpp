#include "ui/viewport/sequence_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "ui/render/overlay/skeleton_drawing.h"
#include "ui/render/scene/value_colors.h"
#include "ui/viewport/assemble_picture.h"
#include "ui/widgets/theme.h"

namespace stretch::ui {

namespace {

using app::SequenceLook;

/// What the editor would hold of the sequence.
app::SequenceDocument documentOf(const SequenceContent& content) {
  app::SequenceDocument document;
  document.analysis = content.analysis;
  document.result = content.result;
  return document;
}

/// Whether there is what the look shows.
bool canShow(const SequenceContent& content, SequenceLook look) {
  if (look == SequenceLook::error) {
    return content.hasResult();
  }
  if (content.analysis == nullptr) {
    return look == SequenceLook::material || look == SequenceLook::compare;
  }
  return app::canShow(documentOf(content), look);
}

const skinning::SkinnedSequence* skinnedOf(const SequenceContent& content) {
  return content.result == nullptr ? nullptr : &content.result->compressed.skinned;
}

Marker jointMarker(const Vec3& place, const SkeletonStyle& style) {
  Marker joint;
  joint.world = place;
  joint.radiusPoints = style.jointPoints;
  joint.fill = style.bone;
  joint.depth = OverlayDepth::onTop;
  return joint;
}

} // namespace

SequenceContent contentOf(const app::SequenceDocument& document) {
  return {document.mesh, document.analysis, document.result, nullptr};
}

SequencePicture::SequencePicture(SequenceContent content, const app::SequenceView& view)
    : content_(std::move(content)), view_(view) {
  const bool showsOne = showsResult() || view.showOriginal;
  view_.look = showsOne && canShow(content_, view.look) ? view.look : SequenceLook::compare;
  if (view_.look == SequenceLook::material) {
    surface_.emplace(*content_.original);
    scene_ = surface_->scene();
  } else {
    prepare();
    scene_ = sceneOfMeshes(meshesAt(0));
  }
  legend_ = makeLegend();
}

/// Makes what a look needs that stays over the frames.
void SequencePicture::prepare() {
  if (view_.look == SequenceLook::cylinders) {
    cylinders_.emplace(*content_.analysis, skinnedOf(content_));
  } else if (view_.look == SequenceLook::segments) {
    colors_ = segmentColors(segmentsOfVertices(*content_.analysis, skinnedOf(content_)));
  } else if (view_.look == SequenceLook::thickness) {
    const std::vector<double>& diameters = content_.analysis->vertexDiameters;
    largestShown_ = *std::max_element(diameters.begin(), diameters.end());
    colors_ = valueColors(ValueScale::thickness, std::vector<float>(diameters.begin(), diameters.end()),
                          largestShown_);
  } else if (view_.look == SequenceLook::error) {
    largestShown_ = largestError();
  }
}

bool SequencePicture::showsResult() const {
  return content_.hasResult() && view_.showSkinned;
}

std::vector<glm::vec3> SequencePicture::originalAt(std::size_t frame) const {
  const std::span<const glm::vec3> places = std::as_const(*content_.original).frame(frame);
  return {places.begin(), places.end()};
}

std::vector<glm::vec3> SequencePicture::resultAt(std::size_t frame) const {
  if (content_.resultFrames != nullptr) {
    const std::span<const glm::vec3> places = std::as_const(*content_.resultFrames).frame(frame);
    return {places.begin(), places.end()};
  }
  std::vector<glm::vec3> places(content_.original->vertexCount);
  skinning::skinFrame(content_.result->compressed.skinned, frame, places);
  return places;
}

/// Three times the root of the mean squared error, so that one outlier does not grey everything else.
double SequencePicture::largestError() const {
  const double diagonal = extentOf(*content_.original).diagonal;
  if (content_.result != nullptr) {
    return 0.03 * content_.result->compressed.metrics.rmsePercent * diagonal;
  }
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t frame = 0; frame < content_.original->frameCount(); ++frame) {
    const std::vector<glm::vec3> places = resultAt(frame);
    for (std::size_t v = 0; v < places.size(); ++v, ++count) {
      const glm::vec3 off = places[v] - std::as_const(*content_.original).frame(frame)[v];
      squares += static_cast<double>(glm::dot(off, off));
    }
  }
  return count == 0 ? 0.0 : 3.0 * std::sqrt(squares / static_cast<double>(count));
}

PlainMesh SequencePicture::valuesAt(std::size_t frame) const {
  const std::vector<Triangle>& triangles = content_.original->triangles;
  if (view_.look != SequenceLook::error) {
    return {showsResult() ? resultAt(frame) : originalAt(frame), triangles, colors_};
  }
  PlainMesh mesh{resultAt(frame), triangles, {}};
  const std::vector<glm::vec3> original = originalAt(frame);
  std::vector<float> errors(original.size());
  for (std::size_t v = 0; v < errors.size(); ++v) {
    errors[v] = glm::distance(mesh.positions[v], original[v]);
  }
  mesh.colors = valueColors(ValueScale::error, errors, largestShown_);
  return mesh;
}

std::vector<PlainMesh> SequencePicture::comparedAt(std::size_t frame) const {
  const std::vector<Triangle>& triangles = content_.original->triangles;
  std::vector<PlainMesh> meshes;
  if (view_.showOriginal) {
    meshes.push_back({originalAt(frame), triangles, {linearLight(toColour(originalMeshColour))}});
  }
  if (showsResult()) {
    meshes.push_back({resultAt(frame), triangles, {linearLight(toColour(skinnedMeshColour))}});
  }
  return meshes;
}

std::vector<PlainMesh> SequencePicture::meshesAt(std::size_t frame) const {
  if (view_.look == SequenceLook::compare) {
    return comparedAt(frame);
  }
  return {cylinders_ ? cylinders_->meshAt(frame) : valuesAt(frame)};
}

SceneShape SequencePicture::shapeAt(std::size_t frame) const {
  return surface_ ? surface_->shapeAt(showsResult() ? resultAt(frame) : originalAt(frame))
                  : shapeOfMeshes(meshesAt(frame));
}

std::optional<SequenceLegend> SequencePicture::makeLegend() const {
  const auto scaleColour = [](ValueScale scale) {
    return [scale](double share) { return rgba(valueColorHex(scale, share)); };
  };
  if (view_.look == SequenceLook::error) {
    const double diagonal = extentOf(*content_.original).diagonal;
    return SequenceLegend{"Distance to the original", "0",
                          fmt::format("{:.3g} units and more", largestShown_),
                          fmt::format("{:.3g} % of the diagonal", 100.0 * largestShown_ / diagonal),
                          scaleColour(ValueScale::error)};
  }
  if (view_.look == SequenceLook::thickness) {
    return SequenceLegend{"Shape diameter", "0", fmt::format("{:.3g} units", largestShown_),
                          "of the first frame", scaleColour(ValueScale::thickness)};
  }
  if (view_.look == SequenceLook::segments || view_.look == SequenceLook::cylinders) {
    return segmentLegend();
  }
  return std::nullopt;
}

SequenceLegend SequencePicture::segmentLegend() const {
  const std::size_t last = segmentCount(*content_.analysis, skinnedOf(content_)) - 1;
  SequenceLegend legend{"Segments", "0", fmt::format("{}", last), "", [last](double share) {
                          const double segment = share * static_cast<double>(last + 1);
                          return segmentColor(std::min(last, static_cast<std::size_t>(segment)));
                        }};
  if (cylinders_) {
    const auto [least, most] = std::ranges::minmax(cylinders_->widths());
    legend.detail = fmt::format("{:.3g} to {:.3g} units wide", least, most);
  }
  return legend;
}

Overlay drawBones(const SequenceContent& content, std::size_t frame, const Palette& palette) {
  const SkeletonStyle style = skeletonStyle(palette);
  Overlay overlay;
  for (const app::ShownBone& shown : app::bonesAt(documentOf(content), frame)) {
    Polyline bone;
    bone.points = {{shown.start, style.bone, style.widthPoints},
                   {shown.end, style.bone, 0.5F * style.widthPoints}};
    bone.depth = OverlayDepth::onTop;
    bone.outlined = true;
    overlay.lines.push_back(bone);
    overlay.markers.push_back(jointMarker(shown.start, style));
    if (shown.isLast) {
      overlay.markers.push_back(jointMarker(shown.end, style));
    }
  }
  return overlay;
}

} // namespace stretch::ui
