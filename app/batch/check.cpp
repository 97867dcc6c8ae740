#include <algorithm>
#include <memory>

#include <fmt/core.h>

#include "app/batch/extension_report.h"
#include "app/batch/options.h"
#include "app/batch/verb.h"
#include "app/forecast/clip_changes.h"
#include "app/forecast/forecast.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/report.h"

namespace stretch::app {

namespace {

using gltf::Json;

std::string_view severityName(gltf::Severity severity) {
  switch (severity) {
  case gltf::Severity::error:
    return "error";
  case gltf::Severity::violation:
    return "violation";
  case gltf::Severity::warning:
    break;
  }
  return "warning";
}

struct CheckArguments {
  std::string file;
  std::string engines;
  std::string before;
  JsonOutput json;
};

Json forecastJson(const std::vector<EngineForecast>& forecasts) {
  Json list = Json::array();
  for (const EngineForecast& one : forecasts) {
    Json findings = Json::array();
    for (const ForecastFinding& finding : one.findings) {
      Json json = {{"id", finding.id},     {"severity", severityName(finding.severity)},
                   {"clip", finding.clip}, {"limb", finding.limb},
                   {"what", finding.what}, {"remedy", finding.remedy}};
      json["frame"] = finding.frame ? Json(*finding.frame) : Json();
      json["share"] = finding.share ? Json(*finding.share) : Json();
      findings.push_back(std::move(json));
    }
    list.push_back({{"engine", one.engine}, {"findings", findings}, {"not_judged", one.notJudged}});
  }
  return list;
}

void printForecast(const Json& forecasts) {
  for (const Json& one : forecasts) {
    for (const Json& finding : one["findings"]) {
      const auto text = [&](const char* key) { return finding[key].get<std::string>(); };
      fmt::print("{} {}{}: {}; {} [{}]\n", one["engine"].get<std::string>(), text("severity"),
                 text("clip").empty() ? "" : " in '" + text("clip") + "'", text("what"), text("remedy"),
                 text("id"));
    }
    std::string subjects;
    for (const Json& subject : one["not_judged"]) {
      subjects += (subjects.empty() ? "" : ", ") + subject.get<std::string>();
    }
    fmt::print("{}: {} finding{}; not judged: {}\n", one["engine"].get<std::string>(), one["findings"].size(),
               one["findings"].size() == 1 ? "" : "s", subjects.empty() ? "nothing" : subjects);
  }
}

// Adds what engines make of the file, and what is worse than in the one it was made from.
Status addComparisons(const CheckArguments& arguments, Json& report) {
  if (arguments.engines.empty() && arguments.before.empty()) {
    return Success{};
  }
  const Result<Document> document = openAsItStands(arguments.file);
  if (!document) {
    return document.error();
  }
  if (!arguments.engines.empty()) {
    const Result<std::vector<std::string>> ids = engineIdsOf(arguments.engines);
    report["engines"] = ids ? forecastJson(forecast(*document, *ids)) : Json::array();
  }
  if (!arguments.before.empty()) {
    const Result<Document> source = openAsItStands(arguments.before);
    if (!source) {
      return source.error();
    }
    const Result<FileChanges> changes = worseThanFile(*document, *source);
    if (!changes) {
      return changes.error();
    }
    report["worse"] = changesToJson(changes->worse);
    report["compared_clips"] = changes->compared;
    report["clips_not_compared"] = {{"in_file", changes->added}, {"in_source", changes->gone}};
  }
  return Success{};
}

std::string quotedNames(const Json& names) {
  std::string text;
  for (const Json& name : names) {
    text += (text.empty() ? "'" : ", '") + name.get<std::string>() + "'";
  }
  return text;
}

// Tells what is worse than in the file from before, and of which clips this is said.
void printComparison(const CheckArguments& arguments, const Json& report) {
  if (!report.contains("worse")) {
    return;
  }
  printChanges(report["worse"]);
  fmt::print("before {} clips compared: {}; {}\n", report["compared_clips"].size(),
             quotedNames(report["compared_clips"]),
             report["worse"].empty() ? "nothing is worse" : fmt::format("{} worse", report["worse"].size()));
  for (const auto& [list, file] :
       {std::pair("in_file", &arguments.file), std::pair("in_source", &arguments.before)}) {
    if (const Json& names = report["clips_not_compared"][list]; !names.empty()) {
      fmt::print("before not compared, in {} alone: {}\n", *file, quotedNames(names));
    }
  }
}

bool hasProblem(const gltf::Diagnosis& diagnosis, gltf::Severity severity) {
  return std::ranges::any_of(diagnosis.problems,
                             [&](const gltf::Problem& problem) { return problem.severity == severity; });
}

Json diagnosisJson(const gltf::Diagnosis& diagnosis) {
  Json list = Json::array();
  for (const gltf::Problem& problem : diagnosis.problems) {
    list.push_back({{"severity", severityName(problem.severity)},
                    {"where", problem.where},
                    {"what", problem.what},
                    {"remedy", problem.remedy}});
  }
  // Other verbs refuse what breaks the specification, unless --tolerant is given.
  const bool isRefused =
      hasProblem(diagnosis, gltf::Severity::error) || hasProblem(diagnosis, gltf::Severity::violation);
  return {{"extensions", extensionsJson(diagnosis.extensions)}, {"problems", list}, {"refused", isRefused}};
}

void printDiagnosis(const gltf::Diagnosis& diagnosis) {
  for (const Json& extension : extensionsJson(diagnosis.extensions)) {
    fmt::print("{}\n", extensionLine(extension));
  }
  const std::vector<gltf::Problem>& problems = diagnosis.problems;
  for (const gltf::Problem& problem : problems) {
    fmt::print("{}: {}\n", severityName(problem.severity),
               Error{problem.what, problem.where, problem.remedy}.line());
  }
  fmt::print("{} problem{} found\n", problems.size(), problems.size() == 1 ? "" : "s");
  if (hasProblem(diagnosis, gltf::Severity::violation) && !hasProblem(diagnosis, gltf::Severity::error)) {
    fmt::print("the other verbs refuse this file as it is: --tolerant takes it as well as it can be read\n");
  }
}

Status runCheck(const CheckArguments& arguments) {
  const gltf::Diagnosis diagnosis = gltf::diagnose(arguments.file);
  Json report = diagnosisJson(diagnosis);
  Status compared =
      hasProblem(diagnosis, gltf::Severity::error) ? Status(Success{}) : addComparisons(arguments, report);
  if (!compared) {
    return compared;
  }
  if (arguments.json) {
    arguments.json.print(report);
  } else {
    printDiagnosis(diagnosis);
    printForecast(report.value("engines", Json::array()));
    printComparison(arguments, report);
  }
  const std::vector<gltf::Problem>& problems = diagnosis.problems;
  const auto error = std::find_if(problems.begin(), problems.end(), [](const gltf::Problem& problem) {
    return problem.severity == gltf::Severity::error;
  });
  if (error == problems.end()) {
    return Success{};
  }
  return inFile(arguments.file, Error{error->what, error->where, error->remedy});
}

} // namespace

Verb checkVerb() {
  return {
      "check",
      "Reports every problem of a file, residual shear of stretched files included, and its extensions; on "
      "request what engines make of it, and what an edit made worse.",
      [](CommandLine& line) {
        const auto arguments = std::make_shared<CheckArguments>();
        line.examples({"punch.glb", "punch.glb --engine all", "punch.glb --before dummy.glb"});
        line.option("FILE", arguments->file, "A .glb, .gltf, .vrm, .fbx, .bvh or .dae file").required();
        line.option("--engine", arguments->engines,
                    "Forecasts what engines show: all, or some of three,godot,babylon,unity-generic,"
                    "unity-humanoid,unreal,roblox (docs/engines.md)")
            .check([](const std::string& text) {
              const Result<std::vector<std::string>> ids = engineIdsOf(text);
              return ids ? std::string() : withoutPlace(ids.error());
            });
        line.option("--before", arguments->before,
                    "The file that this one was made from: tells what is worse than there");
        addJson(line, arguments->json);
        return [arguments] { return runCheck(*arguments); };
      }};
}

} // namespace stretch::app
