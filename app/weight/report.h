#pragma once

#include <string>
#include <vector>

#include "skinning/elastic/limb_elasticity.h"

namespace stretch::app {

/// What the weight of one limb came to.
struct WeightReport {
  std::string limb;
  double youngModulus = 0.0;  ///< Pa, as used: given or chosen.
  std::vector<double> widths; ///< One for each bone, metres of a character of characterHeightMetres.
  std::vector<double> masses; ///< One for each bone, kg.
  double shortest = 1.0;      ///< Limb lengths over the lengths without weight, along the bones.
  double shortestFrame = 0.0;
  double longest = 1.0;
  double longestFrame = 0.0;
  std::vector<std::string> warnings; ///< One line each, with its frame.
};

/// Notes the extremes of a limb, and what the model was not made for. The report and the segments must
/// outlive it.
class ReportWriter {
public:
  ReportWriter(WeightReport& report, const std::vector<skinning::LimbSegment>& segments,
               double framesPerSecond)
      : report_(report), segments_(segments), framesPerSecond_(framesPerSecond) {}

  /// One sample: a stretch for each bone.
  void add(double seconds, const std::vector<skinning::LimbStretch>& bones);

  /// After the last sample: the warnings.
  void finish();

private:
  void judge(double frame, const skinning::StretchFactors& factors);

  WeightReport& report_;
  const std::vector<skinning::LimbSegment>& segments_;
  double framesPerSecond_ = 30.0;
  double flattest_ = 0.0;
  double flattestFrame_ = 0.0;
  double clampedAt_ = 0.0;
  double clampedFrame_ = -1.0;
};

} // namespace stretch::app
