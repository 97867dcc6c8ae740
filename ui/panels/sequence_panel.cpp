#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/commands/command_ids.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
#include "ui/panels/sequence_rows.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

/// Where a row's value lies in the settings.
template <typename Value>
using Place = Value& (*)(skinning::CompressSettings&);

/// What a row is called: before its widget, and as a step of undo.
struct RowLabels {
  const char* row = "";
  const char* undo = "";
};

template <typename Value>
Value valueAt(const PanelContext& context, Place<Value> place) {
  skinning::CompressSettings settings = context.open.sequence()->document().settings;
  return place(settings);
}

template <typename Enum>
void choiceRow(PanelContext& context, const char* id, const RowLabels& labels,
               const std::vector<Choice>& choices, Place<Enum> place) {
  const WidgetContext widgets = widgetsOf(context);
  const Enum value = valueAt(context, place);
  labelledRow(widgets, labels.row, choices[static_cast<std::size_t>(value)].help);
  const int chosen = segmented(widgets, id, choices, static_cast<int>(value));
  if (chosen >= 0) {
    editSequence(context, {true, true}, labels.undo, [&](app::SequenceDocument& document) {
      place(document.settings) = static_cast<Enum>(chosen);
    });
  }
}

template <typename Number>
void countRow(PanelContext& context, const SliderSpec& given, const RowLabels& labels, Place<Number> place) {
  const WidgetContext widgets = widgetsOf(context);
  SliderSpec spec = given;
  spec.step = 1.0;
  spec.decimals = 0;
  labelledRow(widgets, labels.row, spec.help);
  auto number = static_cast<double>(valueAt(context, place));
  const EditPhase phase = slider(widgets, spec, number);
  editSequence(context, phase, labels.undo, [&](app::SequenceDocument& document) {
    place(document.settings) = static_cast<Number>(std::llround(number));
  });
}

void optionRows(PanelContext& context) {
  using skinning::CompressSettings;
  const app::SequenceDocument document = context.open.sequence()->document(); // a copy: rows edit it
  const bool hasLine = !document.analysis->joints.empty();
  const auto mostBones =
      static_cast<double>(std::clamp<std::size_t>(document.mesh->vertexCount / 4, 1, 1000));
  countRow(context,
           {.id = "sequence/bones",
            .minimum = 1.0,
            .maximum = std::min(100.0, mostBones),
            .defaultValue = 30.0,
            .hardMaximum = mostBones,
            .help = {"Bones", "In a row along the body.", {}}},
           {"Bones", "Change the bones"}, Place<int>([](CompressSettings& s) -> int& { return s.bones; }));
  choiceRow(
      context, "sequence/stretch", {"Stretch", "Change the stretch"},
      {{"None", {"No stretch", "Bones turn; the body keeps its length and thickness.", {}}},
       {"Elastic",
        {"Elastic", "By the physical model: gravity flattens, curvature shortens. A handful of numbers.", {}},
        hasLine},
       {"Measured",
        {"Measured", "Scales fitted frame by frame: the best that bones with scales can do.", {}}}},
      Place<skinning::StretchOption>(
          [](CompressSettings& s) -> skinning::StretchOption& { return s.stretch; }));
  choiceRow(
      context, "sequence/weights", {"Weights", "Change the weights"},
      {{"Geodesic", {"Geodesic", "By distance over the surface, from the first frame alone.", {}}, hasLine},
       {"Fitted", {"Fitted", "By least squares over the frames.", {}}}},
      Place<skinning::WeightOption>(
          [](CompressSettings& s) -> skinning::WeightOption& { return s.weights; }));
  if (hasLine) {
    choiceRow(
        context, "sequence/model", {"Length", "Change the length's curve"},
        {{"Line", {"The paper's line", "Length falls with curvature along a straight line.", {}}},
         {"Monotone", {"Monotone curve", "Length never grows with curvature; copes with saturation.", {}}}},
        Place<skinning::LengthModel>(
            [](CompressSettings& s) -> skinning::LengthModel& { return s.body.lengthModel; }));
  }
  countRow(context,
           {.id = "sequence/skip",
            .maximum = std::max(1.0, app::lastFrame(*context.open.sequence())),
            .suffix = " frames",
            .defaultValue = 0.0,
            .help = {"Skip",
                     "Settling frames at the start that no fit uses. They are in the clip all the same.",
                     {}}},
           {"Skip", "Skip frames"},
           Place<std::size_t>([](CompressSettings& s) -> std::size_t& { return s.body.firstFittedFrame; }));
}

