#include "app/commands/keys/keys_modal.h"

#include <cmath>

#include <fmt/core.h>

namespace stretch::app {

namespace {

void stepByArrow(KeysModal& modal, const Chord& chord) {
  const double far = chord.shift ? 10.0 : 1.0;
  const double side = chord.key == Key::right ? 1.0 : chord.key == Key::left ? -1.0 : 0.0;
  const double up = chord.key == Key::up ? 1.0 : chord.key == Key::down ? -1.0 : 0.0;
  modal.arrowFrames += side * far;
  modal.arrowValue += up * far * modal.valueStep;
}

void toggleLock(KeysModal& modal, KeysModal::Lock lock) {
  modal.lock = modal.lock == lock ? KeysModal::Lock::none : lock;
}

bool movesTime(const KeysModal& modal) {
  return modal.lock != KeysModal::Lock::value || !modal.valuesShown;
}

bool movesValue(const KeysModal& modal) {
  return modal.valuesShown && modal.lock != KeysModal::Lock::time;
}

} // namespace

ModalOutcome pressKey(KeysModal& modal, const KeyPress& press) {
  const Chord& chord = press.chord;
  if (const std::optional<ModalOutcome> end = endBy(chord)) {
    return *end;
  }
  if (!chord.ctrl && !chord.alt && typeNumber(modal.typed, chord)) {
    return ModalOutcome::running;
  }
  const char letter = typedLetter(press);
  if (letter == 'x' || letter == 'y') {
    toggleLock(modal, letter == 'x' ? KeysModal::Lock::time : KeysModal::Lock::value);
  } else {
    stepByArrow(modal, chord);
  }
  return ModalOutcome::running;
}

KeyMove moveOf(const KeysModal& modal) {
  KeyMove move{0.0, 0.0, modal.wholeFrames};
  if (!modal.typed.empty()) {
    const bool toValue = modal.lock == KeysModal::Lock::value && modal.valuesShown;
    (toValue ? move.value : move.frames) = modal.typed.value();
    move.wholeFrames = false;
    return move;
  }
  const double pulled = modal.wholeFrames ? std::round(modal.mouseFrames) : modal.mouseFrames;
  move.frames = movesTime(modal) ? pulled + modal.arrowFrames : 0.0;
  move.value = movesValue(modal) ? modal.mouseValue + modal.arrowValue : 0.0;
  return move;
}

KeyScale scaleOf(const KeysModal& modal) {
  const double stepped = std::pow(1.05, modal.arrowFrames);
  const double factor = !modal.typed.empty() ? modal.typed.value() : modal.mouseFactor * stepped;
  KeyScale scale{modal.aboutFrame, 1.0, modal.aboutValue, 1.0};
  (modal.lock == KeysModal::Lock::value && modal.valuesShown ? scale.value : scale.time) = factor;
  return scale;
}

std::string modalText(const KeysModal& modal, std::size_t keys) {
  const std::string what = keys == 1 ? "a key" : fmt::format("{} keys", keys);
  if (modal.kind == KeysModal::Kind::scale) {
    const KeyScale scale = scaleOf(modal);
    return modal.lock == KeysModal::Lock::value && modal.valuesShown
               ? fmt::format("{} \xC3\x97{:.2f} in value", what, scale.value)
               : fmt::format("{} \xC3\x97{:.2f} about frame {:g}", what, scale.time, scale.aboutFrame);
  }
  const KeyMove move = moveOf(modal);
  const std::string time = fmt::format(" by {:g} frames", std::round(move.frames * 100.0) / 100.0);
  const std::string value = fmt::format(" by {:.3g}", move.value);
  return what + (movesTime(modal) ? time : "") +
         (movesValue(modal) ? (movesTime(modal) ? " and" : "") + value : "");
}

std::vector<ModalHint> modalHints(const KeysModal& modal) {
  std::vector<ModalHint> hints{{"Enter", "keep"}, {"Esc", "restore"}, {"0-9", "amount"}};
  if (modal.valuesShown) {
    hints.push_back({"X Y", "time or value alone"});
  }
  hints.push_back({"Arrows", "step"});
  return hints;
}

} // namespace stretch::app
