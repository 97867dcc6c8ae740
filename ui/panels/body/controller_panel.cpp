#include "ui/panels/body/controller_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

#include <fmt/core.h>

#include "app/commands/pose/posing.h"
#include "app/commands/table/selection.h"
#include "app/edits/pose/pose_edits.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/key_diamond.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

constexpr double radiansOfDegree = pi / 180.0;

/// A gesture of a control that poses: one undo step, or shown without a key while auto-key is off.
void poseThrough(PanelContext& context, const EditPhase& phase, const std::string& label,
                 const app::OffsetPose& pose) {
  app::Session& session = context.character();
  if (!session.view().autoKey) {
    tellProblem(context, phase.changed ? app::poseAll(session, pose, label) : Status(Success{}));
    return;
  }
  const int clip = session.view().clip;
  const double frame = session.view().frame;
  const app::KeyRange range = app::keyRange(session);
  const bool isKeyed = phase.changed && (!session.isDragging() || context.ui.panelDrag);
  editThrough(context, phase, label, [&](const app::Document& start) {
    return app::setOffsets(start, clip, frame, pose.offsets, pose.values, range);
  });
  if (isKeyed) {
    app::forgetUnkeyed(session.view(), pose);
  }
}

Help markHelp(KeyMark mark) {
  return {mark == KeyMark::here ? "Delete the key" : "Set a key",
          "Filled: a key stands at the playhead. Half filled: keys stand at other frames.",
          {}};
}

std::string framesText(const std::vector<double>& frames) {
  std::string text;
  for (std::size_t i = 0; i < frames.size() && i < 6; ++i) {
    text += (i == 0 ? "" : ", ") + shortNumber(frames[i], 1);
  }
  return text + (frames.size() > 6 ? ", ..." : "");
}

std::string keysText(const app::Session& session, KeyMark mark) {
  if (!session.view().unkeyed.empty()) {
    return "posed without a key";
  }
  const std::vector<double> frames = app::offsetKeyFrames(session);
  return mark == KeyMark::none ? "none" : "at " + framesText(frames);
}

void keyRow(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  app::Session& session = context.character();
  const std::vector<std::string>& ids = session.view().selection.controllers();
  const KeyMark mark = keyMarkOf(session, ids);
  labelledRow(widgets, "Key", markHelp(mark));
  if (keyDiamond(widgets, "controller/key", mark, markHelp(mark))) {
    request(context, mark == KeyMark::here ? command::poseDeleteKey : command::poseKey);
  }
  ImGui::SameLine();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::Dummy({width, context.theme.rowHeight()});
  drawText(widgets, context.theme.fonts.body,
           {corner, {corner.x + width, corner.y + context.theme.rowHeight()}},
           context.theme.colours.quietText, keysText(session, mark));
}

/// Three numbers of the offset, of all controllers that have them; `number` picks one of an offset.
struct OffsetRow {
  const char* id;
  const char* label;
  const char* verb;
  double unit;
  double reach; ///< Of dragging, in units.
  double hard;
  double step;
  int decimals; ///< Of what is small; one less where the number gets too long for its field.
  double small; ///< In units.
  const char* help;
  Vec3 app::ControllerOffset::*vector;
  bool rig::Controller::*can;
};

void offsetRow(PanelContext& context, const std::vector<rig::Controller>& controllers, const OffsetRow& row) {
  std::vector<std::string> ids;
  for (const rig::Controller& controller : controllers) {
    if (controller.*row.can) {
      ids.push_back(controller.id);
    }
  }
  if (ids.empty()) {
    return;
  }
  const WidgetContext widgets = widgetsOf(context);
  const app::Session& session = context.character();
  const Help help{row.label, row.help, {}};
  labelledRow(widgets, row.label, help);
  const std::string label = app::poseLabel(session.document(), row.verb, ids);
  const app::OffsetPose shown = app::shownPose(session, ids);
  const float width = columnWidth(3);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) {
      ImGui::SameLine();
    }
    const std::string name(1, "XYZ"[axis]);
    double value = (shown.offsets.front().*row.vector)[axis] / row.unit;
    const SliderSpec spec{.id = std::string("controller/") + row.id + name,
                          .minimum = -row.reach,
                          .maximum = row.reach,
                          .step = row.step,
                          .decimals = row.decimals - (std::abs(value) < row.small ? 0 : 1),
                          .defaultValue = 0.0,
                          .hardMinimum = -row.hard,
                          .hardMaximum = row.hard,
                          .showsFill = false,
                          .width = width,
                          .help = dragHelp({std::string(row.label) + " " + name, row.help, {}})};
    const EditPhase phase = slider(widgets, spec, value);
    if (phase.changed || phase.ended) {
      app::OffsetPose pose = shown;
      for (app::ControllerOffset& offset : pose.offsets) {
        (offset.*row.vector)[axis] = value * row.unit;
      }
      poseThrough(context, phase, label, pose);
    }
  }
}

