// The rows of a selected locator.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"

using namespace stretch;

namespace {

/// A body of four locators, two of them the hands.
app::Document withLocators() {
  app::Document document = test::PanelDriver::bundledCharacter();
  for (const char* const name : {"hips", "head", "leftHand", "rightHand"}) {
    rig::Locator locator;
    locator.name = name;
    locator.position = Vec3(name[0] == 'l' ? 0.7 : name[0] == 'r' ? -0.7 : 0.0, 1.5, 0.0);
    document.locators.list.push_back(locator);
  }
  document.locators.list.front().position.y = 1.0;
  return document;
}

const std::vector<std::string> all{"hips", "head", "leftHand", "rightHand"};

} // namespace

TEST_CASE("Of several selected locators the one that was selected last is told, and moved by its numbers") {
  const std::vector<std::string> selected = GENERATE(
      std::vector<std::string>{"leftHand", "head"}, std::vector<std::string>{"head", "hips", "leftHand"},
      std::vector<std::string>{"hips"}, std::vector<std::string>{"rightHand", "leftHand"});
  const int axis = GENERATE(0, 1, 2);
  test::PanelDriver driver(withLocators());
  app::Session& session = *driver.open.character();
  const rig::Locators before = session.document().locators;
  session.view().showLocators = true;
  session.view().mirrorLocators = false;
  app::selectLocators(session, selected);
  driver.frames(3);
  CAPTURE(selected.back(), axis);
  const std::vector<std::string> words = test::shownWords();
  for (const char* const hand : {"leftHand", "rightHand"}) {
    CHECK((std::ranges::find(words, hand) != words.end()) == (hand == selected.back()));
  }
  driver.drag(std::string("locators/") + "XYZ"[axis], 20.0F, 0.0F);
  for (const std::string& name : all) {
    const Vec3 moved = rig::findLocator(session.document().locators, name)->position -
                       rig::findLocator(before, name)->position;
    CAPTURE(name);
    for (int other = 0; other < 3; ++other) {
      CHECK((moved[other] > 1e-3) == (name == selected.back() && other == axis));
    }
  }
  CHECK(session.history().undoLabel() == "Move " + selected.back());
}

TEST_CASE("The numbers of a locator move its counterpart as well while locators mirror") {
  test::PanelDriver driver(withLocators());
  app::Session& session = *driver.open.character();
  session.view().showLocators = true;
  session.view().mirrorLocators = true;
  app::selectLocators(session, {"leftHand"});
  driver.frames(3);
  driver.drag("locators/X", 20.0F, 0.0F);
  const double left = rig::findLocator(session.document().locators, "leftHand")->position.x;
  CHECK(left > 0.7);
  CHECK(rig::findLocator(session.document().locators, "rightHand")->position.x == Approx(-left));
}
