#include "ui/panels/context/panel_support.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <iterator>

#include <glm/geometric.hpp>
#include <imgui_internal.h>

#include "app/commands/table/selection.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/evaluate.h"
#include "rig/limb.h"
#include "ui/panels/context/key_bar.h"
#include "ui/panels/context/panels.h"

namespace stretch::ui {

namespace {

/// Ends a drag that a panel began when Esc or the end of its widget asks for it.
template <typename Document>
bool dragGoesOn(app::Editing<Document>& session) {
  if (!session.isDragging()) {
    return false;
  }
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    session.cancel();
    ImGui::ClearActiveID();
    return false;
  }
  if (ImGui::GetActiveID() == 0 && ImGui::GetCurrentContext()->ActiveIdPreviousFrame == 0) {
    session.commit(); // its widget was not drawn any more when the gesture ended
    return false;
  }
  return true;
}

template <typename Document, typename Change>
void carry(PanelContext& context, app::Editing<Document>& session, const EditPhase& phase,
           const std::string& label, const Change& change) {
  const bool foreignDrag = session.isDragging() && !context.ui.panelDrag;
  if (foreignDrag) {
    return;
  }
  if (phase.changed) {
    Result<Document> changed = change(session.atBegin());
    if (!changed) {
      tell(context.ui, ToastKind::warning, errorLine(context.open, changed.error()));
    } else {
      if (!session.isDragging()) {
        session.begin(label);
        context.ui.panelDrag = true;
      }
      session.preview(std::move(changed).value());
    }
  }
  if (phase.ended && context.ui.panelDrag) {
    session.commit();
    context.ui.panelDrag = false;
  }
}

} // namespace

const CommandInfo* findCommand(const PanelContext& context, std::string_view id) {
  const auto found = std::ranges::find_if(context.commands, [&](const CommandInfo& c) { return c.id == id; });
  return found == context.commands.end() ? nullptr : &*found;
}

void request(PanelContext& context, std::string_view commandId) {
  context.requestedCommands.emplace_back(commandId);
}

void beginPanels(PanelContext& context) {
  context.items.clear();
  if (context.open.character() != nullptr) {
    followPicks(context.ui.time, context.character());
  }
  if (!context.ui.panelDrag) {
    return;
  }
  context.ui.panelDrag = context.open.with(false, [](auto& session) { return dragGoesOn(session); });
}

void commandButton(PanelContext& context, const CommandButton& spec) {
  const CommandInfo* info = findCommand(context, spec.command);
  ButtonSpec drawn;
  drawn.id = spec.command;
  drawn.icon = spec.icon;
  drawn.fallback = spec.fallback;
  const std::string label = info != nullptr ? info->label : spec.text;
  drawn.text = std::string_view(spec.text) == " " ? "" : spec.text[0] != '\0' ? spec.text : label;
  const std::string why = info != nullptr && !info->enabled ? " Off: " + info->reason + "." : "";
  drawn.help = {label, info != nullptr ? info->help + why : "", keyOf(context, spec.command)};
  drawn.emphasis = spec.emphasis;
  drawn.on = info != nullptr && info->checked;
  drawn.enabled = info != nullptr && info->enabled;
  drawn.width = spec.width;
  if (drawn.emphasis == Emphasis::primary && !drawn.enabled) {
    drawn.emphasis = Emphasis::normal;
  }
  if (button(widgetsOf(context), drawn)) {
    request(context, spec.command);
  }
}

void iconButton(PanelContext& context, const char* command, const char* icon, const char* fallback) {
  commandButton(context, {.command = command,
                          .icon = icon,
                          .text = " ",
                          .emphasis = Emphasis::quiet,
                          .width = context.theme.px(30.0F),
                          .fallback = fallback});
  ImGui::SameLine(0.0F, context.theme.px(2.0F));
}

std::string keyOf(const PanelContext& context, std::string_view commandId) {
  const CommandInfo* info = findCommand(context, commandId);
  const std::string key = info != nullptr ? info->keyText : std::string();
  const app::Session* const character = context.open.character();
  // The key of Delete deletes the trail as long as no sphere is selected.
  const bool isDelete = key.empty() && commandId == command::trailDelete && character != nullptr &&
                        character->view().selection.spheres().empty();
  return isDelete ? keyOf(context, command::editDelete) : key;
}

void editThrough(PanelContext& context, const EditPhase& phase, const std::string& label,
                 const DocumentChange& change) {
  carry(context, context.character(), phase, label, change);
}

void editSequence(PanelContext& context, const EditPhase& phase, const std::string& label,
                  const SequenceChange& change) {
  carry(context, context.sequence(), phase, label,
        [&](const app::SequenceDocument& start) -> Result<app::SequenceDocument> {
          app::SequenceDocument changed = start;
          change(changed);
          return changed;
        });
}

void editOnce(PanelContext& context, const std::string& label, const Result<app::Document>& changed) {
  if (!changed) {
    tell(context.ui, ToastKind::warning, errorLine(context.open, changed.error()));
    return;
  }
  if (context.character().isDragging()) {
    tell(context.ui, ToastKind::info, "Finish what is being dragged first: Enter keeps it, Esc restores.");
    return;
  }
  context.character().edit(*changed, label);
}

namespace {

void editSettingsOf(PanelContext& context, const std::vector<int>& targets, const EditPhase& phase,
                    const std::string& label, const SettingsChange& change) {
  editThrough(context, phase, label, [&](const app::Document& start) -> Result<app::Document> {
    app::Document document = start;
    for (const int id : targets) {
      const rig::Trail* trail = app::findTrail(start, id);
      if (trail == nullptr) {
        continue;
      }
      rig::TrailSettings settings = trail->settings;
      change(settings);
      Result<app::Document> changed = app::setTrailSettings(document, id, settings);
      if (!changed) {
        return changed;
      }
      document = std::move(changed).value();
    }
    return document;
  });
}

} // namespace

