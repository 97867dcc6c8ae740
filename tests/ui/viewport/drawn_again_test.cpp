// A picture of the viewport is drawn again where anything of it is another one, and only then.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/anim/sampling.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/render_scenes.h"
#include "ui/viewport/viewport_pane.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// All that a picture is drawn from.
struct DrawnFrom {
  View view;
  ThemeKind theme = ThemeKind::dark;
  FrameState frame;
  std::vector<Ghost> ghosts;
  Overlay overlay;
  SceneStyle style;
};

struct Change {
  const char* name;
  std::function<void(DrawnFrom&)> make;
};

std::shared_ptr<const Image> greyImage() {
  Image image;
  image.width = image.height = 2;
  image.rgba.assign(16, 128);
  return std::make_shared<const Image>(std::move(image));
}

DrawnFrom usuallyDrawn(const Scene& scene) {
  DrawnFrom drawing;
  drawing.view = makeView(Camera{}, {48.0, 40.0, 1.0});
  drawing.frame = test::wavingFrame(scene);
  drawing.frame.stretch.assign(scene.nodes.size(), Mat3(1.0));
  drawing.frame.pose.weights = {{0.25F, 0.5F}};
  drawing.ghosts.push_back({drawing.frame, {1.0F, 0.5F, 0.0F, 0.5F}});
  drawing.overlay.lines.push_back({{{Vec3(0.0)}, {Vec3(1.0)}}, 4.0F, 3.0F});
  drawing.overlay.markers.push_back({});
  drawing.overlay.arrows.push_back({Vec3(0.0), Vec3(0.0, 1.0, 0.0)});
  drawing.style.quality = {1, 64, 1, 0};
  drawing.style.highlight.assign(scene.nodes.size(), 0.0F);
  drawing.style.stretchRatio.assign(scene.nodes.size(), 1.0);
  drawing.style.backdrop = Backdrop{[image = greyImage()] { return Result(image); }, 0.5, 0.5, 0.5};
  return drawing;
}

const std::vector<Change>& changesOfScene() {
  static const std::vector<Change> changes{
      {"camera", [](DrawnFrom& d) { d.view.view[3].z -= 0.1; }},
      {"projection", [](DrawnFrom& d) { d.view.projection[0].x *= 1.1; }},
      {"width", [](DrawnFrom& d) { d.view.viewport.widthPixels = 52.0; }},
      {"height", [](DrawnFrom& d) { d.view.viewport.heightPixels = 44.0; }},
      {"display scale", [](DrawnFrom& d) { d.view.viewport.pixelsPerPoint = 2.0; }},
      {"theme", [](DrawnFrom& d) { d.theme = ThemeKind::light; }},
      {"first node", [](DrawnFrom& d) { d.frame.worlds.front()[3].x += 0.1; }},
      {"last node", [](DrawnFrom& d) { d.frame.worlds.back()[3].x += 0.1; }},
      {"first stretch", [](DrawnFrom& d) { d.frame.stretch.front()[0].x = 1.1; }},
      {"last stretch", [](DrawnFrom& d) { d.frame.stretch.back()[0].x = 1.1; }},
      {"first morph weight", [](DrawnFrom& d) { d.frame.pose.weights[0][0] = 0.3F; }},
      {"last morph weight", [](DrawnFrom& d) { d.frame.pose.weights[0][1] = 0.3F; }},
      {"no ghost", [](DrawnFrom& d) { d.ghosts.clear(); }},
      {"a second ghost", [](DrawnFrom& d) { d.ghosts.push_back(d.ghosts.front()); }},
      {"a ghost's pose", [](DrawnFrom& d) { d.ghosts[0].frame.worlds.back()[3].x += 0.1; }},
      {"a ghost's colour", [](DrawnFrom& d) { d.ghosts[0].tint.a = 0.6F; }},
  };
  return changes;
}

const std::vector<Change>& changesOfStyle() {
  static const std::vector<Change> changes{
      {"samples", [](DrawnFrom& d) { d.style.quality.samples = 4; }},
      {"floor shadow", [](DrawnFrom& d) { d.style.quality.floorShadowPixels = 128; }},
      {"floor shadow's blurs", [](DrawnFrom& d) { d.style.quality.floorShadowBlurs = 2; }},
      {"self shadow", [](DrawnFrom& d) { d.style.quality.selfShadowPixels = 64; }},
      {"thinned", [](DrawnFrom& d) { d.style.quality.thinned = true; }},
      {"shading", [](DrawnFrom& d) { d.style.shading = SurfaceShading::clay; }},
      {"normals", [](DrawnFrom& d) { d.style.normals = skinning::NormalMatrix::plain; }},
      {"stretch that turns normals", [](DrawnFrom& d) { d.style.newStretchTurns = false; }},
      {"mesh", [](DrawnFrom& d) { d.style.mesh = false; }},
      {"floor", [](DrawnFrom& d) { d.style.floor = false; }},
      {"wireframe", [](DrawnFrom& d) { d.style.wireframe = true; }},
      {"floor's height", [](DrawnFrom& d) { d.style.measures.floorHeight = -0.2; }},
      {"character's height", [](DrawnFrom& d) { d.style.measures.characterHeight = 1.2; }},
      {"first joint's highlight", [](DrawnFrom& d) { d.style.highlight.front() = 1.0F; }},
      {"last joint's highlight", [](DrawnFrom& d) { d.style.highlight.back() = 1.0F; }},
      {"first joint's heat", [](DrawnFrom& d) { d.style.stretchRatio.front() = 1.5; }},
      {"last joint's heat", [](DrawnFrom& d) { d.style.stretchRatio.back() = 1.5; }},
      {"no backdrop", [](DrawnFrom& d) { d.style.backdrop.reset(); }},
      {"backdrop's image",
       [](DrawnFrom& d) { d.style.backdrop->image = [image = greyImage()] { return Result(image); }; }},
      {"backdrop's place", [](DrawnFrom& d) { d.style.backdrop->across = 0.6; }},
      {"backdrop's height", [](DrawnFrom& d) { d.style.backdrop->height = 0.6; }},
      {"backdrop's opacity", [](DrawnFrom& d) { d.style.backdrop->opacity = 0.6; }},
  };
  return changes;
}

