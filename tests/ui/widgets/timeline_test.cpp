#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <imgui.h>

#include "ui/widgets/timeline_detail.h"

using namespace stretch;
using namespace stretch::ui;
using namespace stretch::ui::timeline_detail;

namespace {

/// Frames 0 to 60 of a clip, ten pixels a frame; two trails, a hold and two rows of keys.
struct Strip {
  Strip() : gui(ImGui::CreateContext()), theme(makeTheme(ThemeKind::dark, 1.0F)) {
    model.clip = model.view = {0.0, 60.0};
    model.range = {10.0, 20.0};
    model.keyRows = {{"All keys", {0.0, 12.0, 13.0, 40.0}}, {"Left arm", {5.0, 25.0}}};
    model.bars = {{.id = 1, .start = 20.0, .end = 30.0, .windowStart = 20.0, .windowEnd = 36.0, .row = 0},
                  {.id = 2, .start = 40.0, .end = 50.0, .windowStart = 34.0, .windowEnd = 50.0, .row = 1},
                  {.id = -3, .start = 5.0, .end = 15.0, .windowStart = 2.0, .windowEnd = 18.0, .row = 2}};
    layout = layoutOf(theme, {{0.0F, 0.0F}, {724.0F, 200.0F}}, model, 100.0F);
  }
  ~Strip() { ImGui::DestroyContext(gui); }
  Strip(const Strip&) = delete;
  Strip& operator=(const Strip&) = delete;

  [[nodiscard]] ImVec2 onBar(std::size_t bar, double frame) const {
    const TimelineBar& shown = model.bars[bar];
    return {layout.frames.toPixel(frame),
            barBox(theme, layout, model, shown, {shown.start, shown.end}).centre().y};
  }
  [[nodiscard]] ImVec2 onRow(std::size_t row, double frame) const {
    return {layout.frames.toPixel(frame), keyRowBox(theme, layout, model, row).centre().y};
  }
  [[nodiscard]] ImVec2 onRangeEdge(double frame) const {
    return {layout.frames.toPixel(frame), layout.ruler.max.y - 5.0F};
  }
  [[nodiscard]] Hit hit(const ImVec2& mouse) const { return hitTest(theme, layout, model, mouse); }
  [[nodiscard]] TimelineOutcome dragged(const TimelineGesture& gesture, double toFrame) const {
    TimelineOutcome outcome;
    applyGesture(model, layout, gesture, {layout.frames.toPixel(toFrame), 50.0F}, outcome);
    return outcome;
  }
  [[nodiscard]] TimelineOutcome turned(float wheel, double atFrame) const {
    ImGui::GetIO().MouseWheel = wheel;
    TimelineOutcome outcome;
    applyWheel(model, layout, {layout.frames.toPixel(atFrame), 50.0F}, outcome);
    return outcome;
  }
  [[nodiscard]] TimelineOutcome rightClicked(const ImVec2& mouse) const {
    ImGui::GetIO().MouseReleased[ImGuiMouseButton_Right] = true;
    TimelineOutcome outcome;
    applyClicks(theme, model, layout, hit(mouse), mouse, outcome);
    return outcome;
  }

  ImGuiContext* gui;
  Theme theme;
  TimelineModel model;
  Layout layout;
};

/// What a timeline draws: the corners of everything, without soft edges, so that a triangle is three of them.
std::vector<ImDrawVert> drawnCorners(const Theme& theme, const Layout& layout, const TimelineModel& model) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {800.0F, 300.0F};
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  ImGui::GetStyle().AntiAliasedFill = false;
  ImGui::NewFrame();
  ItemRegistry items;
  ImGui::SetNextWindowPos({0.0F, 0.0F});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::Begin("timeline", nullptr, ImGuiWindowFlags_NoDecoration);
  draw({theme, items}, layout, model);
  const ImVector<ImDrawVert>& all = ImGui::GetWindowDrawList()->VtxBuffer;
  std::vector<ImDrawVert> corners(all.begin(), all.end());
  ImGui::End();
  ImGui::EndFrame();
  return corners;
}

