#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/schema/import_settings.h"
#include "app/schema/saved_form.h"
#include "rig/rekey/key_places.h"
#include "ui/panels/state/answers.h"
#include "ui/panels/state/body_state.h"
#include "ui/panels/state/dialog_state.h"
#include "ui/panels/state/editor_status.h"
#include "ui/panels/state/menu_state.h"
#include "ui/panels/state/overlays.h"
#include "ui/panels/state/time_state.h"
#include "ui/panels/state/trails_state.h"
#include "ui/widgets/theme.h"

namespace stretch::ui {

/// Entries that the editor offers while nothing is open.
struct WelcomeState {
  int highlighted = 0;  ///< Entry that the keys are on.
  int columns = 1;      ///< Columns of the entries that have pictures, as they were drawn last.
  bool entered = false; ///< The highlighted entry is to be opened.
  bool moved = false;   ///< The highlight has not been scrolled to yet.
};

/// The tour through the first punch.
struct TourState {
  bool pending = false; ///< It begins when the bundled punch is opened.
  int step = -1;        ///< -1: it does not run.
};

/// View state of all panels: no widget keeps anything anywhere else. Not part of the document, not undone.
struct UiState {
  ThemeKind theme = ThemeKind::dark;
  float scale = 1.0F; ///< The user's factor on top of the screen's.
  NavigationStyle navigation = NavigationStyle::maya;
  bool exaggerateAtTip = false; ///< E moves the playhead to the tip; else a ghost shows the pose there.
  ViewportOverlays overlays;
  TimePanes time;
  TrailPanels trails;
  BodyPanels body;
  MenuState menu;
  DialogStates dialogs;
  WelcomeState welcome;
  TourState tour;
  std::vector<std::filesystem::path> recentFiles;
  std::vector<Toast> toasts;
  std::map<std::string, std::string> typedTexts; ///< Text of settings that are typed, for each field.
  std::vector<std::string> closedSections;       ///< Ids of collapsed sections of panels.
  app::SavedForm savedForm{.keys = rig::KeyPlaces::asClip}; ///< How stretches are told in files.
  app::ImportSettings imports;                              ///< How clips of other files come in.
  UiAnswers answers;
  bool panelDrag = false; ///< The session's drag was begun by a panel.
};

} // namespace stretch::ui
