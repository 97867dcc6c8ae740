#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <optional>

#include "app/commands/table/selection.h"
#include "app/evaluate/evaluate.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/render_frame.h"
#include "ui/batch/sequence_pictures.h"
#include "ui/panels/body/weight_view.h"
#include "ui/render/picture/image_edits.h"
#include "ui/viewport/viewport_scene.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The boxer with a trail of its left arm, exaggerated twice.
app::Document punch() {
  return test::withNewTrail(test::boxer(), {.startFrame = 2.0, .endFrame = 12.0});
}

struct BoxersWindow {
  app::Session session{punch()};
  ViewportState viewport;
  ViewportOverlays overlays;

  [[nodiscard]] PictureContent picture() {
    updateShownTrails(session, viewport.shown);
    const Scene& scene = *session.document().scene;
    return workPicture(session, viewport, overlays, paletteOf(ThemeKind::dark),
                       measuresOf(scene, BoundsSampler(scene)));
  }
};

std::vector<std::uint8_t> drawn(const Scene& scene, const PictureContent& content) {
  PictureOptions options;
  options.widthPixels = 160;
  options.heightPixels = 120;
  const Result<Image> image = test::renderFrame(scene, {content}, options);
  REQUIRE(image);
  return *encodePng(*image);
}

} // namespace

namespace {

/// The mean row, as a share of the height, of pixels that are yellow or orange as the weights from a half on
/// are; nothing where there are none.
std::optional<double> rowOfWeights(const app::Document& document, NodeIndex joint) {
  const auto motion = std::make_shared<const rig::MotionState>(app::prepareMotion(document, 0));
  const auto pictures = picturesOfCharacter(document, motion, {0.0}, {.weightsOf = joint});
  PictureOptions options;
  options.widthPixels = 160;
  options.heightPixels = 160;
  const Result<Image> image = test::renderFrame(*document.scene, pictures.front(), options);
  REQUIRE(image);
  double sum = 0.0;
  int count = 0;
  for (std::size_t pixel = 0; pixel < image->rgba.size() / 4; ++pixel) {
    const auto channel = [&](std::size_t i) { return static_cast<int>(image->rgba[4 * pixel + i]); };
    if (channel(0) > 120 && 2 * channel(2) < channel(0)) {
      const std::size_t row = pixel / 160;
      sum += static_cast<double>(row) / 160.0;
      ++count;
    }
  }
  return count < 10 ? std::nullopt : std::optional(sum / count);
}

NodeIndex nodeNamed(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.nodes, name, &Node::name);
  REQUIRE(found != scene.nodes.end());
  return NodeIndex(static_cast<std::size_t>(found - scene.nodes.begin()));
}

} // namespace

TEST_CASE("Weights colour what follows the joint, and nothing else") {
  const app::Document document = test::PanelDriver::bundledCharacter();
  const Scene& scene = *document.scene;
  const std::optional<double> head = rowOfWeights(document, nodeNamed(scene, "Head"));
  const std::optional<double> foot = rowOfWeights(document, nodeNamed(scene, "LeftFoot"));
  REQUIRE(head);
  REQUIRE(foot);
  CHECK(*head < 0.35);
  CHECK(*foot > 0.65);
}

TEST_CASE("A thing that a joint carries counts as its weight, and other joints do not") {
  Scene scene = *test::PanelDriver::bundledCharacter().scene;
  const NodeIndex hand = nodeNamed(scene, "LeftHand");
  const NodeIndex sword(scene.nodes.size());
  scene.nodes.emplace_back().name = "Sword";
  scene.nodes.back().parent = hand;
  scene.nodes[at(hand)].children.push_back(sword);
  const std::vector<float> shares = sharesOf(scene, hand);
  CHECK(shares[at(hand)] == 1.0F);
  CHECK(shares[at(sword)] == 1.0F);
  CHECK(shares[at(nodeNamed(scene, "LeftHandThumb1"))] == 0.0F);
  CHECK(shares[at(nodeNamed(scene, "LeftForeArm"))] == 0.0F);
}

