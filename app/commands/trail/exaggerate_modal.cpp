#include "app/commands/trail/exaggerate_modal.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace stretch::app {

namespace {

constexpr double largestEase = 0.95; ///< Of both percents together: they must stay below the whole.
constexpr double largestReleaseFrames = 10000.0;

/// 0.05; with Shift 0.01, with Ctrl 0.25.
double stepOf(const Chord& chord) {
  return chord.shift ? 0.01 : chord.ctrl ? 0.25 : 0.05;
}

double clampedScale(double scale) {
  return std::clamp(scale, 0.0, rig::largestScale);
}

/// Steps land on multiples of the smallest one, so that long presses do not gather rounding.
double rounded(double value) {
  return std::round(value * 100.0) / 100.0;
}

void setEasePercent(ExaggerateModal& modal, double percent) {
  const bool in = modal.field == ExaggerateField::easeIn;
  rig::Ease& ease = in ? modal.settings.easeIn : modal.settings.easeOut;
  const rig::Ease& other = in ? modal.settings.easeOut : modal.settings.easeIn;
  ease.percent = std::clamp(percent, 0.0, std::max(0.0, largestEase - other.percent));
}

void setEaseValue(ExaggerateModal& modal, double value) {
  if (modal.field == ExaggerateField::easeIn) {
    modal.settings.easeIn.value = std::clamp(value, 0.0, 0.5);
  } else {
    modal.settings.easeOut.value = std::clamp(value, 0.5, 1.0);
  }
}

const rig::Ease& currentEase(const ExaggerateModal& modal) {
  return modal.field == ExaggerateField::easeIn ? modal.settings.easeIn : modal.settings.easeOut;
}

double currentRelease(const ExaggerateModal& modal) {
  return modal.settings.releaseFrames.value_or(modal.defaultReleaseFrames);
}

void setRelease(ExaggerateModal& modal, double frames) {
  modal.settings.releaseFrames = std::clamp(frames, 0.0, largestReleaseFrames);
}

void restoreField(ExaggerateModal& modal) {
  switch (modal.field) {
  case ExaggerateField::scale:
    modal.settings.scale = modal.start.scale;
    break;
  case ExaggerateField::easeIn:
    setEasePercent(modal, modal.start.easeIn.percent);
    break;
  case ExaggerateField::easeOut:
    setEasePercent(modal, modal.start.easeOut.percent);
    break;
  case ExaggerateField::release:
    modal.settings.releaseFrames = modal.start.releaseFrames;
    break;
  case ExaggerateField::volume:
    modal.settings.volume = modal.start.volume;
    break;
  }
}

void takeTyped(ExaggerateModal& modal) {
  if (modal.typed.empty()) {
    restoreField(modal);
    return;
  }
  const double value = modal.typed.value();
  switch (modal.field) {
  case ExaggerateField::scale:
    modal.settings.scale = clampedScale(value);
    break;
  case ExaggerateField::easeIn:
  case ExaggerateField::easeOut:
    setEasePercent(modal, value / 100.0);
    break;
  case ExaggerateField::release:
    setRelease(modal, value);
    break;
  case ExaggerateField::volume:
    modal.settings.volume = std::clamp(value / 100.0, 0.0, 1.0);
    break;
  }
}

/// Whether the key belongs to a typed number.
bool typeNumber(ExaggerateModal& modal, const Chord& chord) {
  const std::optional<int> digit = digitOf(chord.key);
  const bool separator = isDecimalSeparator(chord.key);
  const bool erase = chord.key == Key::backspace;
  if (chord.ctrl || chord.alt || (!digit && !separator && !erase)) {
    return false;
  }
  if (!modal.typing) {
    modal.typed = {};
    modal.typing = true;
  }
  std::string& text = modal.typed.text;
  if (digit && text.size() < 9) {
    text.push_back(static_cast<char>('0' + *digit));
  } else if (separator && text.find('.') == std::string::npos) {
    text.push_back('.');
  } else if (erase && !text.empty()) {
    text.pop_back();
  }
  takeTyped(modal);
  return true;
}

void stepUpDown(ExaggerateModal& modal, const Chord& chord, double direction) {
  const double step = direction * stepOf(chord);
  switch (modal.field) {
  case ExaggerateField::scale:
    modal.settings.scale = clampedScale(rounded(modal.settings.scale + step));
    break;
  case ExaggerateField::easeIn:
  case ExaggerateField::easeOut:
    setEaseValue(modal, rounded(currentEase(modal).value + step));
    break;
  case ExaggerateField::release:
    setRelease(modal, std::round(currentRelease(modal)) + direction * (chord.ctrl ? 5.0 : 1.0));
    break;
  case ExaggerateField::volume:
    modal.settings.volume = std::clamp(rounded(modal.settings.volume + step), 0.0, 1.0);
    break;
  }
}

void stepLeftRight(ExaggerateModal& modal, const Chord& chord, double direction) {
  const bool easing = modal.field == ExaggerateField::easeIn || modal.field == ExaggerateField::easeOut;
  if (easing) {
    setEasePercent(modal, rounded(currentEase(modal).percent + direction * stepOf(chord)));
  } else if (modal.field != ExaggerateField::scale) {
    stepUpDown(modal, chord, direction);
  }
}

bool stepWithArrows(ExaggerateModal& modal, const Chord& chord) {
  switch (chord.key) {
  case Key::up:
    stepUpDown(modal, chord, 1.0);
    break;
  case Key::down:
    stepUpDown(modal, chord, -1.0);
    break;
  case Key::right:
    stepLeftRight(modal, chord, 1.0);
    break;
  case Key::left:
    stepLeftRight(modal, chord, -1.0);
    break;
  default:
    return false;
  }
  return true;
}

void toggleAxis(ExaggerateModal& modal, std::size_t axis, bool only) {
  if (only) {
    modal.settings.axes = {false, false, false};
    modal.settings.axes[axis] = true;
  } else {
    modal.settings.axes[axis] = !modal.settings.axes[axis];
  }
}

void chooseField(ExaggerateModal& modal, ExaggerateField field) {
  modal.field = modal.field == field ? ExaggerateField::scale : field;
}

void pressLetter(ExaggerateModal& modal, const KeyPress& press) {
  if (press.chord.ctrl || press.chord.alt) {
    return;
  }
  switch (typedLetter(press)) {
  case 'x':
    toggleAxis(modal, 0, press.chord.shift);
    break;
  case 'y':
    toggleAxis(modal, 1, press.chord.shift);
    break;
  case 'z':
    toggleAxis(modal, 2, press.chord.shift);
    break;
  case 'r':
    modal.settings.pivot = modal.settings.pivot == rig::Pivot::start ? rig::Pivot::end : rig::Pivot::start;
    break;
  case 'e':
    modal.field = ExaggerateField::scale;
    break;
  case 'i':
    chooseField(modal, ExaggerateField::easeIn);
    break;
  case 'o':
    chooseField(modal, ExaggerateField::easeOut);
    break;
  case 'l':
    chooseField(modal, ExaggerateField::release);
    break;
  case 'v':
    modal.settings.volume = modal.settings.volume > 0.0 ? 0.0 : 1.0;
    modal.field = ExaggerateField::volume;
    break;
  default:
    break;
  }
}

std::string axesText(const std::array<bool, 3>& axes) {
  if (!axes[0] && !axes[1] && !axes[2]) {
    return "no axis";
  }
  std::string text = "axes";
  text += axes[0] ? " X" : "";
  text += axes[1] ? " Y" : "";
  text += axes[2] ? " Z" : "";
  return text;
}

std::string easeText(std::string_view name, const rig::Ease& ease, bool always) {
  if (!always && ease.percent <= 0.0) {
    return {};
  }
  return fmt::format(", {} {:.0f} % to {:.2f}", name, 100.0 * ease.percent, ease.value);
}

} // namespace

