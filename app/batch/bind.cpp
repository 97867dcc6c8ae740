#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/batch/output.h"
#include "app/batch/verb.h"
#include "app/bind/bind_mesh.h"
#include "app/files/save.h"
#include "app/locators/fit_locators.h"
#include "app/schema/locator_json.h"
#include "core/gltf/json/json.h"
#include "core/scene/stray_vertices.h"

namespace stretch::app {

namespace {

struct BindArguments {
  FileArguments input;
  OutputFile output;
  std::string locators;
  std::string plan;
  bool keepJoints = false;
  std::string weights = "volume";
  JsonOutput json;
};

Result<rig::Locators> locatorsFor(const BindArguments& arguments, const Document& document) {
  if (!arguments.locators.empty()) {
    return loadLocators(arguments.locators);
  }
  Result<FittedLocators> fitted = fitLocators(document, arguments.plan);
  if (!fitted) {
    return fitted.error();
  }
  if (fitted->isOfSkeleton) {
    return Error{"the file has a skeleton already", arguments.input.file, "bind to it with --keep-joints"};
  }
  for (const std::string& warning : fitted->warnings) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
  return std::move(fitted->locators);
}

Result<BindRequest> requestOf(const BindArguments& arguments, const Document& document) {
  BindRequest request;
  request.way = arguments.weights == "surface" ? BindWay::surface : BindWay::volume;
  if (!arguments.keepJoints) {
    Result<rig::Locators> locators = locatorsFor(arguments, document);
    if (!locators) {
      return locators.error();
    }
    request.locators = std::move(locators).value();
  }
  return request;
}

gltf::Json reportOf(const Document& document, const BindReport& report, double seconds) {
  gltf::Json limbs = gltf::Json::array();
  for (const rig::Limb& limb : document.body.limbs) {
    limbs.push_back(limb.id);
  }
  return {{"joints", report.joints},
          {"meshes", report.meshes},
          {"vertices", report.vertices},
          {"cubes", report.cubes},
          {"megabytes", static_cast<double>(report.bytes) / 1e6},
          {"seconds", seconds},
          {"limbs", limbs},
          {"warnings", report.warnings}};
}

void printReport(const BindReport& report, double seconds) {
  fmt::print("{} vertices of {} {} follow {} joints; {:.1f} s", report.vertices, report.meshes,
             report.meshes == 1 ? "mesh" : "meshes", report.joints, seconds);
  if (report.cubes > 0) {
    fmt::print(", {} cubes in {:.0f} MB", report.cubes, static_cast<double>(report.bytes) / 1e6);
  }
  fmt::print("\n");
  for (const std::string& warning : report.warnings) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
}

Status runBind(const BindArguments& arguments) {
  if (arguments.keepJoints && !arguments.locators.empty()) {
    return Error{"joints are either kept or made", "--keep-joints", "leave it or --locators out"};
  }
  if (Status apart = checkOutput(arguments.output, {arguments.input.file, arguments.locators}); !apart) {
    return apart;
  }
  const Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Result<BindRequest> request = requestOf(arguments, *document);
  if (!request) {
    return inFile(request.error(), arguments.input.file);
  }
  // Told to the user and nothing else: no result depends on the clock.
  const auto start = std::chrono::steady_clock::now();
  const Result<BoundMeshes> bound = bindMeshes(*document, *request, terminalProgress("binding"));
  if (!bound) {
    return inFile(bound.error(), arguments.input.file);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Result<Document> result = withBoundMeshes(*document, *bound);
  if (!result) {
    return result.error();
  }
  if (Status saved = saveDocument(*result, arguments.output.path, {}); !saved) {
    return saved;
  }
  BindReport report = bound->report;
  std::ranges::move(strayVertexWarnings(*document->scene), std::back_inserter(report.warnings));
  std::ranges::copy(besideLines(*document->source, arguments.output.path),
                    std::back_inserter(report.warnings));
  if (arguments.json) {
    arguments.json.print(reportOf(*result, report, seconds));
  } else {
    printReport(report, seconds);
  }
  return Success{};
}

} // namespace

Verb bindVerb() {
  return {"bind",
          "Binds a mesh to a skeleton: joints at locators or at the file's own, weights by the way inside "
          "the body.",
          [](CommandLine& line) {
            const auto arguments = std::make_shared<BindArguments>();
            line.examples({"statue.glb -o bound.glb", "character.glb -o again.glb --keep-joints"});
            addFileArguments(line, arguments->input);
            addOutputFile(line, arguments->output, "The .glb or .gltf to write");
            const DeclaredOption locators =
                line.option("--locators", arguments->locators,
                            "Where the joints are made, or moved to in a bound file (JSON, as `rig "
                            "--locators-only` writes it) instead of the fitted places");
            const DeclaredOption plan = addLocatorPlan(line, arguments->plan);
            plan.excludes(locators);
            line.flag("--keep-joints", arguments->keepJoints,
                      "Bind to the joints that the file has; weights that it has are replaced")
                .excludes(plan);
            line.option("--weights", arguments->weights,
                        "volume: by the way inside the body, any triangles will do; surface: by the way on "
                        "a closed surface")
                .oneOf({"volume", "surface"})
                .showDefault();
            addJson(line, arguments->json);
            return [arguments] { return runBind(*arguments); };
          }};
}

} // namespace stretch::app
