#include "skinning/compress/compress.h"

#include <algorithm>

#include <fmt/format.h>

#include "skinning/body/given_skeleton.h"
#include "skinning/compress/body_bones.h"
#include "skinning/compress/fewest_bones.h"
#include "skinning/compress/usable_mesh.h"

namespace stretch::skinning {
namespace {

Status addMetrics(const MeshSequence& sequence, CompressedSequence& result) {
  const MeshSequence shown = skinAllFrames(result.skinned);
  const auto all = compareSequences(sequence, shown);
  if (!all) {
    return all.error();
  }
  result.metrics = *all;
  if (const std::string frame = frameOfErrors(sequence); !frame.empty()) {
    result.warnings.push_back(frame);
  }
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

/// Tells of bones that stretch so far that skin and engines suffer.
void tellScales(CompressedSequence& result) {
  constexpr double least = 0.5;
  constexpr double most = 2.0;
  const SkinnedSequence& skinned = result.skinned;
  std::size_t bones = 0;
  std::string worst;
  double farthest = 0.0;
  for (std::size_t b = 0; b < skinned.bones.size(); ++b) {
    const ScaleRange range = scaleRangeOf(skinned, b);
    if (range.least >= least && range.most <= most) {
      continue;
    }
    ++bones;
    const double far = std::max(range.most, 1.0 / range.least);
    if (far > farthest) {
      farthest = far;
      worst = fmt::format("{} from {:.2g} to {:.2g} (frames {} and {})", nameOfBone(skinned, b), range.least,
                          range.most, range.leastFrame, range.mostFrame);
    }
  }
  if (bones > 0) {
    result.warnings.push_back(
        fmt::format("{} {} scaled below {:g} or above {:g}, most of all {}: "
                    "--scale-limit {:g} keeps them within that, more bones may need less",
                    bones, bones == 1 ? "bone is" : "bones are", least, most, worst, most));
  }
}

constexpr double fittedShare = 0.9;

Result<CompressedSequence> compressUsable(const MeshSequence& sequence, const CompressSettings& settings,
                                          const Proceed& proceed) {
  const Proceed fitting = partOf(proceed, 0.0, fittedShare);
  auto fitted = settings.tolerancePercent ? fewestBones(sequence, settings, fitting)
                                          : fittedBones(sequence, settings, fitting);
  if (!fitted) {
    return fitted.error();
  }
  CompressedSequence result = std::move(fitted).value();
  if (const Status measured = addMetrics(sequence, result); !measured) {
    return measured.error();
  }
  judge(settings, result);
  tellScales(result);
  if (!goesOn(proceed, 1.0)) {
    return stoppedError(sequence);
  }
  return result;
}

Status checkBones(const MeshSequence& sequence, const CompressSettings& settings) {
  constexpr int mostBones = 1000;
  if (!settings.skeleton.empty()) {
    return settings.tolerancePercent ? Status(Error{"a skeleton has the bones that it has", "--tolerance",
                                                    "leave out --tolerance or --skeleton"})
                                     : checkSkeleton(settings.skeleton, sequence);
  }
  if (settings.bones < 1 || settings.bones > mostBones ||
      static_cast<std::size_t>(settings.bones) * 4 > sequence.vertexCount) {
    return Error{
        fmt::format("{} bones for {} vertices", settings.bones, sequence.vertexCount), sequence.name,
        fmt::format("ask for 1 to {} bones", std::min<std::size_t>(mostBones, sequence.vertexCount / 4))};
  }
  return Success{};
}

} // namespace

Result<CompressedSequence> compress(const MeshSequence& sequence, const CompressSettings& settings,
                                    const Proceed& proceed) {
  if (sequence.frameCount() == 0 || sequence.triangles.empty()) {
    return Error{"the sequence has no frames or no triangles", sequence.name, "give a sequence with both"};
  }
  if (sequence.vertexCount < 4) {
    return Error{fmt::format("{} vertices are too few for a bone", sequence.vertexCount), sequence.name,
                 "give a mesh of at least 4 vertices"};
  }
  if (const Status possible = checkBones(sequence, settings);
      !possible && (!settings.tolerancePercent || !settings.skeleton.empty())) {
    return possible.error();
  }
  const UsableMesh usable = usableMesh(sequence);
  auto result = compressUsable(usable.changed ? *usable.changed : sequence, settings, proceed);
  if (result) {
    giveBackVertices(usable, sequence, result.value().skinned);
    std::vector<std::string>& warnings = result.value().warnings;
    warnings.insert(warnings.begin(), usable.warnings.begin(), usable.warnings.end());
    if (sequence.frameCount() == 1) {
      warnings.emplace_back("there is one frame: nothing moves, and the file has no clip");
    }
  }
  return result;
}

} // namespace stretch::skinning
