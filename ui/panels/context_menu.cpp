#include "ui/panels/context_menu.h"

#include <initializer_list>
#include <utility>

#include "app/commands/selection.h"
#include "ui/panels/dialog_frame.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/trail_colours.h"

namespace stretch::ui {

namespace {

using CommandIds = std::initializer_list<const char*>;

CommandIds entriesOf(MenuTarget target) {
  using namespace command;
  static constexpr CommandIds limb{trailExaggerate, trailToggle,        weightToggle, "",
                                   copyTrail,       pasteTrail,         mirrorTrail,  "",
                                   trailDeleteAll,  viewFrameSelection, selectNone};
  static constexpr CommandIds trail{trailExaggerate,
                                    trailConnect,
                                    trailApply,
                                    trailFollow,
                                    trailBlend,
                                    "",
                                    trailRename,
                                    trailNextColour,
                                    "",
                                    trailSelectGroup,
                                    trailGroup,
                                    trailTakeApart,
                                    "",
                                    copyTrail,
                                    mirrorTrail,
                                    viewFrameSelection,
                                    "",
                                    trailDelete};
  static constexpr CommandIds sphere{
      sphereGrab, sphereAlongBack, sphereAlongForward, "", spherePrevious, sphereNext, sphereAll,
      "",         sphereSmooth,    sphereReset,        "", editDelete};
  static constexpr CommandIds key{rangeStart,  rangeEnd, rangeDefault,    "",         timePreviousKey,
                                  timeNextKey, "",       trailExaggerate, trailToggle};
  static constexpr CommandIds time{timePlay,   timeStart,    timeEnd, "",         rangeStart,
                                   rangeEnd,   rangeDefault, "",      clipRate24, clipRate25,
                                   clipRate30, clipRateOwn,  "",      clipLoop};
  static constexpr CommandIds viewport{viewFrameAll,  viewFrameSelection, "",       viewFront,      viewSide,
                                       viewTop,       viewPerspective,    "",       viewSkeleton,   viewWire,
                                       viewHeatMap,   viewGhosts,         viewGrid, viewSideBySide, "",
                                       viewNavigation};
  switch (target) {
  case MenuTarget::limb:
    return limb;
  case MenuTarget::trail:
    return trail;
  case MenuTarget::sphere:
    return sphere;
  case MenuTarget::key:
    return key;
  case MenuTarget::time:
    return time;
  case MenuTarget::viewport:
  case MenuTarget::nothing:
    break;
  }
  return viewport;
}

std::string spheresText(const app::ViewState& view) {
  return view.selectedSpheres.size() == 1 ? "Sphere at frame " + shortNumber(view.selectedSpheres.front(), 1)
                                          : std::to_string(view.selectedSpheres.size()) + " spheres";
}

/// What the menu is about.
std::string titleOf(const PanelContext& context, MenuTarget target) {
  const app::Session& session = context.character();
  const app::ViewState& view = session.view();
  const rig::Trail* const trail = app::selectedTrail(session);
  switch (target) {
  case MenuTarget::limb:
    return view.selectedLimbs.empty() ? "Limb" : limbHeading(session.document(), view.selectedLimbs.back());
  case MenuTarget::trail:
    return trail == nullptr ? "Trail" : trailHeading(session.document(), *trail);
  case MenuTarget::sphere:
    return spheresText(view);
  case MenuTarget::key:
    return "Key at frame " + shortNumber(view.frame, 1);
  case MenuTarget::time:
    return "Frame " + shortNumber(view.frame, 1);
  case MenuTarget::viewport:
  case MenuTarget::nothing:
    break;
  }
  return "View";
}

void swatches(PanelContext& context) {
  const rig::Trail* const trail = app::selectedTrail(context.character());
  if (trail != nullptr && trailColours(context, *trail, "context/colour-")) {
    ImGui::CloseCurrentPopup();
  }
}

} // namespace

void commandEntry(PanelContext& context, const std::string& prefix, const char* commandId) {
  const CommandInfo* info = findCommand(context, commandId);
  if (info == nullptr) {
    return;
  }
  if (ImGui::MenuItem(info->label.c_str(), info->keyText.empty() ? nullptr : info->keyText.c_str(),
                      info->checked, info->enabled)) {
    request(context, commandId);
  }
  context.items.add(prefix + commandId, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), info->enabled);
  tooltip(widgetsOf(context), {info->label, info->help, info->keyText});
}

void askForMenu(UiState& ui, MenuTarget target) {
  ui.menuAsked = target;
}

void drawContextMenu(PanelContext& context) {
  constexpr const char* name = "context-menu";
  UiState& ui = context.ui;
  if (const MenuTarget asked = std::exchange(ui.menuAsked, MenuTarget::nothing);
      asked != MenuTarget::nothing) {
    ui.menuTarget = asked;
    ImGui::OpenPopup(name);
  }
  const Theme& theme = context.theme;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.unit(), theme.unit()));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(16.0F), theme.px(6.0F)));
  if (ImGui::BeginPopup(name)) {
    if (context.open.character() == nullptr || keyPressed(ImGuiKey_Escape)) {
      ImGui::CloseCurrentPopup();
    } else {
      const std::string title = titleOf(context, ui.menuTarget);
      ImGui::PushFont(theme.fonts.label);
      ImGui::TextDisabled("%s", title.c_str());
      ImGui::PopFont();
      for (const char* id : entriesOf(ui.menuTarget)) {
        if (id[0] == '\0') {
          ImGui::Separator();
        } else {
          commandEntry(context, "context/", id);
        }
        if (std::string_view(id) == command::trailNextColour) {
          swatches(context);
        }
      }
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

} // namespace stretch::ui