ExaggerateModal beginExaggerate(const rig::TrailSettings& settings, double defaultReleaseFrames) {
  ExaggerateModal modal;
  modal.start = settings;
  modal.settings = settings;
  modal.defaultReleaseFrames = defaultReleaseFrames;
  return modal;
}

ModalOutcome pressKey(ExaggerateModal& modal, const KeyPress& press) {
  if (const std::optional<ModalOutcome> end = endBy(press.chord)) {
    return *end;
  }
  if (typeNumber(modal, press.chord)) {
    return ModalOutcome::running;
  }
  modal.typing = false;
  if (!stepWithArrows(modal, press.chord)) {
    pressLetter(modal, press);
  }
  return ModalOutcome::running;
}

std::string modalText(const ExaggerateModal& modal, std::string_view limbTitle) {
  const rig::TrailSettings& settings = modal.settings;
  std::string text = fmt::format("{} x{:.2f}, {}", limbTitle, settings.scale, axesText(settings.axes));
  text += settings.pivot == rig::Pivot::end ? ", pivot at the end" : "";
  text += settings.stopAt ? (settings.stopAt->normal.y < 0.0 ? ", stops at the floor" : ", stops at a plane")
                          : "";
  text += easeText("ease-in", settings.easeIn, modal.field == ExaggerateField::easeIn);
  text += easeText("ease-out", settings.easeOut, modal.field == ExaggerateField::easeOut);
  if (settings.releaseFrames || modal.field == ExaggerateField::release) {
    text += fmt::format(", release {:.4g} frames", currentRelease(modal));
  }
  if (settings.volume < 1.0 || modal.field == ExaggerateField::volume) {
    text += fmt::format(", volume {:.0f} %", 100.0 * settings.volume);
  }
  if (settings.scale < rig::smallestScale) {
    text += fmt::format(" (taken as {:.2f})", rig::smallestScale);
  }
  if (modal.field == ExaggerateField::scale && modal.typed.value() > rig::largestScale) {
    text += fmt::format(" ({:g} is the most)", rig::largestScale);
  }
  return text;
}

