#include "app/commands/pose/step_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/commands/pose/hold_text.h"
#include "app/commands/table/selection.h"
#include "app/schema/sequence_schema.h"
#include "app/schema/trail_schema.h"
#include "app/schema/weight_schema.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

using gltf::Json;

/// "3", "0.25", "24.5".
std::string plainNumber(double value) {
  return fmt::format("{:g}", std::round(100.0 * value) / 100.0);
}

/// As panels show it: "×3", "50 %", "12 frames", "off".
std::string shownValue(const SettingFacts& setting, const Json& value) {
  if (value.is_null()) {
    return "automatic";
  }
  if (value.is_boolean()) {
    return value.get<bool>() ? "on" : "off";
  }
  if (value.is_string()) {
    return value.get<std::string>().empty() ? "none" : value.get<std::string>();
  }
  if (!value.is_number()) {
    return {};
  }
  const double shown = value.get<double>() * setting.row.shownFactor * (setting.row.percent ? 100.0 : 1.0);
  const std::string& unit = setting.row.shownUnit.empty() ? setting.unit : setting.row.shownUnit;
  const std::string suffix = setting.row.percent ? " %" : unit.empty() ? "" : " " + unit;
  return setting.row.prefix + plainNumber(shown) + suffix;
}

/// The value of the one setting that differs; empty where several do.
template <typename Settings>
std::string changedValue(const Schema<Settings>& schema, const Settings& before, const Settings& after) {
  std::string text;
  int differ = 0;
  for (const Setting<Settings>& setting : schema) {
    const Json value = setting.read(after);
    if (value != setting.read(before)) {
      text = shownValue(setting, value);
      ++differ;
    }
  }
  return differ == 1 ? text : std::string();
}

std::string rangeOfTrail(const rig::TrailSettings& settings) {
  return plainNumber(settings.startFrame) + " to " + plainNumber(settings.endFrame);
}

/// The frame of the one sphere that differs: " at frame 24"; empty for several.
std::string changedSphere(const rig::TrailSettings& before, const rig::TrailSettings& after) {
  std::vector<double> frames;
  const auto collect = [&](const rig::TrailSettings& of, const rig::TrailSettings& other) {
    for (const rig::SphereOffset& sphere : of.spheres) {
      const bool isSame =
          std::find(other.spheres.begin(), other.spheres.end(), sphere) != other.spheres.end();
      const bool isKnown = std::find(frames.begin(), frames.end(), sphere.frame) != frames.end();
      if (!isSame && !isKnown) {
        frames.push_back(sphere.frame);
      }
    }
  };
  collect(after, before);
  collect(before, after);
  return frames.size() == 1 ? "at frame " + plainNumber(frames.front()) : std::string();
}

/// What became of a trail that was there before.
std::string valueOfChange(const rig::Trail& before, const rig::Trail& after) {
  const rig::TrailSettings& settings = after.settings;
  if (after.exaggerated && !before.exaggerated) {
    return "\xC3\x97" + plainNumber(settings.scale);
  }
  if (settings.startFrame != before.settings.startFrame || settings.endFrame != before.settings.endFrame) {
    return rangeOfTrail(settings);
  }
  const std::string value = changedValue(trailSchema(), before.settings, settings);
  return value.empty() ? changedSphere(before.settings, settings) : value;
}

std::string valueOfNew(const rig::Trail& trail) {
  return trail.exaggerated ? "\xC3\x97" + plainNumber(trail.settings.scale) : rangeOfTrail(trail.settings);
}

/// What an edit did to trails, weight and controllers.
struct Changes {
  std::vector<std::string> names; ///< Of the limbs or trails, each once.
  std::vector<std::string> values;
  const char* noun = "limbs";

  void add(const std::string& name, const std::string& value) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
    }
    values.push_back(value);
  }
};

void addTrailChanges(const Document& before, const Document& after, Changes& changes) {
  for (const rig::Trail& trail : after.trails) {
    const rig::Trail* const old = findTrail(before, trail.id);
    if (old == nullptr) {
      changes.add(trailTitle(after, trail), valueOfNew(trail));
    } else if (*old != trail) {
      changes.add(trailTitle(after, trail), valueOfChange(*old, trail));
    }
  }
  for (const rig::Trail& trail : before.trails) {
    if (findTrail(after, trail.id) == nullptr) {
      changes.add(trailTitle(before, trail), rangeOfTrail(trail.settings));
    }
  }
}

