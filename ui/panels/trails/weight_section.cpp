#include "ui/panels/trails/trail_sections.h"

#include <algorithm>
#include <functional>

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/weight_edits.h"
#include "app/schema/weight_schema.h"
#include "app/weight/report.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

using app::WeightedLimb;
using app::WeightSettings;
using Change = std::function<void(WeightSettings&)>;

void editWeight(PanelContext& context, const EditPhase& phase, const std::string& label,
                const Change& change) {
  const int clip = context.character().view().clip;
  const std::vector<std::string> limbs = app::targetLimbs(context.character());
  editThrough(context, phase, label, [&](const app::Document& start) -> Result<app::Document> {
    app::Document document = start;
    for (const std::string& limb : limbs) {
      const WeightedLimb* const present = app::findWeight(start, limb, clip);
      if (present == nullptr) {
        continue;
      }
      WeightedLimb entry = *present;
      change(entry.settings);
      Result<app::Document> changed = app::setWeight(document, entry);
      if (!changed) {
        return changed;
      }
      document = std::move(changed).value();
    }
    return document;
  });
}

/// Every described setting. While the modulus is left to the program, its row shows what that chose.
void schemaRows(PanelContext& context, const WeightSettings& settings, double usedModulus) {
  const auto edit = [&](const EditPhase& phase, const std::string& label, const Change& change) {
    editWeight(context, phase, label, change);
  };
  for (const app::Setting<WeightSettings>& setting : app::weightSchema()) {
    RowExtras extras;
    if (setting.kind == app::SettingKind::optionalNumber) {
      extras.automatic = usedModulus;
      extras.maximum = std::max(*setting.row.maximum, 3.0 * usedModulus);
    }
    settingRow(context, "weight/", setting, settings, edit, extras);
  }
}

void setBoneModulus(std::size_t bone, std::optional<double> young, WeightSettings& settings) {
  std::vector<skinning::SegmentModuli::Range> kept;
  for (const skinning::SegmentModuli::Range& range : settings.moduli) {
    // A range over several bones is taken apart, so that one of them can change alone.
    for (std::size_t i = range.first; i <= range.last && i < range.first + 64; ++i) {
      if (i != bone) {
        kept.push_back({i, i, range.youngModulus});
      }
    }
  }
  if (young) {
    kept.push_back({bone, bone, *young});
  }
  settings.moduli = std::move(kept);
}

void boneRows(PanelContext& context, const WeightedLimb& entry, double used) {
  const WidgetContext widgets = widgetsOf(context);
  const rig::Limb* const limb = app::findLimb(context.character().document(), entry.limb);
  if (limb == nullptr) {
    return;
  }
  // Copies: a row that is dragged puts another document in the place of this one.
  const std::vector<NodeIndex> joints = limb->joints;
  const std::shared_ptr<const Scene> scene = context.character().document().scene;
  const app::SettingFacts& young = *app::findSetting(app::weightSchema(), "young");
  const double most = std::max(*young.row.maximum, 3.0 * used);
  skinning::SegmentModuli moduli;
  moduli.ranges = entry.settings.moduli;
  for (std::size_t bone = 0; bone < joints.size(); ++bone) {
    const std::string name = nodeName(*scene, joints[bone]);
    const Help help{name, "Modulus of this bone alone; reset in its menu gives it the limb's own.", {}};
    labelledRow(widgets, name, help);
    double value = moduli.at(bone, used);
    const EditPhase phase = numberSlider(context, "weight/bone-" + std::to_string(bone), young, help,
                                         {.maximum = most, .standard = used}, value);
    editWeight(context, phase, "Change a bone's modulus", [&](WeightSettings& s) {
      setBoneModulus(bone, value == used ? std::nullopt : std::optional<double>(value), s);
    });
  }
}

