#include <catch2/catch.hpp>

#include <sstream>

#include "app/commands/trail/exaggerate_modal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// Presses keys as they would be written down: "3 Y Shift+Up Enter".
template <typename Modal>
ModalOutcome type(Modal& modal, const std::string& keys) {
  std::istringstream words(keys);
  ModalOutcome outcome = ModalOutcome::running;
  for (std::string word; words >> word;) {
    const auto chord = parseChord(word);
    REQUIRE(chord);
    outcome = pressKey(modal, KeyPress{*chord, 0});
  }
  return outcome;
}

ExaggerateModal punch() {
  rig::TrailSettings settings;
  settings.scale = 2.0;
  settings.endFrame = 12.0;
  return beginExaggerate(settings, 4.0);
}

} // namespace

TEST_CASE("The refined punch: 3 Y Enter") {
  ExaggerateModal modal = punch();
  CHECK(type(modal, "3 Y Enter") == ModalOutcome::keep);
  CHECK(modal.settings.scale == 3.0);
  CHECK(modal.settings.axes == std::array{true, false, true});
  CHECK(modalText(modal, "arm") == "arm x3.00, axes X Z");
}

TEST_CASE("A scale is typed with a period or a comma, corrected and limited") {
  ExaggerateModal modal = punch();
  SECTION("period") {
    type(modal, "2 . 5");
  }
  SECTION("comma") {
    type(modal, "2 , 5");
  }
  SECTION("numeric pad") {
    type(modal, "Numpad2 Numpad. Numpad5");
  }
  SECTION("corrected") {
    type(modal, "2 . 7 Backspace 5");
  }
  SECTION("a second separator is ignored") {
    type(modal, "2 . . 5");
  }
  SECTION("a new number after another key") {
    type(modal, "3 Y 2 . 5 Y");
  }
  CHECK(modal.settings.scale == Approx(2.5));
}

TEST_CASE("A scale beyond what is offered is limited, and one near nothing is told") {
  ExaggerateModal modal = punch();
  type(modal, "7");
  CHECK(modal.settings.scale == 5.0);
  type(modal, "Up 0");
  CHECK(modal.settings.scale == 0.0);
  CHECK(modalText(modal, "arm").find("taken as 0.05") != std::string::npos);
}

TEST_CASE("Erasing what was typed gives back the scale of the beginning") {
  ExaggerateModal modal = punch();
  type(modal, "4 Backspace");
  CHECK(modal.settings.scale == 2.0);
}

TEST_CASE("Erasing gives back the number of the beginning, whatever is typed, and nothing else changes") {
  rig::TrailSettings settings;
  settings.scale = 2.0;
  settings.easeIn = {0.3, 0.2};
  settings.easeOut = {0.25, 0.8};
  settings.releaseFrames = 7.0;
  settings.volume = 0.6;
  for (const char* const field : {"E", "I", "O", "L", "V"}) {
    INFO(field);
    ExaggerateModal modal = beginExaggerate(settings, 4.0);
    type(modal, field);
    type(modal, "1 2");
    CHECK_FALSE(modal.settings == settings);
    type(modal, "Backspace Backspace");
    CHECK(modal.settings == settings);
  }
  ExaggerateModal unset = beginExaggerate(rig::TrailSettings{}, 4.0);
  type(unset, "L 3 Backspace");
  CHECK_FALSE(unset.settings.releaseFrames);
}

TEST_CASE("Every digit counts in a number that is typed, before and behind the separator, and a minus") {
  TypedNumber number;
  const auto typed = [&](const std::string& text) {
    number.text = text;
    return number.value();
  };
  CHECK(typed("407") == 407.0);
  CHECK(typed("12.25") == Approx(12.25));
  CHECK(typed("-30.5") == Approx(-30.5));
  CHECK(typed(".5") == 0.5);
}

TEST_CASE("Arrows step the scale: plain, fine with Shift, coarse with Ctrl") {
  ExaggerateModal modal = punch();
  type(modal, "Up");
  CHECK(modal.settings.scale == Approx(2.05));
  type(modal, "Shift+Up");
  CHECK(modal.settings.scale == Approx(2.06));
  type(modal, "Ctrl+Down");
  CHECK(modal.settings.scale == Approx(1.81));
  for (int i = 0; i < 100; ++i) {
    type(modal, "Ctrl+Down");
  }
  CHECK(modal.settings.scale == 0.0);
}

