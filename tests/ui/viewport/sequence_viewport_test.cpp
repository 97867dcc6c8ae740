// What the viewport keeps of a mesh sequence while it plays, and its looks.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/ui/gui_stage.h"
#include "ui/render/scene/value_colors.h"
#include "ui/viewport/segment_shapes.h"
#include "ui/viewport/sequence_picture.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

app::SequenceDocument tubeDocument(bool compressed) {
  app::SequenceDocument document;
  document.paths = {"tube"};
  document.mesh = std::make_shared<const MeshSequence>(test::shorteningTube(8, 2.0, 0.06, 0.1));
  document.analysis = std::make_shared<const app::SequenceAnalysis>(app::analyseSequence(*document.mesh));
  document.settings.bones = 7;
  document.settings.stretch = skinning::StretchOption::measured;
  if (compressed) {
    auto made = app::makeCompression(*document.mesh, document.settings);
    REQUIRE(made);
    document.result = std::make_shared<const app::Compression>(std::move(made).value());
  }
  return document;
}

SequencePicture pictureOf(const app::SequenceDocument& document, app::SequenceLook look) {
  app::SequenceView view;
  view.look = look;
  return {contentOf(document), view};
}

} // namespace

TEST_CASE("while a sequence plays its vertices move, and nothing else is uploaded again") {
  test::GuiPainter painter;
  test::GuiStage stage(painter, ThemeKind::dark, 264.0F, 240.0F);
  stage.open.open(tubeDocument(false));
  stage.showViewport();
  const ViewportGpu& gpu = painter.viewportGpu();
  const Scene* const scene = gpu.uploaded.get();
  const std::uint64_t shapes = gpu.sequence.shapes;
  const Image first = stage.picture();
  stage.showViewport();
  CHECK(gpu.sequence.shapes == shapes);
  stage.open.sequence()->view().frame = 7.0;
  stage.showViewport();
  CHECK(gpu.uploaded.get() == scene);
  CHECK(gpu.sequence.shapes == shapes + 1);
  CHECK(stage.picture().rgba != first.rgba);
  stage.open.sequence()->view().look = app::SequenceLook::segments;
  stage.showViewport();
  CHECK(gpu.uploaded.get() != scene);
}

TEST_CASE("the original and the result are shown each by itself, and the result goes when it is taken back") {
  test::GuiPainter painter;
  test::GuiStage stage(painter, ThemeKind::dark, 264.0F, 240.0F);
  stage.open.open(tubeDocument(true));
  app::SequenceSession& session = *stage.open.sequence();
  session.view().look = app::SequenceLook::compare;
  const auto meshesShown = [&] {
    stage.showViewport();
    return painter.viewportGpu().uploaded->meshes.size();
  };
  CHECK(meshesShown() == 2);
  session.view().showOriginal = false;
  CHECK(meshesShown() == 1);
  session.view().showOriginal = true;
  CHECK(meshesShown() == 2);
  session.view().showSkinned = false;
  CHECK(meshesShown() == 1);
  session.view().showSkinned = true;
  CHECK(meshesShown() == 2);
  app::SequenceDocument without = session.document();
  without.result = nullptr;
  session.edit(std::move(without), "Forget the result");
  CHECK(meshesShown() == 1);
}

TEST_CASE("a sequence is framed with all of its frames in the picture, and a small margin") {
  test::GuiPainter painter;
  test::GuiStage stage(painter, ThemeKind::dark, 264.0F, 240.0F);
  stage.open.open(tubeDocument(false));
  const bool all = GENERATE(false, true);
  stage.viewport.framePending = all;
  stage.viewport.frameSelectionPending = !all;
  stage.showViewport();
  const app::SequenceAnalysis& analysis = *stage.open.sequence()->document().analysis;
  const View& view = stage.viewport.view;
  double farthest = 0.0; // of a corner from the picture's middle, in parts of its sides
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1U) != 0 ? analysis.high.x : analysis.low.x,
                     (corner & 2U) != 0 ? analysis.high.y : analysis.low.y,
                     (corner & 4U) != 0 ? analysis.high.z : analysis.low.z);
    const Vec2 pixels = projectToPixels(view, point).value().pixels;
    farthest = std::max({farthest, std::abs(pixels.x / view.viewport.widthPixels - 0.5),
                         std::abs(pixels.y / view.viewport.heightPixels - 0.5)});
  }
  CHECK(farthest == Approx(0.44));
}

