#include "app/schema/style_schema.h"

#include <array>

#include "app/schema/schema_json.h"
#include "app/schema/schema_rows.h"
#include "app/schema/trail_schema.h"

namespace stretch::app {

namespace {

using gltf::Json;
using rig::ScaleRange;
using rig::Style;

constexpr int styleVersion = 1;

struct Kind {
  const char* name;
  const char* limbs;
  ScaleRange Style::*range;
};

constexpr std::array<Kind, 4> kinds{{{"arm", "an arm", &Style::arm},
                                     {"leg", "a leg", &Style::leg},
                                     {"torso", "spine or neck", &Style::torso},
                                     {"other", "a tail, wing, fin, feeler or chain", &Style::other}}};

Setting<Style> scaleSetting(const Kind& kind, const char* suffix, const char* what,
                            double ScaleRange::*member) {
  const std::string name = kind.name;
  return setting<Style>(
      {.name = name + suffix,
       .maximum = rig::largestScale,
       .help = std::string(what) + " scale of " + kind.limbs + ".",
       .row = {.section = "scales", .step = 0.05, .prefix = "\xC3\x97"}},
      [ range = kind.range, member ](auto& style) -> auto& { return style.*range.*member; });
}

Schema<Style> scaleSettings() {
  Schema<Style> schema;
  for (const Kind& kind : kinds) {
    schema.push_back(scaleSetting(kind, "", "Usual", &ScaleRange::usual));
    schema.push_back(scaleSetting(kind, "_least", "Least", &ScaleRange::least));
    schema.push_back(scaleSetting(kind, "_most", "Largest", &ScaleRange::most));
  }
  return schema;
}

Schema<Style> wayOutSettings() {
  return {
      setting<Style>({.name = "axes",
                      .choices = {{"all"}, {"level", "Along the ground alone."}},
                      .help = "Axes along which limbs are exaggerated."},
                     &Style::axes),
      setting<Style>({.name = "reference",
                      .choices = {{"pose"}, {"rest"}},
                      .help = "The length that a scale multiplies."},
                     &Style::reference),
      setting<Style>({.name = "bend",
                      .choices = {{"keep"}, {"straighten"}},
                      .help = "Keep a limb's bend, or straighten it before it stretches."},
                     &Style::bend),
      setting<Style>({.name = "remap",
                      .choices = {{"spline"}, {"linear"}},
                      .help = "Shape of the transition along the path."},
                     &Style::remap),
      setting<Style>({.name = "ease_in",
                      .unit = "fraction,value",
                      .help = "Ease-in: fraction of the path and value there, P,V."},
                     &Style::easeIn),
      setting<Style>({.name = "ease_out",
                      .unit = "fraction,value",
                      .help = "Ease-out: fraction of the path from its end and value there, P,V."},
                     &Style::easeOut),
  };
}

Schema<Style> wayBackSettings() {
  return {
      setting<Style>({.name = "release",
                      .maximum = rig::longestStyleRelease,
                      .unit = "of the range",
                      .help = "Length of the way back to the original motion; default: as a trail finds it."},
                     &Style::release),
      setting<Style>({.name = "overshoot",
                      .maximum = 1.0,
                      .unit = "of the tip's offset",
                      .help = "How far the way back swings past the original."},
                     &Style::overshoot),
      setting<Style>({.name = "volume",
                      .maximum = 1.0,
                      .help = "Volume preservation: 0 keeps the thickness, 1 the volume."},
                     &Style::volume),
  };
}

Schema<Style> spreadAndWeight() {
  return {
      setting<Style>(
          {.name = "spread_limbs",
           .maximum = 1.0,
           .help = "Share of their exaggeration that limbs take which move at the same time as a "
                   "stronger one."},
          [](auto& style) -> auto& { return style.spread.limbs; }),
      setting<Style>(
          {.name = "spread_trunk",
           .maximum = 1.0,
           .help = "Share of its exaggeration with which the spine follows a strike."},
          [](auto& style) -> auto& { return style.spread.trunk; }),
      setting<Style>(
          {.name = "spread_late",
           .maximum = 24.0,
           .unit = "frames of 1/24 s",
           .help = "How much later than the striking limb the spine follows."},
          [](auto& style) -> auto& { return style.spread.lateFrames; }),
      setting<Style>(
          {.name = "weight",
           .maximum = 1.0,
           .help = "How much limbs that move freely give way to their weight; 0: not at all."},
          [](auto& style) -> auto& { return style.weight.amount; }),
      setting<Style>(
          {.name = "weight_stiffness",
           .minimum = 0.01,
           .maximum = 100.0,
           .help = "Stiffness of that weight."},
          [](auto& style) -> auto& { return style.weight.stiffness; }),
      setting<Style>(
          {.name = "weight_damping", .maximum = 10.0, .help = "Damping of that weight: below 1 it wobbles."},
          [](auto& style) -> auto& { return style.weight.damping; }),
  };
}

Schema<Style> withOptions(Schema<Style> schema) {
  for (Setting<Style>& one : schema) {
    one.option.insert(2, "style-");
  }
  return schema;
}

Status readName(const Json& json, std::string& name) {
  if (!json.is_string() || json.get<std::string>().empty() ||
      json.get<std::string>().size() > rig::longestStyleName) {
    return Error{json.dump() + " is not a name", "name", "give 1 to 100 letters"};
  }
  name = json.get<std::string>();
  return Success{};
}

Status readVersion(const Json& json) {
  return json == styleVersion ? Status(Success{})
                              : Status(Error{"this program does not know this version of styles", "version",
                                             "give " + std::to_string(styleVersion)});
}

} // namespace

const Schema<Style>& styleSchema() {
  static const Schema<Style> schema =
      withOptions(joined<Style>({scaleSettings(), wayOutSettings(), wayBackSettings(), spreadAndWeight()}));
  return schema;
}

Json styleToJson(const Style& style) {
  Json json{{"version", styleVersion}, {"name", style.name}};
  writeSettings(styleSchema(), style, json);
  return json;
}

Result<Style> styleFromJson(const Json& json) {
  if (!json.is_object()) {
    return Error{"is not a JSON object", "style", R"(give {"version": 1, "name": "..."} and settings)"};
  }
  Style style;
  Status read = json.contains("version") ? Status(Success{}) : readVersion(nullptr);
  if (read) {
    read = readSettings(json, styleSchema(), style, [&](const std::string& key, const Json& value) {
      return key == "version" ? readVersion(value)
             : key == "name"
                 ? readName(value, style.name)
                 : Status(Error{"is not a setting of a style", key, "remove it, or correct its name"});
    });
  }
  if (read && style.name.empty()) {
    read = readName(nullptr, style.name);
  }
  // As a trail takes them: an older file may hold values beyond the half.
  style.easeIn.value = std::min(style.easeIn.value, easeHalf);
  style.easeOut.value = std::max(style.easeOut.value, easeHalf);
  if (read) {
    read = checkStyle(style);
  }
  return read ? Result<Style>(std::move(style)) : Result<Style>(read.error());
}

Status checkStyle(const Style& style) {
  for (const Kind& kind : kinds) {
    const ScaleRange& range = style.*kind.range;
    if (!(range.least <= range.usual && range.usual <= range.most)) {
      return Error{"its least, usual and largest scale do not rise", kind.name,
                   std::string("give ") + kind.name + "_least, " + kind.name + " and " + kind.name +
                       "_most in this order"};
    }
  }
  if (Status eases = checkEases(style.easeIn, style.easeOut); !eases) {
    return eases;
  }
  return checkSettings(styleSchema(), style);
}

} // namespace stretch::app
