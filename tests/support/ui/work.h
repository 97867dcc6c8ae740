#pragma once

#include <filesystem>

#include "app/open_document.h"
#include "ui/panels/state/ui_state.h"

namespace stretch::test {

/// What panels show: what is open, and how it is looked at.
struct Work {
  app::OpenDocument& open;
  ui::UiState& ui;
  ui::EditorStatus& status;
  std::filesystem::path place = {}; ///< Where the character's file is said to lie; empty: where it does.

  [[nodiscard]] app::Session& session() const { return *open.character(); }
};

/// As the user would, by its key or its button.
void run(const Work& work, const char* command);

// States that work brings the panels to.

void withNothing(const Work& work);
/// The bundled character; its left arm is selected.
void withLimb(const Work& work);
/// And has an exaggerated trail; the playhead is in it.
void withTrail(const Work& work);
/// And has weight, in place of the trail.
void withWeight(const Work& work);
/// Two trails, made one after the other.
void withTwoTrails(const Work& work);
/// The bundled character with two trails that are one group, and a third of another time by itself.
void withGroup(const Work& work);
/// The boxer with a pin, a grip, a prop, weight, offsets and a trail.
void withEverything(const Work& work);
/// Both hands are selected and have a key where the playhead is.
void withControllers(const Work& work);
/// The graph of the left arm.
void withArmsGraph(const Work& work);
/// Every key of the selection is picked.
void pickAll(const Work& work);
/// A mesh sequence, and one that was compressed.
void withSequence(const Work& work);
void withCompression(const Work& work);

} // namespace stretch::test