void offsetRows(PanelContext& context, const std::vector<rig::Controller>& controllers) {
  const double height = std::max(1e-6, context.character().document().body.height);
  const bool large = height > 20.0;
  offsetRow(context, controllers,
            {"move-", "Move", "Move", 1.0, 2.0 * height, 1000.0 * height, large ? 0.1 : 0.005, large ? 1 : 2,
             large ? 100.0 : 10.0,
             "How far it is from where the clip has it, along the axes of what carries it.",
             &app::ControllerOffset::move, &rig::Controller::moves});
  offsetRow(context, controllers,
            {"turn-", "Turn", "Turn", radiansOfDegree, 360.0, 36000.0, 1.0, 1, 100.0,
             "Degrees about each axis of what carries it, as one turn about their sum.",
             &app::ControllerOffset::turn, &rig::Controller::turns});
}

struct AttributeText {
  rig::AttributeKind kind;
  const char* label;
  const char* help;
};

constexpr std::array<AttributeText, 6> attributeTexts{{
    {rig::AttributeKind::curl, "Curl", "1 is a fist; below 0 the hand opens."},
    {rig::AttributeKind::roll, "Roll",
     "Above 0 the heel lifts about the ball of the foot, below 0 the toes about the heel."},
    {rig::AttributeKind::stretch, "Stretch",
     "1: the limb stretches to what it cannot reach. 0: it falls short."},
    {rig::AttributeKind::volume, "Volume", "How much of its volume a stretched bone keeps."},
    {rig::AttributeKind::follow, "Follow",
     "1: the end goes along with what carries it. 0: it stays where the clip has it in the world."},
    {rig::AttributeKind::softness, "Softness",
     "Above 0 a straight elbow or knee does not pop out as the limb shortens."},
}};

void attributeRow(PanelContext& context, const std::vector<rig::Attribute>& attributes,
                  const AttributeText& text) {
  const WidgetContext widgets = widgetsOf(context);
  app::Session& session = context.character();
  std::vector<std::string> ids;
  std::ranges::transform(attributes, std::back_inserter(ids), &rig::Attribute::id);
  const rig::Attribute& first = attributes.front();
  const Help help{text.label, text.help, {}};
  labelledRow(widgets, text.label, help);
  double value = app::shownValue(session, first.id);
  const SliderSpec spec{.id = std::string("controller/") + text.label,
                        .minimum = first.minimum,
                        .maximum = first.maximum,
                        .defaultValue = first.standard,
                        .width = ImGui::GetContentRegionAvail().x - context.theme.rowHeight() -
                                 ImGui::GetStyle().ItemSpacing.x,
                        .help = dragHelp(help)};
  const EditPhase phase = slider(widgets, spec, value);
  if (phase.changed || phase.ended) {
    app::OffsetPose pose;
    for (const std::string& id : ids) {
      pose.values.push_back({id, value});
    }
    poseThrough(context, phase, app::poseLabel(session.document(), "Change", ids), pose);
  }
  ImGui::SameLine();
  const KeyMark mark = keyMarkOf(session, ids);
  if (!keyDiamond(widgets, spec.id + "/key", mark, markHelp(mark))) {
    return;
  }
  if (mark == KeyMark::here) {
    editOnce(context, app::poseLabel(session.document(), "Delete the key of", ids),
             app::removeOffsetKeys(session.document(), session.view().clip, session.view().frame, ids));
  } else {
    tellProblem(context, app::keyPose(session, app::shownPose(session, ids),
                                      app::poseLabel(session.document(), "Key", ids)));
  }
}

