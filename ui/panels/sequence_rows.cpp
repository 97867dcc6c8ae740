#include "ui/panels/sequence_rows.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "app/commands/command_ids.h"
#include "app/schema/sequence_schema.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/setting_rows.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

std::optional<double> positiveNumber(const std::string& text) {
  std::istringstream stream(text);
  double value = 0.0;
  std::string rest;
  const bool read = static_cast<bool>(stream >> value) && !(stream >> rest);
  return read && std::isfinite(value) && value > 0.0 ? std::optional(value) : std::nullopt;
}

std::string textOf(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

/// What is typed for one value of the settings; empty text stands for what the program takes by itself.
template <typename Value>
struct TypedRow {
  std::string id;
  const char* label = "";
  const char* undoLabel = "";
  std::string hint;
  Help help;
  Value (*parse)(const std::string&) = nullptr;
  std::string (*print)(const Value&) = nullptr;
  Value& (*place)(skinning::BodyStretchSettings&) = nullptr;
};

/// The text stays as it is typed while it says what the settings hold; after undo or another file it is made
/// anew.
template <typename Value>
void typedRow(PanelContext& context, const TypedRow<Value>& row, std::string& text) {
  const WidgetContext widgets = widgetsOf(context);
  skinning::BodyStretchSettings body = context.sequence().document().settings.body;
  if (!(row.parse(text) == row.place(body))) {
    text = row.print(row.place(body));
  }
  labelledRow(widgets, row.label, row.help);
  const EditPhase phase = editText(widgets, row.id, row.hint, text);
  editSequence(context, phase, row.undoLabel,
               [&](app::SequenceDocument& document) { row.place(document.settings.body) = row.parse(text); });
}

Help helpFor(const char* setting) {
  return settingHelp(*app::findSetting(app::sequenceSchema(), setting));
}

void complain(PanelContext& context, const std::string& text, bool right, const char* wanted) {
  if (!text.empty() && !right) {
    notice(widgetsOf(context), NoticeKind::error, wanted);
  }
}

/// What the program chose where nothing is typed, once it is known.
std::string chosen(const PanelContext& context, double skinning::BodyStretch::*value, const char* unit,
                   const char* before) {
  const auto& result = context.sequence().document().result;
  return result != nullptr && result->compressed.model && (*result->compressed.model).*value > 0.0
             ? fmt::format("{}: {:.4g} {}", before, (*result->compressed.model).*value, unit)
             : before;
}

void optionalRow(PanelContext& context, const TypedRow<std::optional<double>>& row, std::string& text) {
  typedRow(context, row, text);
  complain(context, text, positiveNumber(text).has_value(), "A number above 0, such as 3770 or 5.8e-10.");
}

void scaleRow(PanelContext& context) {
  std::string& text = context.ui.sequencePanel.metresPerUnit;
  typedRow<double>(
      context,
      {.id = "sequence/scale",
       .label = "Scale",
       .undoLabel = "Change the scale",
       .hint = "1 metre per unit",
       .help = helpFor("metres_per_unit"),
       .parse = [](const std::string& typed) { return positiveNumber(typed).value_or(1.0); },
       .print = [](const double& metres) { return metres == 1.0 ? "" : textOf(metres); },
       .place = [](skinning::BodyStretchSettings& body) -> double& { return body.metresPerUnit; }},
      text);
  complain(context, text, positiveNumber(text).has_value(), "Metres: a number above 0, such as 2.03e-6.");
}

void gravityRow(PanelContext& context) {
  using skinning::BodyStretchSettings;
  std::string& text = context.ui.sequencePanel.gravity;
  typedRow<Vec3>(
      context,
      {.id = "sequence/gravity",
       .label = "Gravity",
       .undoLabel = "Change the gravity",
       .hint = "0, -9.81, 0 m/s\xC2\xB2",
       .help = helpFor("gravity"),
       .parse =
           [](const std::string& typed) { return parseThree(typed).value_or(BodyStretchSettings{}.gravity); },
       .print =
           [](const Vec3& gravity) {
             return gravity == BodyStretchSettings{}.gravity
                        ? std::string()
                        : fmt::format("{}, {}, {}", gravity.x, gravity.y, gravity.z);
           },
       .place = [](BodyStretchSettings& body) -> Vec3& { return body.gravity; }},
      text);
  complain(context, text, parseThree(text).has_value(), "Three numbers, such as 0, -9.81, 0.");
}

using Ranges = std::vector<skinning::SegmentModuli::Range>;

void editRanges(PanelContext& context, const EditPhase& phase, const std::function<void(Ranges&)>& change) {
  editSequence(context, phase, "Change the moduli",
               [&](app::SequenceDocument& document) { change(document.settings.body.moduli.ranges); });
}

EditPhase segmentSlider(PanelContext& context, const std::string& id, const char* prefix, double most,
                        std::size_t& value) {
  SliderSpec spec{.id = id,
                  .maximum = std::max(1.0, most),
                  .step = 1.0,
                  .decimals = 0,
                  .prefix = prefix,
                  .showsFill = false,
                  .width = context.theme.px(64.0F)};
  spec.help = {"Segment", "Counted from 0 at the body's first end. Both ends belong to the range.", {}};
  auto number = static_cast<double>(value);
  const EditPhase phase = slider(widgetsOf(context), spec, number);
  value = static_cast<std::size_t>(std::llround(number));
  ImGui::SameLine(0.0F, context.theme.px(4.0F));
  return phase;
}

EditPhase modulusSlider(PanelContext& context, const std::string& id, double& youngModulus) {
  SliderSpec spec{.id = id,
                  .minimum = 0.01,
                  .maximum = 10000.0,
                  .step = 0.01,
                  .suffix = " Pa",
                  .hardMinimum = 1e-6,
                  .hardMaximum = 1e15,
                  .showsFill = false,
                  .width = ImGui::GetContentRegionAvail().x - context.theme.px(34.0F)};
  spec.help = {"Young's modulus", "Of these segments. Click to type.", {}};
  const EditPhase phase = slider(widgetsOf(context), spec, youngModulus);
  ImGui::SameLine(0.0F, context.theme.px(4.0F));
  return phase;
}

/// One range of segments; true when it is to go.
bool rangeRow(PanelContext& context, std::size_t index, skinning::SegmentModuli::Range range) {
  const std::string id = fmt::format("sequence/moduli/{}", index);
  const auto most = static_cast<double>(context.sequence().document().settings.bones - 1);
  EditPhase phase;
  const auto gather = [&phase](const EditPhase& part) {
    phase = {phase.changed || part.changed, phase.ended || part.ended};
  };
  gather(segmentSlider(context, id + "/from", "", most, range.first));
  gather(segmentSlider(context, id + "/to", "\xE2\x80\x93 ", most, range.last));
  range.last = std::max(range.first, range.last);
  gather(modulusSlider(context, id + "/young", range.youngModulus));
  editRanges(context, phase, [&](Ranges& ranges) { ranges[index] = range; });
  ButtonSpec remove{.id = id + "/remove",
                    .icon = icon::close,
                    .emphasis = Emphasis::quiet,
                    .width = context.theme.px(30.0F),
                    .fallback = "x"};
  remove.help = {"Remove", "These segments are then as stiff as the rest.", {}};
  return button(widgetsOf(context), remove);
}

void addRange(PanelContext& context) {
  const app::SequenceDocument& document = context.sequence().document();
  skinning::SegmentModuli::Range range;
  range.last = static_cast<std::size_t>(std::max(0, std::min(4, document.settings.bones - 1)));
  const bool known = document.result != nullptr && document.result->compressed.model &&
                     document.result->compressed.model->youngModulus > 0.0;
  range.youngModulus = known ? 10.0 * document.result->compressed.model->youngModulus : 1000.0;
  editRanges(context, {true, true}, [&](Ranges& ranges) { ranges.push_back(range); });
}

void moduliRows(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const Ranges ranges = context.sequence().document().settings.body.moduli.ranges; // rows edit it
  note(widgets,
       ranges.empty() ? "Segments: all are as stiff as the body." : "Segments with a modulus of their own");
  std::optional<std::size_t> removed;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    removed = rangeRow(context, i, ranges[i]) ? std::optional(i) : removed;
  }
  if (removed) {
    editRanges(context, {true, true},
               [&](Ranges& kept) { kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(*removed)); });
  }
  const float width = columnWidth(3);
  ButtonSpec add{.id = "sequence/moduli/add", .icon = icon::plus, .text = "Add", .width = width};
  add.help = {"Stiffer or softer segments", "Names a range of segments with a modulus of its own.", {}};
  if (button(widgets, add)) {
    addRange(context);
  }
  ImGui::SameLine();
  commandButton(context, {.command = command::moduliLoad, .text = "Load", .width = width});
  ImGui::SameLine();
  commandButton(context, {.command = command::moduliSave, .text = "Save", .width = width});
}

} // namespace

