#include "app/batch/trail_options.h"

#include <algorithm>
#include <set>

#include "app/batch/options.h"
#include "app/edits/trail/starting_settings.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/clip_moments.h"
#include "app/named.h"
#include "app/schema/parse_text.h"
#include "app/schema/trail_schema.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

Status setSettings(const TrailRequest& request, rig::TrailSettings& settings) {
  for (const auto& [option, text] : request.settings) {
    for (const Setting<rig::TrailSettings>& setting : trailSchema()) {
      Status set = setting.option == option ? setFromText(setting, text, settings) : Status(Success{});
      if (!set) {
        return set;
      }
    }
  }
  if (settings.space == rig::TrailSpace::view) {
    return Error{"counts along the axes of a view, and no option gives one", "--space view",
                 "give world, root or base, or a recipe with \"view_axes\""};
  }
  return Success{};
}

Result<rig::Limb> limbOf(const TrailRequest& request, Document& document) {
  Result<rig::Limb> limb = findOrAddLimb(document, request.limb, "--limb");
  const bool namesScale =
      std::ranges::any_of(request.settings, [](const auto& named) { return named.first == "--scale"; });
  if (limb && !namesScale) {
    return Error{"has no scale", "--limb " + request.limb, "say how long it becomes, such as --scale 2"};
  }
  return limb;
}

Result<rig::Trail> trailOf(const TrailRequest& request, int clip, Document& document) {
  const Result<rig::Limb> limb = limbOf(request, document);
  if (!limb) {
    return limb.error();
  }
  const Result<Vec2> range =
      request.range.empty() ? defaultRange(document, clip, *limb) : parseRange(request.range, "--range");
  if (!range) {
    return range.error();
  }
  rig::Trail trail;
  trail.limb = limb->id;
  trail.clip = clip;
  trail.settings = startingTrail(document, clip, *limb, *range);
  const Status set = setSettings(request, trail.settings);
  return set ? Result<rig::Trail>(std::move(trail)) : Result<rig::Trail>(set.error());
}

} // namespace

std::vector<TrailRequest> requestsOf(const CommandLine& line) {
  TrailRequest common;
  std::vector<TrailRequest> requests;
  for (const auto& [name, text] : line.inOrder()) {
    if (name == "--limb") {
      requests.push_back(common);
      requests.back().limb = text;
      continue;
    }
    TrailRequest& request = requests.empty() ? common : requests.back();
    if (name == "--range") {
      request.range = text;
    } else {
      request.settings.emplace_back(name, text); // options of the verb itself are no setting's
    }
  }
  return requests;
}

std::vector<std::string> trailOptionsOf(const CommandLine& line) {
  std::vector<std::string> options;
  for (const auto& given : line.inOrder()) {
    const std::string& name = given.first;
    const bool isSetting =
        std::ranges::any_of(trailSchema(), [&](const auto& setting) { return name == setting.option; });
    if (isSetting || name == "--limb" || name == "--range") {
      options.push_back(name);
    }
  }
  return options;
}

Status checkTrailOptions(const CommandLine& line) {
  std::set<std::string> given;
  for (const std::string& option : trailOptionsOf(line)) {
    if (option == "--limb") {
      given.clear();
    } else if (!given.insert(option).second) {
      return Error{"is given twice for one limb", option, "leave one out, or start the next trail by --limb"};
    }
  }
  return Success{};
}

Status checkRequests(const std::vector<TrailRequest>& requests, const Document& document) {
  Document tried = document;
  for (const TrailRequest& request : requests) {
    if (const Result<rig::Limb> limb = limbOf(request, tried); !limb) {
      return limb.error();
    }
  }
  return Success{};
}

Result<Recipe> recipeOf(const std::vector<TrailRequest>& requests, int clip, Document& document) {
  Recipe recipe;
  recipe.clip = clip;
  for (const TrailRequest& request : requests) {
    Result<rig::Trail> trail = trailOf(request, clip, document);
    if (!trail) {
      return trail.error();
    }
    trail->colour = static_cast<int>(recipe.trails.size()) % dealtColours;
    recipe.trails.push_back(std::move(*trail));
  }
  return recipe;
}

void addTrailOptions(CommandLine& line) {
  constexpr const char* heading = "Trail (each --limb starts the next)";
  line.ordered("--limb", limbWords).group(heading);
  line.ordered("--range", "First and last frame, A:B; default: the limb's strongest stroke")
      .check(problemOfRange)
      .group(heading);
  for (const Setting<rig::TrailSettings>& setting : trailSchema()) {
    if (setting.kind == SettingKind::flag) {
      line.orderedFlag(setting.option, optionHelp(setting)).group(heading);
      continue;
    }
    line.ordered(setting.option, optionHelp(setting))
        .check([&setting](const std::string& text) {
          const Result<gltf::Json> value = valueOfText(setting, text);
          return value ? std::string() : withoutPlace(value.error());
        })
        .group(heading);
  }
}

} // namespace stretch::app