// Whatever is posed, an elbow or a knee may pop: the hips move them all.
void popRows(PanelContext& context) {
  for (const app::LimbPop& pop : context.character().pops()) {
    notice(widgetsOf(context), NoticeKind::warning, capitalised(app::popWarning(pop)) + ".");
  }
}

void attributeRows(PanelContext& context, const std::vector<rig::Controller>& controllers) {
  const std::vector<rig::Attribute> all = app::attributesOf(context.character(), controllers);
  if (all.empty() ||
      !section(widgetsOf(context), "controller/section-limb", "Limb", context.ui.closedSections)) {
    return;
  }
  for (const AttributeText& text : attributeTexts) {
    std::vector<rig::Attribute> ofKind;
    std::ranges::copy_if(all, std::back_inserter(ofKind),
                         [&](const rig::Attribute& attribute) { return attribute.kind == text.kind; });
    if (!ofKind.empty()) {
      attributeRow(context, ofKind, text);
    }
  }
}

void actsOnRow(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const app::Session& session = context.character();
  const app::ViewState& view = session.view();
  const bool whole = app::isWholeClip(session);
  std::optional<Vec2> range = app::keyRange(session).rangeFrames;
  for (const std::string& id : app::posedIds(session)) {
    const rig::Adjustment* const present = app::adjustmentAt(session.document(), view.clip, view.frame, id);
    range = present != nullptr && present->rangeFrames ? present->rangeFrames : range;
  }
  const bool isSet = view.rangeEnd > view.rangeStart;
  const Help help{"Acts on",
                  "Inside the range a change runs out at both ends; on the whole clip it is held to them.",
                  {}};
  labelledRow(widgets, "Acts on", help);
  const std::string frames =
      range ? fmt::format("{} to {}", shortNumber(range->x, 1), shortNumber(range->y, 1)) : "Range";
  const int chosen = segmented(widgets, "controller/acts-on",
                               {{frames,
                                 {"The range", "Set it with [ and ], or in the timeline.", {}},
                                 isSet || !whole || view.wholeClip},
                                {"Whole clip", help}},
                               whole ? 1 : 0);
  if (chosen == 1 && whole) {
    context.character().view().wholeClip = true; // what is pasted, too
  } else if (chosen >= 0 && (chosen == 1) != whole) {
    request(context, command::poseWholeClip);
  }
  for (const bool first : {true, false}) {
    if (app::endsAtOnce(session, first)) {
      notice(widgets, NoticeKind::warning,
             fmt::format("{} frame {} it {} at once. {} farther off gives it time.", first ? "At" : "After",
                         shortNumber(view.frame, 1), first ? "comes" : "is gone", first ? "[" : "]"));
    }
  }
}

struct InterpolationChoice {
  rig::KeyInterpolation interpolation;
  const char* text;
  const char* command;
};

constexpr std::array<InterpolationChoice, 5> interpolationChoices{
    {{rig::KeyInterpolation::automatic, "Auto", command::poseKeyAutomatic},
     {rig::KeyInterpolation::flat, "Flat", command::poseKeyFlat},
     {rig::KeyInterpolation::linear, "Linear", command::poseKeyLinear},
     {rig::KeyInterpolation::stepped, "Stepped", command::poseKeyStepped},
     {rig::KeyInterpolation::free, "Free", command::poseKeyFree}}};

void interpolationRow(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const app::Session& session = context.character();
  if (keyMarkOf(session, app::posedIds(session)) != KeyMark::here) {
    return;
  }
  const std::optional<rig::KeyInterpolation> here = app::interpolationHere(session);
  std::vector<Choice> choices;
  int selected = -1;
  for (const InterpolationChoice& choice : interpolationChoices) {
    const CommandInfo* const info = findCommand(context, choice.command);
    selected = here == choice.interpolation ? static_cast<int>(choices.size()) : selected;
    choices.push_back({choice.text, {choice.text, info == nullptr ? "" : info->help, {}}});
  }
  const Help help{"Passes as", "How the curve of the offset passes the key at the playhead.", {}};
  labelledRow(widgets, "Passes as", help);
  const int chosen =
      dropdown(widgets, "controller/interpolation", choices, selected, help, 0.0F, "Different ones");
  if (chosen >= 0) {
    request(context, interpolationChoices.at(static_cast<std::size_t>(chosen)).command);
  }
}

