#include <memory>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "app/batch/options.h"
#include "app/batch/output.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/files/save.h"
#include "app/locators/build_rig.h"
#include "app/locators/fit_locators.h"
#include "app/schema/locator_json.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "rig/plan/body_plan.h"

namespace stretch::app {

namespace {

struct RigArguments {
  FileArguments input;
  OutputFile output;
  std::string locators;
  std::string plan;
  bool locatorsOnly = false;
  JsonOutput json;
};

Result<FittedLocators> locatorsOf(const RigArguments& arguments, const Document& document) {
  if (arguments.locators.empty()) {
    return fitLocators(document, arguments.plan);
  }
  Result<rig::Locators> given = loadLocators(arguments.locators);
  return given ? Result<FittedLocators>(FittedLocators{std::move(*given), document.body.isBiped, {}})
               : Result<FittedLocators>(given.error());
}

Result<Document> rigged(const RigArguments& arguments, const Document& document,
                        const FittedLocators& fitted) {
  if (!fitted.isOfSkeleton) {
    return withRigAt(document, fitted.locators);
  }
  if (arguments.locators.empty()) {
    return Error{"the file has a skeleton already, and no joint is made", arguments.input.file,
                 "write its locators with --locators-only, move some and give them back with --locators"};
  }
  return withLimbsAt(document, fitted.locators);
}

void report(const RigArguments& arguments, const FittedLocators& fitted, const Document* document) {
  const std::vector<std::string> unsure = unsureLocators(fitted.locators);
  std::vector<std::string> limbs;
  if (document != nullptr) {
    for (const rig::Limb& limb : document->body.limbs) {
      limbs.push_back(limb.id);
    }
  }
  gltf::Json warnings = fitted.warnings;
  if (document != nullptr) {
    for (const std::string& line : besideLines(*document->source, arguments.output.path)) {
      warnings.push_back(line);
    }
  }
  printWarnings(warnings);
  if (arguments.json) {
    arguments.json.print(
        {{"plan", fitted.locators.plan},
         {"from", fitted.isOfSkeleton ? "skeleton" : "mesh"},
         {"locators", fitted.locators.list.size()},
         {"joints", document == nullptr || fitted.isOfSkeleton ? 0 : fitted.locators.list.size()},
         {"limbs", limbs},
         {"unsure", unsure},
         {"warnings", std::move(warnings)}});
    return;
  }
  fmt::print("{} locators of {}{}\n", fitted.locators.list.size(),
             rig::planNamed(fitted.locators.plan)->title,
             fitted.isOfSkeleton ? ", at the limbs of its skeleton" : "");
  if (!unsure.empty()) {
    fmt::print("unsure: {}\n", fmt::join(unsure, ", "));
  }
  if (document != nullptr) {
    fmt::print("limbs: {}\n", fmt::join(limbs, ", "));
  }
}

OutputFile outputOf(const RigArguments& arguments) {
  OutputFile output = arguments.output;
  output.endings = arguments.locatorsOnly ? std::vector<std::string>{".json"} : OutputFile().endings;
  return output;
}

Status runRig(const RigArguments& arguments) {
  if (Status apart = checkOutput(outputOf(arguments), {arguments.input.file, arguments.locators}); !apart) {
    return apart;
  }
  const Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Result<FittedLocators> fitted = locatorsOf(arguments, *document);
  if (!fitted) {
    return inFile(fitted.error(), arguments.input.file);
  }
  if (arguments.locatorsOnly) {
    Status written = writeText(arguments.output.path, locatorsToJson(fitted->locators).dump(2) + "\n");
    if (written) {
      report(arguments, *fitted, nullptr);
    }
    return written;
  }
  const Result<Document> built = rigged(arguments, *document, *fitted);
  if (!built) {
    return inFile(built.error(), arguments.input.file);
  }
  Status saved = saveDocument(*built, arguments.output.path, {});
  if (saved) {
    report(arguments, *fitted, &*built);
  }
  return saved;
}

} // namespace

Verb rigVerb() {
  return {"rig", "Fits locators to a mesh without a skeleton and makes joints at them.",
          [](CommandLine& line) {
            const auto arguments = std::make_shared<RigArguments>();
            line.examples({"statue.glb -o places.json --locators-only",
                           "statue.glb -o rigged.glb --locators places.json"});
            addFileArguments(line, arguments->input);
            arguments->output.endings = {}; // which depend on what is written
            addOutputFile(line, arguments->output,
                          "The .glb or .gltf to write, or the JSON file of --locators-only");
            const DeclaredOption locators = line.option(
                "--locators", arguments->locators,
                "Where the joints are (JSON, as --locators-only writes it) instead of the fitted places");
            addLocatorPlan(line, arguments->plan).excludes(locators);
            line.flag("--locators-only", arguments->locatorsOnly, "Write the locators and make no joint");
            addJson(line, arguments->json);
            line.checkTogether([arguments](const CommandLine&) { return checkName(outputOf(*arguments)); });
            return [arguments] { return runRig(*arguments); };
          }};
}

} // namespace stretch::app