/// Tips of the arrows at the seam of a loop, from left to right, pixels.
std::vector<float> seamTips(const Strip& strip) {
  std::vector<float> tips;
  for (const ImDrawVert& corner : drawnCorners(strip.theme, strip.layout, strip.model)) {
    if (corner.col == strip.theme.colours.accent && corner.pos.y == strip.layout.ruler.max.y - 5.0F) {
      tips.push_back(corner.pos.x);
    }
  }
  std::ranges::sort(tips);
  return tips;
}

} // namespace

TEST_CASE(
    "The mouse takes ends, bodies and releases of bars, ends of the range, and the playhead elsewhere") {
  const Strip strip;
  struct Place {
    const char* says;
    ImVec2 at;
    TimelinePart part;
    int bar;
  };
  const Place places[] = {{"start of a trail", strip.onBar(0, 20.0), TimelinePart::barStart, 1},
                          {"5 pixels before it", strip.onBar(0, 19.5), TimelinePart::barStart, 1},
                          {"7 pixels before it", strip.onBar(0, 19.3), TimelinePart::playhead, 0},
                          {"its end", strip.onBar(0, 30.5), TimelinePart::barEnd, 1},
                          {"its body", strip.onBar(0, 25.0), TimelinePart::barBody, 1},
                          {"its release", strip.onBar(0, 36.0), TimelinePart::release, 1},
                          {"between body and release", strip.onBar(0, 33.0), TimelinePart::playhead, 0},
                          {"a release before the range", strip.onBar(1, 34.0), TimelinePart::release, 2},
                          {"end of a hold", strip.onBar(2, 15.0), TimelinePart::barEnd, -3},
                          {"a hold has no release", strip.onBar(2, 18.0), TimelinePart::playhead, 0},
                          {"start of the range", strip.onRangeEdge(10.0), TimelinePart::rangeStart, 0},
                          {"end of the range", strip.onRangeEdge(20.0), TimelinePart::rangeEnd, 0},
                          {"inside of the range", strip.onRangeEdge(15.0), TimelinePart::playhead, 0},
                          {"a key", strip.onRow(0, 12.0), TimelinePart::playhead, 0},
                          {"the labels", {50.0F, 60.0F}, TimelinePart::nothing, 0}};
  for (const Place& place : places) {
    INFO(place.says);
    CHECK(strip.hit(place.at).part == place.part);
    CHECK(strip.hit(place.at).bar == place.bar);
  }
}

TEST_CASE("Keys are taken in the dope sheet, the nearest of two, and beside them a box begins") {
  Strip strip;
  strip.model.keysEditable = true;
  const Hit near = strip.hit(strip.onRow(0, 12.4));
  CHECK(near.part == TimelinePart::keys);
  CHECK(near.row == 0);
  CHECK(near.frame == 12.0);
  CHECK(strip.hit(strip.onRow(0, 12.6)).frame == 13.0);
  const Hit second = strip.hit(strip.onRow(1, 25.2));
  CHECK(second.row == 1);
  CHECK(second.frame == 25.0);
  CHECK(strip.hit(strip.onRow(1, 12.0)).part == TimelinePart::keyBox);
  CHECK(strip.hit(strip.onRow(1, 25.7)).part == TimelinePart::keyBox);
}

