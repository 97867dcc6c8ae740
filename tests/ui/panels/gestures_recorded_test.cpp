#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/commands/table/selection.h"
#include "tests/support/ui/change.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"
#include "ui/panels/menus/context_menu.h"

using namespace stretch;
using test::PanelDriver;
using test::Work;

// What each widget of each panel does under each gesture of the mouse, in the states that work brings the
// panels to.

namespace {

struct Gesture {
  const char* name;
  void (*make)(PanelDriver&);
};

void pressRight(PanelDriver& driver) {
  ImGui::GetIO().MouseDown[1] = true;
  driver.frame();
  ImGui::GetIO().MouseDown[1] = false;
  driver.frames(2);
}

void pressLeft(PanelDriver& driver) {
  driver.pressMouse();
  driver.releaseMouse();
}

void dragBy(PanelDriver& driver, float dx, float dy) {
  driver.pressMouse();
  driver.moveBy(dx * 0.5F, dy * 0.5F);
  driver.moveBy(dx * 0.5F, dy * 0.5F);
  driver.releaseMouse();
}

const Gesture clicks[] = {
    {"click", pressLeft},
    {"click with Shift",
     [](PanelDriver& driver) {
       driver.shift = true;
       pressLeft(driver);
       driver.shift = false;
     }},
    {"right click", pressRight},
};

const Gesture drags[] = {
    {"drag right", [](PanelDriver& driver) { dragBy(driver, 46.0F, 0.0F); }},
    {"drag left and up", [](PanelDriver& driver) { dragBy(driver, -38.0F, -14.0F); }},
    {"wheel",
     [](PanelDriver& driver) {
       ImGui::GetIO().MouseWheel = 1.0F;
       driver.frame();
       ImGui::GetIO().MouseWheel = 0.0F;
       driver.frames(2);
     }},
    {"type 7",
     [](PanelDriver& driver) {
       pressLeft(driver);
       pressLeft(driver);
       driver.type("7");
       driver.pressKey(ImGuiKey_Enter);
       driver.frames(2);
     }},
};

struct GestureState {
  const char* name;
  void (*prepare)(const Work&);
};

const GestureState gestureStates[] = {
    {"nothing is open", test::withNothing},
    {"a trail", test::withTrail},
    {"a group of trails", test::withGroup},
    {"everything at once", test::withEverything},
    {"weight", test::withWeight},
    {"controllers", test::withControllers},
    {"a compressed sequence", test::withCompression},
};

const GestureState statesOfTime[] = {
    {"picked keys in the graph",
     [](const Work& work) {
       test::withArmsGraph(work);
       test::pickAll(work);
     }},
    {"picked keys in the dope sheet",
     [](const Work& work) {
       test::withArmsGraph(work);
       test::pickAll(work);
       work.ui.time.tab = ui::BottomTab::dopeSheet;
     }},
    {"controllers in the graph",
     [](const Work& work) {
       test::withControllers(work);
       work.ui.time.tab = ui::BottomTab::graph;
     }},
    {"everything in the dope sheet",
     [](const Work& work) {
       test::withEverything(work);
       work.ui.time.tab = ui::BottomTab::dopeSheet;
     }},
};

test::Lines linesOf(const PanelDriver& driver) {
  test::Lines lines;
  if (driver.open.character() != nullptr) {
    test::addSession(lines, *driver.open.character());
  }
  if (driver.open.sequence() != nullptr) {
    ++lines["undo : " + driver.open.sequence()->history().undoLabel()];
    ++lines[fmt::format("frame {:.4g}", driver.open.sequence()->view().frame)];
  }
  test::addView(lines, driver.ui);
  test::addWidgets(lines, driver.items);
  for (const std::string& command : driver.requested) {
    ++lines["asks for " + command];
  }
  for (const std::string& words : test::shownWords()) {
    ++lines["words " + words];
  }
  return lines;
}

/// The panels in a state, which gestures change until it is brought about anew.
class PanelsInState {
public:
  explicit PanelsInState(const GestureState& state) : state_(state) { begin(); }
  [[nodiscard]] std::vector<ui::Item> widgets() const { return driver_->items.items; }
  [[nodiscard]] std::string changedBy(const Gesture& gesture, const ui::Item& widget) {
    ImGui::GetIO().MousePos = widget.centre();
    driver_->frames(2);
    const test::Lines before = linesOf(*driver_);
    gesture.make(*driver_);
    constexpr int most = 7;
    std::string done = test::changeText(before, linesOf(*driver_), most);
    if (!done.empty()) {
      begin();
    }
    return done;
  }
  [[nodiscard]] std::string tooltipOf(const ui::Item& widget) {
    ImGui::GetIO().MousePos = widget.centre();
    ImGui::GetIO().DeltaTime = 0.2F;
    driver_->frames(5);
    ImGui::GetIO().DeltaTime = 1.0F / 60.0F;
    return test::tooltipWords();
  }

private:
  void begin() {
    driver_ = nullptr;
    driver_ = std::make_unique<PanelDriver>(std::nullopt);
    state_.prepare({driver_->open, driver_->ui, driver_->status});
    driver_->frames(3);
  }

