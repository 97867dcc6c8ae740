// The tools that move and scale picked keys: what mouse, arrows and typed numbers come to.
#include "app/commands/keys/keys_modal.h"

#include <sstream>
#include <string>

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::app;

namespace {

void pressAll(KeysModal& modal, const std::string& keys) {
  std::istringstream words(keys);
  for (std::string word; words >> word;) {
    REQUIRE(pressKey(modal, {*parseChord(word), 0}) == ModalOutcome::running);
  }
}

/// Pulled by 2.4 frames and 0.3, and by arrows 9 frames back and 4.5 down.
KeysModal pulledModal() {
  KeysModal modal;
  modal.mouseFrames = 2.4;
  modal.mouseValue = 0.3;
  modal.valueStep = 0.5;
  pressAll(modal, "Right Shift+Left Up Shift+Down");
  return modal;
}

void checkMove(const KeysModal& modal, double frames, double value, bool wholeFrames) {
  const KeyMove move = moveOf(modal);
  CHECK(move.frames == Approx(frames).margin(1e-12));
  CHECK(move.value == Approx(value).margin(1e-12));
  CHECK(move.wholeFrames == wholeFrames);
}

} // namespace

TEST_CASE("Keys are moved by mouse and arrows together, the mouse by whole frames where keys stand on them") {
  KeysModal modal = pulledModal();
  checkMove(modal, -7.0, -4.2, true);
  CHECK(modalText(modal, 3) == "3 keys by -7 frames and by -4.2");
  modal.wholeFrames = false;
  checkMove(modal, -6.6, -4.2, false);
  CHECK(modalText(modal, 1) == "a key by -6.6 frames and by -4.2");
}

TEST_CASE("X keeps keys to their time and Y to their value, again neither, and a dope sheet has time alone") {
  KeysModal modal = pulledModal();
  pressAll(modal, "X");
  checkMove(modal, -7.0, 0.0, true);
  CHECK(modalText(modal, 3) == "3 keys by -7 frames");
  pressAll(modal, "Y");
  checkMove(modal, 0.0, -4.2, true);
  CHECK(modalText(modal, 3) == "3 keys by -4.2");
  pressAll(modal, "Y");
  checkMove(modal, -7.0, -4.2, true);
  CHECK(modalHints(modal).size() == 5);
  modal.valuesShown = false;
  checkMove(modal, -7.0, 0.0, true);
  CHECK(modalText(modal, 3) == "3 keys by -7 frames");
  CHECK(modalHints(modal).size() == 4);
  pressAll(modal, "Y"); // keeps to what is not shown: nothing
  checkMove(modal, -7.0, 0.0, true);
  CHECK(modalText(modal, 3) == "3 keys by -7 frames");
}

TEST_CASE("A typed number takes the place of mouse and arrows: frames, or the value where that is locked") {
  KeysModal modal = pulledModal();
  pressAll(modal, "2 . 5");
  checkMove(modal, 2.5, 0.0, false);
  pressAll(modal, "Y");
  checkMove(modal, 0.0, 2.5, false);
  modal.valuesShown = false; // and no value to go to
  checkMove(modal, 2.5, 0.0, false);
  KeysModal other = pulledModal();
  pressAll(other, "Ctrl+3 Alt+3");
  checkMove(other, -7.0, -4.2, true);
}

TEST_CASE("Keys are scaled by the mouse and a twentieth for each arrow, in time, or in value where that is "
          "locked") {
  KeysModal modal;
  modal.kind = KeysModal::Kind::scale;
  modal.aboutFrame = 6.0;
  modal.aboutValue = 0.5;
  modal.mouseFactor = 2.0;
  pressAll(modal, "Right");
  const auto checkScale = [&](double time, double value) {
    const KeyScale scale = scaleOf(modal);
    CHECK(scale.aboutFrame == 6.0);
    CHECK(scale.aboutValue == 0.5);
    CHECK(scale.time == Approx(time));
    CHECK(scale.value == Approx(value));
  };
  checkScale(2.1, 1.0);
  CHECK(modalText(modal, 2) == "2 keys \xC3\x97"
                               "2.10 about frame 6");
  pressAll(modal, "Y");
  checkScale(1.0, 2.1);
  pressAll(modal, "2");
  checkScale(1.0, 2.0);
  CHECK(modalText(modal, 1) == "a key \xC3\x97"
                               "2.00 in value");
  modal.valuesShown = false;
  checkScale(2.0, 1.0);
}

TEST_CASE("Keys stay where Enter finds them, and come back with Escape") {
  KeysModal modal;
  CHECK(pressKey(modal, {*parseChord("Enter"), 0}) == ModalOutcome::keep);
  CHECK(pressKey(modal, {*parseChord("Esc"), 0}) == ModalOutcome::restore);
}
