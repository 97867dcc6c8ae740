#include "app/batch/auto_options.h"

#include <algorithm>
#include <numeric>

#include <fmt/core.h>

#include "app/auto/exaggerate_clip.h"
#include "app/batch/trail_report.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/clip_moments.h"
#include "app/evaluate/frame_count.h"
#include "app/files/user_styles.h"
#include "app/named.h"
#include "app/schema/parse_text.h"
#include "app/schema/style_schema.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

using gltf::Json;

constexpr const char* usualStyle = "Average of the six";
constexpr double mostStrength = 2.0;

Result<double> strengthOf(const std::string& text) {
  const Result<double> strength = text.empty() ? Result<double>(1.0) : parseNumber(text, "--strength");
  const bool isOut = strength && !(*strength >= 0.0 && *strength <= mostStrength);
  return isOut ? Result<double>(Error{text + " is no strength", "--strength", "give a number from 0 to 2"})
               : strength;
}

Result<AutoSettings> settingsOf(const AutoArguments& arguments) {
  Result<rig::Style> style =
      findStyle(arguments.style.empty() ? usualStyle : arguments.style, stylesFolder());
  if (!style) {
    return style.error();
  }
  const rig::Style before = *style;
  Status set = setFromTexts(styleSchema(), arguments.settings, *style);
  if (set) {
    set = checkStyle(*style);
  }
  const Result<double> strength = strengthOf(arguments.strength);
  if (!set || !strength) {
    return set ? strength.error() : set.error();
  }
  if (*style != before) {
    style->origin = rig::StyleOrigin::own;
    style->name += ", changed";
  }
  return AutoSettings{std::move(*style), *strength};
}

Result<std::vector<int>> clipsOf(const AutoArguments& arguments, const FileArguments& input,
                                 const Document& document) {
  const Result<int> clip = clipOfArguments(input, document);
  if (!clip) {
    return clip.error();
  }
  std::vector<int> clips{*clip};
  if (arguments.allClips) {
    clips.resize(document.clips->size());
    std::iota(clips.begin(), clips.end(), 0);
  }
  return clips;
}

Json momentJson(const AutoMoment& made) {
  Json json{{"limb", made.moment.limb},         {"kind", rig::momentKindName(made.moment.kind)},
            {"start", made.moment.startFrame},  {"tip", made.moment.tipFrame},
            {"strength", made.moment.strength}, {"exaggerated", made.trailId > 0}};
  if (made.trailId > 0) {
    json["length_scale"] = made.scale;
    json["along_ground"] = made.isLevel;
  }
  if (!made.why.empty()) {
    json["why"] = made.why;
  }
  return json;
}

// The outcome of one clip; the document becomes the changed one, with its trails applied.
Json clipReport(int clip, const AutoSettings& settings, Document& document) {
  AutoClip made = exaggerateClip(document, clip, momentsOf(document, clip), settings);
  for (const int id : made.trailIds) {
    if (Result<Document> applied = applyTrail(made.document, id)) {
      made.document = std::move(*applied);
    }
  }
  document = std::move(made.document);
  Json report = exaggerationJson(document, clip, made.trailIds);
  report["moments"] = Json::array();
  for (const AutoMoment& moment : made.moments) {
    report["moments"].push_back(momentJson(moment));
  }
  report["notes"] = made.notes;
  report["made_loop"] = made.madeLoop;
  return report;
}

std::string momentText(const Json& moment) {
  const bool done = moment["exaggerated"].get<bool>();
  const std::string remark = remarkOn(done, moment.value("along_ground", false), moment.value("why", ""));
  const std::string what =
      done ? fmt::format("scale {:.3g}", moment["length_scale"].get<double>()) : "left out";
  return fmt::format("{}, {} from frame {:g} to {:g}: {}{}", moment["limb"].get<std::string>(),
                     moment["kind"].get<std::string>(), moment["start"].get<double>(),
                     moment["tip"].get<double>(), what, remark.empty() ? "" : ", " + remark);
}

void printClip(const Json& clip) {
  fmt::print("{}:\n", clip["clip"].get<std::string>());
  if (clip["moments"].empty()) {
    fmt::print("  nothing to exaggerate: no limb makes a stroke\n");
  }
  for (const Json& moment : clip["moments"]) {
    fmt::print("  {}\n", momentText(moment));
  }
  for (const Json& note : clip["notes"]) {
    fmt::print("  {}\n", note.get<std::string>());
  }
  if (clip["made_loop"].get<bool>()) {
    fmt::print("  the clip is marked as a loop, so that the way back goes on at its start\n");
  }
  for (const Json& trail : clip["trails"]) {
    printWarnings(trail["warnings"], clip["clip"].get<std::string>());
  }
  if (clip.contains("elastic")) {
    printWeight(clip["elastic"], clip["clip"].get<std::string>());
  }
}

} // namespace

std::string AutoArguments::ownOption() const {
  if (!style.empty() || !strength.empty()) {
    return style.empty() ? "--strength" : "--style";
  }
  const auto setting = std::ranges::find_if(
      styleSchema(), [&](const SettingFacts& one) { return textOf(settings, one) != nullptr; });
  return setting == styleSchema().end() ? std::string() : setting->option;
}

void addAutoOptions(CommandLine& line, AutoArguments& arguments) {
  constexpr const char* heading = "Every moment at once";
  line.flag("--auto", arguments.wanted, "Exaggerates every moment of the clip in a style, instead of --limb")
      .group(heading);
  line.flag("--all-clips", arguments.allClips, "Every clip of the file, instead of --clip").group(heading);
  line.option("--style", arguments.style,
              std::string("With --auto: name of a style or a file of one (.json); default: ") + usualStyle)
      .group(heading);
  line.option("--strength", arguments.strength,
              "With --auto: how much of the style's exaggeration, 0 to 2; default: 1")
      .check([](const std::string& text) {
        const Result<double> strength = strengthOf(text);
        return strength ? std::string() : withoutPlace(strength.error());
      })
      .group(heading);
  addSettingOptions(line, styleSchema(), arguments.settings, "Settings of the style, with --auto");
}

Result<Json> autoExaggerated(const AutoArguments& arguments, const FileArguments& input, Document& document) {
  const Result<AutoSettings> settings = settingsOf(arguments);
  const Result<std::vector<int>> clips =
      settings ? clipsOf(arguments, input, document) : Result<std::vector<int>>(settings.error());
  if (!clips) {
    return clips.error();
  }
  for (const int clip : *clips) {
    if (Status bounded = checkFrameCount(clipOf(document, clip)); !bounded) {
      return bounded.error();
    }
  }
  Json report{{"style", settings->style.name},
              {"origin", rig::originName(settings->style.origin)},
              {"strength", settings->strength},
              {"clips", Json::array()}};
  for (const int clip : *clips) {
    Json one = clipReport(clip, *settings, document);
    one.erase("warnings");
    report["clips"].push_back(std::move(one));
  }
  report["warnings"] = documentWarnings(document);
  return report;
}

void printAuto(const Json& report) {
  for (const Json& clip : report["clips"]) {
    printClip(clip);
  }
  printWarnings(report["warnings"]);
}

} // namespace stretch::app