TEST_CASE("Dragged ends snap to frames, keep a frame between them and stay inside of the clip") {
  Strip strip;
  const TimelineGesture end{TimelinePart::barEnd, 1, 30.0, {20.0, 30.0}};
  CHECK(strip.dragged(end, 33.4).barSpan.end == 33.0);
  CHECK(strip.dragged(end, 33.4).barSpan.start == 20.0);
  CHECK(strip.dragged(end, 33.4).barChanged);
  CHECK(strip.dragged(end, 33.4).editedBar == 1);
  CHECK_FALSE(strip.dragged(end, 30.2).barChanged);
  CHECK(strip.dragged(end, 4.0).barSpan.end == 21.0);
  CHECK(strip.dragged(end, 75.0).barSpan.end == 60.0);
  const TimelineGesture start{TimelinePart::barStart, 1, 20.0, {20.0, 30.0}};
  CHECK(strip.dragged(start, 17.6).barSpan.start == 18.0);
  CHECK(strip.dragged(start, 50.0).barSpan.start == 29.0);
  CHECK(strip.dragged(start, -8.0).barSpan.start == 0.0);
  strip.model.snap = false;
  CHECK(strip.dragged(end, 33.4).barSpan.end == Approx(33.4).margin(1e-3));
  const TimelineGesture rangeStart{TimelinePart::rangeStart, 0, 10.0, {10.0, 20.0}};
  CHECK(strip.dragged(rangeStart, 8.25).range.start == Approx(8.25).margin(1e-3));
  CHECK(strip.dragged(rangeStart, 8.25).rangeChanged);
  CHECK_FALSE(strip.dragged(rangeStart, 8.25).barChanged);
  const TimelineGesture rangeEnd{TimelinePart::rangeEnd, 0, 20.0, {10.0, 20.0}};
  CHECK(strip.dragged(rangeEnd, 28.0).range.end == Approx(28.0).margin(1e-3));
}

TEST_CASE("What snaps to frames stays inside of a clip that ends between two of them") {
  Strip strip;
  strip.model.clip.end = 59.6;
  CHECK(strip.dragged({TimelinePart::playhead, 0, 0.0, {}}, 99.0).playhead == 59.6);
  CHECK(strip.dragged({TimelinePart::barEnd, 1, 30.0, {20.0, 30.0}}, 99.0).barSpan.end == 59.6);
  CHECK(strip.dragged({TimelinePart::playhead, 0, 0.0, {}}, 58.6).playhead == 59.0);
}

TEST_CASE("A dragged bar keeps its length and stops at the ends of the clip") {
  const Strip strip;
  const TimelineGesture body{TimelinePart::barBody, 1, 26.0, {20.0, 30.0}};
  CHECK(strip.dragged(body, 31.2).barSpan.start == 25.0);
  CHECK(strip.dragged(body, 31.2).barSpan.end == 35.0);
  CHECK(strip.dragged(body, 90.0).barSpan.start == 50.0);
  CHECK(strip.dragged(body, 90.0).barSpan.end == 60.0);
  CHECK(strip.dragged(body, -40.0).barSpan.start == 0.0);
  CHECK(strip.dragged(body, -40.0).barSpan.end == 10.0);
  const TimelineGesture gone{TimelinePart::barBody, 9, 26.0, {20.0, 30.0}};
  CHECK_FALSE(strip.dragged(gone, 40.0).barChanged);
}

TEST_CASE("A release is dragged to a frame of the clip, on a loop past its seam as well") {
  Strip strip;
  const TimelineGesture after{TimelinePart::release, 1, 36.0, {20.0, 36.0}};
  CHECK(strip.dragged(after, 41.3).releaseEdge == 41.0);
  CHECK(strip.dragged(after, 41.3).releaseChanged);
  CHECK_FALSE(strip.dragged(after, 36.2).releaseChanged);
  CHECK(strip.dragged(after, 70.0).releaseEdge == 60.0);
  const TimelineGesture before{TimelinePart::release, 2, 34.0, {34.0, 50.0}};
  CHECK(strip.dragged(before, 31.0).releaseEdge == 31.0);
  CHECK(strip.dragged(before, -9.0).releaseEdge == 0.0);
  strip.model.loops = true;
  strip.model.turn = 60.0;
  CHECK(strip.dragged(after, 70.0).releaseEdge == 70.0);
  CHECK(strip.dragged(before, -9.0).releaseEdge == -9.0);
  // Taken hold of past the seam, where it is drawn at the start of the clip.
  strip.model.bars[0].windowEnd = 66.0;
  const TimelineGesture wrapped{TimelinePart::release, 1, 6.0, {20.0, 66.0}};
  CHECK(strip.dragged(wrapped, 8.0).releaseEdge == 68.0);
  CHECK(shownWindow(strip.model, strip.model.bars[0]).end == 6.0);
  CHECK(shownWindow(strip.model, strip.model.bars[1]).start == 34.0);
}

