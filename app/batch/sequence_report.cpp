#include "app/batch/sequence_report.h"

#include <filesystem>

#include <fmt/core.h>

#include "skinning/sequence/read_sequence.h"

namespace stretch::app {

using gltf::Json;

Json metricsJson(const skinning::SequenceMetrics& metrics) {
  return {{"mse", metrics.mse},
          {"rmse_percent", metrics.rmsePercent},
          {"largest_percent", metrics.largestPercent},
          {"kg_error", metrics.kgError},
          {"sted", metrics.sted},
          {"sted_spatial", metrics.stedSpatial},
          {"sted_temporal", metrics.stedTemporal},
          {"sted_parameters",
           {{"rings", metrics.stedSettings.rings},
            {"window", metrics.stedSettings.window},
            {"dt", metrics.stedSettings.timeStep},
            {"c", metrics.stedSettings.c}}}};
}

void printMetrics(const Json& report) {
  fmt::print("MSE {:.6g}, RMSE {:.4g} % of the diagonal, largest {:.4g} %, KG {:.4g}, STED {:.4g}\n",
             report["mse"].get<double>(), report["rmse_percent"].get<double>(),
             report["largest_percent"].get<double>(), report["kg_error"].get<double>(),
             report["sted"].get<double>());
}

Result<MeshSequence> readSequenceWords(const std::vector<std::string>& words) {
  return skinning::readSequence(std::vector<std::filesystem::path>(words.begin(), words.end()));
}

} // namespace stretch::app
