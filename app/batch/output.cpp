#include "app/batch/output.h"

#include <algorithm>
#include <numeric>

#include <fmt/core.h>

#include "app/evaluate/cache.h"
#include "app/forecast/clip_changes.h"
#include "app/schema/form_schema.h"
#include "core/gltf/patch/edits.h"

namespace stretch::app {

namespace {

using gltf::Json;

Result<SaveOptions> saveOptionsOf(const OutputArguments& arguments) {
  SaveOptions options = arguments.save;
  if (Status set = setFromTexts(formSchema(), arguments.form, options.form); !set) {
    return set.error();
  }
  if (arguments.keepsSkeleton) {
    options.form.form = StretchForm::translation;
  }
  if (arguments.keysEveryFrame) {
    options.form.keys = rig::KeyPlaces::everyFrame;
  }
  const Setting<SavedForm>& influences = *findSetting(formSchema(), "influences");
  if (textOf(arguments.form, influences) != nullptr && options.form.form != StretchForm::volume) {
    return Error{"counts with --form volume alone", influences.option, "add --form volume, or leave it out"};
  }
  return options;
}

// The arguments that count together, whatever is saved.
Status checkForm(const OutputArguments& arguments) {
  const auto isGiven = [&](const char* setting) {
    return textOf(arguments.form, *findSetting(formSchema(), setting)) != nullptr;
  };
  if (arguments.keepsSkeleton && isGiven("form")) {
    return Error{"stands beside --form", "--keep-skeleton", "give one of the two"};
  }
  if (arguments.keysEveryFrame && isGiven("key_frames")) {
    return Error{"stands beside --key-frames", "--key-every-frame", "give one of the two"};
  }
  const Result<SaveOptions> options = saveOptionsOf(arguments);
  return options ? Status(Success{}) : Status(options.error());
}

Json formJson(const SaveOptions& options, const rig::CornerFit& fit) {
  Json json = {{"form", findSetting(formSchema(), "form")->read(options.form)}};
  if (options.form.form == StretchForm::translation) {
    json["keeps_thickness"] = true;
  }
  if (options.form.form == StretchForm::volume) {
    json["influences"] = options.form.influences;
    json["joints"] = fit.joints;
    json["corners"] = fit.corners;
    json["vertices"] = fit.vertices;
    json["fitted_vertices"] = fit.fitted;
    json["miss_percent_of_height"] = {{"median", 100.0 * fit.median},
                                      {"percentile_99", 100.0 * fit.percentile99},
                                      {"worst", 100.0 * fit.worst}};
  }
  return json;
}

std::size_t keysOf(const std::vector<Track>& tracks) {
  return std::accumulate(tracks.begin(), tracks.end(), std::size_t(0),
                         [](std::size_t sum, const Track& track) { return sum + track.times.size(); });
}

// Keys of the tracks that are written, beside those that the source has in them.
Json keyCountsOf(const Document& document, const std::vector<gltf::ClipTracks>& clips) {
  std::size_t before = 0;
  std::size_t after = 0;
  for (const gltf::ClipTracks& clip : clips) {
    after += keysOf(clip.tracks);
    for (const Track& track : clip.tracks) {
      const Clip& source = sourceClipOf(document, clip.clip);
      const int own = findTrack(source, track.node, track.channel);
      before += own < 0 ? 0 : source.tracks[static_cast<std::size_t>(own)]->times.size();
    }
  }
  return {{"before", before}, {"after", after}};
}

} // namespace

void addOutputArguments(CommandLine& line, OutputArguments& arguments) {
  addOutputFile(line, arguments.file, "The .glb or .gltf to write");
  constexpr const char* heading = "What is written";
  addSettingOptions(line, formSchema(), arguments.form, heading);
  line.flag("--keep-skeleton", arguments.keepsSkeleton, "Another word for --form translation").group(heading);
  line.flag("--key-every-frame", arguments.keysEveryFrame, "Another word for --key-frames every")
      .group(heading);
  line.flag("--clean", arguments.save.clean, "Leave the program's own data out of the file");
  line.checkTogether([&arguments](const CommandLine&) { return checkForm(arguments); });
}

Status saveReported(const Document& document, const OutputArguments& arguments, Json& report) {
  EvaluationCache cache;
  return saveReported(document, arguments, report, cache);
}

Status saveReported(const Document& document, const OutputArguments& arguments, Json& report,
                    EvaluationCache& cache) {
  const Result<SaveOptions> options = saveOptionsOf(arguments);
  if (!options) {
    return options.error();
  }
  const SavedEdits saved = editsOf(document, *options, cache);
  if (options->form.form != StretchForm::scale) {
    report["form"] = formJson(*options, saved.fit);
  }
  if (saved.missOfHeight > 0.0 || options->form.keys == rig::KeyPlaces::wholeFrames) {
    report["whole_frames"] = {{"miss_percent_of_height", 100.0 * saved.missOfHeight}};
  }
  std::vector<std::pair<int, std::vector<Track>>> edited;
  for (const gltf::ClipTracks& clip : saved.edits.clips) {
    edited.emplace_back(clip.clip, clip.tracks);
  }
  if (!edited.empty()) {
    report["key_counts"] = keyCountsOf(document, saved.edits.clips);
  }
  if (const std::vector<ClipChange> worse = worseThanSource(document, edited, cache); !worse.empty()) {
    report["worse"] = changesToJson(worse);
  }
  for (const std::string& line : besideLines(*document.source, arguments.file.path)) {
    report["warnings"].push_back(line);
  }
  return saveEdits(document, saved.edits, arguments.file.path);
}

void printSaved(const Json& report) {
  printChanges(report.contains("worse") ? report["worse"] : Json::array());
  if (report.contains("key_counts")) {
    const Json& counts = report["key_counts"];
    fmt::print("keys   {} in the tracks that were changed, {} before\n", counts["after"].get<int>(),
               counts["before"].get<int>());
  }
  if (report.contains("whole_frames")) {
    fmt::print("keys   on whole frames and where a range or its way back ends: between them the motion is at "
               "most {:.3f} % of the height off\n",
               report["whole_frames"]["miss_percent_of_height"].get<double>());
  }
  if (!report.contains("form")) {
    return;
  }
  const Json& form = report["form"];
  if (form.contains("keeps_thickness")) {
    fmt::print("form   translation: limbs keep their thickness, and no volume of a trail is written\n");
  }
  if (!form.contains("vertices")) {
    return;
  }
  const Json& miss = form["miss_percent_of_height"];
  fmt::print("form   volume: {} corners of {} joints move {} vertices; ", form["corners"].get<int>(),
             form["joints"].get<int>(), form["vertices"].get<int>());
  fmt::print("{} fitted to {} influences: off by {:.3f} % of the height in the middle, {:.3f} % at the 99th "
             "percentile, {:.3f} % at worst\n",
             form["fitted_vertices"].get<int>(), form["influences"].get<int>(), miss["median"].get<double>(),
             miss["percentile_99"].get<double>(), miss["worst"].get<double>());
}

} // namespace stretch::app
