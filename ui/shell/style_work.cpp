#include "ui/shell/style_work.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/tables.h"
#include "app/edits/trail/style_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/clip_moments.h"
#include "app/evaluate/frame_count.h"
#include "app/files/user_files.h"
#include "app/files/user_styles.h"
#include "ui/panels/context/panel_support.h"
#include "ui/shell/file_work.h"
#include "ui/shell/shell_command.h"

namespace stretch::ui {

void loadStyles(TrailPanels& panels) {
  panels.styles = app::allStyles(app::stylesFolder());
}

namespace {

bool hasExaggerated(const Shell& shell) {
  return showsClip(shell) &&
         std::ranges::any_of(shell.open.character()->document().trails, [&](const rig::Trail& trail) {
           return trail.clip == shell.open.character()->view().clip && trail.exaggerated;
         });
}

/// The user's styles as they are now; the one of this name is chosen.
void refreshStyles(Shell& shell, const std::string& name) {
  TrailPanels& panels = shell.ui.trails;
  loadStyles(panels);
  const auto found = std::ranges::find(panels.styles, name, &rig::Style::name);
  const auto place = static_cast<int>(found - panels.styles.begin());
  const bool isThere = found != panels.styles.end();
  panels.clipStyle.style = isThere ? place : std::min(panels.clipStyle.style, ClipStyleState::usualStyle);
  panels.takenStyle = {};
  panels.clipStyle.changed = panels.clipStyle.open;
}

void keepStyle(Shell& shell, rig::Style style) {
  const std::vector<rig::Style> there = app::allStyles(app::stylesFolder());
  const std::string name = style.name;
  for (int number = 2; std::ranges::find(there, style.name, &rig::Style::name) != there.end(); ++number) {
    style.name = fmt::format("{} {}", name, number);
  }
  const Status saved = app::saveStyle(style, app::fileOfName(app::stylesFolder(), style.name));
  tellProblem(shell, saved);
  if (saved) {
    refreshStyles(shell, style.name);
    tell(shell, ToastKind::success, "The style " + style.name + " is one of yours now");
  }
}

Status takeStyle(Shell& shell) {
  const app::Session& session = *shell.open.character();
  const Result<rig::Style> style = app::styleOfClip(session.atBegin(), session.view().clip, {});
  if (style) {
    keepStyle(shell, *style);
  }
  return style ? Status(Success{}) : Status(style.error());
}

/// Whether both do the same, however they are shown.
bool moveAlike(const rig::Trail& a, const rig::Trail& b) {
  return a.limb == b.limb && a.clip == b.clip && a.settings == b.settings && a.exaggerated == b.exaggerated &&
         a.connected == b.connected;
}

/// Trails of the viewed clip that an earlier style made and whose motion nobody changed since: the new one
/// takes their place.
std::vector<int> trailsToReplace(const Shell& shell) {
  const std::vector<rig::Trail>& kept = shell.beside.styling.kept;
  std::vector<int> ids;
  for (const rig::Trail& trail : shell.open.character()->document().trails) {
    if (trail.clip == shell.open.character()->view().clip &&
        std::ranges::any_of(kept, [&](const rig::Trail& made) { return moveAlike(made, trail); })) {
      ids.push_back(trail.id);
    }
  }
  return ids;
}

app::Document without(app::Document document, const std::vector<int>& trailIds) {
  for (const int id : trailIds) {
    document = *app::deleteTrail(document, id);
  }
  return document;
}

Status beginClip(Shell& shell) {
  app::Session& session = *shell.open.character();
  if (Status bounded = app::checkFrameCount(clipOf(session.document(), session.view().clip)); !bounded) {
    return bounded;
  }
  ClipStyleState& state = shell.ui.trails.clipStyle;
  const std::vector<rig::Moment> moments = app::momentsOf(session.document(), session.view().clip);
  if (moments.empty()) {
    return Error{"nothing to exaggerate: no limb makes a stroke", "this clip", "view another clip"};
  }
  const std::string name = chosenStyle(shell).name; // A copy: the styles that it lies in are read anew.
  refreshStyles(shell, name);
  state.moments = moments;
  state.on.assign(moments.size(), true);
  state.made.clear();
  state.replaced = trailsToReplace(shell);
  state.changed = true;
  state.accepted = false;
  state.open = true;
  hideNews(shell.ui);
  return Success{};
}

std::vector<rig::Moment> momentsThatAre(const ClipStyleState& state, bool on) {
  std::vector<rig::Moment> moments;
  for (std::size_t i = 0; i < state.moments.size(); ++i) {
    if (state.on[i] == on) {
      moments.push_back(state.moments[i]);
    }
  }
  return moments;
}

void startWork(Shell& shell) {
  app::Session& session = *shell.open.character();
  ClipStyleState& state = shell.ui.trails.clipStyle;
  if (!shell.beside.styling.begun) {
    session.begin("Exaggerate the clip");
    shell.beside.styling.begun = true;
  }
  state.changed = false;
  const app::AutoSettings settings{chosenStyle(shell), state.strength, momentsThatAre(state, false)};
  shell.beside.styling.job = std::make_unique<app::Job<app::AutoClip>>(
      [document = without(session.atBegin(), state.replaced), clip = session.view().clip,
       moments = momentsThatAre(state, true), settings](const skinning::Proceed&) -> Result<app::AutoClip> {
        return app::exaggerateClip(document, clip, moments, settings);
      });
}

void takeWork(Shell& shell) {
  const Result<app::AutoClip> made = shell.beside.styling.job->take();
  shell.beside.styling.job.reset();
  ClipStyleState& state = shell.ui.trails.clipStyle;
  if (made && !state.changed && state.open) {
    state.made = made->moments;
    state.trails = made->trailIds;
    state.accepted = state.accepted && !state.trails.empty(); // there is nothing to keep
    shell.open.character()->preview(made->document);
  }
}

/// Keeps what is shown as one step, or drops it.
void endClip(Shell& shell, bool keeps) {
  app::Session& session = *shell.open.character();
  ClipStyleState& state = shell.ui.trails.clipStyle;
  if (shell.beside.styling.begun && keeps) {
    session.commit();
    shell.ui.trails.takenStyle = {session.document().scene, state.trails, state.style};
    for (const int id : state.trails) {
      shell.ui.trails.takenStyle.made.push_back(*app::findTrail(session.document(), id));
      shell.beside.styling.kept.push_back(shell.ui.trails.takenStyle.made.back());
    }
    const auto done = std::ranges::count_if(state.made, [](const auto& one) { return one.trailId > 0; });
    tell(shell, ToastKind::success,
         fmt::format("{} of {} moments exaggerated in the style {}", done, state.moments.size(),
                     chosenStyle(shell).name));
  } else if (shell.beside.styling.begun) {
    session.cancel();
  }
  shell.beside.styling.begun = false;
  state.open = false;
  state.accepted = false;
}

} // namespace

const rig::Style& chosenStyle(const Shell& shell) {
  const TrailPanels& panels = shell.ui.trails;
  const auto place = static_cast<std::size_t>(std::max(0, panels.clipStyle.style));
  return panels.styles[std::min(place, panels.styles.size() - 1)];
}

void closeClipStyle(Shell& shell) {
  endClip(shell, false);
}

void updateClipStyle(Shell& shell) {
  ClipStyleState& state = shell.ui.trails.clipStyle;
  StyleWork& work = shell.beside.styling;
  if (work.job != nullptr && work.job->isFinished()) {
    takeWork(shell);
  }
  state.working = work.job != nullptr;
  if (shell.open.character() == nullptr) {
    state.open = false;
    work.begun = false;
    return;
  }
  if (state.open && state.changed && work.job == nullptr) {
    startWork(shell);
    state.working = true;
  }
  if (!state.open && work.begun) {
    endClip(shell, false);
  } else if (state.accepted && !state.changed && !state.working) {
    endClip(shell, true);
  }
}

void importStyle(Shell& shell, const std::filesystem::path& path) {
  const Result<rig::Style> style = app::loadStyle(path);
  if (style) {
    keepStyle(shell, *style);
  } else {
    tell(shell, ToastKind::error, style.error().line());
  }
}

void exportStyle(Shell& shell, const std::filesystem::path& path) {
  const Status saved = app::saveStyle(chosenStyle(shell), path);
  tellProblem(shell, saved);
  if (saved) {
    tell(shell, ToastKind::success, "Exported the style " + chosenStyle(shell).name);
  }
}

std::vector<ShellCommand> styleCommands() {
  constexpr ShellNeed clipNeeded{showsClip, "open a character with a clip first"};
  const auto asking = [](FilePurpose purpose) {
    return app::doing([purpose](Shell& shell) { askForFile(shell, purpose); });
  };
  return {shellCommand(app::command::clipExaggerate, "Exaggerate the clip",
                       "Exaggerates every moment of the clip in a style: choose it, its strength and "
                       "the moments, and look at them before you keep them.",
                       {"Shift+E"}, clipNeeded, beginClip),
          shellCommand(app::command::styleTake, "Take a style from the clip",
                       "Makes the settings of the clip's trails a style of your own.", {},
                       {hasExaggerated, "exaggerate a limb of the clip first"}, takeStyle),
          shellCommand(app::command::styleImport, "Import a style",
                       "Takes a style from a file into your own.", {}, clipNeeded,
                       asking(FilePurpose::openStyle)),
          shellCommand(app::command::styleExport, "Export the style",
                       "Writes the style that was chosen last for a clip as a file.", {}, clipNeeded,
                       asking(FilePurpose::saveStyle))};
}

} // namespace stretch::ui
