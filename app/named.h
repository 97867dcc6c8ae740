#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "rig/controllers/controller.h"

namespace stretch::app {

// Things that people name in words, found in a document. `where` is the place of the words, for errors: the
// option
// "--limb" of a command line, the key "trails[0].limb" of a recipe.

/// Index of a clip by name or by "#index"; an empty text is the first clip. Names that repeat ask for an
/// index.
[[nodiscard]] Result<int> findClip(const Document& document, const std::string& text,
                                   const std::string& where);

/// A limb by id, or a chain "JOINT_A..JOINT_B", which is added to the document's chains.
[[nodiscard]] Result<rig::Limb> findOrAddLimb(Document& document, const std::string& text,
                                              const std::string& where);

/// "walk, run, #2": for messages.
[[nodiscard]] std::string clipList(const Document& document);

/// The name of a node, or "#index" where it has none.
[[nodiscard]] std::string nodeTitle(const Document& document, NodeIndex node);

/// The controllers and attributes of the document's character.
[[nodiscard]] rig::ControllerList controllersOf(const Document& document);

/// Those on its other joints.
[[nodiscard]] std::vector<rig::Controller> jointControllersOf(const Document& document);

/// The controller on a joint, or of this id.
[[nodiscard]] Result<rig::Controller> findController(const Document& document,
                                                     const rig::ControllerList& list, const std::string& id);

} // namespace stretch::app