TEST_CASE("Keys are dragged by whole frames while frames snap, and the playhead goes where the mouse is") {
  Strip strip;
  const TimelineGesture keys{TimelinePart::keys, 0, 12.0, {}, 0};
  CHECK(strip.dragged(keys, 15.6).keyFrames == 4.0);
  CHECK(strip.dragged(keys, 9.0).keyFrames == -3.0);
  const TimelineGesture playhead{TimelinePart::playhead, 0, 0.0, {}};
  CHECK(strip.dragged(playhead, 7.4).playhead == 7.0);
  CHECK(strip.dragged(playhead, 7.4).playheadMoved);
  CHECK_FALSE(strip.dragged(playhead, 0.3).playheadMoved);
  CHECK(strip.dragged(playhead, 99.0).playhead == 60.0);
  strip.model.snap = false;
  CHECK(*strip.dragged(keys, 15.6).keyFrames == Approx(3.6).margin(1e-3));
  CHECK(strip.dragged(playhead, 7.4).playhead == Approx(7.4).margin(1e-3));
}

TEST_CASE(
    "The wheel zooms about the mouse, down to four frames and up to three clips, with Shift it scrolls") {
  Strip strip;
  const TimelineOutcome in = strip.turned(1.0F, 20.0);
  CHECK(in.viewChanged);
  CHECK(in.view.end - in.view.start == Approx(0.85 * 60.0));
  CHECK((20.0 - in.view.start) / (in.view.end - in.view.start) == Approx(20.0 / 60.0).margin(1e-3));
  const TimelineOutcome out = strip.turned(-1.0F, 20.0);
  CHECK(out.view.end - out.view.start == Approx(60.0 / 0.85));
  CHECK(strip.turned(100.0F, 20.0).view.end - strip.turned(100.0F, 20.0).view.start == Approx(4.0));
  CHECK(strip.turned(-100.0F, 20.0).view.end - strip.turned(-100.0F, 20.0).view.start == Approx(180.0));
  ImGui::GetIO().KeyShift = true;
  const TimelineOutcome scrolled = strip.turned(1.0F, 20.0);
  CHECK(scrolled.view.start == Approx(-6.0));
  CHECK(scrolled.view.end == Approx(54.0));
  CHECK_FALSE(strip.turned(0.0F, 20.0).viewChanged);
  TimelineOutcome beside;
  ImGui::GetIO().MouseWheel = 1.0F;
  applyWheel(strip.model, strip.layout, {50.0F, 50.0F}, beside);
  CHECK_FALSE(beside.viewChanged);
}

TEST_CASE("Of a clip of two frames the wheel shows ten at most") {
  Strip strip;
  strip.model.clip = {0.0, 2.0};
  strip.model.view = {0.0, 5.0};
  const TimelineOutcome out = strip.turned(-100.0F, 1.0);
  CHECK(out.view.end - out.view.start == Approx(10.0));
}

TEST_CASE("The middle button pans by as many frames as the mouse moves") {
  const Strip strip;
  ImGui::GetIO().MouseDelta = {30.0F, 0.0F};
  const TimelineOutcome panned = strip.dragged({.part = TimelinePart::pan}, 20.0);
  CHECK(panned.viewChanged);
  CHECK(panned.view.start == Approx(-3.0).margin(1e-3));
  CHECK(panned.view.end == Approx(57.0).margin(1e-3));
  ImGui::GetIO().MouseDelta = {0.0F, 0.0F};
  CHECK_FALSE(strip.dragged({.part = TimelinePart::pan}, 20.0).viewChanged);
}

TEST_CASE(
    "A right click says what it is on: a bar with its row, the nearest key, an end of the range, a frame") {
  const Strip strip;
  const TimelineOutcome bar = strip.rightClicked(strip.onBar(1, 45.0));
  CHECK(bar.menu.asked);
  CHECK(bar.menu.bar == 2);
  CHECK(bar.menu.row.centre().y == Approx(strip.onBar(1, 45.0).y));
  const TimelineOutcome key = strip.rightClicked(strip.onRow(0, 12.55));
  CHECK(key.menu.onKey);
  CHECK(key.menu.frame == 13.0);
  const TimelineOutcome none = strip.rightClicked(strip.onRow(0, 20.7));
  CHECK_FALSE(none.menu.onKey);
  CHECK(none.menu.frame == 21.0);
  CHECK(none.menu.bar == 0);
  const TimelineOutcome start = strip.rightClicked(strip.onRangeEdge(10.3));
  CHECK(start.menu.onRange);
  CHECK(start.menu.frame == 10.0);
  CHECK(strip.rightClicked(strip.onRangeEdge(19.7)).menu.frame == 20.0);
  CHECK_FALSE(strip.rightClicked({50.0F, 60.0F}).menu.asked);
}