void progressRow(PanelContext& context) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const float cancelWidth = theme.px(84.0F);
  const Control place =
      takePlace(widgets, "sequence/progress",
                {ImGui::GetContentRegionAvail().x - cancelWidth - theme.unit(), theme.rowHeight()}, false);
  const double share = context.open.sequence()->compressedShare();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(place.box.min, place.box.max, theme.colours.sunken, theme.corner());
  list->AddRectFilled(place.box.min,
                      {place.box.min.x + static_cast<float>(share) * place.box.width(), place.box.max.y},
                      theme.colours.accentQuiet, theme.corner());
  drawText(widgets, theme.fonts.label, place.box, theme.colours.text,
           fmt::format("Compressing {:.0f} %", 100.0 * share), 0.5F);
  ImGui::SameLine();
  commandButton(context, {.command = command::sequenceCancel, .text = "Cancel", .width = cancelWidth});
}

void compressRow(PanelContext& context) {
  verticalSpace(widgetsOf(context), 4.0F);
  if (context.open.sequence()->isCompressing()) {
    progressRow(context);
    return;
  }
  const bool next = context.open.sequence()->document().result == nullptr ||
                    app::isOutdated(context.open.sequence()->document());
  commandButton(context, {.command = command::sequenceCompress,
                          .icon = icon::bolt,
                          .text = "Compress",
                          .emphasis = next ? Emphasis::primary : Emphasis::normal,
                          .width = ImGui::GetContentRegionAvail().x});
}

void sizeRows(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const app::SequenceDocument document = context.open.sequence()->document(); // a copy: rows edit it
  const double source = static_cast<double>(skinning::sourceBytesPerFrame(*document.mesh));
  const double bytes = app::exported(document).bytesPerFrame;
  valueRow(widgets, "Frame",
           bytes > 0.0 ? fmt::format("{:.4g} bytes, 1 : {:.3g}", bytes, source / bytes) : "nothing moves",
           {"Bytes per frame",
            fmt::format("All that a client needs for each frame, instead of {:.0f} bytes of "
                        "positions.",
                        source),
            {}});
  labelledRow(widgets, "Quantise",
              {"Quantise", "Rotations and weights as 16-bit integers, as glTF allows.", {}});
  if (toggle(widgets, "sequence/quantise", document.quantise ? "On" : "Off", document.quantise,
             {"Quantise", "Rotations and weights as 16-bit integers, as glTF allows.", {}})) {
    editSequence(context, {true, true}, "Quantise",
                 [](app::SequenceDocument& changed) { changed.quantise = !changed.quantise; });
  }
}

void errorRows(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const skinning::SequenceMetrics& metrics = context.open.sequence()->document().result->compressed.metrics;
  valueRow(widgets, "RMSE", fmt::format("{:.3g} %", metrics.rmsePercent),
           {"Root of the mean squared error",
            "Over all frames and vertices, in percent of the first frame's "
            "box diagonal.",
            {}});
  valueRow(widgets, "MSE", fmt::format("{:.4g} units\xC2\xB2", metrics.mse),
           {"Mean squared error", "Over all frames and vertices, in squared units of the mesh.", {}});
  valueRow(widgets, "Largest", fmt::format("{:.3g} %", metrics.largestPercent),
           {"Largest error", "Of any vertex in any frame, in percent of the diagonal.", {}});
  valueRow(widgets, "STED", fmt::format("{:.4g}", metrics.sted),
           {"Spatio-temporal edge difference", "Vasa and Skala 2011: what the eye sees of it.", {}});
  valueRow(widgets, "KG", fmt::format("{:.4g} %", metrics.kgError), {"Karni and Gotsman's error", "", {}});
}

void resultSection(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const app::SequenceDocument document = context.open.sequence()->document();
  if (!section(widgets, "sequence/result", "Result", context.ui.closedSections)) {
    return;
  }
  if (app::isOutdated(document)) {
    notice(widgets, NoticeKind::info, "Made with other settings. Compress again to see these.");
  }
  errorRows(context);
  sizeRows(context);
  for (const std::string& warning : document.result->compressed.warnings) {
    notice(widgets, NoticeKind::warning, capitalised(warning) + ".");
  }
  verticalSpace(widgets, 4.0F);
  commandButton(context, {.command = command::fileExportClean,
                          .icon = icon::save,
                          .text = "Export",
                          .emphasis = app::isOutdated(document) ? Emphasis::normal : Emphasis::primary,
                          .width = ImGui::GetContentRegionAvail().x});
}

} // namespace

void drawSequencePanel(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  panelTitle(widgets, icon::skeleton, "Skinned clip");
  optionRows(context);
  compressRow(context);
  if (context.open.sequence()->document().result != nullptr) {
    resultSection(context);
  }
  const bool hasLine = !context.open.sequence()->document().analysis->joints.empty();
  if (hasLine && section(widgets, "sequence/elastic", "Elastic model", context.ui.closedSections)) {
    elasticModelRows(context);
  }
}

} // namespace stretch::ui
