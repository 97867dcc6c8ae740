#include <array>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <system_error>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/batch/output_file.h"
#include "app/batch/sequence_report.h"
#include "app/batch/verb.h"
#include "app/schema/sequence_schema.h"
#include "core/base/file.h"
#include "core/base/file_series.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "skinning/body/given_skeleton.h"
#include "skinning/compress/compress.h"
#include "skinning/elastic/moduli.h"
#include "skinning/export/append_frames.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/export/frame_stream.h"

namespace stretch::app {

namespace {

struct CompressArguments {
  std::vector<std::string> sequence;
  std::string clip;
  OutputFile output;
  SettingTexts settings;
  SettingTexts encoding;
  std::string moduli;
  std::string skeleton;
  std::string table;
  std::string stream;
  bool openStream = false;
  std::string append;
  double framesPerSecond = 0.0;
  JsonOutput json;
};

Result<skinning::CompressSettings> settingsOf(const CompressArguments& arguments) {
  skinning::CompressSettings settings;
  if (Status set = setFromTexts(sequenceSchema(), arguments.settings, settings); !set) {
    return set.error();
  }
  if (!arguments.skeleton.empty()) {
    Result<std::vector<skinning::SkinBone>> skeleton = skinning::readSkeleton(arguments.skeleton);
    if (!skeleton) {
      return skeleton.error();
    }
    settings.skeleton = std::move(skeleton).value();
  }
  if (!arguments.moduli.empty()) {
    if (settings.tolerancePercent) {
      return Error{"it names segments of a number of bones that is not known", "--moduli",
                   "give --bones instead of --tolerance"};
    }
    Result<skinning::SegmentModuli> moduli = loadModuli(arguments.moduli);
    if (!moduli) {
      return moduli.error();
    }
    settings.body.moduli = std::move(*moduli);
    if (const Status known = checkModuli(settings.body.moduli.ranges,
                                         static_cast<std::size_t>(settings.bones), arguments.moduli);
        !known) {
      return known.error();
    }
  }
  return settings;
}

Status writeTable(const CompressArguments& arguments, const MeshSequence& sequence,
                  const skinning::CompressedSequence& compressed) {
  if (arguments.table.empty()) {
    return Success{};
  }
  return writeText(arguments.table, curvatureTable(sequence, *compressed.model), MissingFolder::isError);
}

/// A setting that counts where another one has a value alone.
struct Condition {
  const char* setting;
  bool (*counts)(const skinning::CompressSettings&);
  const char* remedy;
};

bool isMeasured(const skinning::CompressSettings& settings) {
  return settings.stretch == skinning::StretchOption::measured;
}

bool isFitted(const skinning::CompressSettings& settings) {
  return settings.weights != skinning::WeightOption::geodesic;
}

constexpr std::array conditions{
    Condition{"scale_limit", isMeasured, "give --stretch measured as well, or leave it out"},
    Condition{"influences", isFitted, "leave out either this or --weights geodesic"}};

/// Refuses options that would do nothing.
Status checkCounts(const CompressArguments& arguments, const skinning::CompressSettings& settings) {
  for (const Condition& condition : conditions) {
    const SettingFacts& setting = *findSetting(sequenceSchema(), condition.setting);
    if (textOf(arguments.settings, setting) != nullptr && !condition.counts(settings)) {
      return Error{"does not count here", setting.option, condition.remedy};
    }
  }
  return Success{};
}

/// Writes the base, and the frames behind each other; adds to the report what they take.
Status writeStream(const CompressArguments& arguments, const skinning::SkinnedSequence& skinned,
                   bool quantise, gltf::Json& report) {
  if (arguments.stream.empty()) {
    return Success{};
  }
  const std::filesystem::path folder(arguments.stream);
  const skinning::FrameStream changing = skinning::streamOf(skinned, quantise);
  const skinning::FrameStream open = skinning::streamOf(skinned, quantise, skinning::StreamCourses::all);
  const skinning::FrameStream& stream = arguments.openStream ? open : changing;
  std::error_code problem;
  std::filesystem::create_directory(folder, problem);
  if (problem) {
    return Error{"the folder cannot be made", arguments.stream, problem.message()};
  }
  if (Status written = writeFile(folder / "frames.bin", stream.frames); !written) {
    return written;
  }
  if (Status saved = gltf::save(stream.base, folder / "base.glb"); !saved) {
    return saved;
  }
  report["stream"] = {{"bytes_per_frame", stream.frameBytes},
                      {"changing_bytes_per_frame", changing.frameBytes},
                      {"open_bytes_per_frame", open.frameBytes},
                      {"base_bytes", std::filesystem::file_size(folder / "base.glb", problem)}};
  return Success{};
}

/// The folder of a stream is made, the one that it is to stand in is not.
Status checkStream(const std::string& folder, const std::vector<std::string>& read) {
  std::error_code missing;
  if (folder.empty() || !std::filesystem::exists(folder, missing)) {
    const std::filesystem::path path(folder);
    const std::string name = (path.has_filename() ? path : path.parent_path()).string();
    return folder.empty() ? Status(Success{}) : checkPlace(name);
  }
  if (!std::filesystem::is_directory(folder, missing)) {
    return Error{"the folder cannot be made", folder, "there is a file of that name: choose another"};
  }
  for (const char* const name : {"base.glb", "frames.bin"}) {
    const std::string file = (std::filesystem::path(folder) / name).string();
    if (Status apart = checkOutput({file, false, {}}, read); !apart) {
      return apart;
    }
  }
  return Success{};
}

/// No file that is written is one that is read, or another one that is written, and all of them can be.
Status checkPlaces(const CompressArguments& arguments) {
  std::vector<std::string> read = arguments.sequence;
  read.push_back(arguments.moduli);
  read.push_back(arguments.skeleton);
  if (Status apart = checkOutput(arguments.output, read); !apart) {
    return apart;
  }
  if (!arguments.table.empty() && arguments.table == arguments.output.path) {
    return Error{"is written twice", arguments.table, "name another file for the table"};
  }
  read.push_back(arguments.output.path);
  if (Status apart = checkOutput({arguments.table, false, {}}, read); !apart) {
    return apart;
  }
  return checkStream(arguments.stream, read);
}

Status compressSequence(const CompressArguments& arguments, const skinning::CompressSettings& settings,
                        const skinning::EncodeSettings& encoding, const MeshSequence& sequence) {
  // Told to the user and nothing else: no result depends on the clock.
  const auto start = std::chrono::steady_clock::now();
  const Result<skinning::CompressedSequence> compressed =
      skinning::compress(sequence, settings, terminalProgress("compressing"));
  if (!compressed) {
    return compressed.error();
  }
  if (!arguments.table.empty() && !compressed->model) {
    return Error{"the body has no centre line, so there is no curvature to write", "--curvature",
                 "leave it out, or give a body without branches"};
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const skinning::EncodedClip encoded = skinning::encodeGltf(compressed->skinned, encoding);
  gltf::Json report = compressionJson(sequence, *compressed, encoded);
  report["seconds"] = seconds;
  if (Status written = writeStream(arguments, compressed->skinned, encoding.quantise, report); !written) {
    return written;
  }
  if (Status written = writeTable(arguments, sequence, *compressed); !written) {
    return written;
  }
  // The clip last: where it stands, everything that was asked for does.
  if (Status saved = gltf::save(encoded.source, arguments.output.path); !saved) {
    return saved;
  }
  if (Status told = addWrittenFile(sequence, arguments.output.path, encoded, report); !told) {
    return told;
  }
  if (arguments.json) {
    arguments.json.print(report);
  } else {
    printCompression(report);
  }
  return Success{};
}

/// The error that frames have to keep to, in percent of the diagonal, where nothing else is asked for.
constexpr double mostErrorOfAppended = 1.0;

/// Adds the frames of the sequence to a stream that is there, fitted to the bones of its base.
Status appendToStream(const CompressArguments& arguments, const skinning::CompressSettings& settings,
                      const skinning::EncodeSettings& encoding, const MeshSequence& sequence) {
  const std::filesystem::path folder(arguments.append);
  Result<Bytes> frames = readFile(folder / "frames.bin");
  if (!frames) {
    return frames.error();
  }
  const auto appended = skinning::framesForStream(folder / "base.glb", sequence, frames->size(),
                                                  settings.tolerancePercent.value_or(mostErrorOfAppended));
  if (!appended) {
    return appended.error();
  }
  frames->insert(frames->end(), appended->bytes.begin(), appended->bytes.end());
  const skinning::EncodedClip encoded = skinning::encodeGltf(appended->skinned, encoding);
  if (Status saved = gltf::save(encoded.source, arguments.output.path); !saved) {
    return saved;
  }
  if (Status written = writeFile(folder / "frames.bin", *frames); !written) {
    return written;
  }
  gltf::Json report{{"frames", sequence.frameCount()},
                    {"first_number", appended->firstNumber},
                    {"bytes_per_frame", appended->frameBytes},
                    {"rmse_percent", appended->metrics.rmsePercent},
                    {"largest_percent", appended->metrics.largestPercent}};
  if (arguments.json) {
    arguments.json.print(report);
  } else {
    fmt::print("{} frames appended, numbers {} to {}, {} bytes each; a client shows them with an error of "
               "{:.4g} %, at most {:.4g} %\n",
               sequence.frameCount(), appended->firstNumber,
               appended->firstNumber + sequence.frameCount() - 1, appended->frameBytes,
               appended->metrics.rmsePercent, appended->metrics.largestPercent);
  }
  return Success{};
}

/// Frames that are appended take everything but their motion from the base.
Status checkAppend(const CompressArguments& arguments) {
  const bool asksForMore = !arguments.stream.empty() || !arguments.skeleton.empty() ||
                           !arguments.moduli.empty() || !arguments.table.empty() || arguments.openStream;
  if (!arguments.append.empty() && asksForMore) {
    return Error{"the bones are those of the stream that is there", "--append",
                 "leave out --stream, --open-stream, --skeleton, --moduli and --curvature"};
  }
  for (const auto& setting : sequenceSchema()) {
    const bool counts = setting.name == "tolerance";
    if (!arguments.append.empty() && !counts && textOf(arguments.settings, setting) != nullptr) {
      return Error{"frames that are appended take their bones from the stream", setting.option,
                   "leave it out, or write a new stream"};
    }
  }
  if (arguments.openStream && arguments.stream.empty()) {
    return Error{"there is no stream to write", "--open-stream", "give --stream FOLDER"};
  }
  return Success{};
}

Status runCompress(const CompressArguments& arguments) {
  if (Status apart = checkPlaces(arguments); !apart) {
    return apart;
  }
  const Result<skinning::CompressSettings> settings = settingsOf(arguments);
  if (!settings) {
    return settings.error();
  }
  if (Status counts = checkCounts(arguments, *settings); !counts) {
    return counts;
  }
  skinning::EncodeSettings encoding;
  if (Status set = setFromTexts(clipSchema(), arguments.encoding, encoding); !set) {
    return set;
  }
  const Result<MeshSequence> sequence =
      readSequenceWords(arguments.sequence, arguments.clip, arguments.framesPerSecond);
  if (!sequence) {
    return sequence.error();
  }
  if (settings->body.firstFittedFrame >= sequence->frameCount()) {
    return Error{fmt::format("{} frames are skipped, and the sequence has {}",
                             settings->body.firstFittedFrame, sequence->frameCount()),
                 "--skip", fmt::format("give at most {}", sequence->frameCount() - 1)};
  }
  return arguments.append.empty() ? compressSequence(arguments, *settings, encoding, *sequence)
                                  : appendToStream(arguments, *settings, encoding, *sequence);
}

} // namespace

Verb compressVerb() {
  return {
      "compress", "Turns a mesh sequence into a small skinned clip.", [](CommandLine& line) {
        const auto arguments = std::make_shared<CompressArguments>();
        line.examples({"worm/ -o worm.glb --bones 30 --quantise",
                       "cloth.obj cloth.mdd -o cloth.glb --stretch measured --tolerance 0.2"});
        line.options("SEQUENCE", arguments->sequence, std::string("A mesh sequence: ") + sequenceWords)
            .required()
            .takes(1, 2);
        addOutputFile(line, arguments->output, "The .glb or .gltf to write");
        addSettingOptions(line, sequenceSchema(), arguments->settings, "Compression");
        addSettingOptions(line, clipSchema(), arguments->encoding, "Clip");
        line.option("--skeleton", arguments->skeleton,
                    "A .glb whose skin's bones are taken: names, parents, places");
        line.option("--moduli", arguments->moduli, "JSON of moduli by segment");
        line.option("--curvature", arguments->table,
                    "CSV to write: curvature and length of the centre line, frame by frame");
        line.option("--stream", arguments->stream,
                    "A folder to write: base.glb, and frames.bin of frames that each say all by themselves");
        line.flag("--open-stream", arguments->openStream,
                  "The frames of --stream say everything of every bone, so that frames of other motion "
                  "can be appended");
        line.option("--append", arguments->append,
                    "A folder that --stream has written: the frames are added to it, fitted to the bones "
                    "of its base; refused where they are off by more than --tolerance (default: 1 %)");
        line.option("--clip", arguments->clip, "Name or #index of the clip of a glTF; default: the first");
        addFrameRate(line, arguments->framesPerSecond, "Frames per second of the clip");
        addJson(line, arguments->json);
        line.checkTogether([arguments](const CommandLine&) { return checkAppend(*arguments); });
        return [arguments] { return runCompress(*arguments); };
      }};
}

} // namespace stretch::app
