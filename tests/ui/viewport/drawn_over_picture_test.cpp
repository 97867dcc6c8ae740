// Flat shapes over the picture: the lit part of the view cube, the curve of an ease, what lines mean.
#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"
#include "ui/viewport/cube_marker.h"
#include "ui/viewport/viewport_labels.h"
#include "ui/viewport/viewport_legend.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

constexpr float pictureWide = 800.0F;
constexpr float pictureHigh = 600.0F;

/// The boxer from the front, and what is drawn over its picture, without soft edges.
struct OverPicture {
  explicit OverPicture(app::Document document) : gui(ImGui::CreateContext(&test::PanelDriver::fonts())) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {pictureWide, pictureHigh};
    io.DeltaTime = 1.0F / 60.0F;
    applyStyle(theme);
    ImGui::GetStyle().AntiAliasedFill = false;
    ImGui::GetStyle().AntiAliasedLines = false;
    open.open(std::move(document));
    viewport.camera.target = Vec3(0.0, 1.0, 0.0);
    viewport.camera.projection = ProjectionKind::orthographic;
    viewport.box = {{0.0F, 0.0F}, {pictureWide, pictureHigh}};
  }
  ~OverPicture() { ImGui::DestroyContext(gui); }
  OverPicture(const OverPicture&) = delete;
  OverPicture& operator=(const OverPicture&) = delete;

  [[nodiscard]] app::Session& session() { return *open.character(); }

  void draw() {
    ImGui::NewFrame();
    items.clear();
    ViewportContext context{{open, ui, theme, commands, requested, items, status}, viewport, tool};
    viewport.view = makeView(viewport.camera, {double(pictureWide), double(pictureHigh), 1.0});
    updateShownTrails(session(), viewport.shown);
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize({pictureWide, pictureHigh});
    ImGui::Begin("picture", nullptr, ImGuiWindowFlags_NoDecoration);
    drawViewportLabels(context, session().shownAt(session().view().frame));
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    corners.clear();
    for (const ImDrawIdx index : list.IdxBuffer) {
      corners.push_back(list.VtxBuffer[index]);
    }
    ImGui::End();
    ImGui::EndFrame();
  }
  /// Square pixels that triangles of a colour cover.
  [[nodiscard]] double areaOf(ImU32 colour) const {
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      if (corners[i].col == colour) {
        const ImVec2 a = corners[i].pos;
        const ImVec2 b = corners[i + 1].pos;
        const ImVec2 c = corners[i + 2].pos;
        area += 0.5 * std::abs(double((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)));
      }
    }
    return area;
  }
  /// The box around everything of a colour.
  [[nodiscard]] Rect boxOf(ImU32 colour) const {
    Rect box{{1e9F, 1e9F}, {-1e9F, -1e9F}};
    for (const ImDrawVert& corner : corners) {
      if (corner.col == colour) {
        box.min = {std::min(box.min.x, corner.pos.x), std::min(box.min.y, corner.pos.y)};
        box.max = {std::max(box.max.x, corner.pos.x), std::max(box.max.y, corner.pos.y)};
      }
    }
    return box;
  }

  ImGuiContext* gui;
  app::OpenDocument open;
  UiState ui;
  EditorStatus status;
  Theme theme = test::PanelDriver::sharedTheme();
  ItemRegistry items;
  std::vector<CommandInfo> commands;
  std::vector<std::string> requested;
  ViewportState viewport;
  Tool tool;
  std::vector<ImDrawVert> corners; ///< Three for each triangle.
};

} // namespace

