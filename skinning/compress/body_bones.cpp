#include "skinning/compress/body_bones.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "skinning/body/given_skeleton.h"
#include "skinning/fit/joint_tree.h"
#include "skinning/fit/motion_clusters.h"
#include "skinning/metrics.h"
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

Status addGeodesicWeights(SkinnedSequence& skinned) {
  std::vector<BoneSegment> segments;
  for (const SkinBone& bone : skinned.bones) {
    segments.push_back({bone.pivot, bone.end});
  }
  auto weights = geodesicWeights(skinned.bindPositions, skinned.triangles, segments);
  if (!weights) {
    return weights.error();
  }
  skinned.influences = std::move(weights.value());
  return Success{};
}

FitSettings fitSettings(const CompressSettings& settings) {
  FitSettings fit = settings.fit;
  fit.fitWeights = settings.weights != WeightOption::geodesic;
  fit.fitStretch = settings.stretch == StretchOption::measured;
  fit.influences = settings.influences == InfluenceLimit::eight ? 8 : 4;
  fit.firstWeightFrame = settings.body.firstFittedFrame;
  return fit;
}

/// Fitted weights come from bones that move and stretch freely, whatever the option: the options then differ
/// by how their bones stretch and by nothing else. (Fitted to a chain of fixed length, weights and bones
/// learn to fold up instead.)
void fitRow(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed,
            SkinnedSequence& skinned) {
  FitSettings fit = fitSettings(settings);
  if (fit.fitWeights) {
    constexpr int rounds = 24; // More would only suit the weights to bones that are free, which these are
                               // not.
    constexpr double leastGain = 2e-3;
    SkinnedSequence free = skinned;
    fit.rounds = std::min(fit.rounds, rounds);
    fit.leastGain = std::max(fit.leastGain, leastGain);
    fit.fitStretch = true;
    fitFreeBones(sequence, free, fit, proceed);
    skinned.influences = std::move(free.influences);
  }
  const bool rigid = settings.stretch == StretchOption::none;
  fitChainedBones(sequence, skinned, rigid ? RowHold::firm : RowHold::loose);
}

/// Both kinds of weights, and the better of the two.
WeightChoice fitRowBothWays(const MeshSequence& sequence, const CompressSettings& settings,
                            const Proceed& proceed, SkinnedSequence& skinned) {
  SkinnedSequence geodesic = skinned;
  CompressSettings tried = settings;
  tried.weights = WeightOption::geodesic;
  fitRow(sequence, tried, partOf(proceed, 0.0, 0.2), geodesic);
  tried.weights = WeightOption::fitted;
  fitRow(sequence, tried, partOf(proceed, 0.2, 1.0), skinned);
  WeightChoice choice;
  choice.geodesicPercent = distancesOf(sequence, skinAllFrames(geodesic)).rmsePercent;
  choice.fittedPercent = distancesOf(sequence, skinAllFrames(skinned)).rmsePercent;
  if (*choice.geodesicPercent < *choice.fittedPercent) {
    choice.used = WeightOption::geodesic;
    skinned = std::move(geodesic);
  }
  return choice;
}

constexpr double measuredShare = 0.15;

Status compressBody(const MeshSequence& sequence, const BodyMotion& body, const CompressSettings& settings,
                    const Proceed& proceed, CompressedSequence& result) {
  auto model = stretchOfBody(body, settings.body);
  if (!model) {
    return model.error();
  }
  SkinnedSequence& skinned = result.skinned;
  skinned = bonesOfBody(sequence, body, *model);
  skinned.chained = settings.stretch != StretchOption::measured;
  result.segmentWidths = body.widths;
  if (Status weighted = addGeodesicWeights(skinned); !weighted) {
    return weighted;
  }
  if (settings.stretch == StretchOption::elastic) {
    applyModel(*model, skinned);
    result.warnings.insert(result.warnings.end(), model->warnings.begin(), model->warnings.end());
  }
  if (!skinned.chained) {
    fitFreeBones(sequence, skinned, fitSettings(settings), proceed);
    for (std::size_t b = 1; b < skinned.bones.size() && settings.joints == JointOption::tree; ++b) {
      skinned.bones[b].parent = static_cast<int>(b) - 1;
    }
  } else if (settings.weights == WeightOption::automatic) {
    result.weights = fitRowBothWays(sequence, settings, proceed, skinned);
  } else {
    fitRow(sequence, settings, proceed, skinned);
  }
  result.model = std::move(model.value());
  return Success{};
}

/// A row of bones as rigid ones.
SkinnedSequence withRigidRow(SkinnedSequence skinned, const ChainStretch& row) {
  for (std::size_t k = 0; k < skinned.frameCount(); ++k) {
    for (const std::size_t bone : row.bones) {
      skinned.pose(k, bone).scale = Vec3(1.0);
    }
  }
  return skinned;
}