TEST_CASE("The window and the verb render make the same picture, ghosts, trails and skeleton included") {
  BoxersWindow window;
  window.overlays.ghosts = true;
  window.overlays.skeleton = true;
  window.session.view().frame = 6.0;
  window.session.view().selection.editTrails().trail = window.session.document().trails.front().id;
  const PictureContent shown = window.picture();
  REQUIRE(shown.ghosts.size() == 6);
  REQUIRE(shown.trails.size() == 1);
  const app::Document& document = window.session.document();
  const auto pictures = picturesOfCharacter(document, window.session.sharedMotion(), {6.0},
                                            {.skeleton = true, .ghosts = 3, .labelled = false});
  const PictureContent& written = pictures.at(0).content;
  REQUIRE(written.ghosts.size() == shown.ghosts.size());
  for (std::size_t i = 0; i < shown.ghosts.size(); ++i) {
    CHECK(written.ghosts[i].tint == shown.ghosts[i].tint);
    CHECK(written.ghosts[i].frame.timeSeconds == shown.ghosts[i].frame.timeSeconds);
  }
  CHECK(drawn(*document.scene, written) == drawn(*document.scene, shown));
}

TEST_CASE("A character that is drawn alone moves as its trails say, which are not drawn") {
  BoxersWindow window;
  const app::Document& document = window.session.document();
  const auto pictures =
      picturesOfCharacter(document, window.session.sharedMotion(), {12.0}, {.trails = false});
  const auto withTrails = picturesOfCharacter(document, window.session.sharedMotion(), {12.0}, {});
  CHECK(pictures.at(0).content.trails.empty());
  REQUIRE(withTrails.at(0).content.trails.size() == 1);
  CHECK(pictures.at(0).content.frame.worlds == withTrails.at(0).content.frame.worlds);
}

TEST_CASE("Sampling spaces the points of a drawn trail, and the playhead stays where it was") {
  BoxersWindow window;
  window.session.view().frame = 8.0;
  const TrailPicture fine = window.picture().trails.at(0).path;
  window.overlays.trailIncrement = 3.0;
  const TrailPicture coarse = window.picture().trails.at(0).path;
  REQUIRE(fine.original.size() > 24);
  const std::size_t pieces = (fine.original.size() - 1 + 5) / 6; // of six half frames each
  CHECK(coarse.original.size() == pieces + 1);
  CHECK(coarse.exaggerated.size() == pieces + 1);
  CHECK(coarse.original.back() == fine.original.back());
  CHECK(coarse.original.at(2) == fine.original.at(12));
  CHECK(fine.currentSample == 12.0);
  CHECK(coarse.currentSample == 2.0);
  CHECK(coarse.samplesPerFrame == 1);
}

TEST_CASE("Ghosts before and after have two colours, the nearest the strongest, none outside of the clip") {
  BoxersWindow window;
  window.overlays.ghosts = true;
  window.session.view().frame = 3.0;
  const std::vector<Ghost> ghosts = window.picture().ghosts;
  REQUIRE(ghosts.size() == 4); // frame 1, then 9, 7 and 5
  const Palette palette = darkPalette();
  CHECK(glm::vec3(ghosts[0].tint) == glm::vec3(palette.ghostBefore));
  CHECK(glm::vec3(ghosts[1].tint) == glm::vec3(palette.ghostAfter));
  CHECK(ghosts[3].tint.a > ghosts[1].tint.a);
}

TEST_CASE("Spheres stand on the selected trail only, handles on its last selected sphere") {
  BoxersWindow window;
  CHECK(window.picture().trails.at(0).path.spheres.empty());
  app::selectTrail(window.session, window.session.document().trails.front().id);
  const PictureContent selected = window.picture();
  REQUIRE_FALSE(selected.trails.at(0).path.spheres.empty());
  CHECK_FALSE(selected.handles);
  const app::PlacedSphere& sphere = window.viewport.shown.trails.at(0).spheres.at(1);
  window.session.view().selection.editTrails().spheres = {sphere.frame};
  const PictureContent held = window.picture();
  REQUIRE(held.handles);
  CHECK(held.handles->origin == sphere.positionWorld);
  CHECK(held.trails.at(0).path.spheres.at(1).selected);
}

