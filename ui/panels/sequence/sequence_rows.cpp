#include "ui/panels/sequence/sequence_rows.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "app/commands/table/command_ids.h"
#include "app/schema/sequence_schema.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

/// What the program chose where nothing is typed, once it is known.
std::string chosen(const PanelContext& context, double skinning::BodyStretch::*value, const char* unit,
                   const char* before) {
  const auto& result = context.sequence().document().result;
  return result != nullptr && result->compressed.model && (*result->compressed.model).*value > 0.0
             ? fmt::format("{}: {:.4g} {}", before, (*result->compressed.model).*value, unit)
             : before;
}

std::string hintOf(const PanelContext& context, const app::SettingFacts& setting) {
  if (setting.name == "young") {
    return chosen(context, &skinning::BodyStretch::youngModulus, "Pa", "fitted");
  }
  return setting.name == "mass" ? chosen(context, &skinning::BodyStretch::mass, "kg", "of water")
                                : std::string();
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

void elasticModelRows(PanelContext& context) {
  const skinning::CompressSettings settings = context.sequence().document().settings; // rows edit it
  const auto edit = [&](const EditPhase& phase, const std::string& label,
                        const std::function<void(skinning::CompressSettings&)>& change) {
    editSequence(context, phase, label, [&](app::SequenceDocument& document) { change(document.settings); });
  };
  for (const app::Setting<skinning::CompressSettings>& setting : app::sequenceSchema()) {
    if (setting.row.section == "model") {
      settingRow(context, "sequence/", setting, settings, edit, {.hint = hintOf(context, setting)});
    }
  }
  moduliRows(context);
}

} // namespace stretch::ui