const std::vector<Change>& changesOfOverlay() {
  static const std::vector<Change> changes{
      {"no line", [](DrawnFrom& d) { d.overlay.lines.clear(); }},
      {"line's first point", [](DrawnFrom& d) { d.overlay.lines[0].points[0].world.x = 0.1; }},
      {"line's last point", [](DrawnFrom& d) { d.overlay.lines[0].points[1].world.x = 0.9; }},
      {"line's colour", [](DrawnFrom& d) { d.overlay.lines[0].points[1].color.r = 0.5F; }},
      {"line's width", [](DrawnFrom& d) { d.overlay.lines[0].points[1].widthPoints = 3.0F; }},
      {"line's dashes", [](DrawnFrom& d) { d.overlay.lines[0].dashPoints = 5.0F; }},
      {"line's gaps", [](DrawnFrom& d) { d.overlay.lines[0].gapPoints = 2.0F; }},
      {"line's depth", [](DrawnFrom& d) { d.overlay.lines[0].depth = OverlayDepth::onTop; }},
      {"line's edge", [](DrawnFrom& d) { d.overlay.lines[0].outlined = true; }},
      {"a line in two",
       [](DrawnFrom& d) {
         Polyline rest = d.overlay.lines[0];
         rest.points.erase(rest.points.begin());
         d.overlay.lines[0].points.pop_back();
         d.overlay.lines.push_back(rest);
       }},
      {"no mark", [](DrawnFrom& d) { d.overlay.markers.clear(); }},
      {"mark's place", [](DrawnFrom& d) { d.overlay.markers[0].world.y = 0.1; }},
      {"mark's shape", [](DrawnFrom& d) { d.overlay.markers[0].shape = MarkerShape::diamond; }},
      {"mark's radius", [](DrawnFrom& d) { d.overlay.markers[0].radiusPoints = 5.0F; }},
      {"mark's fill", [](DrawnFrom& d) { d.overlay.markers[0].fill.g = 0.5F; }},
      {"mark's edge", [](DrawnFrom& d) { d.overlay.markers[0].edge.a = 0.5F; }},
      {"width of a mark's edge", [](DrawnFrom& d) { d.overlay.markers[0].edgePoints = 1.0F; }},
      {"mark's turn", [](DrawnFrom& d) { d.overlay.markers[0].turnRadians = 0.5; }},
      {"mark's depth", [](DrawnFrom& d) { d.overlay.markers[0].depth = OverlayDepth::onTop; }},
      {"no arrow", [](DrawnFrom& d) { d.overlay.arrows.clear(); }},
      {"arrow's start", [](DrawnFrom& d) { d.overlay.arrows[0].from.x = 0.1; }},
      {"arrow's end", [](DrawnFrom& d) { d.overlay.arrows[0].to.x = 0.1; }},
      {"arrow's colour", [](DrawnFrom& d) { d.overlay.arrows[0].color.b = 0.5F; }},
      {"arrow's width", [](DrawnFrom& d) { d.overlay.arrows[0].widthPoints = 4.0F; }},
      {"arrow's head", [](DrawnFrom& d) { d.overlay.arrows[0].headPoints = 9.0F; }},
  };
  return changes;
}

} // namespace

TEST_CASE("A picture is drawn again where anything that it shows is another one, else it stays") {
  test::GuiPainter painter;
  test::GuiStage stage(painter, ThemeKind::dark, 48.0F, 40.0F);
  const Scene scene = test::bipedScene();
  ViewportGpu& gpu = painter.viewportGpu();
  gpu.renderer.setScene(scene);
  DrawnPicture drawn;
  const auto isDrawn = [&](const DrawnFrom& drawing) {
    gpu.drewPicture = false;
    stage.viewport.view = drawing.view;
    stage.theme.kind = drawing.theme;
    stage.show([&](ViewportContext& context) {
      drawPicture(context, gpu, drawn, {drawing.frame, drawing.ghosts, drawing.overlay, drawing.style});
    });
    return gpu.drewPicture;
  };
  const DrawnFrom usual = usuallyDrawn(scene);
  CHECK(isDrawn(usual));
  for (const std::vector<Change>* const changes :
       {&changesOfScene(), &changesOfStyle(), &changesOfOverlay()}) {
    for (const Change& change : *changes) {
      CAPTURE(change.name);
      CHECK_FALSE(isDrawn(usual));
      DrawnFrom changed = usual;
      change.make(changed);
      CHECK(isDrawn(changed));
      CHECK_FALSE(isDrawn(changed));
      CHECK(isDrawn(usual));
    }
  }
  gpu.sequence.shapes += 1; // Vertices were moved.
  CHECK(isDrawn(usual));
  gpu.uploaded = std::make_shared<const Scene>(scene);
  CHECK(isDrawn(usual));
  CHECK_FALSE(isDrawn(usual));
}