void addWeightChanges(const Document& before, const Document& after, Changes& changes) {
  for (const WeightedLimb& entry : after.weights) {
    const WeightedLimb* const old = findWeight(before, entry.limb, entry.clip);
    if (old == nullptr || !(*old == entry)) {
      changes.add(limbTitle(after, entry.limb),
                  old == nullptr ? "" : changedValue(weightSchema(), old->settings, entry.settings));
    }
  }
  for (const WeightedLimb& entry : before.weights) {
    if (findWeight(after, entry.limb, entry.clip) == nullptr) {
      changes.add(limbTitle(before, entry.limb), "");
    }
  }
}

/// The keys of a controller or an attribute in all clips, with what they count in.
std::vector<std::pair<int, rig::OffsetKey>> keysOf(const Document& document, const std::string& id) {
  std::vector<std::pair<int, rig::OffsetKey>> keys;
  for (const rig::Adjustment& adjustment : document.adjustments) {
    for (const rig::OffsetKey& key : adjustment.keys) {
      if (adjustment.controller == id) {
        keys.emplace_back(adjustment.clip, key);
      }
    }
  }
  return keys;
}

/// "at frame 12" where one key differs, the frames of a range that is another; empty for more.
std::string changedKey(const Document& before, const Document& after, const std::string& id) {
  const auto old = keysOf(before, id);
  const auto now = keysOf(after, id);
  std::set<double> frames;
  const auto collect = [&](const auto& of, const auto& other) {
    for (const auto& key : of) {
      if (std::ranges::find(other, key) == other.end()) {
        frames.insert(key.second.frame);
      }
    }
  };
  collect(now, old);
  collect(old, now);
  return frames.size() == 1 ? "at frame " + plainNumber(*frames.begin()) : std::string();
}

std::vector<rig::Adjustment> adjustmentsOf(const Document& document, const std::string& id) {
  std::vector<rig::Adjustment> found;
  std::ranges::copy_if(document.adjustments, std::back_inserter(found),
                       [&](const rig::Adjustment& adjustment) { return adjustment.controller == id; });
  return found;
}

void addAdjustmentChanges(const Document& before, const Document& after, Changes& changes) {
  std::set<std::string> ids;
  for (const Document* const document : {&before, &after}) {
    for (const rig::Adjustment& adjustment : document->adjustments) {
      ids.insert(adjustment.controller);
    }
  }
  for (const std::string& id : ids) {
    if (adjustmentsOf(before, id) != adjustmentsOf(after, id)) {
      changes.add(controllerTitle(after, id), changedKey(before, after, id));
      changes.noun = "controllers";
    }
  }
}

std::string joinedStep(const std::string& label, const std::string& detail) {
  return detail.empty() ? label : label + " \xE2\x80\x93 " + detail;
}

/// The rate that a clip is worked at since; empty where none changed.
std::string newRate(const Document& before, const Document& after) {
  for (std::size_t i = 0; i < std::min(before.clips->size(), after.clips->size()); ++i) {
    const double rate = after.clips->at(i).framesPerSecond;
    if (rate != before.clips->at(i).framesPerSecond) {
      return plainNumber(rate) + " fps";
    }
  }
  return {};
}

} // namespace

std::string stepText(const std::string& label, const Document& before, const Document& after) {
  if (const std::string rate = newRate(before, after); !rate.empty()) {
    return joinedStep(label, rate); // Frames of trails only count otherwise.
  }
  Changes changes;
  addTrailChanges(before, after, changes);
  addWeightChanges(before, after, changes);
  addAdjustmentChanges(before, after, changes);
  if (changes.names.empty()) {
    return joinedStep(label, holdChangeText(before, after));
  }
  const bool sameValue = std::ranges::all_of(
      changes.values, [&](const std::string& value) { return value == changes.values.front(); });
  const std::string names = changes.names.size() > 3
                                ? fmt::format("{} {}", changes.names.size(), changes.noun)
                                : listed(changes.names);
  const bool isNamed = label.find(names) != std::string::npos || // "Pull the left arm", "Key 4 controllers".
                       label.ends_with(std::string(" ") + changes.noun);
  const std::string value = sameValue ? changes.values.front() : std::string();
  const std::string detail = isNamed ? value : value.empty() ? names : names + " " + value;
  return joinedStep(label, detail);
}

std::string stepText(const std::string& label, const SequenceDocument& before,
                     const SequenceDocument& after) {
  const std::string fit = changedValue(sequenceSchema(), before.settings, after.settings);
  const std::string clip = changedValue(clipSchema(), before.encoding, after.encoding);
  return joinedStep(label, fit.empty() ? clip : fit);
}

} // namespace stretch::app
