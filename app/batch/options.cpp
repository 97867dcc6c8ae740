#include "app/batch/options.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>

#include <fmt/core.h>
#include <unistd.h>

#include "app/edits/body/limb_edits.h"
#include "app/edits/keys/rate_edits.h"
#include "app/files/save.h"
#include "app/named.h"
#include "app/schema/parse_text.h"
#include "app/sequence/open_any.h"
#include "core/anim/frames.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/gltf/json/json.h"
#include "rig/body/locators/locator_plans.h"
#include "rig/plan/body_plan.h"
#include "skinning/sequence/mesh_file.h"

namespace stretch::app {

namespace {

constexpr double slowestRate = 0.01; // frames per second
constexpr double fastestRate = 10000.0;

} // namespace

void addFileArguments(CommandLine& line, FileArguments& arguments) {
  line.option("FILE", arguments.file, "A .glb, .gltf, .vrm, .fbx, .bvh or .dae file").required();
  addTolerant(line, arguments);
}

void addPlan(CommandLine& line, FileArguments& arguments) {
  line.option(
          "--plan", arguments.plan,
          "Body plan to read the character as: " + rig::planIds() +
              "; default: as found. Limbs of other bodies than a biped's start from settings of their own "
              "(docs/body_plans.md)")
      .check([](const std::string& text) {
        return rig::planNamed(text) != nullptr
                   ? std::string()
                   : "'" + text + "' is no body plan; give one of: " + rig::planIds();
      });
}

DeclaredOption addLocatorPlan(CommandLine& line, std::string& plan) {
  return line
      .option("--plan", plan,
              "What kind of body a mesh without a skeleton is: whose locators are fitted; default: as its "
              "shape shows (docs/from_a_mesh.md)")
      .oneOf(rig::locatorPlanIds());
}

void addTolerant(CommandLine& line, FileArguments& arguments) {
  line.flag("--tolerant", arguments.tolerant,
            "Take a file that breaks the specification as well as it can be read");
}

DeclaredOption addClip(CommandLine& line, FileArguments& arguments) {
  return line.option("--clip", arguments.clip, "Name or #index of the clip; default: the first");
}

DeclaredOption addClipArguments(CommandLine& line, FileArguments& arguments) {
  const DeclaredOption clip = addClip(line, arguments);
  addFrameRate(
      line, arguments.framesPerSecond,
      "Frames per second to count in; default: as the file was worked on, else guessed from the keys");
  return clip;
}

void addFrameRate(CommandLine& line, double& framesPerSecond, const std::string& help) {
  line.option("--fps", framesPerSecond, help).check([](const std::string& text) {
    const std::optional<double> given = stretch::parseNumber(text);
    return given && *given >= slowestRate && *given <= fastestRate
               ? std::string()
               : fmt::format("'{}' is not possible; give a number from {:g} to {:g}", text, slowestRate,
                             fastestRate);
  });
}

void JsonOutput::print(const gltf::Json& report) const {
  std::cout << report.dump(oneLine ? -1 : 1, ' ', false, gltf::Json::error_handler_t::replace) << '\n';
}

void addJson(CommandLine& line, JsonOutput& json) {
  line.flag("--json", json.wanted, "Print one JSON document");
  line.flag("--json-line", json.oneLine, "The same in one line, for logs of many files");
}

bool isSequence(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path path(file);
  return std::filesystem::is_directory(path, ignored) ? holdsSequence(path) : namesSequence({path});
}

Result<Document> openDocument(const FileArguments& arguments) {
  if (isSequence(arguments.file)) {
    const bool isMesh = skinning::isMeshFile(arguments.file);
    return Error{
        isMesh ? "is read as a frame of a sequence of meshes, and not as a character"
               : "is a sequence of meshes, no character with joints",
        arguments.file,
        isMesh ? "save the mesh as .glb, or make a skinned clip of its sequence by compress, and give that"
               : "make a skinned clip of it by compress, and give that"};
  }
  Result<Document> document =
      openDocument(arguments.file, arguments.tolerant ? gltf::Tolerance::warn : gltf::Tolerance::refuse,
                   arguments.pictures);
  if (document && !arguments.plan.empty()) {
    document = changePlan(*document, arguments.plan);
  }
  if (document && arguments.framesPerSecond > 0.0) {
    setFramesPerSecond(*document, arguments.framesPerSecond);
  }
  return document ? std::move(document) : inFile(arguments.file, document.error());
}

Result<int> clipOfArguments(const FileArguments& arguments, const Document& document) {
  return findClip(document, arguments.clip, "--clip");
}

Result<Recipe> loadRecipe(const std::string& path, const FileArguments& arguments, Document& document) {
  if (arguments.clip.empty()) {
    return loadRecipe(path, document);
  }
  const Result<int> clip = clipOfArguments(arguments, document);
  return clip ? loadRecipe(path, document, *clip) : Result<Recipe>(clip.error());
}

Result<skinning::SegmentModuli> loadModuli(const std::string& path) {
  const Result<std::string> text = readText(path);
  return text ? skinning::parseModuli(*text) : Result<skinning::SegmentModuli>(text.error());
}

Status checkModuli(const std::vector<skinning::SegmentModuli::Range>& moduli, std::size_t bones,
                   const std::string& where) {
  for (const skinning::SegmentModuli::Range& range : moduli) {
    if (range.last >= bones) {
      return Error{fmt::format("names bone {}, and the last one is {}", range.last, bones - 1), where,
                   "count bones from 0"};
    }
  }
  return Success{};
}

Error inFile(Error error, const std::string& file) {
  error.where = error.where.empty() ? file : error.where;
  return error;
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

skinning::Proceed terminalProgress(const std::string& doing) {
  if (isatty(STDERR_FILENO) == 0) {
    return {};
  }
  return [doing](double share) {
    fmt::print(stderr, "\r{}: {:.0f} %{}", doing, 100.0 * share, share < 1.0 ? "" : "\r\033[K");
    std::fflush(stderr);
    return true;
  };
}

} // namespace stretch::app
