#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/batch/command_line.h"
#include "app/document.h"
#include "app/recipe/recipe.h"
#include "app/schema/schema.h"
#include "core/base/result.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/pictures.h"
#include "skinning/elastic/moduli.h"
#include "skinning/fit/alternate.h"

namespace stretch::app {

// Options that several verbs share, declared in one place. What they are read into has to live as long as the
// command line.

inline constexpr const char* limbWords =
    "left-arm, right-arm, left-leg, right-leg, spine, neck, what info lists of another body, "
    "or JOINT_A..JOINT_B";

/// The character file that a verb works on.
struct FileArguments {
  std::string file;
  bool tolerant = false;
  std::string plan = {}; ///< Id of a body plan; empty: as found.
  std::string clip = {};
  double framesPerSecond = 0.0;                      ///< 0: as guessed from the keys.
  gltf::Pictures pictures = gltf::Pictures::headers; ///< Decoded by verbs that draw.
};

/// Declares FILE and --tolerant.
void addFileArguments(CommandLine& line, FileArguments& arguments);

/// Declares --plan, for verbs that ask for limbs.
void addPlan(CommandLine& line, FileArguments& arguments);

/// Declares --plan, for verbs that fit locators.
DeclaredOption addLocatorPlan(CommandLine& line, std::string& plan);

/// Declares --tolerant.
void addTolerant(CommandLine& line, FileArguments& arguments);

/// Declares --clip, which is answered.
DeclaredOption addClip(CommandLine& line, FileArguments& arguments);

/// Declares --clip, which is answered, and --fps, for verbs that work on one clip.
DeclaredOption addClipArguments(CommandLine& line, FileArguments& arguments);

/// Declares --fps.
void addFrameRate(CommandLine& line, double& framesPerSecond, const std::string& help);

/// The report of a verb as JSON, on standard output, which holds nothing else then.
struct JsonOutput {
  bool wanted = false;
  bool oneLine = false; ///< For streams of one document in each line.

  explicit operator bool() const { return wanted || oneLine; }
  void print(const gltf::Json& report) const;
};

/// Declares --json and --json-line.
void addJson(CommandLine& line, JsonOutput& json);

/// Kinds of mesh sequences, for the help of a verb.
inline constexpr const char* sequenceWords = "a folder of OBJ or PLY frames, BASE CACHE (a mesh and its .pc2 "
                                             "or .mdd), an animated glTF, or a Sibernetic "
                                             "folder";

/// Whether the path names a sequence of meshes: a folder of frames, a mesh, a cache.
[[nodiscard]] bool isSequence(const std::string& file);

[[nodiscard]] Result<Document> openDocument(const FileArguments& arguments);

/// Index of the clip that --clip names.
[[nodiscard]] Result<int> clipOfArguments(const FileArguments& arguments, const Document& document);

/// The recipe, for the clip that --clip names, else for the one that it names itself.
[[nodiscard]] Result<Recipe> loadRecipe(const std::string& path, const FileArguments& arguments,
                                        Document& document);

/// Reads a file of moduli; an error names the file.
[[nodiscard]] Result<skinning::SegmentModuli> loadModuli(const std::string& path);

/// Refuses moduli of bones that are not there.
[[nodiscard]] Status checkModuli(const std::vector<skinning::SegmentModuli::Range>& moduli, std::size_t bones,
                                 const std::string& where);

/// Says what is wrong with the text of a range "A:B" that needs a length; empty when nothing is.
[[nodiscard]] std::string problemOfRange(const std::string& text);

/// The error with the file that it is about, where it does not say a place itself.
[[nodiscard]] Error inFile(Error error, const std::string& file);

/// The error as the command line tells it behind the option, which it names itself.
[[nodiscard]] std::string withoutPlace(Error error);

/// Texts given for the settings of a schema: text by option, empty where nothing was.
struct SettingTexts {
  std::map<std::string, std::string> values;
  std::map<std::string, bool> flags;
};

/// Declares the option of one setting. A value that the setting never takes is a wrong argument: found before
/// any file is opened.
void addSettingOption(CommandLine& line, const SettingFacts& setting, SettingTexts& texts,
                      const std::string& heading);

/// The text of a setting's option; null where it was not given.
[[nodiscard]] const std::string* textOf(const SettingTexts& texts, const SettingFacts& setting);

template <typename Settings>
void addSettingOptions(CommandLine& line, const Schema<Settings>& schema, SettingTexts& texts,
                       const std::string& heading) {
  for (const Setting<Settings>& setting : schema) {
    addSettingOption(line, setting, texts, heading);
  }
}

/// Sets what the option's text says; an error names the option.
template <typename Settings>
[[nodiscard]] Status setFromText(const Setting<Settings>& setting, const std::string& text,
                                 Settings& settings) {
  const auto value = valueOfText(setting, text);
  if (!value) {
    return value.error();
  }
  setting.write(*value, settings);
  return Success{};
}

/// Tells how far work is where somebody looks: at a terminal. `doing`: "compressing".
[[nodiscard]] skinning::Proceed terminalProgress(const std::string& doing);

template <typename Settings>
[[nodiscard]] Status setFromTexts(const Schema<Settings>& schema, const SettingTexts& texts,
                                  Settings& settings) {
  for (const Setting<Settings>& setting : schema) {
    const std::string* const text = textOf(texts, setting);
    if (text == nullptr) {
      continue;
    }
    if (Status set = setFromText(setting, *text, settings); !set) {
      return set;
    }
  }
  return Success{};
}

} // namespace stretch::app