/// Stretch by the rows of bones in place of rigid bones, where that lowers the error: how a row stretches is
/// measured on bones that stretch freely, a row that is better off without stays rigid, and weights and
/// motion are fitted to what is left.
void stretchByRows(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed,
                   CompressedSequence& result) {
  const auto errorOf = [&](const SkinnedSequence& skinned) {
    return distancesOf(sequence, skinAllFrames(skinned)).rmsePercent;
  };
  FitSettings fit = fitSettings(settings);
  fit.fitStretch = true;
  SkinnedSequence stretched = result.skinned;
  fitFreeBones(sequence, stretched, fit, partOf(proceed, 0.0, 0.4));
  result.chains = stretchRows(stretched, settings.body.lengthModel, result.firstFittedFrame);
  fit.fitStretch = false;
  FitSettings poses = fit;
  poses.fitWeights = false;
  fitFreeBones(sequence, stretched, poses);
  double best = errorOf(stretched);
  for (ChainStretch& row : result.chains) {
    SkinnedSequence rigid = withRigidRow(stretched, row);
    fitFreeBones(sequence, rigid, poses);
    if (const double error = errorOf(rigid); error < best) {
      stretched = std::move(rigid);
      best = error;
      row.least = row.most = 1.0;
    }
    if (!goesOn(proceed, 0.5)) {
      return;
    }
  }
  fitFreeBones(sequence, stretched, fit, partOf(proceed, 0.5, 1.0));
  if (errorOf(stretched) < errorOf(result.skinned)) {
    result.skinned = std::move(stretched);
    return;
  }
  for (ChainStretch& row : result.chains) {
    row.least = row.most = 1.0;
  }
}

/// Axes of scales along the bones, for bones whose scales are still to come.
void turnAxesAlongBones(SkinnedSequence& skinned) {
  for (SkinBone& bone : skinned.bones) {
    const Vec3 along = bone.end - bone.pivot;
    if (glm::length(along) > 0.0) {
      bone.axes = frameAlong(along, anyPerpendicular(glm::normalize(along)));
    }
  }
}

/// Bones without a centre line: one for each part that moves alike.
void addBonesOfParts(const MeshSequence& sequence, const CompressSettings& settings,
                     CompressedSequence& result) {
  result.skinned = clustersOfMotion(sequence, settings.bones, settings.body.firstFittedFrame);
  const std::size_t found = result.skinned.bones.size();
  if (found < static_cast<std::size_t>(settings.bones)) {
    result.warnings.push_back(fmt::format("{} bones instead of {}: no part that is left can be split so that "
                                          "both pieces keep four vertices and move apart",
                                          found, settings.bones));
  }
}

/// Without a centre line: parts that move alike, where the options allow it. Elastic stretch goes limb by
/// limb then, along the rows of the tree that the parts hang in.
Status compressParts(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed,
                     const Error& reason, CompressedSequence& result) {
  const bool elastic = settings.stretch == StretchOption::elastic;
  const bool tree = settings.joints == JointOption::tree;
  if ((elastic && !tree) || settings.weights == WeightOption::geodesic) {
    return reason;
  }
  result.warnings.push_back(
      reason.what + ": each part of it that moves alike has a bone" +
      (elastic ? ", and every row of bones between two branchings stretches by its own curvature" : ""));
  addBonesOfParts(sequence, settings, result);
  FitSettings fit = fitSettings(settings);
  fit.bonesMove = true;
  const double joined = tree ? 0.97 : 1.0; // of the work
  fitFreeBones(sequence, result.skinned, fit, partOf(proceed, 0.0, elastic ? 0.6 : joined));
  if (tree) {
    hangTogether(result.skinned);
  }
  if (elastic) {
    turnAxesAlongBones(result.skinned);
    stretchByRows(sequence, settings, partOf(proceed, 0.6, joined), result);
  }
  if (tree) {
    bringJointsInside(result.skinned, partOf(proceed, joined, 1.0));
  }
  return Success{};
}

/// Bones that were given, with their names and places.
Status compressWithSkeleton(const MeshSequence& sequence, const CompressSettings& settings,
                            const Proceed& proceed, CompressedSequence& result) {
  result.skinned = withoutBones(sequence);
  result.skinned.bones = settings.skeleton;
  if (Status weighted = addGeodesicWeights(result.skinned); !weighted) {
    return weighted;
  }
  const bool elastic = settings.stretch == StretchOption::elastic;
  fitFreeBones(sequence, result.skinned, fitSettings(settings),
               elastic ? partOf(proceed, 0.0, 0.6) : proceed);
  if (elastic) {
    stretchByRows(sequence, settings, partOf(proceed, 0.6, 1.0), result);
  }
  return Success{};
}

} // namespace

Proceed partOf(const Proceed& proceed, double from, double to) {
  return [&proceed, from, to](double share) { return goesOn(proceed, from + (to - from) * share); };
}

Error stoppedError(const MeshSequence& sequence) {
  return {"the compression was stopped", sequence.name, "start it again"};
}

Result<CompressedSequence> fittedBones(const MeshSequence& sequence, const CompressSettings& settings,
                                       const Proceed& proceed) {
  CompressedSequence result;
  result.firstFittedFrame = std::min(settings.body.firstFittedFrame, sequence.frameCount() - 1);
  result.weights.used =
      settings.weights == WeightOption::geodesic ? WeightOption::geodesic : WeightOption::fitted;
  const Proceed fitting = partOf(proceed, measuredShare, 1.0);
  Status done = Success{};
  if (!settings.skeleton.empty()) {
    done = compressWithSkeleton(sequence, settings, fitting, result);
  } else {
    const auto body = analyseBody(sequence, settings.bones);
    if (!goesOn(proceed, measuredShare)) {
      return stoppedError(sequence);
    }
    done = body ? compressBody(sequence, *body, settings, fitting, result)
                : compressParts(sequence, settings, fitting, body.error(), result);
  }
  if (!done) {
    return done.error();
  }
  if (!goesOn(proceed, 1.0)) {
    return stoppedError(sequence);
  }
  return result;
}

} // namespace stretch::skinning