TEST_CASE("Axes toggle, and with Shift one is left alone") {
  ExaggerateModal modal = punch();
  type(modal, "X");
  CHECK(modal.settings.axes == std::array{false, true, true});
  type(modal, "X Shift+Y");
  CHECK(modal.settings.axes == std::array{false, true, false});
  type(modal, "Y");
  CHECK(modalText(modal, "arm") == "arm x2.00, no axis");
}

TEST_CASE("Each of the three axes toggles alone, is left alone with Shift, and is told by its letter") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string letter(1, static_cast<char>('X' + axis));
    ExaggerateModal modal = punch();
    type(modal, letter);
    std::array<bool, 3> others{true, true, true};
    others[axis] = false;
    CHECK(modal.settings.axes == others);
    CHECK(modalText(modal, "arm").find(letter) == std::string::npos);
    type(modal, letter + " Shift+" + letter);
    std::array<bool, 3> alone{false, false, false};
    alone[axis] = true;
    CHECK(modal.settings.axes == alone);
    CHECK(modalText(modal, "arm") == "arm x2.00, axes " + letter);
  }
}

TEST_CASE("Axes are read by what the layout prints, not by position") {
  ExaggerateModal modal = punch();
  CHECK(pressKey(modal, KeyPress{{Key{'Z'}}, 'y'}) == ModalOutcome::running); // The key left of X on a German
                                                                              // keyboard's bottom row.
  CHECK(modal.settings.axes == std::array{true, false, true});
}

TEST_CASE("R turns the pivot round and back") {
  ExaggerateModal modal = punch();
  type(modal, "R");
  CHECK(modal.settings.pivot == rig::Pivot::end);
  type(modal, "R");
  CHECK(modal.settings.pivot == rig::Pivot::start);
}

TEST_CASE("I and O take the arrows and digits for the ease") {
  ExaggerateModal modal = punch();
  type(modal, "I 6 0");
  CHECK(modal.settings.easeIn.percent == Approx(0.6));
  CHECK(modal.settings.scale == 2.0);
  type(modal, "Right Shift+Left Up");
  CHECK(modal.settings.easeIn.percent == Approx(0.64));
  CHECK(modal.settings.easeIn.value == Approx(0.15));
  type(modal, "O Right Down");
  CHECK(modal.settings.easeOut.percent == Approx(0.05));
  CHECK(modal.settings.easeOut.value == Approx(0.85));

  SECTION("both percents together stay below the whole") {
    type(modal, "9 0");
    CHECK(modal.settings.easeIn.percent + modal.settings.easeOut.percent < 1.0);
  }
  SECTION("the same key again gives the digits back to the scale") {
    type(modal, "O 4");
    CHECK(modal.settings.scale == 4.0);
  }
}

TEST_CASE("L takes digits and arrows for the release, starting from the default") {
  ExaggerateModal modal = punch();
  CHECK_FALSE(modal.settings.releaseFrames);
  type(modal, "L Right");
  CHECK(modal.settings.releaseFrames == 5.0);
  type(modal, "1 2");
  CHECK(modal.settings.releaseFrames == 12.0);
  type(modal, "0");
  CHECK(modal.settings.releaseFrames == 120.0);
  CHECK(modalText(modal, "arm").find("release 120 frames") != std::string::npos);
}

TEST_CASE("V switches volume preservation and lets it be typed") {
  ExaggerateModal modal = punch();
  type(modal, "V");
  CHECK(modal.settings.volume == 0.0);
  type(modal, "5 0");
  CHECK(modal.settings.volume == Approx(0.5));
}

TEST_CASE("Esc restores, keys that mean nothing here change nothing") {
  ExaggerateModal modal = punch();
  CHECK(type(modal, "Q F5 Ctrl+Z Home") == ModalOutcome::running);
  CHECK(modal.settings == modal.start);
  CHECK(type(modal, "3 Esc") == ModalOutcome::restore);
}