TEST_CASE("The part of the view cube under the mouse lies lit on each face that it is a part of") {
  OverPicture stage(test::boxer());
  const ImU32 light = faded(stage.theme.colours.accent, 0.7F);
  stage.draw();
  CHECK(stage.areaOf(light) == 0.0);
  constexpr double halfEdge = 20.0; // Pixels; the middle of a face goes as far as 0.55 of it.
  struct Part {
    std::array<int, 3> side;
    double across, up; // Of the half edge, what of the front face is lit.
  };
  for (const Part& part : {Part{{0, 0, 1}, 1.1, 1.1}, Part{{1, 0, 1}, 0.45, 1.1}, Part{{-1, 0, 1}, 0.45, 1.1},
                           Part{{0, 1, 1}, 1.1, 0.45}, Part{{0, -1, 1}, 1.1, 0.45},
                           Part{{1, 1, 1}, 0.45, 0.45}, Part{{-1, -1, 1}, 0.45, 0.45}}) {
    stage.viewport.look.hoveredPart = CubePart{part.side};
    stage.draw();
    CAPTURE(part.side[0], part.side[1], part.side[2]);
    CHECK(stage.areaOf(light) == Approx(part.across * part.up * halfEdge * halfEdge).epsilon(0.02));
    const Rect box = stage.boxOf(light);
    CHECK(double(box.width()) == Approx(part.across * halfEdge).margin(0.1));
    CHECK(double(box.height()) == Approx(part.up * halfEdge).margin(0.1));
    const ImVec2 middle{pictureWide - 46.0F, 46.0F};
    CHECK((box.centre().x > middle.x + 1.0F) == (part.side[0] > 0));
    CHECK((box.centre().y < middle.y - 1.0F) == (part.side[1] > 0));
  }
  stage.viewport.look.hoveredPart = CubePart{{0, 0, -1}}; // On the other side of it.
  stage.draw();
  CHECK(stage.areaOf(light) == 0.0);
  stage.viewport.look.hoveredPart = CubePart{{0, 0, 1}};
  stage.tool = KeysTool{};
  stage.draw();
  CHECK(stage.areaOf(light) == 0.0); // A running tool has the mouse.
}

namespace {

/// The boxer's left arm while E runs on it.
struct Easing : OverPicture {
  Easing() : OverPicture(test::boxer()) {
    session().view().rangeEnd = 10.0;
    app::selectLimb(session(), "left-arm", false);
    REQUIRE(startExaggerate(session(), tool));
    draw();
  }
  [[nodiscard]] app::ExaggerateModal& modal() { return std::get<ExaggerateTool>(tool).modal; }
  [[nodiscard]] ImU32 ground() const { return faded(theme.colours.sunken, 0.9F); }
  [[nodiscard]] ImVec2 tip() {
    const ShownTrail* const shown = findShown(viewport.shown, session().view().selection.trail());
    REQUIRE(shown != nullptr);
    const auto place = placeOf(viewport, pointOnTrail(*shown, shown->endFrame, true));
    REQUIRE(place);
    return *place;
  }
};

} // namespace

TEST_CASE(
    "The curve of an ease stands to the right of the trail's tip, half of it above, and in the picture") {
  Easing stage;
  constexpr float side = 112.0F;
  stage.modal().field = GENERATE(app::ExaggerateField::easeIn, app::ExaggerateField::easeOut);
  const float unit = stage.theme.unit();
  const ImVec2 place = GENERATE(ImVec2(300.0F, 300.0F), ImVec2(790.0F, 300.0F), ImVec2(300.0F, 8.0F),
                                ImVec2(300.0F, 592.0F), ImVec2(672.0F, 300.0F), ImVec2(650.0F, 300.0F));
  // The picture is moved until the tip stands there.
  const ImVec2 tip = stage.tip();
  const double perPixel = 1.0 / stage.viewport.pixelsPerUnit * unitsPerPixel(stage.viewport.view, Vec3(0.0));
  stage.viewport.camera.target +=
      Vec3(perPixel * double(tip.x - place.x), perPixel * double(place.y - tip.y), 0.0);
  stage.draw();
  const ImVec2 moved = stage.tip();
  CHECK(moved.x == Approx(place.x).margin(1.0));
  CHECK(moved.y == Approx(place.y).margin(1.0));
  const Rect box = stage.boxOf(stage.ground());
  CAPTURE(moved.x, moved.y);
  CHECK(box.width() == Approx(side).margin(1.0));
  CHECK(box.height() == Approx(side).margin(1.0));
  CHECK(box.min.x == Approx(std::min(moved.x + 24.0F, pictureWide - side - unit)).margin(1.0));
  CHECK(box.min.y == Approx(std::clamp(moved.y - 0.5F * side, unit, pictureHigh - side - unit)).margin(1.0));
}

TEST_CASE("No curve of an ease is shown while something else is typed") {
  Easing stage;
  for (const app::ExaggerateField field :
       {app::ExaggerateField::scale, app::ExaggerateField::release, app::ExaggerateField::volume}) {
    stage.modal().field = field;
    stage.draw();
    CHECK(stage.areaOf(stage.ground()) == 0.0);
  }
  stage.modal().field = app::ExaggerateField::easeIn;
  stage.draw();
  CHECK(stage.areaOf(stage.ground()) > 1000.0);
}