std::vector<ModalHint> modalHints(const ExaggerateModal& modal) {
  std::vector<ModalHint> hints;
  switch (modal.field) {
  case ExaggerateField::scale:
    hints = {{"0-9", "scale"}, {"Up Down", "by 0.05"}};
    if (modal.hasStrokes) {
      hints.push_back({"N", "next stroke"});
    }
    break;
  case ExaggerateField::easeIn:
  case ExaggerateField::easeOut:
    hints = {{"0-9", "percent"}, {"Left Right", "percent"}, {"Up Down", "value"}};
    break;
  case ExaggerateField::release:
    hints = {{"0-9", "frames"}, {"Left Right", "one frame"}};
    break;
  case ExaggerateField::volume:
    hints = {{"0-9", "percent"}, {"Up Down", "volume"}};
    break;
  }
  hints.insert(hints.begin(), {{"Enter", "keep"}, {"Esc", "restore"}});
  hints.insert(hints.end(),
               {{"X Y Z", "axes"}, {"R", "pivot"}, {"I O", "ease"}, {"L", "release"}, {"V", "volume"}});
  return hints;
}

rig::TrailSettings withModal(const rig::TrailSettings& other, const ExaggerateModal& modal) {
  rig::TrailSettings settings = other;
  const auto take = [&](auto rig::TrailSettings::*field) {
    if (modal.settings.*field != modal.start.*field) {
      settings.*field = modal.settings.*field;
    }
  };
  take(&rig::TrailSettings::scale);
  take(&rig::TrailSettings::pivot);
  take(&rig::TrailSettings::easeIn);
  take(&rig::TrailSettings::easeOut);
  take(&rig::TrailSettings::volume);
  take(&rig::TrailSettings::releaseFrames);
  for (std::size_t axis = 0; axis < settings.axes.size(); ++axis) {
    if (modal.settings.axes[axis] != modal.start.axes[axis]) {
      settings.axes[axis] = modal.settings.axes[axis];
    }
  }
  const bool takesIn = modal.settings.easeIn != modal.start.easeIn;
  if (takesIn != (modal.settings.easeOut != modal.start.easeOut)) { // the other one is of this trail
    rig::Ease& taken = takesIn ? settings.easeIn : settings.easeOut;
    const double own = takesIn ? settings.easeOut.percent : settings.easeIn.percent;
    taken.percent = std::clamp(taken.percent, 0.0, std::max(0.0, largestEase - own));
  }
  return settings;
}

} // namespace stretch::app
