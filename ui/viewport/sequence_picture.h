#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/sequence/sequence_session.h"
#include "ui/render/overlay/overlay.h"
#include "ui/render/scene/sequence_scene.h"
#include "ui/render/scene/sequence_surface.h"
#include "ui/render/view/palette.h"
#include "ui/viewport/segment_shapes.h"

namespace stretch::ui {

// The one place that says what is drawn of a mesh sequence: the window and the verb `render` both ask here.

/// Input from which a picture of a sequence is made.
struct SequenceContent {
  std::shared_ptr<const MeshSequence> original;
  std::shared_ptr<const app::SequenceAnalysis> analysis; ///< Null where only materials and comparison are
                                                         ///< asked for.
  std::shared_ptr<const app::Compression> result;        ///< Null: none.
  std::shared_ptr<const MeshSequence> resultFrames; ///< A result that was read from a file; same vertices and
                                                    ///< frames as the original. Null: none.

  [[nodiscard]] bool hasResult() const { return result != nullptr || resultFrames != nullptr; }
};

[[nodiscard]] SequenceContent contentOf(const app::SequenceDocument& document);

/// Legend of the colours of a picture.
struct SequenceLegend {
  std::string title;
  std::string low;
  std::string high;
  std::string detail;
  std::function<glm::vec4(double)> colour; ///< Colour of a share 0..1, sRGB.
};

/// One look at a sequence: a scene that stays over the frames, and each frame as a shape of it. With values
/// as colours, or materials, two surfaces would only hide each other: the result is shown where there is one.
class SequencePicture {
public:
  /// A look that the content has nothing for is the comparison.
  SequencePicture(SequenceContent content, const app::SequenceView& view);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] SceneShape shapeAt(std::size_t frame) const;
  /// Nothing for looks without a scale.
  [[nodiscard]] const std::optional<SequenceLegend>& legend() const { return legend_; }

private:
  [[nodiscard]] bool showsResult() const;
  [[nodiscard]] std::vector<glm::vec3> resultAt(std::size_t frame) const;
  [[nodiscard]] std::vector<glm::vec3> originalAt(std::size_t frame) const;
  [[nodiscard]] std::vector<PlainMesh> meshesAt(std::size_t frame) const;
  [[nodiscard]] PlainMesh valuesAt(std::size_t frame) const;
  [[nodiscard]] std::vector<PlainMesh> comparedAt(std::size_t frame) const;
  void prepare();
  [[nodiscard]] std::optional<SequenceLegend> makeLegend() const;
  [[nodiscard]] SequenceLegend segmentLegend() const;
  [[nodiscard]] double largestError() const;

  SequenceContent content_;
  app::SequenceView view_;
  std::optional<SequenceSurface> surface_;
  std::optional<SegmentCylinders> cylinders_;
  std::vector<glm::vec4> colors_; ///< One for each vertex, of looks whose colours stay over the frames.
  double largestShown_ = 0.0;     ///< At the end of the scale.
  Scene scene_;
  std::optional<SequenceLegend> legend_;
};

/// The bones of the result in a frame, or before there is one the centre line, over everything. Needs the
/// analysis.
[[nodiscard]] Overlay drawBones(const SequenceContent& content, std::size_t frame, const Palette& palette);

} // namespace stretch::ui