TEST_CASE("Moments lie in a lane below the ruler, the keys and bars below it, and none takes no room") {
  Strip strip;
  const float withoutLane = keyRowBox(strip.theme, strip.layout, strip.model, 0).min.y;
  const float height = timelineHeight(strip.theme, strip.model);
  strip.model.moments = {{.start = 10.0, .tip = 16.0, .strength = 0.3F},
                         {.start = 12.0, .tip = 16.0, .strength = 1.0F},
                         {.start = 30.0, .tip = 33.0, .strength = 0.5F}};
  strip.layout = layoutOf(strip.theme, {{0.0F, 0.0F}, {724.0F, 200.0F}}, strip.model, 100.0F);
  const float lane = strip.layout.lane.height();
  CHECK(lane > 0.0F);
  CHECK(keyRowBox(strip.theme, strip.layout, strip.model, 0).min.y == withoutLane + lane);
  CHECK(timelineHeight(strip.theme, strip.model) == height + lane);
  const auto onLane = [&](double frame) {
    return ImVec2(strip.layout.frames.toPixel(frame), strip.layout.lane.centre().y);
  };
  CHECK(strip.hit(onLane(16.2)).part == TimelinePart::moment);
  CHECK(strip.hit(onLane(16.2)).row == 1); // The stronger of two whose tips meet.
  CHECK(strip.hit(onLane(32.6)).row == 2);
  CHECK(strip.hit(onLane(25.0)).part == TimelinePart::playhead);
  CHECK_FALSE(strip.dragged({TimelinePart::moment, 0, 16.0, {}, 1}, 30.0).playheadMoved);
  CHECK_FALSE(strip.dragged({TimelinePart::moment, 0, 16.0, {}, 1}, 30.0).rangeChanged);
}

TEST_CASE("A sound has a lane of its own below the moments, in which the playhead is moved") {
  Strip strip;
  const ImVec2 before = strip.onRow(0, 30.0);
  const float height = timelineHeight(strip.theme, strip.model);
  strip.model.sound =
      TimelineSound{{5.0, 40.0}, "beat.wav", [](double, double) { return std::pair(0.0F, 0.0F); }};
  strip.layout = layoutOf(strip.theme, {{0.0F, 0.0F}, {724.0F, 200.0F}}, strip.model, 100.0F);
  const float lane = strip.layout.sound.height();
  CHECK(lane > 20.0F);
  CHECK(strip.onRow(0, 30.0).y == before.y + lane);
  CHECK(timelineHeight(strip.theme, strip.model) == height + lane);
  for (const bool editable : {false, true}) {
    strip.model.keysEditable = editable;
    const Hit hit = strip.hit({strip.layout.frames.toPixel(30.0), strip.layout.sound.centre().y});
    CHECK(hit.part == TimelinePart::playhead);
  }
}

TEST_CASE("Arrows at the ends of a loop lead to its first frame and on from its last, where both are seen") {
  Strip strip;
  const auto tips = [&] { return seamTips(strip); };
  const auto at = [&](double frame) { return strip.layout.frames.toPixel(frame); };
  CHECK(tips().empty());
  strip.model.loops = true;
  strip.model.clip = {10.0, 50.0};
  // Six pixels long; the second begins one pixel behind the last frame, so that both are told apart.
  CHECK(tips() == std::vector<float>{at(10.0), at(50.0) + 7.0F});
  strip.model.clip = {0.0, 50.0};
  const bool hasRoom = at(0.0) - 6.0F >= strip.layout.track.min.x;
  CHECK(tips().size() == (hasRoom ? 2U : 1U));
  strip.model.clip = {-20.0, 50.0};
  CHECK(tips() == std::vector<float>{at(50.0) + 7.0F});
  strip.model.clip = {10.0, 90.0};
  CHECK(tips() == std::vector<float>{at(10.0)});
}

