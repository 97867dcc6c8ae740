#include "app/batch/options.h"

#include "app/edits/rate_edits.h"
#include "app/files/save.h"
#include "app/named.h"
#include "app/schema/parse_text.h"
#include "app/sequence/open_any.h"
#include "core/base/file.h"
#include "core/gltf/json.h"

namespace stretch::app {

void addFileArguments(CommandLine& line, FileArguments& arguments) {
  line.option("FILE", arguments.file, "A .glb, .gltf or .vrm file").required();
  line.flag("--tolerant", arguments.tolerant,
            "Take a file that breaks the specification as well as it can be read");
}

void addClipArguments(CommandLine& line, FileArguments& arguments) {
  line.option("--clip", arguments.clip, "Name or #index of the clip; default: the first");
  line.option("--fps", arguments.framesPerSecond,
              "Frames per second to count in; default: as the file was worked on, else guessed from the keys")
      .positive();
}

void addOutputArguments(CommandLine& line, OutputArguments& arguments) {
  line.option("-o,--output", arguments.file, "The .glb or .gltf to write").required();
  line.flag("--key-every-frame", arguments.save.keyEveryFrame, "A key on every frame that is changed");
  line.flag("--keep-skeleton", arguments.save.keepSkeleton,
            "Stretch through translations only: no bind joints");
  line.flag("--clean", arguments.save.clean, "Leave the program's own data out of the file");
}

void addJson(CommandLine& line, bool& json) {
  line.flag("--json", json, "Print one JSON document");
}

bool isSequence(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path path(file);
  return std::filesystem::is_directory(path, ignored) ? holdsSequence(path) : namesSequence({path});
}

Result<Document> openDocument(const FileArguments& arguments) {
  if (isSequence(arguments.file)) {
    return Error{"is a sequence of meshes, no character with joints", arguments.file,
                 "make a skinned clip of it by compress, and give that"};
  }
  Result<Document> document =
      openDocument(arguments.file, arguments.tolerant ? gltf::Tolerance::warn : gltf::Tolerance::refuse);
  if (document && arguments.framesPerSecond > 0.0) {
    setFramesPerSecond(*document, arguments.framesPerSecond);
  }
  if (document || document.error().where == arguments.file) {
    return document;
  }
  Error error = document.error();
  error.where = arguments.file + (error.where.empty() ? "" : ": ") + error.where;
  return error;
}

Result<int> clipOfArguments(const FileArguments& arguments, const Document& document) {
  return findClip(document, arguments.clip, "--clip");
}

Result<skinning::SegmentModuli> loadModuli(const std::string& path) {
  const Result<std::string> text = readText(path);
  return text ? skinning::parseModuli(*text) : Result<skinning::SegmentModuli>(text.error());
}

std::string withoutPlace(Error error) {
  error.where.clear();
  return error.line();
}

std::string problemOfRange(const std::string& text) {
  const Result<Vec2> range = parseRange(text, "--range");
  if (!range) {
    return withoutPlace(range.error());
  }
  return range->x < range->y ? "" : "the range " + text + " has no length; give a last frame after the first";
}

void addSettingOption(CommandLine& line, const SettingFacts& setting, SettingTexts& texts,
                      const std::string& heading) {
  if (setting.kind == SettingKind::flag) {
    line.flag(setting.option, texts.flags[setting.option], optionHelp(setting)).group(heading);
    return;
  }
  line.option(setting.option, texts.values[setting.option], optionHelp(setting))
      .check([setting](const std::string& text) {
        const Result<gltf::Json> value = valueOfText(setting, text);
        return value ? std::string() : withoutPlace(value.error());
      })
      .group(heading);
}

const std::string* textOf(const SettingTexts& texts, const SettingFacts& setting) {
  static const std::string given;
  const auto flag = texts.flags.find(setting.option);
  if (flag != texts.flags.end()) {
    return flag->second ? &given : nullptr;
  }
  const auto value = texts.values.find(setting.option);
  return value == texts.values.end() || value->second.empty() ? nullptr : &value->second;
}

} // namespace stretch::app