std::optional<Vec3> parseThree(const std::string& text) {
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream stream(spaced);
  Vec3 value(0.0);
  std::string rest;
  const bool read = static_cast<bool>(stream >> value.x >> value.y >> value.z) && !(stream >> rest);
  const bool finite = std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
  return read && finite ? std::optional(value) : std::nullopt;
}

void elasticModelRows(PanelContext& context) {
  using Body = skinning::BodyStretchSettings;
  SequencePanelState& typed = context.ui.sequencePanel;
  optionalRow(context,
              {.id = "sequence/young",
               .label = "Young",
               .undoLabel = "Change Young's modulus",
               .hint = chosen(context, &skinning::BodyStretch::youngModulus, "Pa", "fitted"),
               .help = helpFor("young"),
               .parse = positiveNumber,
               .print = textOf,
               .place = [](Body& body) -> std::optional<double>& { return body.youngModulus; }},
              typed.young);
  optionalRow(context,
              {.id = "sequence/mass",
               .label = "Mass",
               .undoLabel = "Change the mass",
               .hint = chosen(context, &skinning::BodyStretch::mass, "kg", "of water"),
               .help = helpFor("mass"),
               .parse = positiveNumber,
               .print = textOf,
               .place = [](Body& body) -> std::optional<double>& { return body.mass; }},
              typed.mass);
  scaleRow(context);
  gravityRow(context);
  moduliRows(context);
}

} // namespace stretch::ui
