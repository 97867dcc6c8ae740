#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/batch/verb.h"
#include "app/evaluate/clip_moments.h"
#include "app/named.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct MomentsArguments {
  std::vector<std::string> files;
  FileArguments input; ///< All but the file.
  bool allClips = false;
  JsonOutput json;
};

/// The moments of one clip of a file.
struct ClipMoments {
  std::string file;
  std::string clip;
  double framesPerSecond = 0.0;
  std::vector<rig::Moment> moments;
};

Json momentJson(const rig::Moment& moment) {
  return {{"limb", moment.limb},        {"kind", rig::momentKindName(moment.kind)},
          {"start", moment.startFrame}, {"tip", moment.tipFrame},
          {"end", moment.endFrame},     {"strength", moment.strength}};
}

Json clipJson(const ClipMoments& clip) {
  Json json{{"clip", clip.clip}, {"fps", clip.framesPerSecond}, {"moments", Json::array()}};
  for (const rig::Moment& moment : clip.moments) {
    json["moments"].push_back(momentJson(moment));
  }
  return json;
}

/// Those of one file: a clip, or all of them.
Result<std::vector<ClipMoments>> momentsOfFile(const MomentsArguments& arguments, const std::string& file) {
  FileArguments input = arguments.input;
  input.file = file;
  const Result<Document> document = openDocument(input);
  if (!document) {
    return document.error();
  }
  const Result<int> chosen = clipOfArguments(input, *document);
  if (!chosen) {
    return Error{chosen.error().what, file + ": " + chosen.error().where, chosen.error().remedy};
  }
  const int first = arguments.allClips ? 0 : *chosen;
  const int last = arguments.allClips ? static_cast<int>(document->clips->size()) - 1 : *chosen;
  std::vector<ClipMoments> found;
  for (int index = first; index <= last; ++index) {
    const Clip& clip = clipOf(*document, index);
    found.push_back({file, clip.name, clip.framesPerSecond, momentsOf(*document, index)});
  }
  return found;
}

/// One list of all moments, strongest first; each says its file and clip.
Json oneList(const std::vector<ClipMoments>& clips) {
  struct Entry {
    const ClipMoments* clip;
    const rig::Moment* moment;
  };
  std::vector<Entry> entries;
  for (const ClipMoments& clip : clips) {
    for (const rig::Moment& moment : clip.moments) {
      entries.push_back({&clip, &moment});
    }
  }
  std::ranges::stable_sort(entries, std::ranges::greater{},
                           [](const Entry& entry) { return entry.moment->strength; });
  Json list = Json::array();
  for (const Entry& entry : entries) {
    Json json{{"file", entry.clip->file}, {"clip", entry.clip->clip}, {"fps", entry.clip->framesPerSecond}};
    const Json own = momentJson(*entry.moment);
    for (const auto& [key, value] : own.items()) {
      json[key] = value;
    }
    list.push_back(std::move(json));
  }
  return list;
}

void printMoment(const rig::Moment& moment, const std::string& where) {
  fmt::print("{:8.2f}  {:<7}  {:<16} frames {:g} to {:g}{}\n", moment.strength,
             rig::momentKindName(moment.kind), moment.limb, moment.startFrame, moment.endFrame, where);
}

void printClips(const std::vector<ClipMoments>& clips) {
  for (const ClipMoments& clip : clips) {
    fmt::print("clip {}, {:g} fps: {}\n", clip.clip, clip.framesPerSecond,
               clip.moments.empty() ? "no moment" : fmt::format("{} moments", clip.moments.size()));
    for (const rig::Moment& moment : clip.moments) {
      printMoment(moment, "");
    }
  }
}

/// A file of a library that could not be read.
struct LostFile {
  std::string file;
  Error problem;
};

void printReport(const MomentsArguments& arguments, const std::vector<ClipMoments>& clips,
                 const std::vector<LostFile>& lost) {
  const bool isLibrary = arguments.files.size() > 1;
  if (arguments.json) {
    Json list = Json::array();
    for (const ClipMoments& clip : clips) {
      list.push_back(clipJson(clip));
    }
    Json library = isLibrary ? oneList(clips) : Json::array();
    for (const LostFile& one : lost) {
      library.push_back({{"file", one.file}, {"error", one.problem.line()}});
    }
    arguments.json.print(isLibrary ? library : arguments.allClips ? list : list.front());
  } else if (isLibrary) {
    for (const Json& entry : oneList(clips)) {
      fmt::print("{:8.2f}  {:<7}  {:<16} frames {:g} to {:g} of {} in {}\n", entry["strength"].get<double>(),
                 entry["kind"].get<std::string>(), entry["limb"].get<std::string>(),
                 entry["start"].get<double>(), entry["end"].get<double>(), entry["clip"].get<std::string>(),
                 entry["file"].get<std::string>());
    }
  } else {
    printClips(clips);
  }
}

// A file of a library that cannot be read keeps nobody from the others: it is told, in the list too, and
// counts in the end.
Status runMoments(const MomentsArguments& arguments) {
  std::vector<ClipMoments> clips;
  std::vector<LostFile> lost;
  for (const std::string& file : arguments.files) {
    Result<std::vector<ClipMoments>> found = momentsOfFile(arguments, file);
    if (!found) {
      if (!lost.empty()) {
        std::fputs(("stretch-engine: " + lost.back().problem.line() + "\n").c_str(), stderr);
      }
      lost.push_back({file, found.error()});
      continue;
    }
    std::ranges::move(*found, std::back_inserter(clips));
  }
  if (!clips.empty() || (arguments.json && arguments.files.size() > 1)) {
    printReport(arguments, clips, lost);
  }
  return lost.empty() ? Status(Success{}) : Status(lost.back().problem);
}

} // namespace

Verb momentsVerb() {
  return {"moments",
          "Finds where the action is: the strokes, cycles and landings of a clip that are worth "
          "exaggerating, strongest first.",
          [](CommandLine& line) {
            const auto arguments = std::make_shared<MomentsArguments>();
            line.examples({"punch.glb", "knight.glb --all-clips --json", "library/*.glb --json-line"});
            line.options("FILE", arguments->files,
                         "A .glb, .gltf, .vrm, .fbx, .bvh or .dae file; of several one list is made, sorted "
                         "by strength")
                .required();
            addTolerant(line, arguments->input);
            addPlan(line, arguments->input);
            const DeclaredOption clip = addClipArguments(line, arguments->input);
            line.flag("--all-clips", arguments->allClips, "Every clip of a file").excludes(clip);
            addJson(line, arguments->json);
            return [arguments] { return runMoments(*arguments); };
          }};
}

} // namespace stretch::app
