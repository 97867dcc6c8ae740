#include "skinning/elastic/curvature_length.h"

#include <algorithm>

#include <fmt/format.h>

namespace stretch::skinning {
namespace {

double meanLengthOf(const std::vector<CurvatureLength>& frames) {
  double sum = 0.0;
  for (const CurvatureLength& frame : frames) {
    sum += frame.length;
  }
  return frames.empty() ? 0.0 : sum / static_cast<double>(frames.size());
}

/// 1 - (residual / total) sum of squares; 0 when the lengths hardly vary.
template <typename Predict>
double explained(const std::vector<CurvatureLength>& frames, Predict&& predict) {
  const double mean = meanLengthOf(frames);
  double total = 0.0;
  double residual = 0.0;
  for (const CurvatureLength& frame : frames) {
    total += (frame.length - mean) * (frame.length - mean);
    const double off = frame.length - predict(frame.curvatureRadians);
    residual += off * off;
  }
  const double noise = 1e-18 * mean * mean * static_cast<double>(frames.size());
  return total > noise ? 1.0 - residual / total : 0.0;
}

struct Block {
  double curvatureSum = 0.0;
  double lengthSum = 0.0;
  double count = 0.0;
  [[nodiscard]] double length() const { return lengthSum / count; }
};

} // namespace

LineFit fitLine(const std::vector<CurvatureLength>& frames) {
  const auto count = static_cast<double>(frames.size());
  LineFit fit;
  fit.intercept = meanLengthOf(frames);
  double meanCurvature = 0.0;
  for (const CurvatureLength& frame : frames) {
    meanCurvature += frame.curvatureRadians / count;
  }
  double spread = 0.0;
  double product = 0.0;
  for (const CurvatureLength& frame : frames) {
    const double offset = frame.curvatureRadians - meanCurvature;
    spread += offset * offset;
    product += offset * (frame.length - fit.intercept);
  }
  if (!(spread > 1e-18 * (1.0 + meanCurvature * meanCurvature) * count)) {
    return fit;
  }
  fit.slope = product / spread;
  fit.intercept -= fit.slope * meanCurvature;
  fit.rSquared = explained(frames, [&](double curvature) { return fit.slope * curvature + fit.intercept; });
  return fit;
}

double MonotoneFit::at(double curvatureRadians) const {
  if (curvatures.empty()) {
    return 0.0;
  }
  const auto above = std::upper_bound(curvatures.begin(), curvatures.end(), curvatureRadians);
  if (above == curvatures.begin()) {
    return lengths.front();
  }
  if (above == curvatures.end()) {
    return lengths.back();
  }
  const auto i = static_cast<std::size_t>(above - curvatures.begin());
  const double t = (curvatureRadians - curvatures[i - 1]) / (curvatures[i] - curvatures[i - 1]);
  return lengths[i - 1] + t * (lengths[i] - lengths[i - 1]);
}

MonotoneFit fitMonotone(const std::vector<CurvatureLength>& frames) {
  std::vector<CurvatureLength> sorted = frames;
  std::sort(sorted.begin(), sorted.end(), [](const CurvatureLength& a, const CurvatureLength& b) {
    return a.curvatureRadians < b.curvatureRadians ||
           (a.curvatureRadians == b.curvatureRadians && a.length < b.length);
  });
  std::vector<Block> blocks;
  for (const CurvatureLength& frame : sorted) {
    blocks.push_back({frame.curvatureRadians, frame.length, 1.0});
    while (blocks.size() > 1 && (blocks[blocks.size() - 2].length() <= blocks.back().length() ||
                                 blocks[blocks.size() - 2].curvatureSum / blocks[blocks.size() - 2].count >=
                                     blocks.back().curvatureSum / blocks.back().count)) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().curvatureSum += last.curvatureSum;
      blocks.back().lengthSum += last.lengthSum;
      blocks.back().count += last.count;
    }
  }
  MonotoneFit fit;
  for (const Block& block : blocks) {
    fit.curvatures.push_back(block.curvatureSum / block.count);
    fit.lengths.push_back(block.length());
  }
  fit.rSquared = explained(frames, [&](double curvature) { return fit.at(curvature); });
  return fit;
}

double LengthFunction::at(double curvatureRadians) const {
  switch (model) {
  case LengthModel::line:
    return line.slope * curvatureRadians + line.intercept;
  case LengthModel::monotone:
    return monotone.at(curvatureRadians);
  case LengthModel::automatic:
  case LengthModel::measuredMean:
    break;
  }
  return meanLength;
}

namespace {

/// The curve has more to turn than the line, so it has to earn its place.
LengthModel clearlyBetter(const LengthFunction& fit) {
  constexpr std::size_t manyFrames = 12;
  constexpr double clearly = 0.05;
  const bool curve = fit.frameCount >= manyFrames && fit.monotone.rSquared > fit.line.rSquared + clearly;
  return curve ? LengthModel::monotone : LengthModel::line;
}

} // namespace

LengthFunction fitLength(const std::vector<CurvatureLength>& frames, LengthModel wanted) {
  LengthFunction fit;
  fit.line = fitLine(frames);
  fit.monotone = fitMonotone(frames);
  fit.meanLength = meanLengthOf(frames);
  fit.frameCount = frames.size();
  fit.model = wanted == LengthModel::automatic ? clearlyBetter(fit) : wanted;
  const double rSquared = fit.model == LengthModel::monotone ? fit.monotone.rSquared : fit.line.rSquared;
  if (wanted == LengthModel::measuredMean) {
    return fit;
  }
  if (frames.size() < fewestFrames) {
    fit.model = LengthModel::measuredMean;
    fit.remark =
        fmt::format("only {} frames to relate length and curvature: the mean length is used", frames.size());
  } else if (rSquared < leastRSquared) {
    fit.model = LengthModel::measuredMean;
    fit.remark = fmt::format("curvature explains little of the length (R^2 {:.3f}): the mean length is used",
                             rSquared);
  }
  return fit;
}

} // namespace stretch::skinning