TEST_CASE("the cylinders of a centre line lie along it in each frame") {
  const app::SequenceDocument document = tubeDocument(false);
  const SegmentCylinders cylinders(*document.analysis, nullptr);
  for (const std::size_t frame : {0U, 7U}) {
    CAPTURE(frame);
    const std::vector<Vec3>& joints = document.analysis->joints[frame];
    REQUIRE(joints.size() == cylinders.count() + 1);
    const PlainMesh mesh = cylinders.meshAt(frame);
    const std::size_t each = mesh.positions.size() / cylinders.count();
    for (const std::size_t segment : {std::size_t{0}, std::size_t{12}, cylinders.count() - 1}) {
      Vec3 sum(0.0);
      for (std::size_t v = segment * each; v < (segment + 1) * each; ++v) {
        sum += Vec3(mesh.positions[v]);
      }
      const Vec3 middle = 0.5 * (joints[segment] + joints[segment + 1]);
      CHECK(glm::distance(sum / static_cast<double>(each), middle) < 1e-4);
    }
  }
  CHECK(glm::distance(document.analysis->joints[0].back(), document.analysis->joints[7].back()) > 0.1);
}

TEST_CASE("the bones of a centre line are drawn from joint to joint, each joint once") {
  const app::SequenceDocument document = tubeDocument(false);
  const std::vector<Vec3>& joints = document.analysis->joints[7];
  const Overlay overlay = drawBones(contentOf(document), 7, darkPalette());
  REQUIRE(overlay.lines.size() == joints.size() - 1);
  REQUIRE(overlay.markers.size() == joints.size());
  for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
    const std::vector<LinePoint>& bone = overlay.lines[i].points;
    REQUIRE(bone.size() == 2);
    CHECK((bone[0].world == joints[i] && bone[1].world == joints[i + 1]));
    CHECK(bone[1].widthPoints < bone[0].widthPoints); // It tapers away from its joint.
    CHECK(overlay.markers[i].world == joints[i]);
  }
  CHECK(overlay.markers.back().world == joints.back());
}

TEST_CASE("errors of a clip that was read are coloured up to three times their root mean square") {
  const MeshSequence body = test::still(test::box({3, 4, 12}, 1.0)); // whose diagonal is 13
  MeshSequence moved = body;
  for (glm::vec3& place : moved.positions) {
    place.y += 0.1F;
  }
  app::SequenceView view;
  view.look = app::SequenceLook::error;
  const SequencePicture picture({std::make_shared<const MeshSequence>(body), nullptr, nullptr,
                                 std::make_shared<const MeshSequence>(moved)},
                                view);
  REQUIRE(picture.legend());
  CHECK(picture.legend()->high == "0.3 units and more");
  CHECK(picture.legend()->detail == "2.31 % of the diagonal");
  const SceneShape shape = picture.shapeAt(0);
  REQUIRE(shape.size() == 1);
  REQUIRE(shape[0].colors.size() == body.vertexCount);
  for (const glm::vec4& color : shape[0].colors) {
    CHECK(glm::distance(color, valueColor(ValueScale::error, 1.0 / 3.0)) < 1e-3F);
  }
}

