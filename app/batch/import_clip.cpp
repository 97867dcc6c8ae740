#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/batch/output.h"
#include "app/batch/output_file.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/edits/keys/import_clip.h"
#include "app/schema/import_schema.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct ImportArguments {
  FileArguments input;
  OutputArguments output;
  std::string from; // OTHER or OTHER#clip
  std::string fromClip;
  std::string name;
  SettingTexts settings;
  JsonOutput json;
};

// "other.glb#walk" is the clip walk of other.glb, unless there is a file of that very name. Files and clips
// may have a # in their names: the mark is the first one that a file stands before, else the first.
ClipRequest requestOf(const ImportArguments& arguments) {
  ClipRequest request{arguments.from, arguments.fromClip, arguments.name, {}};
  const auto isThere = [&](std::size_t length) {
    std::error_code ignored;
    return std::filesystem::exists(arguments.from.substr(0, length), ignored);
  };
  const std::size_t first = arguments.from.find('#');
  std::size_t mark = first;
  while (mark != std::string::npos && !isThere(mark)) {
    mark = arguments.from.find('#', mark + 1);
  }
  mark = mark == std::string::npos ? first : mark;
  if (mark != std::string::npos && !isThere(std::string::npos)) {
    request.file = arguments.from.substr(0, mark);
    request.clip = arguments.from.substr(mark + 1);
  }
  return request;
}

Json clipJson(const Clip& clip, const NewClip& brought) {
  Json json{{"name", clip.name},
            {"from", brought.from},
            {"way", brought.isRetargeted ? "retargeted" : "copied"},
            {"seconds", clip.endSeconds},
            {"frames", frameCount(clip)},
            {"keys", keyCount(clip)},
            {"fps", clip.framesPerSecond},
            {"left_out", brought.left}};
  if (brought.report) {
    json["report"] = reportToJson(*brought.report);
    json["figures"] = reportLines(*brought.report);
  }
  return json;
}

Json reportOf(const Document& document, const NewClips& brought) {
  Json report{{"clips", Json::array()}, {"warnings", document.body.warnings}};
  for (const std::string& warning : brought.warnings) {
    report["warnings"].push_back(warning);
  }
  const std::size_t first = document.clips->size() - brought.clips.size();
  for (std::size_t i = 0; i < brought.clips.size(); ++i) {
    report["clips"].push_back(clipJson((*document.clips)[first + i], brought.clips[i]));
  }
  return report;
}

void printReport(const Json& report) {
  for (const Json& clip : report["clips"]) {
    fmt::print("clip   {}: {} from {}, {:.3f} s, {} keys\n", clip["name"].get<std::string>(),
               clip["way"].get<std::string>(), clip["from"].get<std::string>(), clip["seconds"].get<double>(),
               clip["keys"].get<int>());
    for (const Json& line : clip.value("figures", Json::array())) {
      fmt::print("       {}\n", line.get<std::string>());
    }
  }
  printWarnings(report["warnings"]);
}

Status runImport(const ImportArguments& arguments) {
  ClipRequest request = requestOf(arguments);
  if (Status set = setFromTexts(importSchema(), arguments.settings, request.settings); !set) {
    return set;
  }
  if (Status apart = checkOutput(arguments.output.file, {arguments.input.file, request.file.string()});
      !apart) {
    return apart;
  }
  if (!arguments.fromClip.empty() && request.clip != arguments.fromClip) {
    return Error{"names a clip beside the one of --from", "--from-clip", "give one of the two"};
  }
  const Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Result<NewClips> brought = clipsFromFile(*document, request);
  if (!brought) {
    return brought.error();
  }
  std::vector<Clip> clips;
  for (const NewClip& clip : brought->clips) {
    clips.push_back(clip.clip);
  }
  const Result<Document> changed = withNewClips(*document, clips);
  if (!changed) {
    return changed.error();
  }
  Json report = reportOf(*changed, *brought);
  if (Status saved = saveReported(*changed, arguments.output, report); !saved) {
    return saved;
  }
  if (arguments.json) {
    arguments.json.print(report);
  } else {
    printReport(report);
    printSaved(report);
  }
  return Success{};
}

} // namespace

Verb importClipVerb() {
  return {"import-clip",
          "Adds clips of another file to a character: copied where the skeleton is the same, else retargeted "
          "by limbs.",
          [](CommandLine& line) {
            const auto arguments = std::make_shared<ImportArguments>();
            line.examples({"knight.glb -o dancing.glb --from dance.glb",
                           "knight.glb -o walking.glb --from 'human.glb#Walk'",
                           "knight.glb -o waving.glb --from hello.vrma --name hello",
                           "knight.glb -o walking.glb --from walking.fbx"});
            addFileArguments(line, arguments->input);
            addOutputArguments(line, arguments->output);
            line.option("--from", arguments->from,
                        "The other file (.glb, .gltf, .vrm, .vrma, .fbx, .bvh, .dae), or FILE#CLIP for one "
                        "of its clips")
                .required();
            line.option("--from-clip", arguments->fromClip,
                        "The one clip that is wanted, by name or #index; else all of them");
            line.option("--name", arguments->name, "What the one clip is to be called");
            addSettingOptions(line, importSchema(), arguments->settings, "Retargeting");
            addJson(line, arguments->json);
            return [arguments] { return runImport(*arguments); };
          }};
}

} // namespace stretch::app
