#include <algorithm>
#include <functional>
#include <memory>

#include <fmt/format.h>

#include "app/commands/table/command_ids.h"
#include "app/schema/sequence_schema.h"
#include "core/gltf/json/json.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/panels/sequence/sequence_rows.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

/// What the sequence allows: a body without a centre line has no row of bones.
RowExtras extrasOf(PanelContext& context, const app::SettingFacts& setting, double mostBones) {
  const bool hasLine = !context.sequence().document().analysis->joints.empty();
  const skinning::CompressSettings& settings = context.sequence().document().settings;
  if (setting.name == "bones") {
    return {.maximum = std::min(100.0, mostBones)};
  }
  if (setting.name == "skip") {
    return {.maximum = std::max(1.0, app::lastFrame(context.sequence()))};
  }
  const bool hasSkeleton = !settings.skeleton.empty();
  if (setting.name == "stretch") {
    const bool hasTree = hasSkeleton || settings.joints == skinning::JointOption::tree;
    return {.offered = {true, hasLine || hasTree, true}};
  }
  if (setting.name == "joints") {
    const bool measured = settings.stretch == skinning::StretchOption::measured;
    const bool byRows = settings.stretch == skinning::StretchOption::elastic;
    return {.offered = {measured || !hasLine, measured || (!hasLine && !byRows)}};
  }
  if (setting.name == "tolerance") {
    return {.hint = "none: the bones above"};
  }
  return {.offered = setting.name == "weights" ? std::vector<bool>{true, hasLine || hasSkeleton, true}
                                               : std::vector<bool>{}};
}

/// The bones of a file in place of own ones.
void skeletonRow(PanelContext& context) {
  const Theme& theme = context.theme;
  const app::SequenceDocument& document = context.sequence().document();
  const std::size_t bones = document.settings.skeleton.size();
  const std::string file = document.skeletonFile.filename().string();
  labelledRow(
      widgetsOf(context), "Skeleton",
      {"Skeleton", "Bones of a file's skin in place of own ones: their names, parents and places.", {}});
  const float removeWidth = bones == 0 ? 0.0F : theme.px(34.0F);
  const std::string text = fmt::format("{}, {} {}", file, bones, bones == 1 ? "bone" : "bones");
  commandButton(context, {.command = command::skeletonTake,
                          .text = bones == 0 ? "From a file" : text.c_str(),
                          .width = ImGui::GetContentRegionAvail().x - removeWidth});
  if (bones > 0) {
    ImGui::SameLine(0.0F, theme.px(4.0F));
    commandButton(context, {.command = command::skeletonLeave,
                            .icon = icon::close,
                            .text = " ",
                            .emphasis = Emphasis::quiet,
                            .width = theme.px(30.0F),
                            .fallback = "x"});
  }
}

/// Whether a setting says something: a skeleton has its own bones, a length model needs a line or rows.
bool applies(const app::SequenceDocument& document, const app::SettingFacts& setting) {
  const bool hasSkeleton = !document.settings.skeleton.empty();
  if (setting.name == "length") {
    return hasSkeleton || !document.analysis->joints.empty();
  }
  const bool asksForBones =
      setting.name == "bones" || setting.name == "tolerance" || setting.name == "joints";
  return !hasSkeleton || !asksForBones;
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
  skeletonRow(context);
  for (const app::Setting<CompressSettings>& setting : app::sequenceSchema()) {
    if (setting.row.section == "options" && applies(document, setting)) {
      settingRow(context, "sequence/", setting, document.settings, edit,
                 extrasOf(context, setting, static_cast<double>(mostBones)));
    }
  }
}

/// How far some work is, and a way to stop it.
void progressRow(PanelContext& context, const char* id, const char* what, double share) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const float cancelWidth = theme.px(84.0F);
  const Control place = takePlace(
      widgets, id, {ImGui::GetContentRegionAvail().x - cancelWidth - theme.unit(), theme.rowHeight()}, false);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(place.box.min, place.box.max, theme.colours.sunken, theme.corner());
  list->AddRectFilled(place.box.min,
                      {place.box.min.x + static_cast<float>(share) * place.box.width(), place.box.max.y},
                      theme.colours.accentQuiet, theme.corner());
  drawText(widgets, theme.fonts.label, place.box, theme.colours.text,
           fmt::format("{} {:.0f} %", what, 100.0 * share), 0.5F);
  ImGui::SameLine();
  commandButton(context, {.command = command::sequenceCancel, .text = "Cancel", .width = cancelWidth});
}

void compressRow(PanelContext& context) {
  verticalSpace(widgetsOf(context), 4.0F);
  if (context.sequence().isCompressing()) {
    progressRow(context, "sequence/progress", "Compressing", context.sequence().compressedShare());
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
  const app::SequenceSession& session = context.sequence();
  const auto source = static_cast<double>(skinning::sourceBytesPerFrame(*session.document().mesh));
  const std::shared_ptr<const app::ExportedClip> clip = session.clip();
  if (clip == nullptr) {
    const std::string state = session.isEncoding()
                                  ? fmt::format("encoding {:.0f} %", 100.0 * session.encodedShare())
                                  : "not encoded";
    const Help help{"Not known yet", "The result is encoded beside the window, at the latest by Export.", {}};
    valueRow(widgets, "Frame", state, help);
    valueRow(widgets, "Once", state, help);
    return;
  }
  const double bytes = clip->clip.bytesPerFrame;
  valueRow(widgets, "Frame",
           bytes > 0.0 ? fmt::format("{:.4g} bytes, 1 : {:.3g}", bytes, source / bytes) : "nothing moves",
           {"Bytes per frame",
            fmt::format("All that a client needs for each frame, instead of {:.0f} bytes of "
                        "positions.",
                        source),
            {}});
  const std::size_t once = clip->clip.bytesOnce + clip->clip.bytesOfJson;
  valueRow(widgets, "Once", fmt::format("{:.4g} kB", static_cast<double>(once) / 1000.0),
           {"Bytes once",
            fmt::format("Mesh, weights, images and {} bytes of JSON, whatever the number of frames.",
                        clip->clip.bytesOfJson),
            {}});
}

/// How the clip is written; it is encoded again beside the window.
void encodingRows(PanelContext& context) {
  using skinning::EncodeSettings;
  const EncodeSettings encoding = context.sequence().document().encoding; // a copy: rows edit it
  const auto edit = [&](const EditPhase& phase, const std::string& label,
                        const std::function<void(EncodeSettings&)>& change) {
    editSequence(context, phase, label, [&](app::SequenceDocument& changed) { change(changed.encoding); });
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
            "Over all frames and vertices, in percent of the box diagonal of the first frame "
            "that has an extent.",
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

void exportRow(PanelContext& context) {
  const app::SequenceSession& session = context.sequence();
  if (session.isExporting()) {
    progressRow(context, "sequence/export-progress", "Exporting", session.exportedShare());
    return;
  }
  const bool isLong = session.document().encoding.keyTolerancePercent > 0.0; // All else is done at once.
  if (session.isEncoding() && isLong) {
    progressRow(context, "sequence/encode-progress", "Encoding", session.encodedShare());
  }
  commandButton(context,
                {.command = command::fileExportClean,
                 .icon = icon::save,
                 .text = "Export",
                 .emphasis = app::isOutdated(session.document()) ? Emphasis::normal : Emphasis::primary,
                 .width = ImGui::GetContentRegionAvail().x});
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
  exportRow(context);
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
