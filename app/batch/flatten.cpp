#include <cmath>
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/batch/verb.h"
#include "core/base/number.h"
#include "core/gltf/json/json.h"
#include "core/math/types.h"
#include "skinning/elastic/cylinder.h"

namespace stretch::app {

namespace {

constexpr double earthGravity = 9.81; // m/s^2

struct FlattenArguments {
  skinning::Cylinder cylinder{0.0, 0.0, 0.0, 0.0}; ///< Length and width in the units of the mesh.
  double angleDegrees = 0.0;
  double metresPerUnit = 1.0;
  JsonOutput json;
};

/// An option for a number that has to be greater than 0.
DeclaredOption addPositive(CommandLine& line, const std::string& name, double& value,
                           const std::string& help) {
  return line.option(name, value, help).check([](const std::string& text) {
    const auto number = stretch::parseNumber(text);
    return number && *number > 0.0 ? std::string() : "'" + text + "' is no number above 0";
  });
}

struct Flattened {
  double force = 0.0;      ///< N, across the axis.
  double deflection = 0.0; ///< dw, m.
  double share = 0.0;      ///< dw / w as Eq. 6 has it.
  double ratio = 0.0;      ///< q: the share within the model's limits.
};

Flattened flattened(const FlattenArguments& arguments) {
  skinning::Cylinder cylinder = arguments.cylinder;
  cylinder.length *= arguments.metresPerUnit;
  cylinder.width *= arguments.metresPerUnit;
  const double across = earthGravity * std::cos(arguments.angleDegrees * pi / 180.0);
  Flattened result;
  result.force = cylinder.mass * across;
  result.deflection = skinning::gravityDisplacement(cylinder, across);
  result.share = result.deflection / cylinder.width;
  result.ratio = skinning::compressionFactor(cylinder, across);
  return result;
}

std::string warningOf(const Flattened& result) {
  if (result.share > skinning::largestCompression) {
    return fmt::format("the width would shrink by {:.3g} of itself; {} is the most that the model gives",
                       result.share, skinning::largestCompression);
  }
  return result.share > skinning::largestSmallStrain
             ? fmt::format("beyond {} the deformation is not small, as the model assumes",
                           skinning::largestSmallStrain)
             : std::string();
}

Status runFlatten(const FlattenArguments& arguments) {
  const Flattened result = flattened(arguments);
  const skinning::StretchFactors factors = skinning::combine(result.ratio, 1.0);
  const double height = arguments.cylinder.width * factors.withLoad;
  const double width = arguments.cylinder.width * factors.sideways;
  const std::string warning = warningOf(result);
  if (arguments.json) {
    gltf::Json report{{"force", result.force},
                      {"deflection", result.deflection},
                      {"ratio", result.ratio},
                      {"height", height},
                      {"width", width}};
    report["warnings"] = warning.empty() ? gltf::Json::array() : gltf::Json{warning};
    arguments.json.print(report);
    return Success{};
  }
  fmt::print(
      "{:.5g} N across the axis flatten it by {:.5g} m, {:.5g} % of its width: {:.6g} high, {:.6g} wide\n",
      result.force, result.deflection, 100.0 * result.ratio, height, width);
  if (!warning.empty()) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
  return Success{};
}

} // namespace

Verb flattenVerb() {
  return {"flatten",
          "How far gravity flattens a cylinder of soft material (Eq. 6 of the elastic model), in SI units.",
          [](CommandLine& line) {
            const auto arguments = std::make_shared<FlattenArguments>();
            line.examples({"--mass 2e-9 --young 3770 --length 0.88e-3 --width 0.085e-3"});
            skinning::Cylinder& cylinder = arguments->cylinder;
            addPositive(line, "--mass", cylinder.mass, "Mass of the cylinder, kg").required();
            addPositive(line, "--young", cylinder.youngModulus, "Young's modulus, Pa").required();
            addPositive(line, "--length", cylinder.length, "Length along its axis, m").required();
            addPositive(line, "--width", cylinder.width, "Its diameter, m").required();
            line.option("--angle", arguments->angleDegrees,
                        "Degrees between its axis and the ground: only what pulls across the axis counts")
                .check([](const std::string& text) {
                  const auto number = stretch::parseNumber(text);
                  return number && std::abs(*number) <= 90.0 ? std::string()
                                                             : "'" + text + "' is no angle from -90 to 90";
                });
            addPositive(line, "--metres-per-unit", arguments->metresPerUnit,
                        "Length and width count in units of so many metres");
            addJson(line, arguments->json);
            return [arguments] { return runFlatten(*arguments); };
          }};
}

} // namespace stretch::app
