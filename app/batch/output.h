#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/batch/options.h"
#include "app/batch/output_file.h"
#include "app/files/save.h"

namespace stretch::app {

class EvaluationCache;

/// Arguments of a verb that writes a character file.
struct OutputArguments {
  OutputFile file;
  SaveOptions save; ///< All but the form.
  SettingTexts form;
  bool keepsSkeleton = false;
  bool keysEveryFrame = false;
};

/// Declares -o, --in-place, the options of formSchema, their other words, and --clean.
void addOutputArguments(CommandLine& line, OutputArguments& arguments);

/// Writes the document, and adds to the report of the verb what the form cost, where that is not the scale of
/// leaves, what keys on whole frames alone miss ("whole_frames"), and what is worse than in the source
/// ("worse", left out where nothing is). Files beside the output are among its warnings.
[[nodiscard]] Status saveReported(const Document& document, const OutputArguments& arguments,
                                  gltf::Json& report);
/// Likewise; what `cache` remembers of the document's motion is not worked out again.
[[nodiscard]] Status saveReported(const Document& document, const OutputArguments& arguments,
                                  gltf::Json& report, EvaluationCache& cache);

/// Prints what saveReported added, as lines of text.
void printSaved(const gltf::Json& report);

} // namespace stretch::app
