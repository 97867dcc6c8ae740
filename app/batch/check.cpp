#include <algorithm>
#include <memory>

#include <fmt/core.h>

#include "app/batch/extension_report.h"
#include "app/batch/options.h"
#include "app/batch/verb.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/report.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct CheckArguments {
  std::string file;
  JsonOutput json;
};

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

Json diagnosisJson(const gltf::Diagnosis& diagnosis) {
  Json list = Json::array();
  for (const gltf::Problem& problem : diagnosis.problems) {
    list.push_back({{"severity", severityName(problem.severity)},
                    {"where", problem.where},
                    {"what", problem.what},
                    {"remedy", problem.remedy}});
  }
  return {{"extensions", extensionsJson(diagnosis.extensions)}, {"problems", list}};
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
}

Status runCheck(const CheckArguments& arguments) {
  const gltf::Diagnosis diagnosis = gltf::diagnose(arguments.file);
  arguments.json ? arguments.json.print(diagnosisJson(diagnosis)) : printDiagnosis(diagnosis);
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
  return {"check",
          "Reports every problem of a file, residual shear of stretched files included, and its extensions.",
          [](CommandLine& line) {
            const auto arguments = std::make_shared<CheckArguments>();
            line.examples({"punch.glb"});
            line.option("FILE", arguments->file, "A .glb, .gltf, .vrm, .fbx, .bvh or .dae file").required();
            addJson(line, arguments->json);
            return [arguments] { return runCheck(*arguments); };
          }};
}

} // namespace stretch::app
