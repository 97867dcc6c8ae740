#include <memory>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/batch/output_file.h"
#include "app/batch/verb.h"
#include "app/edits/trail/style_edits.h"
#include "app/files/user_styles.h"
#include "app/schema/style_schema.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct StylesArguments {
  std::string style;
  FileArguments taken; ///< File whose clip a style is taken from; empty: none.
  std::string name;
  OutputFile output{.endings = {".json"}};
  JsonOutput json;
};

Result<rig::Style> wantedStyle(const StylesArguments& arguments) {
  if (arguments.taken.file.empty()) {
    return findStyle(arguments.style, stylesFolder());
  }
  const Result<Document> document = openDocument(arguments.taken);
  const Result<int> clip =
      document ? clipOfArguments(arguments.taken, *document) : Result<int>(document.error());
  return clip ? styleOfClip(*document, *clip, arguments.name) : Result<rig::Style>(clip.error());
}

void printStyle(const rig::Style& style) {
  fmt::print("{} ({})\n", style.name, rig::originName(style.origin));
  for (const Setting<rig::Style>& setting : styleSchema()) {
    fmt::print("  {}: {}\n", setting.name, setting.read(style).dump());
  }
}

Status listStyles(const StylesArguments& arguments) {
  Json list = Json::array();
  for (const rig::Style& style : allStyles(stylesFolder())) {
    list.push_back({{"name", style.name}, {"origin", rig::originName(style.origin)}});
    if (!arguments.json) {
      fmt::print("{} ({})\n", style.name, rig::originName(style.origin));
    }
  }
  if (arguments.json) {
    arguments.json.print(list);
  }
  return Success{};
}

// The arguments that count together.
Status checkWays(const StylesArguments& arguments) {
  const bool lists = arguments.style.empty() && arguments.taken.file.empty();
  if (lists && !arguments.output.path.empty()) {
    return Error{"says no style", "-o", "give --style or --take as well"};
  }
  if (!arguments.style.empty() && !arguments.taken.file.empty()) {
    return Error{"stands beside --take", "--style", "give one of them"};
  }
  if (arguments.taken.file.empty() && !(arguments.name.empty() && arguments.taken.clip.empty())) {
    return Error{"says how a style is taken", arguments.name.empty() ? "--clip" : "--name",
                 "give --take as well"};
  }
  return checkName(arguments.output);
}

Status runStyles(const StylesArguments& arguments) {
  if (arguments.style.empty() && arguments.taken.file.empty()) {
    return listStyles(arguments);
  }
  if (Status apart = checkOutput(arguments.output, {arguments.style, arguments.taken.file}); !apart) {
    return apart;
  }
  const Result<rig::Style> style = wantedStyle(arguments);
  if (!style) {
    return style.error();
  }
  if (arguments.json) {
    arguments.json.print(styleToJson(*style));
  } else {
    printStyle(*style);
  }
  return arguments.output.path.empty() ? Status(Success{}) : saveStyle(*style, arguments.output.path);
}

} // namespace

Verb stylesVerb() {
  return {"styles", "Lists the styles, writes one as a file, or takes one from the trails of a clip.",
          [](CommandLine& line) {
            const auto arguments = std::make_shared<StylesArguments>();
            line.examples({"", "--style \"Rubber hose\" -o hose.json",
                           "--take punch.glb --clip Punch --name \"My punch\" -o punch-style.json"});
            line.option("--style", arguments->style, "A style by name, or a file of one (.json)");
            line.option("--take", arguments->taken.file,
                        "A file whose clip has trails: their settings become a style");
            line.option("--name", arguments->name,
                        "With --take: what the style is called; default: as the clip");
            addTolerant(line, arguments->taken);
            addPlan(line, arguments->taken);
            addClip(line, arguments->taken);
            line.option("-o,--output", arguments->output.path, "The .json to write the style to");
            addJson(line, arguments->json);
            line.checkTogether([arguments](const CommandLine&) { return checkWays(*arguments); });
            return [arguments] { return runStyles(*arguments); };
          }};
}

} // namespace stretch::app