TEST_CASE("The legend explains the selected trail first, in its colour, and shows the others beside it") {
  app::Document document = test::withNewTrail(test::boxer(), {.startFrame = 0.0, .endFrame = 8.0});
  document = test::withNewTrail(document, {.startFrame = 10.0, .endFrame = 20.0});
  OverPicture stage(document);
  const std::size_t selected = GENERATE(0U, 1U);
  app::selectTrail(stage.session(), document.trails[selected].id);
  stage.draw();
  REQUIRE(stage.viewport.shown.trails.size() == 2);
  const auto colourOf = [&](std::size_t trail) {
    return trailColour(findShown(stage.viewport.shown, document.trails[trail].id)->colour, stage.theme.kind);
  };
  REQUIRE(colourOf(0) != colourOf(1));
  // The lines of the legend: flat, in its part of the picture.
  const auto lineOf = [&](ImU32 colour) {
    Rect box{{1e9F, 1e9F}, {-1e9F, -1e9F}};
    for (const ImDrawVert& corner : stage.corners) {
      if (corner.col == colour && corner.pos.x > pictureWide - 150.0F &&
          corner.pos.y > pictureHigh - 120.0F) {
        box.min = {std::min(box.min.x, corner.pos.x), std::min(box.min.y, corner.pos.y)};
        box.max = {std::max(box.max.x, corner.pos.x), std::max(box.max.y, corner.pos.y)};
      }
    }
    return box;
  };
  const Rect own = lineOf(colourOf(selected));
  const Rect other = lineOf(colourOf(1 - selected));
  REQUIRE(own.width() > 0.0F);
  REQUIRE(other.width() > 0.0F);
  CHECK(own.min.x < other.min.x);
  CHECK(own.min.y == other.min.y);
}

TEST_CASE(
    "A pin stands at the place that is held, its head above it, while it holds and not over the original") {
  OverPicture stage(test::PanelDriver::bundledCharacter());
  app::selectLimb(stage.session(), "left-arm", false);
  app::setRangeByHand(stage.session(), {20.0, 30.0});
  stage.session().view().frame = 25.0;
  test::run({stage.open, stage.ui, stage.status}, app::command::holdPin);
  const auto pinAt = [&](double frame) {
    stage.session().view().frame = frame;
    stage.draw();
    return stage.items.find("viewport/pin/left-arm");
  };
  CHECK(pinAt(2.0) == nullptr);
  CHECK(pinAt(58.0) == nullptr);
  const Item* const pin = pinAt(25.0);
  REQUIRE(pin != nullptr);
  const auto& pins = stage.session().motion().holds.pins;
  REQUIRE((pins.size() == 1 && pins.front()));
  const auto held = placeOf(stage.viewport, pins.front()->place.position);
  REQUIRE(held);
  CHECK(pin->centre().x == Approx(held->x + stage.theme.px(7.0F)).margin(0.5));
  CHECK(pin->centre().y == Approx(held->y - stage.theme.px(15.0F)).margin(0.5));
  // Held wholly it is drawn in full: a round head of nine pixels.
  CHECK(stage.areaOf(stage.theme.colours.accent) == Approx(pi * 4.5 * 4.5).epsilon(0.15));
  stage.session().view().showOriginal = true;
  CHECK(pinAt(25.0) == nullptr);
}

TEST_CASE("What lies beside or above the picture of the file's camera is dimmed, its safe part is outlined") {
  OverPicture stage(test::boxer());
  const ImU32 dim = faded(stage.theme.colours.background, 0.6F);
  const auto isSafePart = [&](const ImVec2& low, const ImVec2& high) {
    const Item* const safe = stage.items.find("viewport/safe-frame");
    REQUIRE(safe != nullptr);
    CHECK(safe->min.x == Approx(low.x));
    CHECK(safe->min.y == Approx(low.y));
    CHECK(safe->max.x == Approx(high.x));
    CHECK(safe->max.y == Approx(high.y));
  };
  stage.draw();
  CHECK(stage.items.find("viewport/safe-frame") == nullptr);
  stage.ui.overlays.safeFrame = true;
  stage.draw();
  CHECK(stage.areaOf(dim) == 0.0);
  isSafePart({40.0F, 30.0F}, {760.0F, 570.0F});
  ThroughCamera& camera = stage.viewport.look.through.emplace();
  camera.lens.aspect = 1.0; // 600 of 800 wide
  stage.draw();
  CHECK(stage.areaOf(dim) == Approx(200.0 * 600.0));
  isSafePart({130.0F, 30.0F}, {670.0F, 570.0F});
  camera.lens.aspect = 2.0; // 400 of 600 high
  stage.draw();
  CHECK(stage.areaOf(dim) == Approx(800.0 * 200.0));
  isSafePart({40.0F, 120.0F}, {760.0F, 480.0F});
  camera.lens.aspect.reset();
  stage.draw();
  CHECK(stage.areaOf(dim) == 0.0);
}

