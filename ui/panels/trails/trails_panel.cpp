#include <algorithm>
#include <cmath>
#include <optional>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/stopped.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/context/trail_colours.h"
#include "ui/panels/menus/context_menu.h"
#include "ui/panels/trails/trail_group_row.h"
#include "ui/panels/trails/trail_list_row.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

std::string stateText(const rig::Trail& trail) {
  if (trail.applied) {
    return "applied";
  }
  return trail.connected ? "connected" : trail.exaggerated ? "disconnected" : "path only";
}

/// Why the limb is as long at the tip as it was, where that is so: empty where the reason is not known.
std::optional<std::string> whyIdle(app::Session& session, const rig::SolvedTrail& solved) {
  constexpr double noticed = 0.005;
  const TipLengths lengths = tipLengths(session, solved);
  const bool isAsLong = std::abs(lengths.after - lengths.before) <= noticed * lengths.before;
  const rig::TrailSettings& settings = solved.trail.settings;
  if (!solved.active || !isAsLong || settings.scale == 1.0 || !settings.spheres.empty()) {
    return std::nullopt;
  }
  const bool isStopped = app::isStoppedAtTip(session.document(), session.motion(), solved);
  return solved.tip.outcome == rig::TipOutcome::nothingToScale             ? "it does not move along its axes"
         : isStopped && settings.stopAt && settings.stopAt->normal.y < 0.0 ? "the floor is in its way"
         : isStopped                                                       ? "a plane is in its way"
                     : app::keptFromLength(session.document(), session.motion(), solved);
}

/// The reasons of the trails that do nothing; during a drag those of before.
const std::map<int, std::string>& idleTrails(PanelContext& context) {
  app::Session& session = context.character();
  IdleTrails& idle = context.ui.trails.idle;
  if (idle.motion == session.sharedMotion() || session.isDragging()) {
    return idle.why;
  }
  idle = {session.sharedMotion(), {}};
  for (const rig::SolvedTrail& solved : session.motion().trails) {
    if (const std::optional<std::string> why = whyIdle(session, solved)) {
      idle.why[solved.trail.id] = *why;
    }
  }
  return idle.why;
}

std::string detailText(PanelContext& context, const rig::Trail& trail) {
  const rig::TrailSettings& s = trail.settings;
  const std::string range = shortNumber(s.startFrame, 1) + "\xE2\x80\x93" + shortNumber(s.endFrame, 1);
  const std::string scale = trail.exaggerated ? ", \xC3\x97" + shortNumber(s.scale) : std::string();
  const auto& idle = idleTrails(context);
  const auto found = idle.find(trail.id);
  return range + scale + ", " +
         (found == idle.end()     ? stateText(trail)
          : found->second.empty() ? "no longer than before"
                                  : "no longer: " + found->second);
}

/// The next thing to do with the selected trail: its button carries the accent.
const char* nextStep(const app::Session& session) {
  const rig::Trail* trail = app::selectedTrail(session);
  if (trail == nullptr || !trail->exaggerated) {
    return command::trailExaggerate;
  }
  if (!trail->connected) {
    return command::trailConnect;
  }
  return trail->applied ? "" : command::trailApply;
}

/// What the button of trails does now: makes one, or hides or shows what there is.
struct TrailButton {
  const char* icon = "";
  const char* text = "";
};

TrailButton trailButton(const PanelContext& context) {
  const CommandInfo* const toggle = findCommand(context, command::trailToggle);
  const std::string label = toggle == nullptr ? "" : toggle->label;
  return label.starts_with("Hide")   ? TrailButton{icon::hidden, "Hide"}
         : label.starts_with("Show") ? TrailButton{icon::visible, "Show"}
                                     : TrailButton{icon::plus, "Trail"};
}

void actions(PanelContext& context) {
  const std::string next = nextStep(context.character());
  const auto emphasis = [&](const char* id) { return next == id ? Emphasis::primary : Emphasis::normal; };
  const float width = columnWidth(2);
  const CommandInfo* const connect = findCommand(context, command::trailConnect);
  const bool connected = connect != nullptr && connect->label == "Disconnect";
  const TrailButton toggle = trailButton(context);
  commandButton(context,
                {.command = command::trailToggle, .icon = toggle.icon, .text = toggle.text, .width = width});
  ImGui::SameLine();
  commandButton(context, {.command = command::trailExaggerate,
                          .icon = icon::bolt,
                          .text = "Exaggerate",
                          .emphasis = emphasis(command::trailExaggerate),
                          .width = width});
  commandButton(context, {.command = command::trailConnect,
                          .icon = connected ? icon::unlink : icon::link,
                          .text = "",
                          .emphasis = emphasis(command::trailConnect),
                          .width = width});
  ImGui::SameLine();
  commandButton(context, {.command = command::trailApply,
                          .icon = icon::check,
                          .text = "Apply",
                          .emphasis = emphasis(command::trailApply),
                          .width = width});
}

