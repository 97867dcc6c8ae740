#pragma once

#include <string>
#include <vector>

#include "app/weight/sample_clip.h"
#include "rig/motion/motion.h"
#include "skinning/elastic/limb_elasticity.h"

namespace stretch::app {

/// Outcome of the weight of one limb.
struct WeightReport {
  std::string limb;
  double youngModulus = 0.0;  ///< Pa, as used: given or chosen.
  std::vector<double> widths; ///< One for each bone, metres of a character of characterSizeMetres.
  std::vector<double> masses; ///< One for each bone, kg.
  /// Lengths along the bones of the pose that is shown and saved, feet back in their places, over those
  /// without weight: the least and the greatest over the frames of the range.
  double shortest = 1.0;
  double shortestFrame = 0.0;
  double longest = 1.0;
  double longestFrame = 0.0;
  bool held = false;                 ///< The stretch along a bone reached the most that the model allows.
  std::vector<std::string> warnings; ///< One line each, with its frame.
};

/// Notes what the model was not made for. The report must outlive it.
class ReportWriter {
public:
  ReportWriter(WeightReport& report, double framesPerSecond)
      : report_(report), framesPerSecond_(framesPerSecond) {}

  /// One sample: a stretch for each bone.
  void add(double seconds, const std::vector<skinning::LimbStretch>& bones);

  /// After the last sample: the warnings.
  void finish();

private:
  void judge(double frame, const skinning::StretchFactors& factors);

  WeightReport& report_;
  double framesPerSecond_ = 30.0;
  double flattest_ = 0.0;
  double flattestFrame_ = 0.0;
  double clampedAt_ = 0.0;
  double clampedFrame_ = -1.0;
};

/// Measures the lengths of each report's limb frame by frame (between frames too where they are few), and
/// tells of bones whose strain the model was not made for. `motion`: trails and weights of the clip.
void measureLengths(const WeightInput& input, const rig::MotionState& motion,
                    std::vector<WeightReport>& reports);

} // namespace stretch::app
