#include <algorithm>
#include <functional>
#include <memory>

#include <fmt/format.h>

#include "app/commands/command_ids.h"
#include "app/schema/sequence_schema.h"
#include "core/gltf/json.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
#include "ui/panels/sequence_rows.h"
#include "ui/panels/setting_rows.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

/// What the sequence allows: a body without a centre line has no elastic model.
RowExtras extrasOf(PanelContext& context, const app::SettingFacts& setting, double mostBones) {
  const bool hasLine = !context.sequence().document().analysis->joints.empty();
  const skinning::CompressSettings& settings = context.sequence().document().settings;
  if (setting.name == "bones") {
    return {.maximum = std::min(100.0, mostBones)};
  }
  if (setting.name == "skip") {
    return {.maximum = std::max(1.0, app::lastFrame(context.sequence()))};
  }
  if (setting.name == "stretch") {
    return {.offered = {true, hasLine, true}};
  }
  if (setting.name == "joints") {
    const bool measured = settings.stretch == skinning::StretchOption::measured || !hasLine;
    return {.offered = {measured, measured}};
  }
  if (setting.name == "tolerance") {
    return {.hint = "none: the bones above"};
  }
  return {.offered =
              setting.name == "weights" ? std::vector<bool>{true, hasLine, true} : std::vector<bool>{}};
}

void optionRows(PanelContext& context) {
  using skinning::CompressSettings;
  const app::SequenceDocument document = context.sequence().document(); // a copy: rows edit it
  const auto mostBones = std::clamp<std::size_t>(document.mesh->vertexCount / 4, 1, 1000);
  const auto edit = [&](const EditPhase& phase, const std::string& label,
                        const std::function<void(CompressSettings&)>& change) {
    editSequence(context, phase, label, [&](app::SequenceDocument& changed) {
      change(changed.settings);
      changed.settings.bones = std::min(changed.settings.bones, static_cast<int>(mostBones));
    });
  };
  for (const app::Setting<CompressSettings>& setting : app::sequenceSchema()) {
    const bool applies = setting.name != "length" || !document.analysis->joints.empty();
    if (setting.row.section == "options" && applies) {
      settingRow(context, "sequence/", setting, document.settings, edit,
                 extrasOf(context, setting, static_cast<double>(mostBones)));
    }
  }
}

void progressRow(PanelContext& context) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const float cancelWidth = theme.px(84.0F);
  const Control place =
      takePlace(widgets, "sequence/progress",
                {ImGui::GetContentRegionAvail().x - cancelWidth - theme.unit(), theme.rowHeight()}, false);
  const double share = context.sequence().compressedShare();
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
  if (context.sequence().isCompressing()) {
    progressRow(context);
    return;
  }
  const bool next =
      context.sequence().document().result == nullptr || app::isOutdated(context.sequence().document());
  commandButton(context, {.command = command::sequenceCompress,
                          .icon = icon::bolt,
                          .text = "Compress",
                          .emphasis = next ? Emphasis::primary : Emphasis::normal,
                          .width = ImGui::GetContentRegionAvail().x});
}

void sizeRows(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const app::SequenceDocument document = context.sequence().document(); // a copy: rows edit it
  const auto source = static_cast<double>(skinning::sourceBytesPerFrame(*document.mesh));
  const std::shared_ptr<const app::ExportedClip> exported = app::exported(document);
  const double bytes = exported->clip.bytesPerFrame;
  valueRow(widgets, "Frame",
           bytes > 0.0 ? fmt::format("{:.4g} bytes, 1 : {:.3g}", bytes, source / bytes) : "nothing moves",
           {"Bytes per frame",
            fmt::format("All that a client needs for each frame, instead of {:.0f} bytes of "
                        "positions.",
                        source),
            {}});
  const std::size_t once = exported->clip.bytesOnce + exported->clip.bytesOfJson;
  valueRow(widgets, "Once", fmt::format("{:.4g} kB", static_cast<double>(once) / 1000.0),
           {"Bytes once",
            fmt::format("Mesh, weights, images and {} bytes of JSON, whatever the number of frames.",
                        exported->clip.bytesOfJson),
            {}});
}

/// How the clip is written; it is made again at once.
void encodingRows(PanelContext& context) {
  using skinning::EncodeSettings;
  const EncodeSettings encoding = context.sequence().document().encoding; // a copy: rows edit it
  const auto edit = [&](const EditPhase& phase, const std::string& label,
                        const std::function<void(EncodeSettings&)>& change) {
    editSequence(context, phase, label, [&](app::SequenceDocument& changed) {
      change(changed.encoding);
      changed.clip = app::exported(changed);
    });
  };
  for (const app::Setting<EncodeSettings>& setting : app::clipSchema()) {
    settingRow(context, "sequence/", setting, encoding, edit);
  }
}

void errorRows(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const skinning::SequenceMetrics& metrics = context.sequence().document().result->compressed.metrics;
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

/// Which weights were taken, where both were tried.
void weightsRow(PanelContext& context) {
  const skinning::WeightChoice& weights = context.sequence().document().result->compressed.weights;
  if (!weights.geodesicPercent || !weights.fittedPercent) {
    return;
  }
  const bool geodesic = weights.used == skinning::WeightOption::geodesic;
  valueRow(widgetsOf(context), "Weights", geodesic ? "geodesic" : "fitted",
           {"Weights that were taken",
            fmt::format("The better of the two: RMSE {:.3g} % with geodesic, {:.3g} % with fitted ones.",
                        *weights.geodesicPercent, *weights.fittedPercent),
            {}});
}

void resultSection(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const app::SequenceDocument document = context.sequence().document();
  if (!section(widgets, "sequence/result", "Result", context.ui.closedSections)) {
    return;
  }
  if (app::isOutdated(document)) {
    notice(widgets, NoticeKind::info, "Made with other settings. Compress again to see these.");
  }
  errorRows(context);
  weightsRow(context);
  sizeRows(context);
  encodingRows(context);
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
  if (context.sequence().document().result != nullptr) {
    resultSection(context);
  }
  const bool hasLine = !context.sequence().document().analysis->joints.empty();
  if (hasLine && section(widgets, "sequence/elastic", "Elastic model", context.ui.closedSections)) {
    elasticModelRows(context);
  }
}

} // namespace stretch::ui