  const GestureState& state_;
  std::unique_ptr<PanelDriver> driver_;
};

bool isAnywhere(const ui::Item&) {
  return true;
}

/// In the pane of graph and dope sheet.
bool isInTime(const ui::Item& widget) {
  return widget.min.y >= 2240.0F && widget.max.y < 2640.0F;
}

/// Of many keys in a row the first two and some of the others: they differ in their number alone.
bool isOneOfMany(const ui::Item& widget) {
  const std::size_t slash = widget.id.find_last_of('/');
  const std::string last = slash == std::string::npos ? std::string() : widget.id.substr(slash + 1);
  const bool isNumber = !last.empty() && last.find_first_not_of("0123456789") == std::string::npos;
  return isNumber && std::stoi(last) > 1 && std::stoi(last) % 8 != 0;
}

/// What every gesture does to every widget that no earlier state had: on, or off.
template <std::size_t States, std::size_t Gestures>
std::string gesturesText(const GestureState (&shown)[States], const Gesture (&gestures)[Gestures],
                         bool (*isMeant)(const ui::Item&)) {
  std::set<std::pair<std::string, bool>> tried;
  std::string text;
  for (const GestureState& state : shown) {
    text += std::string(state.name) + "\n";
    PanelsInState panels(state);
    for (const ui::Item& widget : panels.widgets()) {
      if (!isMeant(widget) || isOneOfMany(widget) || !tried.insert({widget.id, widget.enabled}).second) {
        continue;
      }
      std::string last;
      for (const Gesture& gesture : gestures) {
        const std::string done = panels.changedBy(gesture, widget);
        text += "    " + widget.id + " , " + gesture.name;
        text += done.empty() ? " : nothing\n" : done == last ? " : the same\n" : "\n" + done;
        last = done;
      }
    }
  }
  return text;
}

/// What a drag does from many places of a widget that has parts of its own.
std::string placesText(const GestureState& state, const std::string& widget) {
  PanelsInState panels(state);
  const std::vector<ui::Item> widgets = panels.widgets();
  const auto whole = std::ranges::find(widgets, widget, &ui::Item::id);
  REQUIRE(whole != widgets.end());
  std::string text = std::string(state.name) + " , " + widget + "\n";
  std::string before;
  for (float y = whole->min.y + 4.0F; y < whole->max.y; y += 19.0F) {
    for (float x = whole->min.x + 5.0F; x < whole->max.x; x += 71.0F) {
      ui::Item place = *whole;
      place.min = place.max = {x, y};
      const std::string done = panels.changedBy(drags[0], place);
      if (done != before) {
        text += fmt::format("    from {:.0f} {:.0f}\n", x, y) + done;
      }
      before = done;
    }
  }
  return text;
}

std::string widgetsText() {
  std::string text;
  std::map<std::string, std::string> told;
  for (const GestureState& state : gestureStates) {
    text += std::string(state.name) + "\n";
    PanelsInState panels(state);
    for (const ui::Item& widget : panels.widgets()) {
      const std::string line =
          fmt::format("{} , {:.1f} {:.1f} to {:.1f} {:.1f}{}{} : {}\n", widget.id, widget.min.x, widget.min.y,
                      widget.max.x, widget.max.y, widget.enabled ? "" : " , off",
                      widget.explained ? "" : " , unexplained", panels.tooltipOf(widget));
      if (std::string& last = told[widget.id]; last != line) {
        last = line;
        text += "    " + line;
      }
    }
  }
  return text;
}

} // namespace

TEST_CASE("What each widget of the panels is, and what its tooltip says, is as it was looked at") {
  test::compareWithRecord("widgets", widgetsText());
}

TEST_CASE("What a click on each widget of the panels does is as it was looked at") {
  test::compareWithRecord("clicks", gesturesText(gestureStates, clicks, isAnywhere));
}

TEST_CASE("What dragging and typing at each widget of the panels does is as it was looked at") {
  test::compareWithRecord("drags", gesturesText(gestureStates, drags, isAnywhere));
}

TEST_CASE("What each gesture in graph and dope sheet does is as it was looked at") {
  test::compareWithRecord("clicks-in-time", gesturesText(statesOfTime, clicks, isInTime));
  test::compareWithRecord("drags-in-time", gesturesText(statesOfTime, drags, isInTime));
}

TEST_CASE("What a drag does from each place of timeline, graph and dope sheet is as it was looked at") {
  test::compareWithRecord("drags-from-places", placesText(gestureStates[2], "timeline") +
                                                   placesText(statesOfTime[0], "graph") +
                                                   placesText(statesOfTime[1], "dope-sheet"));
}
