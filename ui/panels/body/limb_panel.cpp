#include <algorithm>
#include <optional>

#include "app/commands/body/selection_sets.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/moments.h"
#include "app/commands/table/selection.h"
#include "app/document.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/pose_edits.h"
#include "app/edits/pose/selection_set_edits.h"
#include "rig/body/reading/planned_body.h"
#include "ui/panels/body/controller_panel.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/menus/context_menu.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/limb_diagram.h"

namespace stretch::ui {

namespace {

constexpr double doubtful = 0.6; ///< Confidence below this is shown as a question.

/// The trail that the limb shows: the selected one, else its first in the viewed clip.
const rig::Trail* trailOf(const app::Session& session, const std::string& limbId) {
  const rig::Trail* shown = nullptr;
  for (const rig::Trail& trail : session.document().trails) {
    if (trail.limb == limbId && trail.clip == session.view().clip &&
        (shown == nullptr || trail.id == session.view().selection.trail())) {
      shown = &trail;
    }
  }
  return shown;
}

ImVec2 pointOf(const rig::FigurePoint& point) {
  return {point.x, point.y};
}

std::vector<DiagramBone> bonesOf(const rig::PlannedLimb& limb) {
  std::vector<DiagramBone> bones;
  for (const rig::FigureBone& bone : limb.bones) {
    bones.push_back({{bone.fromX, bone.fromY}, bone.fromRadius, {bone.toX, bone.toY}, bone.toRadius});
  }
  return bones;
}

DiagramPart partOf(const PanelContext& context, const rig::PlannedLimb& planned, std::size_t slot) {
  const app::Session& session = context.character();
  DiagramPart state{
      .id = planned.id, .bones = bonesOf(planned), .end = pointOf(planned.end), .key = pointOf(planned.key)};
  const rig::Limb* limb = app::findLimb(session.document(), state.id);
  state.keyText = slot < command::limbSlots.size() ? keyOf(context, command::limbSlots[slot]) : "";
  state.help.title = capitalised(app::limbTitle(session.document(), state.id));
  state.help.keyText = state.keyText;
  state.found = limb != nullptr;
  if (limb == nullptr) {
    state.help.text = "Not found in this character. Choose its joints in the rig panel.";
    return state;
  }
  state.selected = app::isSelected(session, state.id);
  state.lowConfidence = limb->confidence < doubtful;
  if (const rig::Trail* trail = trailOf(session, state.id)) {
    state.trail = trailColour(trail->colour, context.theme.kind);
  }
  const app::WeightedLimb* const weight = app::findWeight(session.document(), state.id, session.view().clip);
  state.hasWeight = weight != nullptr && weight->on;
  state.help.text = "Click selects it, Shift+click adds it, a right click opens its menu.";
  if (state.hasWeight) {
    state.help.text += " It has weight.";
  }
  if (state.lowConfidence) {
    state.help.text += " Its joints are a guess (" + shortNumber(limb->confidence * 100.0, 0) +
                       " %): check them in the rig panel.";
  }
  return state;
}

/// How strong a limb's strongest moment is, of the clip's strongest.
void markMoments(const app::Session& session, std::vector<DiagramPart>& parts) {
  const std::vector<rig::Moment> shown = app::shownMoments(session);
  const rig::Moment* const strongest = rig::strongestMoment(shown);
  for (DiagramPart& part : parts) {
    for (const rig::Moment& moment : shown) {
      const auto share = static_cast<float>(moment.strength / strongest->strength);
      part.moment = moment.limb == part.id ? std::max(part.moment, share) : part.moment;
    }
    part.help.text += part.moment > 0.0F ? " A ring: it makes a stroke in this clip." : "";
  }
}

/// Those that the plan shows, in the order of their keys.
std::vector<DiagramPart> diagramParts(const PanelContext& context) {
  const app::Document& document = context.character().document();
  const rig::BodyPlan& plan = planOf(document.body);
  std::vector<DiagramPart> parts;
  const std::vector<std::string> ids = app::limbsByKey(document);
  for (std::size_t slot = 0; slot < ids.size(); ++slot) {
    if (const rig::PlannedLimb* const planned = plannedLimb(plan, ids[slot])) {
      parts.push_back(partOf(context, *planned, slot));
    }
  }
  markMoments(context.character(), parts);
  return parts;
}

/// Half-way along the bones of a limb.
ImVec2 middleOf(const rig::PlannedLimb& limb) {
  const std::vector<rig::FigureBone>& bones = limb.bones;
  if (bones.size() > 1) {
    return {bones[bones.size() / 2].fromX, bones[bones.size() / 2].fromY};
  }
  const rig::FigureBone& bone = bones.front();
  return {0.5F * (bone.fromX + bone.toX), 0.5F * (bone.fromY + bone.toY)};
}

/// Where a controller stands on the figure: as the plan says, else at the joint of its limb's bones that it
/// is for; nothing for one that the figure has no place for.
std::optional<ImVec2> placeOfController(const rig::BodyPlan& plan, const rig::Controller& controller) {
  const auto said = std::ranges::find(plan.controllers, controller.id, &rig::PlannedController::id);
  if (said != plan.controllers.end()) {
    return pointOf(said->place);
  }
  const rig::PlannedLimb* const limb = plannedLimb(plan, controller.limb);
  if (limb == nullptr) {
    return std::nullopt;
  }
  const rig::FigureBone& first = limb->bones.front();
  const rig::FigureBone& last = limb->bones.back();
  switch (controller.kind) {
  case rig::ControllerKind::spineLow:
    return ImVec2(last.toX, last.toY);
  case rig::ControllerKind::spineMiddle:
    return middleOf(*limb);
  case rig::ControllerKind::pole:
    return ImVec2(first.toX, first.toY);
  case rig::ControllerKind::spineTop:
    return ImVec2(first.fromX, first.fromY);
  default:
    return pointOf(limb->end);
  }
}

std::vector<DiagramController> diagramControllers(const PanelContext& context) {
  const app::Session& session = context.character();
  const app::Document& document = session.document();
  std::vector<DiagramController> controllers;
  if (!hasViewedClip(context)) {
    return controllers;
  }
  const rig::ControllerList list = app::controllersOf(document);
  for (const rig::Controller& controller : list.controllers) {
    const std::optional<ImVec2> place = placeOfController(planOf(document.body), controller);
    if (!place) {
      continue;
    }
    std::vector<std::string> ids{controller.id}; // With what it holds: a fist is a key of the hand.
    for (const rig::Attribute& attribute : app::attributesHeldBy(list, controller)) {
      ids.push_back(attribute.id);
    }
    const bool selected = app::isControllerSelected(session, controller.id);
    controllers.push_back(
        {controller.id,
         *place,
         selected,
         keyMarkOf(session, ids),
         {capitalised(app::controllerTitle(document, controller.id)),
          "A controller: click selects it, Shift+click adds it, a right click opens its menu.",
          {}}});
  }
  return controllers;
}

/// Controllers on single joints, which the figure has no place for.
void jointList(PanelContext& context) {
  app::Session& session = context.character();
  const std::vector<rig::Controller> joints = app::jointControllersOf(session.document());
  if (joints.empty() || !hasViewedClip(context)) {
    return;
  }
  std::vector<Choice> choices;
  int selected = -1;
  for (const rig::Controller& joint : joints) {
    const bool keyed = keyMarkOf(session, {&joint.id, 1}) != KeyMark::none;
    selected = app::isControllerSelected(session, joint.id) ? static_cast<int>(choices.size()) : selected;
    choices.push_back({.text = joint.id, .help = {joint.id, "Turns this joint.", {}}, .marked = keyed});
  }
  const Help help{
      "Other joints", "Fingers, clavicles, toes, a tail: each turns by itself. A dot: it is keyed.", {}};
  const int chosen = dropdown(widgetsOf(context), "controller/joint", choices, selected, help, 0.0F,
                              "Other joints", &context.ui.body.jointFilter);
  if (chosen >= 0) {
    app::selectController(session, joints[static_cast<std::size_t>(chosen)].id, ImGui::GetIO().KeyShift);
  }
}

/// Selection sets, and what keeps or forgets one.
void selectionSetRow(PanelContext& context) {
  app::Session& session = context.character();
  const std::vector<app::SelectionSet>& sets = session.document().selectionSets;
  const app::SelectionSet* const selected = app::setOfSelection(session.document(), session.view().selection);
  std::vector<Choice> choices;
  for (const app::SelectionSet& set : sets) {
    const bool isAny = !app::presentIn(session.document(), set).empty();
    choices.push_back(
        {.text = set.name,
         .help = {set.name, isAny ? "Selects it; Shift adds it." : "This character has nothing of it.", {}},
         .enabled = isAny});
  }
  const float buttons = 2.0F * context.theme.px(34.0F); // icon buttons, with their gaps
  const Help help{"Selection sets", "Limbs or controllers that are selected together.", {}};
  const int chosen =
      dropdown(widgetsOf(context), "limb/selection-set", choices,
               selected == nullptr ? -1 : static_cast<int>(selected - sets.data()), help,
               ImGui::GetContentRegionAvail().x - buttons, sets.empty() ? "No set yet" : "Sets");
  if (chosen >= 0) {
    app::selectSet(session, sets[static_cast<std::size_t>(chosen)], ImGui::GetIO().KeyShift);
  }
  ImGui::SameLine(0.0F, context.theme.px(4.0F));
  iconButton(context, command::selectionKeep, icon::plus, "+");
  iconButton(context, command::selectionForget, icon::trash, "-");
  ImGui::NewLine();
}

/// A limb of several that are selected keeps them, so that the menu acts on all.
void selectForMenu(PanelContext& context, const std::string& limbId) {
  if (!app::isSelected(context.character(), limbId)) {
    app::selectLimb(context.character(), limbId, false);
  }
  askForMenu(context.ui, MenuTarget::limb);
}

void chainChips(PanelContext& context) {
  app::Session& session = context.character();
  const WidgetContext widgets = widgetsOf(context);
  for (const rig::Limb& chain : app::allLimbs(session.document())) {
    if (chain.kind != rig::LimbKind::chain) {
      continue;
    }
    ButtonSpec chip;
    chip.id = "limb/" + chain.id;
    chip.icon = icon::link;
    chip.text = chain.id;
    chip.on = app::isSelected(session, chain.id);
    chip.width = ImGui::GetContentRegionAvail().x;
    chip.help = {chain.id, "A chain of joints. Click selects it, Shift+click adds it.", {}};
    if (button(widgets, chip)) {
      app::selectLimb(session, chain.id, ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right)) {
      selectForMenu(context, chain.id);
    }
  }
}

std::string limbSelectionText(const app::Session& session) {
  const std::vector<std::string>& limbs = session.view().selection.limbs();
  const std::vector<std::string>& controllers = session.view().selection.controllers();
  if (!controllers.empty()) {
    return capitalised(controllers.size() == 1 ? app::controllerTitle(session.document(), controllers.front())
                                               : std::to_string(controllers.size()) + " controllers");
  }
  if (limbs.empty()) {
    return "Click a limb or a controller.";
  }
  std::string text;
  for (const std::string& limb : limbs) {
    text += (text.empty() ? "" : ", ") + app::limbTitle(session.document(), limb);
  }
  return capitalised(text);
}

void menuOfDiagram(PanelContext& context, const DiagramClick& under, const std::vector<DiagramPart>& parts) {
  if (!ImGui::IsItemHovered() || !ImGui::IsMouseReleased(ImGuiMouseButton_Right)) {
    return;
  }
  app::Session& session = context.character();
  if (!under.hoveredController.empty()) {
    if (!app::isControllerSelected(session, under.hoveredController)) {
      app::selectController(session, under.hoveredController, false);
    }
    askForMenu(context.ui, MenuTarget::controller);
  } else if (under.hovered && parts[*under.hovered].found) {
    selectForMenu(context, parts[*under.hovered].id);
  }
}

/// The body as its plan draws it; nothing for one without.
void diagram(PanelContext& context) {
  app::Session& session = context.character();
  const rig::BodyPlan& plan = planOf(session.document().body);
  if (plan.limbs.empty()) {
    return;
  }
  const DiagramFigure figure{diagramParts(context), diagramControllers(context),
                             plan.view == rig::FigureView::front};
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = std::min(width * 1.22F, context.theme.px(248.0F));
  const DiagramClick clicked = limbDiagram(widgetsOf(context), "limb", figure, height);
  if (clicked.hovered && figure.parts[*clicked.hovered].moment > 0.0F) {
    const std::vector<rig::Moment> own = session.momentsOf(figure.parts[*clicked.hovered].id);
    context.ui.time.hoveredMoment = *rig::strongestMoment(own);
  }
  const bool add = ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl;
  if (!clicked.controller.empty()) {
    app::selectController(session, clicked.controller, add);
  } else if (clicked.part && figure.parts[*clicked.part].found) {
    app::selectLimb(session, figure.parts[*clicked.part].id, add);
  } else if (clicked.part) {
    context.ui.body.jointPick = {};
    context.ui.body.jointPick.open = true;
    context.ui.body.jointPick.limbId = figure.parts[*clicked.part].id;
  }
  menuOfDiagram(context, clicked, figure.parts);
}

} // namespace

void drawLimbPanel(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  panelTitle(widgets, icon::person, "Limbs");
  if (!hasCharacter(context)) {
    note(widgets, "The character's limbs appear here.");
    return;
  }
  const app::Session& session = context.character();
  diagram(context);
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy({width, context.theme.px(20.0F)});
  drawText(widgets, context.theme.fonts.label,
           {corner, {corner.x + width, corner.y + context.theme.px(20.0F)}},
           session.view().selection.limbs().empty() && !app::hasControllers(session)
               ? context.theme.colours.quietText
               : context.theme.colours.text,
           limbSelectionText(session), 0.5F);
  chainChips(context);
  jointList(context);
  selectionSetRow(context);
}

} // namespace stretch::ui