void editSettings(PanelContext& context, const EditPhase& phase, const std::string& label,
                  const SettingsChange& change) {
  editSettingsOf(context, app::targetTrails(context.character()), phase, label, change);
}

void editRange(PanelContext& context, const EditPhase& phase, const SettingsChange& change) {
  editSettingsOf(context, app::targetsOfRange(context.character()), phase, "Change the range", change);
}

std::string capitalised(std::string text) {
  if (!text.empty()) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }
  return text;
}

std::string limbHeading(const app::Document& document, const std::string& limbId) {
  const rig::Limb* limb = app::findLimb(document, limbId);
  const bool chain = limb != nullptr && limb->kind == rig::LimbKind::chain;
  return chain ? limbId : capitalised(app::limbTitle(document, limbId));
}

std::string trailHeading(const app::Document& document, const rig::Trail& trail) {
  return trail.name.empty() ? limbHeading(document, trail.limb) : trail.name;
}

std::string nodeName(const Scene& scene, NodeIndex node) {
  if (!node.exists() || at(node) >= scene.nodes.size()) {
    return "(estimated)";
  }
  const std::string& name = scene.nodes[at(node)].name;
  if (!name.empty()) {
    return name;
  }
  std::string number = "#";
  number += std::to_string(node.value);
  return number;
}

bool hasCharacter(const PanelContext& context) {
  return context.open.character() != nullptr && context.character().document().scene != nullptr;
}

bool hasViewedClip(const PanelContext& context) {
  if (!hasCharacter(context) || !context.character().document().clips) {
    return false;
  }
  const int clip = context.character().view().clip;
  return clip >= 0 && clip < static_cast<int>(context.character().document().clips->size());
}

std::string shortNumber(double value, int decimals) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string result = text;
  if (result.find('.') != std::string::npos) {
    result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.') {
      result.pop_back();
    }
  }
  return result == "-0" ? "0" : result;
}

int frameDecimals(double frame) {
  return std::abs(frame - std::round(frame)) < 5e-3 ? 0 : 2;
}

TipLengths tipLengths(app::Session& session, const rig::SolvedTrail& solved) {
  TipLengths lengths;
  if (solved.path.samples.empty()) {
    return lengths;
  }
  const bool tipIsEnd = solved.settings.pivot == rig::Pivot::start;
  const rig::LimbSample& tip = tipIsEnd ? solved.path.samples.back() : solved.path.samples.front();
  lengths.before = glm::length(tip.end - tip.base);
  lengths.after = solved.tip.reachedLength;
  if (solved.active) {
    const FrameState frame = app::evaluate(session.document(), session.motion(), solved.tipSeconds);
    const std::vector<Vec3> points = rig::limbPoints(solved.limb, frame);
    lengths.after = points.size() < 2 ? lengths.after : glm::length(points.back() - points.front());
  } else if (!solved.trail.exaggerated) {
    lengths.after = lengths.before;
  }
  return lengths;
}

std::string lengthsText(const TipLengths& lengths) {
  char text[96];
  const double ratio = lengths.before > 0.0 ? lengths.after / lengths.before : 1.0;
  const int decimals = lengths.before >= 10.0 ? 1 : lengths.before >= 0.1 ? 2 : 4;
  std::snprintf(text, sizeof text, "%.*f \xE2\x86\x92 %.*f  (\xC3\x97%.2f)", decimals, lengths.before,
                decimals, lengths.after, ratio);
  return text;
}

namespace {

/// A line that begins with the path of a file, with the file's name alone.
std::string withoutFolders(const std::string& text) {
  const std::size_t end = std::min(text.find(": "), text.size());
  const std::size_t slash = text.rfind('/', end);
  return text.starts_with('/') && slash + 1 < end ? text.substr(slash + 1) : text;
}

} // namespace

void tell(UiState& ui, ToastKind kind, const std::string& text) {
  const float seconds = kind == ToastKind::error ? 8.0F : 5.0F;
  const std::string shown = withoutFolders(text);
  const auto same = std::ranges::find(ui.toasts, shown, &Toast::text);
  if (same != ui.toasts.end()) {
    same->secondsLeft = seconds;
    return;
  }
  ui.toasts.push_back({kind, shown, seconds});
  // They stand over the picture: of many the oldest that only inform make room.
  constexpr std::size_t atOnce = 3;
  const auto oldest = std::ranges::find(ui.toasts, ToastKind::info, &Toast::kind);
  if (ui.toasts.size() > atOnce && std::distance(oldest, ui.toasts.end()) > 1) {
    ui.toasts.erase(oldest);
  }
}

void hideNews(UiState& ui) {
  std::erase_if(ui.toasts, [](const Toast& toast) {
    return toast.kind == ToastKind::info || toast.kind == ToastKind::success;
  });
}

std::string errorLine(const app::OpenDocument& open, Error error) {
  const app::Session* const session = open.character();
  if (session != nullptr && app::findLimb(session->document(), error.where) != nullptr) {
    error.where = limbHeading(session->document(), error.where);
  } else if (session != nullptr) {
    const std::string title = app::controllerTitle(session->document(), error.where);
    error.where = title == error.where ? error.where : capitalised(title);
  }
  return error.line();
}

void tellProblem(UiState& ui, const app::OpenDocument& open, const Status& status) {
  if (!status) {
    tell(ui, ToastKind::error, errorLine(open, status.error()));
  }
}

void tellProblem(PanelContext& context, const Status& status) {
  tellProblem(context.ui, context.open, status);
}

} // namespace stretch::ui
