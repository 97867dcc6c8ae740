#include "app/batch/sequence_report.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "app/batch/trail_report.h"
#include "core/gltf/json/json.h"
#include "skinning/export/read_back.h"
#include "skinning/sequence/read_sequence.h"

namespace stretch::app {

using gltf::Json;

namespace {

Json fittedFrames(const MeshSequence& sequence, std::size_t first) {
  return {{"first", first}, {"last", sequence.frameCount() - 1}, {"count", sequence.frameCount() - first}};
}

const char* nameOf(skinning::LengthModel model) {
  switch (model) {
  case skinning::LengthModel::line:
    return "line";
  case skinning::LengthModel::monotone:
    return "monotone";
  case skinning::LengthModel::automatic:
  case skinning::LengthModel::measuredMean:
    break;
  }
  return "mean";
}

Json lengthJson(const skinning::BodyStretch& model) {
  const skinning::LengthFunction& length = model.length;
  return {{"used", nameOf(length.model)},
          {"frames", length.frameCount},
          {"rest_length", model.restLength},
          {"mean_length", length.meanLength},
          {"line",
           {{"slope", length.line.slope},
            {"intercept", length.line.intercept},
            {"r_squared", length.line.rSquared}}},
          {"monotone",
           {{"curvatures", length.monotone.curvatures},
            {"lengths", length.monotone.lengths},
            {"r_squared", length.monotone.rSquared}}}};
}

/// The rows of bones of a given skeleton, each with its own length by curvature.
Json chainsJson(const std::vector<skinning::ChainStretch>& chains) {
  Json list = Json::array();
  for (const skinning::ChainStretch& chain : chains) {
    const skinning::LengthFunction& length = chain.length;
    list.push_back({{"bones", chain.names},
                    {"used", nameOf(length.model)},
                    {"rest_length", chain.restLength},
                    {"slope", length.line.slope},
                    {"intercept", length.line.intercept},
                    {"r_squared", length.model == skinning::LengthModel::monotone ? length.monotone.rSquared
                                                                                  : length.line.rSquared},
                    {"least", chain.least},
                    {"most", chain.most}});
  }
  return list;
}

void printChains(const Json& chains) {
  for (const Json& chain : chains) {
    const Json& bones = chain["bones"];
    fmt::print("{}..{}: length by curvature, R^2 {:.3f}, the {} is used: {:.4g} to {:.4g} times as long\n",
               bones.front().get<std::string>(), bones.back().get<std::string>(),
               chain["r_squared"].get<double>(), chain["used"].get<std::string>(),
               chain["least"].get<double>(), chain["most"].get<double>());
  }
}

/// Curvature (radians) and length of the centre line, frame by frame.
Json framesJson(const skinning::BodyStretch& model) {
  Json curvatures = Json::array();
  Json lengths = Json::array();
  for (const skinning::CurvatureLength& frame : model.measured) {
    curvatures.push_back(frame.curvatureRadians);
    lengths.push_back(frame.length);
  }
  return {{"curvatures", std::move(curvatures)}, {"lengths", std::move(lengths)}};
}

const char* nameOf(skinning::WeightOption weights) {
  return weights == skinning::WeightOption::geodesic ? "geodesic" : "fitted";
}

Json weightsJson(const skinning::WeightChoice& weights) {
  Json json{{"used", nameOf(weights.used)}};
  if (weights.geodesicPercent && weights.fittedPercent) {
    json["geodesic_rmse_percent"] = *weights.geodesicPercent;
    json["fitted_rmse_percent"] = *weights.fittedPercent;
  }
  return json;
}

void printWeights(const Json& weights) {
  if (weights.contains("fitted_rmse_percent")) {
    fmt::print("weights: {}, the better of geodesic ({:.4g} %) and fitted ({:.4g} %)\n",
               weights["used"].get<std::string>(), weights["geodesic_rmse_percent"].get<double>(),
               weights["fitted_rmse_percent"].get<double>());
  }
}

void printFile(const Json& report) {
  if (!report.contains("file")) {
    return;
  }
  const Json& file = report["file"];
  fmt::print("the file has {} bytes, {} of them JSON, and {} keys; read back, it is off by {:.4g} %, at most "
             "{:.4g} %\n",
             file["bytes"].get<std::size_t>(), report["bytes_json"].get<std::size_t>(),
             report["keys"].get<std::size_t>(), file["rmse_percent"].get<double>(),
             file["largest_percent"].get<double>());
}

/// The physics that explains the frames, whether the bones are stretched by it or not.
void printModel(const Json& report) {
  const Json& length = report["length_by_curvature"];
  const Json& line = length["line"];
  fmt::print("length by curvature: line {:.4g} kappa + {:.4g}, R^2 {:.3f}; monotone curve of {} knots, R^2 "
             "{:.3f}; the {} is used\n",
             line["slope"].get<double>(), line["intercept"].get<double>(), line["r_squared"].get<double>(),
             length["monotone"]["lengths"].size(), length["monotone"]["r_squared"].get<double>(),
             length["used"].get<std::string>());
  const std::vector<double> compressions = report["gravity_compression"];
  const auto [least, most] = std::minmax_element(compressions.begin(), compressions.end());
  if (report["young"].get<double>() > 0.0 && least != compressions.end()) {
    fmt::print("gravity compresses segments by {:.3g} to {:.3g}; Young's modulus {:.4g} Pa ({}), mass {:.4g} "
               "kg\n",
               *least, *most, report["young"].get<double>(),
               report["young_fitted"].get<bool>() ? "fitted" : "given", report["mass"].get<double>());
  }
}

} // namespace

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

Json compressionJson(const MeshSequence& sequence, const skinning::CompressedSequence& compressed,
                     const skinning::EncodedClip& encoded) {
  Json report = metricsJson(compressed.metrics);
  report["frames"] = sequence.frameCount();
  report["vertices"] = sequence.vertexCount;
  report["joints"] = encoded.joints;
  report["fitted_frames"] = fittedFrames(sequence, compressed.firstFittedFrame);
  if (compressed.fittedMetrics) {
    report["metrics_of_fitted_frames"] = metricsJson(*compressed.fittedMetrics);
  }
  report["bytes_per_frame_source"] = skinning::sourceBytesPerFrame(sequence);
  report["bytes_per_frame"] = encoded.bytesPerFrame;
  report["bytes_once"] = encoded.bytesOnce;
  report["bytes_json"] = encoded.bytesOfJson;
  report["keys"] = encoded.keys;
  report["keys_off_percent"] = encoded.keyErrorPercent;
  report["weights"] = weightsJson(compressed.weights);
  if (compressed.model) {
    report["length_by_curvature"] = lengthJson(*compressed.model);
    report["young"] = compressed.model->youngModulus;
    report["young_fitted"] = compressed.model->modulusFitted;
    report["mass"] = compressed.model->mass;
    report["gravity_compression"] = compressed.model->compressions;
    report["curvature_and_length"] = framesJson(*compressed.model);
  }
  if (!compressed.chains.empty()) {
    report["chains"] = chainsJson(compressed.chains);
  }
  report["warnings"] = sequence.warnings;
  for (const std::string& warning : compressed.warnings) {
    report["warnings"].push_back(warning);
  }
  return report;
}

Status addWrittenFile(const MeshSequence& sequence, const std::string& path,
                      const skinning::EncodedClip& encoded, Json& report) {
  const Result<skinning::SequenceMetrics> metrics = skinning::errorOfFile(path, encoded, sequence);
  if (!metrics) {
    return metrics.error();
  }
  report["file"] = {{"bytes", static_cast<std::size_t>(std::filesystem::file_size(path))},
                    {"rmse_percent", metrics->rmsePercent},
                    {"largest_percent", metrics->largestPercent}};
  return Success{};
}

void printCompression(const Json& report) {
  printMetrics(report);
  const double bytes = report["bytes_per_frame"].get<double>();
  const double source = report["bytes_per_frame_source"].get<double>();
  const auto ratioTo = [&](double less) { // Nothing has no ratio.
    return less > 0.0 ? fmt::format(", 1 : {:.3g}", source / less) : std::string();
  };
  fmt::print("{} joints, {:.5g} bytes per frame instead of {:.0f}{}; {} bytes once\n",
             report["joints"].get<std::size_t>(), bytes, source, ratioTo(bytes),
             report["bytes_once"].get<std::size_t>());
  printFile(report);
  printWeights(report["weights"]);
  if (report.contains("stream")) {
    const double streamed = report["stream"]["bytes_per_frame"].get<double>();
    fmt::print("stream: {:.0f} bytes for each frame{}; a base of {} bytes (frames of what changes "
               "{}, open ones {} bytes)\n",
               streamed, ratioTo(streamed), report["stream"]["base_bytes"].get<std::size_t>(),
               report["stream"]["changing_bytes_per_frame"].get<std::size_t>(),
               report["stream"]["open_bytes_per_frame"].get<std::size_t>());
  }
  const Json& used = report["fitted_frames"];
  fmt::print("fits use frames {} to {}, {} of {}\n", used["first"].get<std::size_t>(),
             used["last"].get<std::size_t>(), used["count"].get<std::size_t>(),
             report["frames"].get<std::size_t>());
  if (report.contains("length_by_curvature")) {
    printModel(report);
  }
  if (report.contains("chains")) {
    printChains(report["chains"]);
  }
  printWarnings(report["warnings"]);
}

std::string curvatureTable(const MeshSequence& sequence, const skinning::BodyStretch& model) {
  std::string table = "frame,name,curvature_radians,length,modelled_length\n";
  for (std::size_t k = 0; k < model.measured.size(); ++k) {
    const skinning::CurvatureLength& frame = model.measured[k];
    std::string name = k < sequence.frameNames.size() ? sequence.frameNames[k] : std::string();
    std::ranges::replace(name, '"', '\''); // What a name may hold must not end its cell.
    table += fmt::format("{},\"{}\",{},{},{}\n", k, name, frame.curvatureRadians, frame.length,
                         model.length.at(frame.curvatureRadians));
  }
  return table;
}

Result<MeshSequence> readSequenceWords(const std::vector<std::string>& words, const std::string& clip,
                                       double framesPerSecond) {
  return skinning::readSequence(std::vector<std::filesystem::path>(words.begin(), words.end()), {}, clip,
                                framesPerSecond);
}

} // namespace stretch::app
