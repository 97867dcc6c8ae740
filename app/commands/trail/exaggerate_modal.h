#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/commands/table/key.h"
#include "app/commands/table/modal.h"
#include "rig/trail/trail.h"

namespace stretch::app {

/// Setting that typed digits and arrows change.
enum class ExaggerateField { scale, easeIn, easeOut, release, volume };

/// The modal behind E: pure state, keys in, settings and text out.
struct ExaggerateModal {
  rig::TrailSettings start;          ///< When it began.
  rig::TrailSettings settings;       ///< Settings as edited so far.
  double defaultReleaseFrames = 0.0; ///< Value from which the arrows start while no release is set.
  ExaggerateField field = ExaggerateField::scale;
  TypedNumber typed;       ///< The number being typed for `field`.
  bool hasStrokes = false; ///< N goes to another stroke.
  bool typing = false;     ///< Whether the next digit goes on with `typed`.
};

[[nodiscard]] ExaggerateModal beginExaggerate(const rig::TrailSettings& settings,
                                              double defaultReleaseFrames);

/// Digits, period or comma, Backspace: the current field's number (scale; ease and volume in percent; frames
/// of release). Up/Down and Left/Right step it. X, Y, Z toggle an axis (with Shift: only that axis). R turns
/// the pivot; I, O, L, V choose a field (again: back to the scale; V also switches volume preservation).
/// Enter keeps, Esc restores. Other keys do nothing.
[[nodiscard]] ModalOutcome pressKey(ExaggerateModal& modal, const KeyPress& press);

/// "left arm x3.00, axes X Z", and what differs from plain after it.
[[nodiscard]] std::string modalText(const ExaggerateModal& modal, std::string_view limbTitle);

/// Says what the keys do right now.
[[nodiscard]] std::vector<ModalHint> modalHints(const ExaggerateModal& modal);

/// Another trail's settings with what the modal has changed since it began, of the axes each by itself; the
/// rest stays.
[[nodiscard]] rig::TrailSettings withModal(const rig::TrailSettings& other, const ExaggerateModal& modal);

} // namespace stretch::app
