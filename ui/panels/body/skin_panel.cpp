#include <algorithm>
#include <cmath>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/locators/build_rig.h"
#include "app/locators/fit_locators.h"
#include "app/locators/locator_edits.h"
#include "rig/plan/body_plan.h"
#include "ui/panels/body/weight_view.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/widgets/button.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

void locatorNews(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const std::vector<std::string> unsure = app::unsureLocators(context.character().document().locators);
  if (unsure.empty()) {
    note(widgets, "Click a locator and drag it, or press G or R.");
    return;
  }
  std::string names;
  for (const std::string& name : unsure) {
    names += (names.empty() ? "" : ", ") + name;
  }
  notice(widgets, NoticeKind::warning, "Guessed, and drawn dashed; move them: " + names);
}

/// What is done with the locators once they stand right.
void useLocators(PanelContext& context) {
  const app::Document& document = context.character().document();
  const float width = columnWidth(2);
  if (app::isRigBuilt(document)) {
    commandButton(
        context,
        {.command = command::bindMesh, .icon = icon::link, .emphasis = Emphasis::primary, .width = width});
    ImGui::SameLine();
    commandButton(context,
                  {.command = command::rigBack, .icon = icon::hidden, .text = "Hide", .width = width});
    return;
  }
  if (document.body.isBiped) {
    commandButton(context, {.command = command::rigBuild,
                            .icon = icon::cube,
                            .emphasis = Emphasis::primary,
                            .width = ImGui::GetContentRegionAvail().x});
    return;
  }
  commandButton(
      context,
      {.command = command::bindMesh, .icon = icon::link, .emphasis = Emphasis::primary, .width = width});
  ImGui::SameLine();
  commandButton(context, {.command = command::rigBuild, .icon = icon::cube, .width = width});
}

void moveTools(PanelContext& context) {
  constexpr float resetShare = 0.42F; // the switch beside it is wider
  commandButton(context, {.command = command::locatorsReset,
                          .icon = icon::refresh,
                          .text = "Reset",
                          .width = resetShare * ImGui::GetContentRegionAvail().x});
  ImGui::SameLine();
  app::ViewState& view = context.character().view();
  if (toggle(widgetsOf(context), "locators/mirror", "Mirror", view.mirrorLocators,
             {"Mirror locators", "What moves a locator moves its counterpart on the other side.", {}})) {
    view.mirrorLocators = !view.mirrorLocators;
  }
  commandButton(context, {.command = command::locatorsSnap,
                          .icon = icon::target,
                          .text = "To the middle",
                          .width = ImGui::GetContentRegionAvail().x});
}

/// From the first one, the hips, to the head: what steps and decimals are measured by.
double lengthOf(const rig::Locators& locators) {
  const rig::Locator* const head = rig::findLocator(locators, "head");
  const double length = head == nullptr ? 1.0 : glm::distance(locators.list.front().position, head->position);
  return length > 0.0 ? length : 1.0;
}

/// Where the selected locator stands, to be typed or dragged.
void placeRow(PanelContext& context) {
  const app::Session& session = context.character();
  const rig::Locators& locators = session.document().locators;
  const std::string name = session.view().selection.locators().empty()
                               ? std::string()
                               : session.view().selection.locators().back();
  const rig::Locator* const locator = rig::findLocator(locators, name);
  if (locator == nullptr) {
    return;
  }
  const Vec3 placeScene = locator->position; // an edit below takes the document away that the locator is in
  constexpr int digits = 3;
  const double length = lengthOf(locators);
  const int places = digits - static_cast<int>(std::floor(std::log10(length)));
  const Help help{name, "Where it stands, in units of the scene.", {}};
  note(widgetsOf(context), name);
  const float width = columnWidth(3);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) {
      ImGui::SameLine();
    }
    const std::string letter(1, "XYZ"[axis]);
    double value = placeScene[axis];
    const double step = std::pow(10.0, -places);
    const SliderSpec spec{.id = "locators/" + letter,
                          .minimum = value - 2.0 * length,
                          .maximum = value + 2.0 * length,
                          .step = step,
                          .decimals = std::clamp(places, 0, 9),
                          .hardMinimum = -1e9,
                          .hardMaximum = 1e9,
                          .showsFill = false,
                          .width = width,
                          .help = dragHelp({letter, help.text, {}})};
    const EditPhase phase = slider(widgetsOf(context), spec, value);
    if (phase.changed || phase.ended) {
      const bool mirror = session.view().mirrorLocators;
      editThrough(context, phase, "Move " + name, [&](const app::Document& start) -> Result<app::Document> {
        Vec3 change(0.0);
        const rig::Locator* const from = rig::findLocator(start.locators, name);
        change[axis] = from == nullptr ? 0.0 : value - from->position[axis];
        return app::moveLocators(start, {name}, change, mirror);
      });
    }
  }
}

