#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/edits/trail/place_trails.h"
#include "rig/controllers/controller.h"

namespace stretch::app {

// The one door for adjustments: the command line, recipes and the work that a file carries all pass through
// it. An adjustment names a controller or an attribute that the character has and a clip of the file; its
// keys are numbers, stand inside its range, and ask only for what the controller can do.

/// The controllers and attributes of the document's character.
[[nodiscard]] rig::ControllerList controllersOf(const Document& document);

/// Those on its other joints.
[[nodiscard]] std::vector<rig::Controller> jointControllersOf(const Document& document);

/// The controller on a joint, or of this id.
[[nodiscard]] Result<rig::Controller> findController(const Document& document,
                                                     const rig::ControllerList& list, const std::string& id);

/// All of them or none. What the document has of the same controller at the same time gives way; two of
/// `wanted` that overlap are refused. Errors name the controller. With Entry::file a range may lie past the
/// clip's end.
[[nodiscard]] Result<Document> placeAdjustments(const Document& document,
                                                std::span<const rig::Adjustment> wanted,
                                                Entry entry = Entry::request);

/// Takes every adjustment of a controller or an attribute in a clip away.
[[nodiscard]] Document removeAdjustments(const Document& document, const std::string& controller, int clip);

} // namespace stretch::app