void rangeRow(PanelContext& context, const WeightSettings& settings) {
  const WidgetContext widgets = widgetsOf(context);
  const double last = app::lastFrame(context.character().document(), context.character().view().clip);
  const Help help{"Range", "First and last frame with weight; inside the clip it fades in and out.", {}};
  labelledRow(widgets, "Range", help);
  const Vec2 range = settings.rangeFrames.value_or(Vec2(0.0, last));
  const auto set = [&](const EditPhase& phase, const Vec2& wanted) {
    editWeight(context, phase, "Change the range of the weight", [&](WeightSettings& s) {
      const bool whole = wanted.x <= 0.0 && wanted.y >= last;
      s.rangeFrames = whole ? std::nullopt : std::optional<Vec2>(wanted);
    });
  };
  SliderSpec spec{.id = "weight/range-start",
                  .maximum = last,
                  .step = 1.0,
                  .decimals = 0,
                  .defaultValue = 0.0,
                  .showsFill = false,
                  .width = columnWidth(2)};
  spec.help = dragHelp({"First frame", help.text, {}});
  double start = range.x;
  const EditPhase first = slider(widgets, spec, start);
  set(first, {std::min(start, range.y - 1.0), range.y});
  ImGui::SameLine();
  spec.id = "weight/range-end";
  spec.defaultValue = last;
  spec.help = dragHelp({"Last frame", help.text, {}});
  double end = range.y;
  const EditPhase second = slider(widgets, spec, end);
  set(second, {range.x, std::max(end, range.x + 1.0)});
}

const app::WeightReport* reportOf(PanelContext& context, const std::string& limbId) {
  const std::vector<app::WeightReport>& reports = context.character().weightReports();
  const auto found =
      std::ranges::find_if(reports, [&](const app::WeightReport& report) { return report.limb == limbId; });
  return found == reports.end() ? nullptr : &*found;
}

void outcomeRows(PanelContext& context, const app::WeightReport& report) {
  const WidgetContext widgets = widgetsOf(context);
  valueRow(widgets, "Length",
           fmt::format("\xC3\x97{:.3f} to \xC3\x97{:.3f}", report.shortest, report.longest),
           {.title = "Shortest and longest",
            .text = fmt::format("Along its bones, at frames {:.0f} and {:.0f}.", report.shortestFrame,
                                report.longestFrame)});
  for (const std::string& warning : report.warnings) {
    notice(widgets, NoticeKind::warning, warning);
  }
}

void weightSettings(PanelContext& context, const WeightedLimb& entry) {
  const app::WeightReport* const report = reportOf(context, entry.limb);
  if (report != nullptr) {
    const app::WeightReport shown = *report; // a copy: the rows change what it was made from
    outcomeRows(context, shown);
    schemaRows(context, entry.settings, shown.youngModulus);
    boneRows(context, entry, shown.youngModulus);
    rangeRow(context, entry.settings);
  }
  commandButton(context, {.command = command::weightRemove,
                          .text = "Take the weight away",
                          .emphasis = Emphasis::quiet,
                          .width = ImGui::GetContentRegionAvail().x});
}

} // namespace

void weightSection(PanelContext& context, const std::string& limbId) {
  const WidgetContext widgets = widgetsOf(context);
  if (!section(widgets, "weight/section", "Weight", context.ui.closedSections)) {
    return;
  }
  const WeightedLimb* const present =
      app::findWeight(context.character().document(), limbId, context.character().view().clip);
  const bool on = present != nullptr && present->on;
  const Help help{"Weight",
                  "The limb sags, squashes when it lands and stretches when it swings, by its own load. "
                  "Seen at once, and saved with the clip.",
                  {}};
  labelledRow(widgets, "Weight", help);
  if (toggle(widgets, "weight/on", on ? "On" : "Off", on, help)) {
    request(context, command::weightToggle);
  }
  if (on) {
    const WeightedLimb entry = *present; // a copy: rows edit the document while the others are drawn
    weightSettings(context, entry);
  }
}

} // namespace stretch::ui
