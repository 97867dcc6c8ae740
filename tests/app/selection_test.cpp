#include "app/selection.h"

#include <catch2/catch.hpp>

using stretch::app::Selection;
using Names = std::vector<std::string>;

namespace {

Selection armWithSpheres() {
  Selection selection;
  selection.editTrails() = {{"left-arm"}, 3, {4.0, 5.0}};
  return selection;
}

} // namespace

TEST_CASE("Selected things are of one kind at a time") {
  Selection selection = armWithSpheres();
  selection.setControllers({"hips", "head"});
  CHECK(selection.limbs().empty());
  CHECK(selection.trail() == 0);
  CHECK(selection.spheres().empty());
  CHECK(selection.controllers() == Names{"hips", "head"});

  selection.setLocators({"leftHand"});
  CHECK(selection.controllers().empty());
  CHECK(selection.locators() == Names{"leftHand"});

  selection.editTrails().limbs = {"spine"};
  CHECK(selection.locators().empty());
  CHECK(selection.limbs() == Names{"spine"});
  CHECK(selection.trail() == 0);
}

TEST_CASE("An empty list drops its own kind alone") {
  Selection selection = armWithSpheres();
  selection.setControllers({});
  selection.setLocators({});
  CHECK(selection == armWithSpheres());

  selection.setControllers({"hips"});
  selection.setLocators({});
  CHECK(selection.controllers() == Names{"hips"});
  selection.setControllers({});
  CHECK(selection == Selection{});

  selection.setLocators({"head"});
  selection.setControllers({});
  CHECK(selection.locators() == Names{"head"});
  selection.setLocators({});
  CHECK(selection == Selection{});
}

TEST_CASE("Parts of a selection are dropped without the rest") {
  Selection selection = armWithSpheres();
  selection.dropSpheres();
  CHECK(selection.spheres().empty());
  CHECK(selection.trail() == 3);

  selection = armWithSpheres();
  selection.dropTrail();
  CHECK(selection.trail() == 0);
  CHECK(selection.spheres().empty());
  CHECK(selection.limbs() == Names{"left-arm"});

  selection = armWithSpheres();
  selection.dropHandles();
  CHECK(selection == armWithSpheres());

  for (const bool ofLocators : {false, true}) {
    ofLocators ? selection.setLocators({"head"}) : selection.setControllers({"head"});
    const Selection before = selection;
    selection.dropSpheres();
    selection.dropTrail();
    CHECK(selection == before);
    selection.dropHandles();
    CHECK(selection == Selection{});
  }
}