TEST_CASE("the segments of a body are cylinders as wide as it is, and stretch as its bones do") {
  const app::SequenceDocument document = tubeDocument(true);
  const SegmentCylinders cylinders(*document.analysis, &document.result->compressed.skinned);
  REQUIRE(cylinders.count() == 7);
  for (std::size_t middle = 1; middle < 6; ++middle) {
    CHECK(cylinders.widths()[middle] == Approx(1.0).epsilon(0.1));
  }
  const std::size_t perCylinder = cylinders.meshAt(0).positions.size() / 7;
  const auto height = [](std::span<const glm::vec3> positions) {
    const auto [low, high] = std::ranges::minmax(positions, {}, &glm::vec3::y);
    return static_cast<double>(high.y - low.y);
  };
  const auto cylinderHeight = [&](std::size_t frame) {
    const PlainMesh mesh = cylinders.meshAt(frame);
    return height(std::span(mesh.positions).subspan(3 * perCylinder, perCylinder));
  };
  const MeshSequence& tube = *document.mesh;
  const double flattened = height(tube.frame(7)) / height(tube.frame(0));
  REQUIRE(flattened < 0.97);
  CHECK(cylinderHeight(0) == Approx(cylinders.widths()[3]).epsilon(0.02));
  CHECK(cylinderHeight(7) / cylinderHeight(0) == Approx(flattened).margin(0.01));
}

TEST_CASE("before there is a result the segments are those of the centre line") {
  const app::SequenceDocument document = tubeDocument(false);
  CHECK(SegmentCylinders(*document.analysis, nullptr).count() == 30);
  const auto legend = pictureOf(document, app::SequenceLook::segments).legend();
  REQUIRE(legend);
  CHECK(legend->high == "29");
  CHECK(legend->colour(0.0) != legend->colour(1.5 / 30.0));
}

TEST_CASE("looks that show values say what their colours mean, with figures") {
  const app::SequenceDocument document = tubeDocument(true);
  const auto error = pictureOf(document, app::SequenceLook::error).legend();
  REQUIRE(error);
  CHECK_THAT(error->detail, Catch::Contains("% of the diagonal"));
  const auto cylinders = pictureOf(document, app::SequenceLook::cylinders).legend();
  REQUIRE(cylinders);
  CHECK_THAT(cylinders->detail, Catch::Contains("units wide"));
  CHECK_FALSE(pictureOf(document, app::SequenceLook::material).legend());
}

TEST_CASE("vertices take the colours of their bones, mixed by the weights") {
  std::vector<skinning::Influences> segments(2);
  segments[0].bones = {1, 0, 0, 0};
  segments[0].weights = {1.0F, 0.0F, 0.0F, 0.0F};
  segments[1].bones = {1, 2, 0, 0};
  segments[1].weights = {0.5F, 0.5F, 0.0F, 0.0F};
  const auto colors = segmentColors(segments);
  CHECK(colors[0] == linearLight(segmentColor(1)));
  CHECK(colors[1].r == Approx(0.5 * (linearLight(segmentColor(1)).r + linearLight(segmentColor(2)).r)));
}

TEST_CASE("the cylinders of segments are closed, of a result and of a centre line") {
  const bool compressed = GENERATE(false, true);
  const app::SequenceDocument document = tubeDocument(compressed);
  const SegmentCylinders cylinders(*document.analysis,
                                   compressed ? &document.result->compressed.skinned : nullptr);
  const PlainMesh mesh = cylinders.meshAt(3);
  REQUIRE_FALSE(mesh.triangles.empty());
  std::map<std::pair<int, int>, int> edges; // of the places, since a lid may have vertices of its own
  const std::size_t each = mesh.positions.size() / cylinders.count();
  const auto placeOf = [&](std::size_t vertex) {
    const auto first = mesh.positions.begin() + static_cast<std::ptrdiff_t>(vertex / each * each);
    const auto same =
        std::find_if(first, first + static_cast<std::ptrdiff_t>(each), [&](const glm::vec3& other) {
          return glm::distance(other, mesh.positions[vertex]) < 1e-6F;
        });
    return static_cast<int>(same - mesh.positions.begin());
  };
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{placeOf(triangle[i]), placeOf(triangle[(i + 1) % 3])}];
    }
  }
  for (const auto& [edge, count] : edges) {
    CHECK(count == 1);
    CHECK(edges.contains({edge.second, edge.first}));
  }
}
