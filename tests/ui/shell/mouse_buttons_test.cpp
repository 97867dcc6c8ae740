#include <tuple>

#include <catch2/catch.hpp>

#include "tests/support/ui/panel_driver.h"
#include "ui/shell/window/input.h"

using namespace stretch;

namespace {

/// What the widgets see of the left button's events in the frames that follow.
struct SeenClicks {
  int presses = 0;
  int releases = 0;
  int doubleClicks = 0;
};

SeenClicks seen(const std::vector<ui::ButtonEvent>& events, float frameSeconds, int frames) {
  const test::PanelDriver gui(std::nullopt); // For its context of widgets.
  ui::InputQueue queue;
  queue.buttons.assign(events.begin(), events.end());
  ImGuiIO& io = ImGui::GetIO();
  SeenClicks clicks;
  for (int i = 0; i < frames; ++i) {
    io.DeltaTime = frameSeconds;
    ui::playButtons(queue, io);
    ImGui::NewFrame();
    clicks.presses += ImGui::IsMouseClicked(ImGuiMouseButton_Left) ? 1 : 0;
    clicks.releases += ImGui::IsMouseReleased(ImGuiMouseButton_Left) ? 1 : 0;
    clicks.doubleClicks += ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ? 1 : 0;
    ImGui::EndFrame();
  }
  return clicks;
}

/// Two clicks, each a press and a release, so many seconds apart.
std::vector<ui::ButtonEvent> twoClicks(double apart) {
  return {{0, true, 1.0}, {0, false, 1.04}, {0, true, 1.0 + apart}, {0, false, 1.04 + apart}};
}

} // namespace

TEST_CASE("Two quick clicks that came within one frame are a double click, however slow the frames are") {
  const float frameSeconds = GENERATE(1.0F / 60.0F, 0.25F, 1.5F);
  const SeenClicks clicks = seen(twoClicks(0.12), frameSeconds, 6);
  CHECK(clicks.presses == 2);
  CHECK(clicks.releases == 2);
  CHECK(clicks.doubleClicks == 1);
}

TEST_CASE("Two slow clicks are no double click, also where quick frames show them at once") {
  const SeenClicks clicks = seen(twoClicks(0.6), 1.0F / 60.0F, 6);
  CHECK(clicks.presses == 2);
  CHECK(clicks.doubleClicks == 0);
}

TEST_CASE("A press and its release within one frame are both seen, and a button that is held stays down") {
  const SeenClicks tapped = seen({{0, true, 1.0}, {0, false, 1.01}}, 0.5F, 3);
  CHECK(tapped.presses == 1);
  CHECK(tapped.releases == 1);
  const SeenClicks held = seen({{0, true, 1.0}}, 0.5F, 5);
  CHECK(held.presses == 1);
  CHECK(held.releases == 0);
}

TEST_CASE("Clicks half a second apart are a double click where the frames are too slow to tell") {
  for (const auto& [frameSeconds, apart, doubles] : {std::tuple(0.25F, 0.5, 1), std::tuple(0.25F, 0.6, 0),
                                                     std::tuple(0.05F, 0.4, 0), std::tuple(0.05F, 0.28, 1)}) {
    CAPTURE(frameSeconds, apart);
    CHECK(seen(twoClicks(apart), frameSeconds, 6).doubleClicks == doubles);
  }
}

TEST_CASE("While an event of a button waits for its frame the next frame comes at once") {
  const test::PanelDriver gui(std::nullopt); // For its context of widgets.
  ui::InputQueue queue;
  for (const ui::ButtonEvent& event : twoClicks(0.1)) {
    queue.buttons.push_back(event);
  }
  for (int left = 3; left >= 0; --left) {
    queue.anything = false;
    ui::playButtons(queue, ImGui::GetIO());
    CHECK(static_cast<int>(queue.buttons.size()) == left);
    CHECK(queue.anything == (left > 0));
  }
}