TEST_CASE("The modal's settings carry over to another limb without its range") {
  ExaggerateModal modal = punch();
  type(modal, "3 Y");
  rig::TrailSettings other;
  other.startFrame = 4.0;
  other.endFrame = 9.0;
  other.spheres = {{5.0, Vec3(1.0)}};
  const rig::TrailSettings result = withModal(other, modal);
  CHECK(result.scale == 3.0);
  CHECK(result.startFrame == 4.0);
  CHECK(result.spheres == other.spheres);
}

TEST_CASE(
    "Each number of the modal carries over, and what the modal does not set stays the other limb's own") {
  using Settings = rig::TrailSettings;
  const std::vector<std::pair<const char*, void (*)(Settings&)>> carried{
      {"scale", [](Settings& s) { s.scale = 3.5; }},
      {"axes",
       [](Settings& s) {
         s.axes = {true, false, false};
       }},
      {"pivot", [](Settings& s) { s.pivot = rig::Pivot::end; }},
      {"ease-in",
       [](Settings& s) {
         s.easeIn = {0.3, 0.2};
       }},
      {"ease-out",
       [](Settings& s) {
         s.easeOut = {0.2, 0.7};
       }},
      {"volume", [](Settings& s) { s.volume = 0.4; }},
      {"release", [](Settings& s) { s.releaseFrames = 7.0; }}};
  Settings other;
  other.startFrame = 4.0;
  other.endFrame = 9.0;
  other.overshoot = 0.3;
  other.blend = 1.0;
  for (const auto& [name, change] : carried) {
    CAPTURE(name);
    ExaggerateModal modal = punch();
    modal.start = modal.settings = Settings{};
    change(modal.settings);
    Settings wanted = other;
    change(wanted);
    CHECK(withModal(other, modal) == wanted);
  }
  ExaggerateModal modal = punch();
  modal.start.overshoot = 0.1;
  modal.settings.overshoot = 0.3;
  CHECK(withModal(Settings{}, modal) == Settings{});
}

TEST_CASE("What the keys of the modal left alone stays each trail's own, of the axes one by one") {
  ExaggerateModal modal = punch();
  rig::TrailSettings other;
  other.scale = 4.0;
  other.axes = {true, true, false};
  other.pivot = rig::Pivot::end;
  other.easeOut = {0.6, 0.8};
  CHECK(withModal(other, modal) == other);
  type(modal, "Y");
  CHECK(withModal(other, modal).axes == std::array{true, false, false});
  CHECK(withModal(other, modal).scale == 4.0);
  CHECK(withModal(other, modal).pivot == rig::Pivot::end);
  type(modal, "I 7 0");
  CHECK(withModal(other, modal).easeIn.percent == Approx(0.35)); // both together stay below the whole
  CHECK(withModal(other, modal).easeOut == other.easeOut);
  modal = punch();
  other.easeIn = {0.6, 0.2};
  other.easeOut = {};
  type(modal, "O 7 0");
  CHECK(withModal(other, modal).easeIn == other.easeIn);
  CHECK(withModal(other, modal).easeOut.percent == Approx(0.35));
}

TEST_CASE("The ease steps by its field, its value within its half and its percent beside the other one") {
  ExaggerateModal modal = punch();
  type(modal, "I Ctrl+Up Ctrl+Up Ctrl+Up");
  CHECK(modal.settings.easeIn.value == 0.5);
  type(modal, "Ctrl+Down Ctrl+Down Ctrl+Down");
  CHECK(modal.settings.easeIn.value == 0.0);
  type(modal, "Ctrl+Right Ctrl+Right Ctrl+Right Shift+Left");
  CHECK(modal.settings.easeIn.percent == Approx(0.74));
  type(modal, "O Ctrl+Right");
  CHECK(modal.settings.easeOut.percent == Approx(0.21)); // 95 percent together are the most.
  type(modal, "Ctrl+Down Ctrl+Down Ctrl+Down");
  CHECK(modal.settings.easeOut.value == 0.5);
  type(modal, "Ctrl+Up Ctrl+Up Ctrl+Up");
  CHECK(modal.settings.easeOut.value == 1.0);
  type(modal, "Ctrl+Left");
  CHECK(modal.settings.easeOut.percent == 0.0);
  CHECK(modal.settings.easeIn.percent == Approx(0.74));
  CHECK(modal.settings.scale == 2.0);
}