void colourPopup(PanelContext& context, const rig::Trail& trail, const std::string& popup) {
  if (!ImGui::BeginPopup(popup.c_str())) {
    return;
  }
  if (trailColours(context, trail, "trails/colour-") || keyPressed(ImGuiKey_Escape)) {
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void colourSwatch(PanelContext& context, const rig::Trail& trail, float height) {
  const WidgetContext widgets = widgetsOf(context);
  const Theme& theme = context.theme;
  const std::string id = "trails/" + std::to_string(trail.id);
  const std::string popup = id + "/colours";
  const Control swatch = takePlace(widgets, id + "/colour", {theme.px(24.0F), height});
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float radius = theme.px(swatch.hovered ? 7.0F : 6.0F);
  if (trail.visible) {
    list->AddCircleFilled(swatch.box.centre(), radius, trailColour(trail.colour, theme.kind));
  } else {
    list->AddCircle(swatch.box.centre(), radius - theme.px(1.0F), trailColour(trail.colour, theme.kind), 0,
                    theme.px(1.5F));
  }
  tooltip(widgets, {.title = "Colour", .text = "Click to choose another one."});
  if (swatch.clicked) {
    ImGui::OpenPopup(popup.c_str());
  }
  colourPopup(context, trail, popup);
}

void trailText(PanelContext& context, const rig::Trail& trail) {
  const Theme& theme = context.theme;
  app::Session& session = context.character();
  const std::string title = trailHeading(session.document(), trail);
  const std::string limb = trail.name.empty() ? "" : limbHeading(session.document(), trail.limb) + ", ";
  const std::string detail = detailText(context, trail);
  const RowClicks mouse =
      rowText(context,
              {.id = "trails/" + std::to_string(trail.id),
               .title = title,
               .detail = detail,
               .colour = session.view().selection.trail() == trail.id ? theme.colours.accent
                         : trail.visible                              ? theme.colours.text
                                                                      : theme.colours.quietText,
               .help = {.title = title,
                        .text = limb + detail +
                                ". Click selects this trail, Ctrl+click adds it, a double click renames it, "
                                "a right click opens its menu."}},
              3);
  if (mouse.clicked) {
    const ImGuiIO& io = ImGui::GetIO();
    app::selectTrailInList(session, trail.id, io.KeyShift || io.KeyCtrl);
  }
  if (mouse.renames) {
    request(context, command::trailRename);
  }
  if (mouse.asksMenu) {
    if (app::isSelected(session, trail.limb)) {
      app::selectTrail(session, trail.id); // With what else is selected.
    } else {
      app::selectTrailInList(session, trail.id, false);
    }
    askForMenu(context.ui, MenuTarget::trail);
  }
}

void trailButtons(PanelContext& context, const rig::Trail& trail) {
  const std::string id = "trails/" + std::to_string(trail.id);
  const app::Document& document = context.character().document();
  if (rowButton(context, id + "/visible", trail.visible ? icon::visible : icon::hidden,
                trail.visible ? "o" : "-", false,
                {"Visible", "Shows or hides the trail in the viewport.", {}})) {
    editOnce(context, trail.visible ? "Hide the trail" : "Show the trail",
             app::setTrailDisplay(document, trail.id, {trail.colour, !trail.visible, trail.pinned}));
  }
  if (rowButton(context, id + "/pinned", icon::pin, "p", trail.pinned,
                {"Pinned", "A pinned trail is drawn even when its limb is not selected.", {}})) {
    editOnce(context, trail.pinned ? "Unpin the trail" : "Pin the trail",
             app::setTrailDisplay(document, trail.id, {trail.colour, trail.visible, !trail.pinned}));
  }
  if (rowButton(context, id + "/delete", icon::trash, "x", false,
                {"Delete this trail", "Gives its range back exactly as the source has it.",
                 keyOf(context, command::trailDelete)})) {
    editOnce(context, "Delete the trail", app::deleteTrail(document, trail.id));
  }
}

/// Whether the trail is the selected one or was added to it, in the list or with its limb.
bool isSelectedTrail(const app::Session& session, int trailId) {
  const std::vector<int> targets = app::targetTrails(session);
  return app::hasSelectedTrail(session) &&
         std::find(targets.begin(), targets.end(), trailId) != targets.end();
}

void trailRow(PanelContext& context, const rig::Trail& trail) {
  const Theme& theme = context.theme;
  const float height = rowLines(theme).whole;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  fillRow(context, isSelectedTrail(context.character(), trail.id));
  ImGui::BeginGroup();
  colourSwatch(context, trail, height);
  ImGui::SameLine(0.0F, theme.px(4.0F));
  trailText(context, trail);
  trailButtons(context, trail);
  ImGui::EndGroup();
  ImGui::SetCursorScreenPos({corner.x, corner.y + height});
}

/// A trail by itself, or with the whole group that it belongs to where that is not listed yet.
void listTrail(PanelContext& context, const std::vector<rig::Trail>& trails, const rig::Trail& trail,
               std::vector<int>& listed) {
  const std::vector<int> members = app::groupMembers(context.character().document(), trail.id);
  const auto isListed = [&](int id) { return std::find(listed.begin(), listed.end(), id) != listed.end(); };
  if (members.empty() || isListed(trail.id)) {
    if (!isListed(trail.id)) {
      trailRow(context, trail);
    }
    return;
  }
  const bool open = trailGroupRow(context, members);
  const float indent = context.theme.px(16.0F);
  ImGui::Indent(indent);
  for (const rig::Trail& member : trails) {
    if (open && std::find(members.begin(), members.end(), member.id) != members.end()) {
      trailRow(context, member);
    }
  }
  ImGui::Unindent(indent);
  listed.insert(listed.end(), members.begin(), members.end());
}

/// Copy, paste and mirror at the right end of the title's row.
void clipboardButtons(PanelContext& context) {
  const float side = context.theme.px(28.0F);
  const float gap = context.theme.px(2.0F);
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - side * 3.0F - gap * 2.0F);
  const auto add = [&](const char* id, const char* iconText, const char* fallback) {
    commandButton(context, {.command = id,
                            .icon = iconText,
                            .text = " ",
                            .emphasis = Emphasis::quiet,
                            .width = side,
                            .fallback = fallback});
  };
  add(command::copyTrail, icon::copy, "C");
  ImGui::SameLine(0.0F, gap);
  add(command::pasteTrail, icon::paste, "P");
  ImGui::SameLine(0.0F, gap);
  add(command::mirrorTrail, icon::mirror, "M");
}

} // namespace

