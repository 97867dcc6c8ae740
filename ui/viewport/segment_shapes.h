#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <glm/vec4.hpp>

#include "app/sequence/sequence_document.h"
#include "ui/render/scene/sequence_scene.h"

namespace stretch::ui {

// The segments of a body: of its result the bones, before that those of its centre line.

/// The segments that a vertex belongs to, one list for each vertex; weights sum to 1.
[[nodiscard]] std::vector<skinning::Influences> segmentsOfVertices(const app::SequenceAnalysis& analysis,
                                                                   const skinning::SkinnedSequence* result);

[[nodiscard]] std::size_t segmentCount(const app::SequenceAnalysis& analysis,
                                       const skinning::SkinnedSequence* result);

/// Colour of a segment, sRGB: neighbours differ.
[[nodiscard]] glm::vec4 segmentColor(std::size_t segment);

/// One colour for each vertex, linear light, mixed of those of its segments.
[[nodiscard]] std::vector<glm::vec4> segmentColors(const std::vector<skinning::Influences>& segments);

/// The segments as cylinders, as wide as the surface around them is in the first frame (the mean shape
/// diameter). Those of a result turn and stretch as its bones do, and one of a bone without length is as long
/// as wide; those of a centre line lie along it.
class SegmentCylinders {
public:
  /// `analysis` has shape diameters, and a centre line where there is no result (null). Both must outlive
  /// this.
  SegmentCylinders(const app::SequenceAnalysis& analysis, const skinning::SkinnedSequence* result);

  [[nodiscard]] std::size_t count() const { return widths_.size(); }
  [[nodiscard]] const std::vector<double>& widths() const { return widths_; }
  /// All of them in a frame, in the colours of their segments.
  [[nodiscard]] PlainMesh meshAt(std::size_t frame) const;

private:
  void add(PlainMesh& mesh, std::size_t segment, std::size_t frame) const;

  const app::SequenceAnalysis& analysis_;
  const skinning::SkinnedSequence* result_;
  std::vector<double> widths_;
  std::vector<Triangle> triangles_;
};

} // namespace stretch::ui