TEST_CASE("The name of a sound keeps clear of its wave, however long it is") {
  Strip strip;
  TimelineSound sound;
  sound.frames = {0.0, 60.0};
  sound.peak = [](double, double) { return std::pair(-0.5F, 0.5F); };
  const auto nameEnds = [&](const std::string& name) {
    sound.label = name;
    strip.model.sound = sound;
    strip.layout = layoutOf(strip.theme, {{0.0F, 0.0F}, {724.0F, 200.0F}}, strip.model, 100.0F);
    const Rect lane = strip.layout.sound;
    float end = 0.0F;
    for (const ImDrawVert& corner : drawnCorners(strip.theme, strip.layout, strip.model)) {
      const bool isBeside = corner.pos.x < strip.layout.track.min.x + 3.0F * strip.theme.unit();
      const bool isInside = std::abs(corner.pos.y - lane.centre().y) < 0.45F * lane.height();
      if (isBeside && isInside && corner.col == strip.theme.colours.quietText) {
        end = std::max(end, corner.pos.x);
      }
    }
    return end;
  };
  const float room = strip.layout.track.min.x - strip.theme.unit();
  const float shortEnd = nameEnds("Hm");
  CHECK(shortEnd > 0.0F);
  CHECK(shortEnd < room - 20.0F);
  const float longEnd = nameEnds("A recording of the whole evening, second take");
  CHECK(longEnd > room - 20.0F);
  CHECK(longEnd <= room);
}

TEST_CASE("A bar of a trail that was applied has a check mark at its end, where it is wide enough for one") {
  const double frames = GENERATE(2.0, 3.0, 10.0); // Of ten pixels each.
  const auto marked = [&](bool isApplied) {
    Strip strip;
    strip.model.bars = {
        {.id = 1, .start = 20.0, .end = 20.0 + frames, .windowStart = 20.0, .windowEnd = 20.0 + frames}};
    strip.model.bars.front().applied = isApplied;
    const ImVec2 end = strip.onBar(0, 20.0 + frames);
    int corners = 0;
    for (const ImDrawVert& corner : drawnCorners(strip.theme, strip.layout, strip.model)) {
      const bool isNear =
          corner.pos.x > end.x - 24.0F && corner.pos.x < end.x && std::abs(corner.pos.y - end.y) < 8.0F;
      corners += isNear && corner.col == strip.theme.colours.text ? 1 : 0;
    }
    return corners;
  };
  CAPTURE(frames);
  CHECK((marked(true) > marked(false)) == (frames > 2.6));
}

TEST_CASE("A label that is cut is told whole under the mouse, that of a bar sooner by the mark before it") {
  Strip strip;
  const auto labelOfWidth = [&](float width) {
    std::string label;
    while (textSize(strip.theme.fonts.label, label).x < width) {
      label += 'i';
    }
    return label;
  };
  // A hundred pixels but for eight at either side; the mark of a bar takes fourteen of them.
  const std::string narrow = labelOfWidth(60.0F);
  const std::string middling = labelOfWidth(73.0F);
  const std::string wide = labelOfWidth(90.0F);
  const auto toldFor = [&](const std::string& label, bool ofBar) {
    strip.model.keyRows[1].label = label;
    strip.model.bars[0].label = label;
    const float y = ofBar ? strip.onBar(0, 25.0).y : strip.onRow(1, 25.0).y;
    return cutLabelAt(strip.theme, strip.layout, strip.model, {50.0F, y});
  };
  CHECK(toldFor(narrow, false).empty());
  CHECK(toldFor(narrow, true).empty());
  CHECK(toldFor(middling, false).empty());
  CHECK(toldFor(middling, true) == middling);
  CHECK(toldFor(wide, false) == wide);
  CHECK(toldFor(wide, true) == wide);
  CHECK(cutLabelAt(strip.theme, strip.layout, strip.model, strip.onRow(1, 25.0)).empty()); // Not the label.
}