void drawTrailsPanel(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  panelTitle(widgets, icon::bolt, "Trails", hasViewedClip(context) ? context.theme.px(96.0F) : 0.0F);
  if (!hasViewedClip(context)) {
    note(widgets, "Motion trails appear here once a character with a clip is open.");
    return;
  }
  clipboardButtons(context);
  actions(context);
  verticalSpace(widgets, 4.0F);
  const app::Session& session = context.character();
  const std::vector<rig::Trail> trails = session.document().trails; // a copy: rows may edit the document
  bool any = false;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  std::vector<int> listed;
  for (const rig::Trail& trail : trails) {
    if (trail.clip == session.view().clip) {
      listTrail(context, trails, trail, listed);
      any = true;
    }
  }
  ImGui::PopStyleVar();
  if (any) {
    return;
  }
  commandButton(context, {.command = command::clipExaggerate,
                          .icon = icon::magic,
                          .text = "Exaggerate the clip",
                          .emphasis = Emphasis::primary,
                          .width = ImGui::GetContentRegionAvail().x});
  const bool limbChosen = !session.view().selection.limbs().empty();
  const std::string key = keyOf(context, command::trailExaggerate);
  emptyState(widgets, icon::bolt, limbChosen ? "Ready to exaggerate" : "No trail yet",
             limbChosen
                 ? "Press " + (key.empty() ? std::string("Exaggerate") : key) +
                       " to make the limb's path bigger, or Trail to see the path first."
                 : "Exaggerate the clip does it for every moment. Or click a limb on the left and press " +
                       (key.empty() ? std::string("Exaggerate") : key) + ".");
}

} // namespace stretch::ui
