#include "ui/panels/trail_sections.h"

#include <algorithm>
#include <functional>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/commands/command_ids.h"
#include "app/commands/frames.h"
#include "app/commands/selection.h"
#include "app/edits/weight_edits.h"
#include "app/schema/weight_schema.h"
#include "app/weight/report.h"
#include "core/gltf/json.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/setting_rows.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

using app::WeightedLimb;
using app::WeightSettings;
using Change = std::function<void(WeightSettings&)>;

constexpr double pascalsShown = 1e-3; // moduli are shown in kPa

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

const WeightSettings& defaults() {
  static const WeightSettings settings;
  return settings;
}

void gravityRow(PanelContext& context, const WeightSettings& settings) {
  const WidgetContext widgets = widgetsOf(context);
  const double size = glm::length(settings.gravity);
  const Vec3 direction = size > 0.0 ? settings.gravity / size : Vec3(0.0, -1.0, 0.0);
  const Help help{"Gravity", "How strongly the limb is pulled down; 0 leaves inertia alone.", {}};
  labelledRow(widgets, "Gravity", help);
  SliderSpec spec{.id = "weight/gravity",
                  .maximum = 30.0,
                  .suffix = " m/s\xC2\xB2",
                  .defaultValue = glm::length(defaults().gravity)};
  spec.hardMaximum = 500.0;
  spec.help = dragHelp(help);
  double value = size;
  const EditPhase phase = slider(widgets, spec, value);
  editWeight(context, phase, "Change the gravity", [&](WeightSettings& s) { s.gravity = value * direction; });
}

SliderSpec modulusSlider(const std::string& id, double used) {
  SliderSpec spec{.id = id,
                  .minimum = 1e3,
                  .maximum = std::max(2e6, 3.0 * used),
                  .step = 1e3,
                  .decimals = 0,
                  .suffix = " kPa",
                  .displayFactor = pascalsShown,
                  .defaultValue = used};
  spec.hardMinimum = 1.0;
  spec.hardMaximum = 1e12;
  return spec;
}

void modulusRow(PanelContext& context, const WeightSettings& settings, double used) {
  const WidgetContext widgets = widgetsOf(context);
  const Help help = settingHelp(*app::findSetting(app::weightSchema(), "young"));
  labelledRow(widgets, "Modulus", help);
  const float width = ImGui::GetContentRegionAvail().x;
  const float autoWidth = context.theme.px(80.0F);
  SliderSpec spec = modulusSlider("weight/young", used);
  spec.width = width - autoWidth;
  spec.help = dragHelp(help);
  double value = used;
  const EditPhase phase = slider(widgets, spec, value);
  editWeight(context, phase, "Change the modulus", [&](WeightSettings& s) { s.youngModulus = value; });
  ImGui::SameLine();
  const bool automatic = !settings.youngModulus;
  if (toggle(widgets, "weight/young-auto", "Auto", automatic,
             {"Automatic modulus",
              "As stiff as lets the limb at rest give way by two and a half percent of its length.",
              {}})) {
    editWeight(context, {true, true}, "Change the modulus", [&](WeightSettings& s) {
      s.youngModulus = automatic ? std::optional<double>(used) : std::nullopt;
    });
  }
}

/// Every described setting; gravity is drawn by its size, the modulus beside what the program chose.
void schemaRows(PanelContext& context, const WeightSettings& settings, double usedModulus) {
  const auto edit = [&](const EditPhase& phase, const std::string& label, const Change& change) {
    editWeight(context, phase, label, change);
  };
  for (const app::Setting<WeightSettings>& setting : app::weightSchema()) {
    if (setting.name == "gravity") {
      gravityRow(context, settings);
    } else if (setting.name == "young") {
      modulusRow(context, settings, usedModulus);
    } else {
      settingRow(context, "weight/", setting, settings, edit);
    }
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
  const app::Document& document = context.character().document();
  const rig::Limb* const limb = app::findLimb(document, entry.limb);
  if (limb == nullptr) {
    return;
  }
  skinning::SegmentModuli moduli;
  moduli.ranges = entry.settings.moduli;
  for (std::size_t bone = 0; bone < limb->joints.size(); ++bone) {
    const std::string name = nodeName(*document.scene, limb->joints[bone]);
    const Help help{name, "Modulus of this bone alone; reset in its menu gives it the limb's own.", {}};
    labelledRow(widgets, name, help);
    SliderSpec spec = modulusSlider("weight/bone-" + std::to_string(bone), used);
    spec.help = dragHelp(help);
    double value = moduli.at(bone, used);
    const EditPhase phase = slider(widgets, spec, value);
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
  const auto found = std::find_if(reports.begin(), reports.end(),
                                  [&](const app::WeightReport& report) { return report.limb == limbId; });
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