TEST_CASE("The box of a selection lies between the press and the mouse, whichever way it is drawn") {
  OverPicture stage(test::boxer());
  const ImU32 inside = faded(stage.theme.colours.accent, 0.15F);
  stage.viewport.pressPixels = Vec2(300.0, 150.0);
  stage.viewport.mousePixels = Vec2(100.0, 400.0);
  stage.draw();
  CHECK(stage.areaOf(inside) == 0.0);
  stage.viewport.gesture = ViewportGesture::boxSelect;
  const double pixelsPerUnit = GENERATE(1.0, 2.0);
  stage.viewport.pixelsPerUnit = pixelsPerUnit;
  stage.draw();
  const Rect box = stage.boxOf(inside);
  CHECK(double(box.min.x) == Approx(100.0 / pixelsPerUnit));
  CHECK(double(box.min.y) == Approx(150.0 / pixelsPerUnit));
  CHECK(double(box.max.x) == Approx(300.0 / pixelsPerUnit));
  CHECK(double(box.max.y) == Approx(400.0 / pixelsPerUnit));
}

TEST_CASE("The circle around a pulled sphere is as large as the reach of its pull, and goes along") {
  OverPicture stage(test::boxer());
  const ImU32 colour = faded(stage.theme.colours.accent, 0.7F);
  GrabTool grab;
  grab.anchor = Vec3(0.2, 1.3, 0.0);
  grab.modal.mouseWorld = Vec3(0.1, 0.2, 0.0);
  stage.tool = grab;
  stage.draw();
  CHECK(stage.areaOf(colour) == 0.0); // It pulls itself alone.
  grab.falloffRadius = 0.25;
  stage.tool = grab;
  stage.draw();
  const Vec3 middle(0.3, 1.5, 0.0);
  const auto place = placeOf(stage.viewport, middle);
  REQUIRE(place);
  const Rect circle = stage.boxOf(colour);
  const double across = 2.0 * 0.25 / unitsPerPixel(stage.viewport.view, middle);
  CHECK(double(circle.width()) == Approx(across).margin(2.5));
  CHECK(double(circle.height()) == Approx(across).margin(2.5));
  CHECK(circle.centre().x == Approx(place->x).margin(1.0));
  CHECK(circle.centre().y == Approx(place->y).margin(1.0));
  grab.tangent.emplace();
  stage.tool = grab;
  stage.draw();
  CHECK(stage.areaOf(colour) == 0.0); // A tangent has no neighbours.
}

TEST_CASE("The end of a tangent that is pulled stays under the mouse, the other one where it was") {
  OverPicture stage(test::boxer());
  const Vec3 sphere(0.2, 1.4, 0.0);
  const Vec3 tipBefore(0.0, 1.4, 0.0);
  const Vec3 tipAfter(0.4, 1.4, 0.0);
  stage.viewport.tangents.handles = {{{.frames = -2.0, .sphereWorld = sphere}, tipBefore},
                                     {{.frames = 2.0, .sphereWorld = sphere}, tipAfter}};
  const auto stands = [&](const char* id, const Vec3& world) {
    CAPTURE(id);
    const Item* const item = stage.items.find(id);
    const auto place = placeOf(stage.viewport, world);
    REQUIRE((item != nullptr && place));
    CHECK(item->centre().x == Approx(place->x).margin(0.5));
    CHECK(item->centre().y == Approx(place->y).margin(0.5));
  };
  stage.draw();
  stands("viewport/tangent/before", tipBefore);
  stands("viewport/tangent/after", tipAfter);
  const Vec3 pulled(0.05, 0.3, 0.0);
  for (const bool after : {false, true}) {
    GrabTool grab;
    grab.tangent = stage.viewport.tangents.handles[after ? 1 : 0].handle;
    grab.anchor = after ? tipAfter : tipBefore;
    grab.modal.mouseWorld = pulled;
    stage.tool = grab;
    stage.draw();
    stands("viewport/tangent/before", after ? tipBefore : tipBefore + pulled);
    stands("viewport/tangent/after", after ? tipAfter + pulled : tipAfter);
  }
}