/// Between the key before the playhead and the key after it; the slider stands at half-way until it is held.
void tweenRow(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const app::Session& session = context.character();
  const bool possible = app::canTween(session);
  const Help help{
      "Tween",
      std::string("A pose between the key before (0 %) and the key after (100 %), or past them.") +
          (possible ? "" : " Off: the playhead stands between no two keys."),
      {}};
  labelledRow(widgets, "Tween", help);
  const SliderSpec spec{.id = "controller/tween",
                        .minimum = -0.5,
                        .maximum = 1.5,
                        .decimals = 0,
                        .suffix = " %",
                        .displayFactor = 100.0,
                        .defaultValue = 0.5,
                        .hardMinimum = -2.0,
                        .hardMaximum = 3.0,
                        .help = dragHelp(help),
                        .enabled = possible};
  const EditPhase phase = slider(widgets, spec, context.ui.body.tween);
  if (phase.changed || phase.ended) {
    poseThrough(context, phase, "Tween", app::tweened(session, context.ui.body.tween));
  }
  if (phase.ended) {
    context.ui.body.tween = 0.5;
  }
}

void buttonRow(PanelContext& context) {
  const bool fits = columnWidth(4) >= context.theme.px(56.0F);
  const std::size_t columns = fits ? 4 : 2;
  const float width = columnWidth(static_cast<int>(columns));
  const std::array<CommandButton, 4> buttons{
      {{.command = command::poseMirror, .text = "Mirror", .width = width},
       {.command = command::poseReset, .text = "Reset", .width = width},
       {.command = command::poseCopy, .text = "Copy", .width = width},
       {.command = command::posePaste, .text = "Paste", .width = width}}};
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    if (i % columns != 0) {
      ImGui::SameLine();
    }
    commandButton(context, buttons[i]);
  }
}

void autoKeyRow(PanelContext& context) {
  const CommandInfo* const info = findCommand(context, command::poseAutoKey);
  const bool on = context.character().view().autoKey;
  const Help help{"Auto-key", info == nullptr ? "" : info->help, keyOf(context, command::poseAutoKey)};
  labelledRow(widgetsOf(context), "Auto-key", help);
  if (toggle(widgetsOf(context), "controller/auto-key", on ? "On" : "Off", on, help)) {
    request(context, command::poseAutoKey);
  }
}

} // namespace

KeyMark keyMarkOf(const app::Session& session, std::span<const std::string> ids) {
  const app::ViewState& view = session.view();
  const app::Document& document = session.document();
  const bool here = std::ranges::any_of(ids, [&](const std::string& id) {
    return app::offsetKeyAt(document, view.clip, view.frame, id) != nullptr;
  });
  const bool elsewhere = std::ranges::any_of(document.adjustments, [&](const rig::Adjustment& adjustment) {
    return adjustment.clip == view.clip && std::ranges::find(ids, adjustment.controller) != ids.end();
  });
  return here ? KeyMark::here : elsewhere ? KeyMark::elsewhere : KeyMark::none;
}

void drawControllerSettings(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const std::vector<rig::Controller> controllers = app::selectedControllers(context.character());
  if (controllers.empty()) {
    return;
  }
  const std::size_t also = controllers.size() - 1;
  panelTitle(widgets, icon::sliders,
             capitalised(app::controllerTitle(context.character().document(), controllers.front().id)) +
                 (also > 0 ? " and " + std::to_string(also) + " more" : ""));
  buttonRow(context);
  keyRow(context);
  offsetRows(context, controllers);
  actsOnRow(context);
  interpolationRow(context);
  tweenRow(context);
  autoKeyRow(context);
  attributeRows(context, controllers);
  popRows(context);
}

} // namespace stretch::ui