/// What kind of body the mesh is: another choice fits its locators.
void fittedPlanRow(PanelContext& context) {
  const app::Session& session = context.character();
  if (!app::isMeshAlone(session)) {
    return;
  }
  const rig::Locators& locators = session.document().locators;
  std::vector<Choice> choices;
  int selected = -1;
  for (const rig::LocatorPlan& plan : rig::locatorPlans()) {
    const bool isFitted = !locators.empty() && locators.plan == plan.id;
    selected = isFitted ? static_cast<int>(choices.size()) : selected;
    choices.push_back({capitalised(rig::planNamed(plan.id)->title)});
  }
  const Help help{"Body of the locators", "Which joints are looked for in the mesh. A choice fits them.", {}};
  labelledRow(widgetsOf(context), "Body", help);
  const int chosen =
      dropdown(widgetsOf(context), "locators/plan", choices, selected, help, 0.0F, "As it looks");
  if (chosen >= 0 && chosen != selected) {
    request(context, command::locatorsFitPrefix + rig::locatorPlans()[static_cast<std::size_t>(chosen)].id);
  }
}

void shownLocators(PanelContext& context) {
  panelTitle(widgetsOf(context), icon::target, "Locators");
  fittedPlanRow(context);
  useLocators(context);
  moveTools(context);
  placeRow(context);
  locatorNews(context);
}

/// What a file without a skeleton needs first, and what goes on once its locators are there.
void locatorPart(PanelContext& context) {
  const app::Session& session = context.character();
  const app::Document& document = session.document();
  const float width = ImGui::GetContentRegionAvail().x;
  if (app::showsLocators(session)) {
    shownLocators(context);
  } else if (app::isRigBuilt(document)) {
    commandButton(context, {.command = command::rigBack, .icon = icon::target, .width = width});
  } else if (!document.body.isBiped && document.scene->skins.empty()) {
    panelTitle(widgetsOf(context), icon::target, "Locators");
    commandButton(context, {.command = command::locatorsFit,
                            .icon = icon::target,
                            .emphasis = Emphasis::primary,
                            .width = width});
    fittedPlanRow(context);
    note(widgetsOf(context), "This mesh has no skeleton. Fit locators finds where its joints belong; move "
                             "what is off, then bind.");
  } else {
    return;
  }
  separator(widgetsOf(context));
}

/// Whose weights the viewport shows, while it shows any.
void weightPart(PanelContext& context) {
  if (!context.ui.overlays.weights) {
    return;
  }
  const WidgetContext widgets = widgetsOf(context);
  const app::Session& session = context.character();
  const Scene& scene = *session.document().scene;
  panelTitle(widgets, icon::brush, "Weights of");
  const std::vector<NodeIndex> joints = weightedJoints(scene);
  if (joints.empty()) {
    note(widgets, "No mesh follows a joint yet. Bind makes it follow them.");
    return;
  }
  const auto shown = std::ranges::find(joints, weightsShownOf(context.ui, session));
  std::vector<Choice> choices;
  for (const NodeIndex joint : joints) {
    const std::string name = nodeName(scene, joint);
    const bool isTaken = std::ranges::find(choices, name, &Choice::text) != choices.end();
    choices.push_back({isTaken ? name + " #" + std::to_string(joint.value) : name});
  }
  const int chosen =
      dropdown(widgets, "weights/of", choices, static_cast<int>(shown - joints.begin()),
               {"Weights of",
                "How much the mesh follows this joint: yellow wholly, grey not at all. A click "
                "on the mesh takes the joint that it follows most there.",
                {}},
               0.0F, "", &context.ui.body.weights.filter);
  if (chosen >= 0) {
    showWeightsOf(context.ui.body.weights, session, joints[static_cast<std::size_t>(chosen)]);
  }
  separator(widgets);
}

} // namespace

void drawSkinPanel(PanelContext& context) {
  if (hasCharacter(context)) {
    locatorPart(context);
    weightPart(context);
  }
}

} // namespace stretch::ui