TEST_CASE("The release and the volume step by any arrow, the scale by those up and down alone") {
  ExaggerateModal modal = punch();
  type(modal, "Left Right");
  CHECK(modal.settings.scale == 2.0);
  type(modal, "L Up");
  CHECK(modal.settings.releaseFrames == 5.0);
  type(modal, "Left Down");
  CHECK(modal.settings.releaseFrames == 3.0);
  type(modal, "Ctrl+Right");
  CHECK(modal.settings.releaseFrames == 8.0);
  type(modal, "Ctrl+Left Ctrl+Down");
  CHECK(modal.settings.releaseFrames == 0.0);
  type(modal, "V Up Shift+Right");
  CHECK(modal.settings.volume == Approx(0.06));
  type(modal, "Down Down");
  CHECK(modal.settings.volume == 0.0);
  type(modal, "1 5 0");
  CHECK(modal.settings.volume == 1.0);
  type(modal, "V");
  CHECK(modal.settings.volume == 0.0);
  type(modal, "V");
  CHECK(modal.settings.volume == 1.0);
}

TEST_CASE("The modal tells what is set, of what its keys change always and of the rest what is not plain") {
  ExaggerateModal modal = punch();
  const auto told = [&] { return modalText(modal, "arm"); };
  CHECK(told() == "arm x2.00, axes X Y Z");
  type(modal, "R");
  CHECK(told() == "arm x2.00, axes X Y Z, pivot at the end");
  type(modal, "R I");
  CHECK(told() == "arm x2.00, axes X Y Z, ease-in 0 % to 0.10");
  type(modal, "3 0 O 2 5");
  CHECK(told() == "arm x2.00, axes X Y Z, ease-in 30 % to 0.10, ease-out 25 % to 0.90");
  type(modal, "I 0 O 0 L");
  CHECK(told() == "arm x2.00, axes X Y Z, release 4 frames");
  type(modal, "Ctrl+Up E");
  CHECK(told() == "arm x2.00, axes X Y Z, release 9 frames");
  type(modal, "V");
  CHECK(told() == "arm x2.00, axes X Y Z, release 9 frames, volume 0 %");
  type(modal, "V");
  CHECK(told() == "arm x2.00, axes X Y Z, release 9 frames, volume 100 %");
  type(modal, "E");
  CHECK(told() == "arm x2.00, axes X Y Z, release 9 frames");
  modal = punch();
  type(modal, "5");
  CHECK(told() == "arm x5.00, axes X Y Z");
  type(modal, "E 6");
  CHECK(told() == "arm x5.00, axes X Y Z (5 is the most)");
  modal = punch();
  modal.settings.stopAt = rig::StopPlane{};
  modal.settings.stopAt->normal = Vec3(0.0, -1.0, 0.0);
  CHECK(told() == "arm x2.00, axes X Y Z, stops at the floor");
  modal.settings.stopAt->normal = Vec3(1.0, 0.0, 0.0);
  CHECK(told() == "arm x2.00, axes X Y Z, stops at a plane");
}

TEST_CASE(
    "The hints of the modal say what digits and arrows mean now, and name the next stroke where there is "
    "one") {
  ExaggerateModal modal = punch();
  const auto hinted = [&] {
    std::string text;
    for (const ModalHint& hint : modalHints(modal)) {
      text += (text.empty() ? "" : ", ") + hint.key + ": " + hint.does;
    }
    return text;
  };
  const std::string first = "Enter: keep, Esc: restore, ";
  const std::string last = ", X Y Z: axes, R: pivot, I O: ease, L: release, V: volume";
  CHECK(hinted() == first + "0-9: scale, Up Down: by 0.05" + last);
  modal.hasStrokes = true;
  CHECK(hinted() == first + "0-9: scale, Up Down: by 0.05, N: next stroke" + last);
  for (const char* const ease : {"I", "O"}) {
    type(modal, ease);
    CHECK(hinted() == first + "0-9: percent, Left Right: percent, Up Down: value" + last);
  }
  type(modal, "L");
  CHECK(hinted() == first + "0-9: frames, Left Right: one frame" + last);
  type(modal, "V");
  CHECK(hinted() == first + "0-9: percent, Up Down: volume" + last);
}