TEST_CASE(
    "A trail stands out while it is selected or under the mouse, but not an applied one that is selected") {
  BoxersWindow window;
  const int trail = window.session.document().trails.front().id;
  const auto standsOut = [&] { return window.picture().trails.at(0).style.emphasised; };
  CHECK_FALSE(standsOut());
  window.viewport.hoveredTrail = trail;
  CHECK(standsOut());
  window.viewport.hoveredTrail = 0;
  app::selectTrail(window.session, trail);
  CHECK(standsOut());
  app::Document document = window.session.document();
  document.trails.front().applied = true;
  window.session.edit(document, "Apply");
  CHECK_FALSE(standsOut());
  window.viewport.hoveredTrail = trail;
  CHECK(standsOut());
}

TEST_CASE("The pose at a trail's tip is one ghost more, in a colour of its own") {
  BoxersWindow window; // with 30 frames per second
  window.viewport.tipFrame = 12.0;
  const std::vector<Ghost> ghosts = window.picture().ghosts;
  REQUIRE(ghosts.size() == 1);
  CHECK(ghosts[0].frame.timeSeconds == Approx(12.0 / 30.0));
  CHECK(glm::vec3(ghosts[0].tint) == glm::vec3(darkPalette().ghostTip));
  window.viewport.tipFrame = 21.0; // The clip ends at 20.
  CHECK(window.picture().ghosts.empty());
}

TEST_CASE("The way of a moment that is pointed at is drawn beside the trails, with its end as the tip") {
  BoxersWindow window;
  REQUIRE(window.picture().trails.size() == 1);
  window.viewport.shown.momentPath = {{0.0, 1.0, 0.0}, {0.5, 1.0, 0.0}, {1.0, 1.5, 0.0}};
  const std::vector<StyledTrail> trails = window.picture().trails;
  REQUIRE(trails.size() == 2);
  CHECK(trails[1].path.original == window.viewport.shown.momentPath);
  CHECK(trails[1].path.exaggerated == window.viewport.shown.momentPath);
  CHECK(trails[1].path.tip == Vec3(1.0, 1.5, 0.0));
}

TEST_CASE("The selected limb lights up in full, the one under the mouse less, and no other") {
  BoxersWindow window;
  const Scene& scene = *window.session.document().scene;
  const auto lightOf = [&](const char* joint) {
    return window.picture().style.highlight.at(at(nodeNamed(scene, joint)));
  };
  window.viewport.hoveredLimb = "left-arm";
  const float hovered = lightOf("LeftForeArm");
  CHECK((hovered > 0.0F && hovered < 1.0F));
  CHECK(lightOf("RightForeArm") == 0.0F);
  app::selectLimb(window.session, "left-arm", false);
  CHECK(lightOf("LeftForeArm") == 1.0F); // Under the mouse it does not fade.
  window.viewport.hoveredLimb = "right-arm";
  CHECK(lightOf("LeftForeArm") == 1.0F);
  CHECK(lightOf("RightForeArm") == hovered);
}

TEST_CASE("The original beside the work has neither trails nor ghosts nor skeleton, but the same look") {
  BoxersWindow window;
  window.overlays.ghosts = true;
  window.overlays.skeleton = true;
  window.overlays.wire = true;
  window.session.view().frame = 8.0;
  const PictureContent work = window.picture();
  const PictureContent beside = originalPicture(window.session, window.viewport, window.overlays,
                                                paletteOf(ThemeKind::dark), work.style.measures);
  CHECK(beside.trails.empty());
  CHECK(beside.ghosts.empty());
  CHECK_FALSE(beside.skeleton);
  CHECK(beside.style.wireframe);
  CHECK(beside.frame.worlds == window.session.originalAt(8.0).worlds);
  CHECK_FALSE(beside.frame.worlds == work.frame.worlds);
}

TEST_CASE("Trails are drawn when they are visible, or only those of selected limbs and pinned ones") {
  ViewportOverlays overlays;
  rig::Trail trail;
  trail.limb = "left-arm";
  CHECK(isDrawn(trail, {}, overlays));
  overlays.trailsOnlyWhenSelected = true;
  CHECK_FALSE(isDrawn(trail, {}, overlays));
  CHECK(isDrawn(trail, {"left-arm"}, overlays));
  trail.pinned = true;
  CHECK(isDrawn(trail, {}, overlays));
  trail.visible = false;
  CHECK_FALSE(isDrawn(trail, {"left-arm"}, overlays));
}
