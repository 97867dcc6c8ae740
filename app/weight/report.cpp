#include "app/weight/report.h"

#include <cmath>

#include <fmt/core.h>

namespace stretch::app {

void ReportWriter::add(double seconds, const std::vector<skinning::LimbStretch>& bones) {
  const double frame = seconds * framesPerSecond_;
  double length = 0.0;
  double rest = 0.0;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    length += bones[i].factors.along * segments_[i].length;
    rest += segments_[i].length;
    judge(frame, bones[i].factors);
  }
  const double ratio = length / rest;
  if (ratio < report_.shortest) {
    report_.shortest = ratio;
    report_.shortestFrame = frame;
  }
  if (ratio > report_.longest) {
    report_.longest = ratio;
    report_.longestFrame = frame;
  }
}

void ReportWriter::finish() {
  if (flattest_ > skinning::largestSmallStrain) {
    report_.warnings.push_back(fmt::format(
        "{}: flattened by {:.3g} at frame {:.4g}{}; past {:g} the model no longer holds: make it stiffer",
        report_.limb, flattest_, flattestFrame_,
        flattest_ > skinning::largestCompression - 1e-6 ? ", which is the most allowed" : "",
        skinning::largestSmallStrain));
  }
  if (clampedFrame_ >= 0.0) {
    report_.warnings.push_back(
        fmt::format("{}: the stretch along a bone is held at {:g} from frame {:.4g} on: make it stiffer",
                    report_.limb, clampedAt_, clampedFrame_));
  }
}

void ReportWriter::judge(double frame, const skinning::StretchFactors& factors) {
  const double flattened = 1.0 - factors.withLoad * std::sqrt(factors.along);
  if (flattened > flattest_) {
    flattest_ = flattened;
    flattestFrame_ = frame;
  }
  if ((factors.along <= 0.5 || factors.along >= 2.0) && clampedFrame_ < 0.0) {
    clampedFrame_ = frame;
    clampedAt_ = factors.along;
  }
}

} // namespace stretch::app
