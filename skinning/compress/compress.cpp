#include "skinning/compress/compress.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "skinning/compress/usable_mesh.h"
#include "skinning/weights/geodesic_weights.h"

namespace stretch::skinning {
namespace {

/// Columns: along the bone, against the load, and what is left.
Quat frameAlong(const Vec3& along, const Vec3& across) {
  const Vec3 x = glm::normalize(along);
  const Vec3 y = glm::normalize(across - glm::dot(across, x) * x);
  return glm::normalize(glm::quat_cast(Mat3(x, y, glm::cross(x, y))));
}

/// Bones of the centre line; poses follow the segments' own motion, without stretch.
SkinnedSequence bonesOfBody(const MeshSequence& sequence, const BodyMotion& body, const BodyStretch& load) {
  SkinnedSequence skinned = withoutBones(sequence);
  for (std::size_t b = 0; b < body.segmentCount(); ++b) {
    const Vec3& start = body.skeleton.joints[b];
    const Vec3& end = body.skeleton.joints[b + 1];
    skinned.bones.push_back({start, end, frameAlong(end - start, load.loadAxes[b])});
  }
  for (std::size_t k = 0; k < sequence.frameCount(); ++k) {
    for (std::size_t b = 0; b < body.segmentCount(); ++b) {
      skinned.poses.push_back(
          {body.joints[k][b], body.motion(k, b).rotation, Vec3(1.0), skinned.bones[b].axes});
    }
  }
  return skinned;
}

void applyModel(const BodyStretch& model, SkinnedSequence& skinned) {
  for (std::size_t i = 0; i < skinned.poses.size(); ++i) {
    const SkinBone& bone = skinned.bones[i % skinned.bones.size()];
    const StretchFactors& factors = model.factors[i];
    skinned.poses[i].scale = Vec3(factors.along, factors.withLoad, factors.sideways);
    skinned.poses[i].stretchAxes =
        model.loadTurns ? frameAlong(bone.end - bone.pivot, model.loadDirections[i]) : bone.axes;
  }
}

Status addGeodesicWeights(const BodyMotion& body, SkinnedSequence& skinned) {
  std::vector<BoneSegment> segments;
  for (std::size_t b = 0; b < body.segmentCount(); ++b) {
    segments.push_back({body.skeleton.joints[b], body.skeleton.joints[b + 1]});
  }
  auto weights = geodesicWeights(skinned.bindPositions, skinned.triangles, segments);
  if (!weights) {
    return weights.error();
  }
  skinned.influences = std::move(weights.value());
  return Success{};
}

/// Shares of the whole work after the body was measured, after the fit, and after the comparison.
constexpr double measuredShare = 0.15;
constexpr double fittedShare = 0.9;

bool goesOn(const Proceed& proceed, double share) {
  return !proceed || proceed(share);
}

/// A part of the whole work as work of its own, 0..1.
Proceed partOf(const Proceed& proceed, double from, double to) {
  return [&proceed, from, to](double share) { return goesOn(proceed, from + (to - from) * share); };
}

Error stopped(const MeshSequence& sequence) {
  return {"the compression was stopped", sequence.name, "start it again"};
}

FitSettings fitSettings(const CompressSettings& settings) {
  FitSettings fit = settings.fit;
  fit.fitWeights = settings.weights == WeightOption::fitted;
  fit.fitStretch = settings.stretch == StretchOption::measured;
  fit.firstWeightFrame = settings.body.firstFittedFrame;
  return fit;
}

/// Fitted weights come from bones that move and stretch freely, whatever the option: the options then differ
/// by how their bones stretch and by nothing else. (Fitted to a chain of fixed length, weights and bones
/// learn to fold up instead.)
void fitPoses(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed,
              SkinnedSequence& skinned) {
  FitSettings fit = fitSettings(settings);
  if (fit.fitWeights && settings.stretch != StretchOption::measured) {
    SkinnedSequence free = skinned;
    fit.fitStretch = true;
    fitFreeBones(sequence, free, fit, partOf(proceed, measuredShare, fittedShare));
    skinned.influences = std::move(free.influences);
    fit.fitWeights = false;
    fit.fitStretch = false;
  }
  if (skinned.chained) {
    const bool rigid = settings.stretch == StretchOption::none;
    fitChainedBones(sequence, skinned, rigid ? RowHold::firm : RowHold::loose);
  } else {
    fitFreeBones(sequence, skinned, fit, partOf(proceed, measuredShare, fittedShare));
  }
}

Status compressBody(const MeshSequence& sequence, const BodyMotion& body, const CompressSettings& settings,
                    const Proceed& proceed, CompressedSequence& result) {
  auto model = stretchOfBody(body, settings.body);
  if (!model) {
    return model.error();
  }
  result.skinned = bonesOfBody(sequence, body, *model);
  result.skinned.chained = settings.stretch != StretchOption::measured;
  result.segmentWidths = body.widths;
  const auto weighted = addGeodesicWeights(body, result.skinned);
  if (!weighted) {
    return weighted.error();
  }
  if (settings.stretch == StretchOption::elastic) {
    applyModel(*model, result.skinned);
    result.warnings.insert(result.warnings.end(), model->warnings.begin(), model->warnings.end());
  }
  fitPoses(sequence, settings, proceed, result.skinned);
  result.model = std::move(model.value());
  return Success{};
}

/// Without a centre line: free parts, where the options allow it.
Status compressParts(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed,
                     const Error& reason, CompressedSequence& result) {
  if (settings.stretch == StretchOption::elastic || settings.weights == WeightOption::geodesic) {
    return reason;
  }
  result.warnings.push_back(reason.what + ": its bones are free parts instead");
  result.skinned = partsOfMesh(sequence, settings.bones);
  fitFreeBones(sequence, result.skinned, fitSettings(settings), partOf(proceed, measuredShare, fittedShare));
  return Success{};
}

Status addMetrics(const MeshSequence& sequence, CompressedSequence& result) {
  const MeshSequence shown = skinAllFrames(result.skinned);
  const auto all = compareSequences(sequence, shown);
  if (!all) {
    return all.error();
  }
  result.metrics = *all;
  if (result.firstFittedFrame > 0) {
    const auto fitted = compareSequences(withoutFirstFrames(sequence, result.firstFittedFrame),
                                         withoutFirstFrames(shown, result.firstFittedFrame));
    if (!fitted) {
      return fitted.error();
    }
    result.fittedMetrics = *fitted;
  }
  return Success{};
}

/// Tells of an error that is out of proportion, and what helps.
void judge(const CompressSettings& settings, CompressedSequence& result) {
  constexpr double mostPercent = 1.0;
  if (result.metrics.rmsePercent <= mostPercent) {
    return;
  }
  const char* const remedy =
      settings.stretch == StretchOption::none
          ? "bones without stretch do not follow a body that changes its length; use --stretch elastic or "
            "--stretch measured"
      : settings.stretch == StretchOption::elastic
          ? "the elastic model does not explain this motion; use --stretch measured"
          : "give more --bones";
  result.warnings.push_back(fmt::format("the result is off by {:.2g} % of the body's size on average: {}",
                                        result.metrics.rmsePercent, remedy));
}

Result<CompressedSequence> compressUsable(const MeshSequence& sequence, const CompressSettings& settings,
                                          const Proceed& proceed) {
  CompressedSequence result;
  result.firstFittedFrame = std::min(settings.body.firstFittedFrame, sequence.frameCount() - 1);
  const auto body = analyseBody(sequence, settings.bones);
  if (!goesOn(proceed, measuredShare)) {
    return stopped(sequence);
  }
  const auto done = body ? compressBody(sequence, *body, settings, proceed, result)
                         : compressParts(sequence, settings, proceed, body.error(), result);
  if (!done) {
    return done.error();
  }
  if (!goesOn(proceed, fittedShare)) {
    return stopped(sequence);
  }
  const auto measured = addMetrics(sequence, result);
  if (!measured) {
    return measured.error();
  }
  judge(settings, result);
  if (!goesOn(proceed, 1.0)) {
    return stopped(sequence);
  }
  return result;
}

} // namespace

Result<CompressedSequence> compress(const MeshSequence& sequence, const CompressSettings& settings,
                                    const Proceed& proceed) {
  constexpr int mostBones = 1000;
  if (sequence.frameCount() == 0 || sequence.triangles.empty()) {
    return Error{"the sequence has no frames or no triangles", sequence.name, "give a sequence with both"};
  }
  if (sequence.vertexCount < 4) {
    return Error{fmt::format("{} vertices are too few for a bone", sequence.vertexCount), sequence.name,
                 "give a mesh of at least 4 vertices"};
  }
  if (settings.bones < 1 || settings.bones > mostBones ||
      static_cast<std::size_t>(settings.bones) * 4 > sequence.vertexCount) {
    return Error{
        fmt::format("{} bones for {} vertices", settings.bones, sequence.vertexCount), sequence.name,
        fmt::format("ask for 1 to {} bones", std::min<std::size_t>(mostBones, sequence.vertexCount / 4))};
  }
  const UsableMesh usable = usableMesh(sequence);
  auto result = compressUsable(usable.changed ? *usable.changed : sequence, settings, proceed);
  if (result) {
    giveBackVertices(usable, sequence, result.value().skinned);
    std::vector<std::string>& warnings = result.value().warnings;
    warnings.insert(warnings.begin(), usable.warnings.begin(), usable.warnings.end());
  }
  return result;
}

} // namespace stretch::skinning
